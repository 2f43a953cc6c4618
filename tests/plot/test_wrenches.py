import math

import numpy as np
import pytest
from mpl_toolkits.mplot3d import art3d, proj3d

from swarmgrasp import Criterion, Ellipsoid, Outline, Polytope, Robot, Swarm, Tolerance
from swarmgrasp.plot import wrench_sets
from swarmgrasp.plot.bodies import body, split
from swarmgrasp.plot.fit import text_area
from swarmgrasp.plot.tasks import unit_ball
from swarmgrasp.quality import quality


@pytest.mark.parametrize("name", ["barge", "square", "crowd"])
def test_the_ball_touches_the_weakest_face_and_no_other_is_nearer(name, request):
    swarm = request.getfixturevalue(name)
    shape = body(swarm)
    face = shape.vertices[list(shape.facet)]
    size = float(np.abs(shape.vertices).max())
    assert shape.quality == pytest.approx(quality(swarm).value, abs=1e-9 * size)
    normal = np.cross(face[1] - face[0], face[2] - face[1])
    normal /= np.linalg.norm(normal)
    assert (shape.touching - face[0]) @ normal == pytest.approx(0.0, abs=1e-9 * size)
    assert np.linalg.norm(shape.touching) == pytest.approx(shape.quality, rel=1e-12)
    assert (shape.offsets >= shape.quality - 1e-9 * size).all()


def test_the_balanced_square_has_its_known_ball(square):
    assert body(square).quality == pytest.approx(0.8 / np.sqrt(1.32), rel=1e-12)


def test_cutting_the_ball_loses_and_adds_nothing(crowd):
    shape = body(crowd)
    patches, _ = unit_ball()
    patches = [1.4 * shape.quality * patch for patch in patches]
    inside, outside = split(patches, np.zeros((len(patches), 4)), shape)
    assert inside
    assert outside
    assert sum(area(p) for p, _ in inside + outside) == pytest.approx(sum(map(area, patches)))
    middles = np.array([p.mean(axis=0) for p, _ in inside])
    assert (middles @ shape.normals.T <= shape.offsets + 1e-12).all()


def area(polygon):
    fan = np.cross(polygon[1:-1] - polygon[0], polygon[2:] - polygon[0])
    return float(np.linalg.norm(fan, axis=1).sum() / 2.0)


class Scribbled:
    """NumPy, where new memory holds the largest numbers there are."""

    def __getattr__(self, name):
        return getattr(np, name)

    @staticmethod
    def empty(shape, dtype=float):
        """Return an array of these."""
        return np.full(shape, np.finfo(float).max if dtype is float else 0, dtype)


def test_what_memory_holds_does_not_get_into_a_picture(barge, monkeypatch):
    """Of faces with several numbers of corners, matplotlib fills the rest with just that."""
    monkeypatch.setattr(art3d, "np", Scribbled())
    strong = Swarm.from_arrays(barge.outline, barge.contacts, barge.directions, 5.0 * barge.limits)
    tug = Robot((-20.0, 11.0), -2.0, 6e5)
    wrench_sets(strong, strong.with_robot(tug))  # the ball stands out, in faces of all kinds


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


CRITERIA = {
    "losing": Criterion(losing=1),
    "worst poses": Criterion(worst_case=True),
    "failures": Criterion(failures=(("R1", "R2"), ("R3", "R4"))),
    "load": Criterion(load=(0.1, -0.3, 0.2)),
    "task": Criterion(task=Polytope([(1, 0, 0), (0.5, 0, 1), (0.5, 0, -1), (0.5, 1, 0)])),
    "one wrench": Criterion(task=Polytope([(1, 0, 0)])),
    "ellipsoid": Criterion(task=Ellipsoid([(3, 0, 0), (0, 1, 0), (0, 0, 0.5)])),
    "all": Criterion(2, True, (0.1, -0.1, 0.1), Polytope([(1, 0, 0), (0.5, 0, 1)])),
}


@pytest.fixture(scope="module")
def rough(crowd):
    return crowd.with_tolerance(Tolerance(contact=0.05, direction=0.05))


@pytest.mark.parametrize("criterion", CRITERIA.values(), ids=CRITERIA)
def test_what_is_drawn_by_a_criterion_fits_and_touches(rough, criterion):
    """Ball or task is inside the set of the worst case, moved by the load, up to its face."""
    shape = body(rough, criterion)
    assert shape.quality == quality(rough, **criterion.keywords).value > 0.0
    held = shape.held
    corners = held.segment if held.segment is not None else np.concatenate(held.patches)
    size = float(np.abs(shape.vertices).max())
    reach = (shape.normals @ corners.T).max(axis=1)
    assert (reach <= shape.offsets + 1e-9 * size).all()
    face = shape.vertices[list(shape.facet)]
    height = float(shape.weakest @ face[0])
    assert shape.touching @ shape.weakest == pytest.approx(height, abs=1e-7 * size)
    gone = criterion.losing + (2 if criterion.failures else 0)
    assert shape.robots == len(rough) - gone


def texts(figure):
    legend = [text.get_text() for text in figure.legends[0].get_texts()]
    return legend, " ".join(text.get_text() for text in figure.texts)


def test_the_worst_case_stands_beside_the_swarm_as_it_is(rough):
    """The wire frame is the set without the worst case, and the title says the criterion."""
    criterion = Criterion(losing=1, worst_case=True)
    figure = wrench_sets(rough, criterion=criterion)
    legend, said = texts(figure)
    nominal, worst = quality(rough).value, quality(rough, **criterion.keywords).value
    assert legend[:2] == [f"14 robots, quality {worst:.3g} N", f"as they stand: {nominal:.3g} N"]
    assert "in the worst poses, after the worst loss of 1 robot" in said
    assert "robots left in their worst poses" in said


def test_a_task_takes_the_place_of_the_ball(rough):
    """No unit, no ball; a load is drawn from no wrench to where the set then begins."""
    criterion = Criterion(load=(0.1, -0.3, 0.2), task=Polytope([(1, 0, 0), (0.5, 0, 1)]))
    figure = wrench_sets(rough, rough.with_robot(Robot((1.8, 0.0), 0.0)), criterion=criterion)
    ax = figure.axes[0]
    gids = {artist.get_gid() for artist in ax.get_children()}
    assert gids >= {"before", "task", "facet", "touching", "load"}
    assert "ball" not in gids
    (load,) = (artist for artist in ax.lines if artist.get_gid() == "load")
    tip = np.array(load.get_data_3d())[:, 1]
    np.testing.assert_allclose(tip, np.array(criterion.load) * rough.scale)
    legend, said = texts(figure)
    assert legend[0].startswith("15 robots: ")
    assert legend[0].endswith(" times the task")
    assert "the task, times the quality" in legend
    assert "Load on the object: 0.1 N ahead, 0.3 N to starboard, 0.2 N m turning to port." in said


def test_a_load_beyond_reach_shows_the_face_it_is_beyond(barge):
    """No ball, and words that say why."""
    legend, _ = texts(wrench_sets(barge, criterion=Criterion(load=(0.0, -9e6, 0.0))))
    assert "face the load is beyond" in legend


def test_a_flat_set_touched_at_its_rim_marks_no_face():
    """Two robots ahead can do a task ahead."""
    outline = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    swarm = Swarm(outline, [Robot((-1, 0.3), 0.0), Robot((-1, -0.3), 0.0)])
    criterion = Criterion(task=Polytope([(1, 0, 0)]))
    assert body(swarm, criterion).facet == ()
    assert "weakest face" not in texts(wrench_sets(swarm, criterion=criterion))[0]


def test_a_round_set_is_drawn_without_edges():
    """Four azimuths: an outline, a ball, and where it touches; nothing of the mesh."""
    outline = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    corners = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    swarm = Swarm(outline, [Robot(c, 0.0, steers=math.pi) for c in corners])
    shape = body(swarm)
    assert (shape.edges, shape.facet) == ((), ())
    np.testing.assert_allclose(shape.weakest, quality(swarm).direction)
    assert (shape.offsets >= shape.quality * (1.0 - 1e-9)).all()
    legend, _ = texts(wrench_sets(swarm, swarm.with_robot(Robot((0.3, 1), -1.5))))
    assert "weakest face" not in legend


def test_a_flat_face_among_round_ones_is_drawn_whole():
    """The ball touches it inside its rim."""
    outline = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    robots = [
        Robot((0.3, 0.2), 0.0, steers=math.pi, mounted=True),
        Robot((1, 0.2), math.pi, reverse_limit=0.5),
        Robot((-1, 0.1), 0.0, reverse_limit=0.5),
        Robot((0.3, 1), -math.pi / 2, friction=0.3),
        Robot((0, -1), 1.0, steers=0.3, least=0.2),
    ]
    shape = body(Swarm(outline, robots))
    rim = shape.vertices[list(shape.facet)]
    sides = np.cross(np.roll(rim, -1, axis=0) - rim, shape.touching - rim) @ shape.weakest
    assert (sides > -1e-3).all()
    assert 0 < len(shape.edges) < len(shape.vertices)
