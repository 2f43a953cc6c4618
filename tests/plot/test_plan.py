import itertools
import math

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

from swarmgrasp import Newcomer, Outline, Robot, Swarm, Zone, place
from swarmgrasp.plot import landscape, plan, save
from swarmgrasp.plot.arrows import Arrows
from swarmgrasp.quality import quality


def by_gid(figure, gid):
    return figure.findobj(lambda artist: artist.get_gid() == gid)


def ends_of(figure, gid):
    """Return tails and tips of the arrows of a kind, each (n, 2)."""
    (quiver,) = by_gid(figure, gid)
    tails = np.asarray(quiver.XY)
    return tails, tails + np.column_stack([quiver.U, quiver.V])


def round_swarm(count):
    angles = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    outline = Outline(np.column_stack([np.cos(angles), np.sin(angles)]))
    places = [outline.at_arc_length(outline.perimeter * i / count) for i in range(count)]
    return Swarm(outline, [Robot(c.point, c.inward) for c in places])


def test_an_arrow_per_robot_a_push_ends_and_a_pull_starts_at_the_contact(barge):
    tails, tips = ends_of(plan(barge), "robot")
    contacts = np.array([robot.contact for robot in barge.robots])
    assert len(tips) == 5
    pushes = [0, 2, 3, 4]
    np.testing.assert_allclose(tips[pushes], contacts[pushes], atol=1e-12)
    np.testing.assert_allclose(tails[1], contacts[1], atol=1e-12)
    assert tips[1, 1] > 11.0  # Bram pulls to port


def test_lengths_follow_the_limits_and_the_key(barge):
    figure = plan(barge)
    lengths = np.linalg.norm(np.subtract(*ends_of(figure, "robot")), axis=1)
    limits = np.array([robot.limit for robot in barge.robots])
    np.testing.assert_allclose(lengths / lengths[0], limits / limits[0], rtol=1e-12)
    key = np.linalg.norm(np.subtract(*ends_of(figure, "key")), axis=1)
    np.testing.assert_allclose(key / lengths[0], 100e3 / 120e3, rtol=1e-12)
    assert "100 kN" in [text.get_text() for text in figure.findobj(Text)]


@pytest.mark.parametrize("height", [22.0, 200.0])
def test_a_metre_is_as_long_across_as_along(height):
    hull = Outline([(0, 0), (76, 0), (76, height), (0, height)])
    figure = plan(Swarm(hull, []))
    figure.draw_without_rendering()
    steps = np.diff(figure.axes[0].transData.transform([(0, 0), (1, 1)]), axis=0)[0]
    assert steps[0] == pytest.approx(steps[1], rel=1e-9)


def test_the_answer_is_told_in_words(barge, placement):
    figure = plan(barge, quality=quality(barge), placements=[placement])
    (label,) = by_gid(figure, "newcomer-label")
    assert label.get_text().startswith("Fred, 100 kN\nquality ")
    assert {t.get_text() for t in by_gid(figure, "robot-label")} == {r.name for r in barge.robots}
    assert len(by_gid(figure, "runner-up-label")) == len(placement.runners_up) > 0
    assert (len(by_gid(figure, "zone")), len(by_gid(figure, "bollard"))) == (1, 1)
    assert len(by_gid(figure, "no-go")) == 1


def test_labels_lie_apart_and_inside_the_frame(barge, placement):
    figure = plan(barge, quality=quality(barge), placements=[placement])
    kinds = ["robot-label", "newcomer-label", "runner-up-label", "edge-label", "weakest-label"]
    boxes = [text.get_window_extent() for kind in kinds for text in by_gid(figure, kind)]
    for one, other in itertools.combinations(boxes, 2):
        assert not one.overlaps(other)
    frame = figure.axes[0].bbox.padded(2.0)
    assert all(frame.contains(*corner) for box in boxes for corner in box.corners())


@pytest.mark.parametrize(("count", "labels"), [(0, 0), (1, 1), (40, 40), (200, 0)])
def test_any_number_of_robots_is_drawn(count, labels):
    swarm = round_swarm(count)
    figure = plan(swarm, quality=quality(swarm))
    assert len(by_gid(figure, "robot")) == (count > 0)
    assert len(by_gid(figure, "robot-label")) == labels


HULL = Outline([(-5, -1), (5, -1), (5, 1), (-5, 1)])


def test_what_pushes_both_ways_has_an_arrow_each_way():
    """Both start at the contact, as long as their limits, and share a label."""
    bow = Robot((4, 0), math.pi / 2, 3.0, "bow", True, reverse_limit=2.0)
    figure = plan(Swarm(HULL, [bow]))
    tails, tips = ends_of(figure, "thruster")
    np.testing.assert_allclose(tails, [(4, 0), (4, 0)])
    np.testing.assert_allclose(3.0 * (tips - tails)[1], -2.0 * (tips - tails)[0], atol=1e-12)
    assert [text.get_text() for text in by_gid(figure, "robot-label")] == ["bow"]


def corners_of(figure, gid):
    """Return the corners (k, 2) of the only area of a kind."""
    (areas,) = by_gid(figure, gid)
    (path,) = areas.get_paths()
    return path.vertices


KINDS = {
    "tug": ({"steers": 0.5}, 0.5),
    "finger": ({"friction": 0.5}, math.atan(0.5)),
    "envelope": ({"envelope": ((2.0, 0.0), (1.0, 1.0), (0.0, 0.0), (1.0, -0.5))}, math.pi / 4),
}


@pytest.mark.parametrize("kind", KINDS)
def test_all_forces_of_a_push_are_drawn_behind_the_contact(kind):
    """Off the object, as far to the side as they go, and to the scale of the arrows."""
    more, half = KINDS[kind]
    limit = 1.0 if kind == "envelope" else 2.0
    robot = Robot((0, -1), math.pi / 2, limit, **more)
    figure = plan(Swarm(HULL, [robot]))
    off = corners_of(figure, "robot-area") - robot.contact
    ((tail, *_), _) = ends_of(figure, "robot")
    assert off[:, 1].max() == pytest.approx(0.0, abs=1e-12)
    assert off[:, 1].min() == pytest.approx(tail[1] + 1.0)
    turns = np.arctan2(off[:, 0], -off[:, 1])[np.hypot(*off.T) > 1e-9]
    assert np.abs(turns).max() == pytest.approx(half)


def test_an_azimuth_thruster_is_a_circle_without_an_arrow():
    """Round its contact, its radius as long as the arrow of its limit."""
    azimuth = Robot((2, 0), 1.0, 2.0, "az", True, steers=math.pi)
    figure = plan(Swarm(HULL, [azimuth, Robot((0, -1), 1.0, 4.0)]))
    radii = np.hypot(*(corners_of(figure, "thruster-area") - azimuth.contact).T)
    ((tail,), (tip,)) = ends_of(figure, "robot")
    np.testing.assert_allclose(radii, 0.5 * np.hypot(*(tip - tail)))
    assert not by_gid(figure, "thruster")
    entries = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert entries[:3] == ["robot", "thruster", "all its forces"]


def test_a_bar_stands_at_the_least_force():
    """Of a cable that must stay taut, a quarter of its arrow from the contact."""
    cable = Robot((5, 0), math.pi, 4.0, least=1.0)
    figure = plan(Swarm(HULL, [cable]))
    (bar,) = by_gid(figure, "least")
    ((tail,), _) = ends_of(figure, "robot")
    assert bar.get_xdata()[0] == pytest.approx(5.0 + 0.25 * (tail[0] - 5.0))


def test_sectors_with_gaps_are_fans():
    """One from the contact for each sector, to the robot's scale; its arrow would say less."""
    two = Robot((0.5, 0.0), limit=2.0, sectors=[(0.0, 1.0), (2.0, 3.5)], mounted=True)
    figure = plan(Swarm(HULL, [two, Robot((-0.5, 0.0), 0.0, mounted=True)]))
    (areas,) = by_gid(figure, "thruster-area")
    fans = [path.vertices - two.contact for path in areas.get_paths()]
    assert len(fans) == 2
    for fan, (start, end) in zip(fans, two.sectors, strict=True):
        off = fan[np.hypot(*fan.T) > 1e-9]
        turns = np.arctan2(off[:, 1], off[:, 0]) % (2.0 * np.pi)
        assert (turns.min(), turns.max()) == pytest.approx((start, end))


def test_a_steering_robot_that_is_lost_has_an_empty_area():
    """And a cross."""
    robots = [
        Robot((x, y), -y * math.pi / 2, 1.0, f"{x}, {y}", steers=0.5)
        for x in (-4, 4)
        for y in (-1, 1)
    ]
    swarm = Swarm(HULL, robots)
    figure = plan(swarm, quality=quality(swarm, losing=1))
    fills = sorted(len(areas.get_facecolor()) for areas in by_gid(figure, "robot-area"))
    assert fills == [0, 1]


def test_a_notch_decides_push_or_pull_by_its_own_inside():
    notched = Outline([(0, 0), (4, 0), (4, 4), (3, 4), (3, 1), (1, 1), (1, 4), (0, 4)])
    down, up = Robot((2, 1), -math.pi / 2), Robot((2, 1), math.pi / 2)
    arrows = Arrows(notched, (down, up))
    assert arrows.ends(down)[1].tolist() == [2, 1]
    assert arrows.ends(up)[0].tolist() == [2, 1]


def test_a_given_axes_keeps_its_size(barge):
    figure = Figure(figsize=(8, 3))
    left, _ = figure.subplots(1, 2)
    before = left.get_position().bounds
    assert plan(barge, ax=left) is figure
    figure.draw_without_rendering()
    np.testing.assert_allclose(left.get_position().bounds, before, atol=1e-9)


NAMES = ["$", "$x$", "\\frac{", "A$lva $\\foo$", "曳船"]


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_written_as_it_is(name, tmp_path):
    hull = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)], edge_names=[f"{i}{name}" for i in "abcd"])
    swarm = Swarm(hull, [Robot((-2, 0), 0.0, name=name)])
    zone = Zone(hull.stretch(0, 0.0, 3.0, f"zone {name}"))
    no_go = hull.stretch(0, 3.0, 4.0, f"no-go {name}")
    answer = place(swarm, Newcomer(1.0, name=name), zones=[zone], no_go=[no_go])
    figure = plan(swarm, placements=[answer])
    assert by_gid(figure, "robot-label")[0].get_text() == name
    for picture in (figure, landscape(answer, resolution=(20, 10))):
        for suffix in ("pdf", "png", "svg"):
            save(picture, tmp_path / f"picture.{suffix}")


def test_strips_with_names_of_their_own_are_named(barge):
    hull = barge.outline
    zones = [Zone(hull.stretch("port side", 2, 30, "pads")), Zone(hull.stretch("bow"))]
    no_go = [hull.stretch("starboard side", 50, 70, "ladder")]
    figure = plan(barge, zones=zones, no_go=no_go)
    assert [t.get_text() for t in by_gid(figure, "zone-label")] == ["pads"]
    (label,) = by_gid(figure, "no-go-label")
    assert label.get_text() == "ladder"
    x, y = label.get_position()
    assert 12.0 < x < 32.0  # along the strip
    assert -11.0 < y < -6.0


def test_an_edge_name_stands_next_to_its_edge(barge, placement):
    for label in by_gid(plan(barge, placements=[placement]), "edge-label"):
        distances, arcs = barge.outline.nearest(label.get_position())
        edge = barge.outline.at_arc_length(float(arcs[0])).edge
        assert barge.outline.edge_names[edge] == label.get_text()
        assert distances[0] < 10.0


def test_an_origin_out_of_view_is_not_drawn():
    hull = Outline([(0, 0), (4, 0), (4, 2), (0, 2)], origin=(30, 5))
    swarm = Swarm(hull, [Robot((0, 1), 0.0), Robot((4, 1), 3.0)])
    figure = plan(swarm, quality=quality(swarm))
    assert not by_gid(figure, "weakest-label")
    entries = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert entries == ["robot"]


def test_thrusters_are_named_at_their_contacts():
    hull = Outline([(-5, -1), (5, -1), (5, 1), (-5, 1)])
    port = Robot((0, 0.6), -1.5, 1.0, "port", mounted=True)
    starboard = Robot((0, -0.6), 1.5, 1.0, "starboard", mounted=True)
    labels = by_gid(plan(Swarm(hull, [port, starboard])), "robot-label")
    assert [math.copysign(1.0, t.get_position()[1]) for t in labels] == [1.0, -1.0]


def test_zones_inside_are_drawn_and_told():
    """An area, a line and a spot, each named, and none of them for a newcomer on the boundary."""
    hull = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    bay = [(-20, -5), (-10, -5), (-10, 5), (-20, 5)]
    zones = [
        Zone(area=area, name=name)
        for name, area in (("bay", bay), ("keel", [(10, 0), (25, 0)]), ("well", [(0, 5)]))
    ]
    figure = plan(Swarm(hull, [Robot((40, 0), np.pi)]), zones=zones)
    drawn = by_gid(figure, "area")
    np.testing.assert_allclose(drawn[0].get_xy()[:-1], bay)
    assert len(drawn) == 2
    assert by_gid(figure, "spot")[0].get_xydata().tolist() == [[0.0, 5.0]]
    assert {text.get_text() for text in by_gid(figure, "area-label")} == {"bay", "keel", "well"}
    words = {text.get_text() for text in figure.findobj(Text)}
    assert {"zone inside", "spot inside"} < words
    assert not {"zone", "bollard"} & words


def test_labels_keep_off_the_circles_of_azimuth_thrusters():
    """Where the page has room for that."""
    hull = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    crew = [
        Robot((x, y), 0.0, steers=math.pi, mounted=True, name=f"thruster {x} {y}")
        for x in (-30, 30)
        for y in (-4, 4)
    ]
    figure = plan(Swarm(hull, crew))
    figure.draw_without_rendering()
    (areas,) = by_gid(figure, "thruster-area")
    to_page = figure.axes[0].transData
    for text in by_gid(figure, "robot-label"):
        box = text.get_window_extent().padded(-2.0)  # pixels that fonts may differ by
        for path in areas.get_paths():
            assert not any(box.contains(*point) for point in to_page.transform(path.vertices))
