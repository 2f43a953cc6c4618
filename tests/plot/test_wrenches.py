import numpy as np
import pytest
from mpl_toolkits.mplot3d import proj3d

from swarmgrasp import Outline, Robot, Swarm
from swarmgrasp.plot import wrench_sets
from swarmgrasp.plot.bodies import body, split, unit_ball
from swarmgrasp.plot.wrenches import text_area
from swarmgrasp.quality import quality


@pytest.mark.parametrize("name", ["barge", "square", "crowd"])
def test_the_ball_touches_the_weakest_face_and_no_other_is_nearer(name, request):
    swarm = request.getfixturevalue(name)
    shape = body(swarm)
    face = shape.vertices[list(shape.facet)]
    size = float(np.abs(shape.vertices).max())
    assert shape.radius == pytest.approx(quality(swarm).value, abs=1e-9 * size)
    normal = np.cross(face[1] - face[0], face[2] - face[1])
    normal /= np.linalg.norm(normal)
    assert (shape.touching - face[0]) @ normal == pytest.approx(0.0, abs=1e-9 * size)
    assert np.linalg.norm(shape.touching) == pytest.approx(shape.radius, rel=1e-12)
    assert (shape.offsets >= shape.radius - 1e-9 * size).all()


def test_the_balanced_square_has_its_known_ball(square):
    assert body(square).radius == pytest.approx(0.8 / np.sqrt(1.32), rel=1e-12)


def test_cutting_the_ball_loses_and_adds_nothing(crowd):
    shape = body(crowd)
    patches, _ = unit_ball()
    patches = 1.4 * shape.radius * patches
    inside, outside = split(patches, np.zeros((len(patches), 4)), shape)
    assert inside
    assert outside
    assert sum(area(p) for p, _ in inside + outside) == pytest.approx(sum(map(area, patches)))
    middles = np.array([p.mean(axis=0) for p, _ in inside])
    assert (middles @ shape.normals.T <= shape.offsets + 1e-12).all()


def area(polygon):
    fan = np.cross(polygon[1:-1] - polygon[0], polygon[2:] - polygon[0])
    return float(np.linalg.norm(fan, axis=1).sum() / 2.0)


def test_the_ball_is_round_on_paper(barge):
    figure = wrench_sets(barge, barge.with_robot(Robot((38, -5), 3.0, 1e5)))
    ax = figure.axes[0]
    figure.draw_without_rendering()
    x, y, _ = proj3d.proj_transform(*np.vstack([np.zeros(3), np.eye(3)]).T, ax.get_proj())
    pixels = ax.transData.transform(np.column_stack([x, y]))
    view = (pixels[1:] - pixels[0]).T  # (2, 3): how the units of the three axes are drawn
    gram = view @ view.T
    np.testing.assert_allclose(gram, gram[0, 0] * np.eye(2), atol=1e-9 * gram[0, 0])
    assert {a.get_gid() for a in ax.get_children()} >= {"before", "ball", "facet", "touching"}


@pytest.mark.parametrize("count", [0, 1, 2, 3])
def test_a_swarm_that_holds_nothing_shows_no_ball(count):
    outline = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    robots = [Robot((1, 0.3), 0.0), Robot((0, -1), 1.2), Robot((0.5, 1), 2.0)]
    figure = wrench_sets(Swarm(outline, robots[:count]))
    gids = {artist.get_gid() for artist in figure.axes[0].get_children()}
    assert "ball" not in gids
    assert ("facet" in gids) == (count > 1)


def test_the_names_of_the_axes_clear_the_numbers(barge):
    weighted = Swarm(barge.outline, barge.robots, force_weights=(2.0, 0.5))
    figure = wrench_sets(weighted, weighted.with_robot(Robot((38, -5), 3.0, 1e5)))
    figure.draw_without_rendering()
    ax = figure.axes[0]
    axes = (ax.xaxis, ax.yaxis, ax.zaxis)
    names = [text_area(axis.label) for axis in axes]
    numbers = [text_area(tick.label1) for axis in axes for tick in axis.get_major_ticks()]
    for i, name in enumerate(names):
        assert not any(name.intersects_path(other) for other in numbers + names[:i])
