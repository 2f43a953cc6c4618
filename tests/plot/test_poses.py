"""The worst case is drawn as it is: ranges, worst poses, and who is missing."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.text import Text

from swarmgrasp import Newcomer, Polytope, Robot, Swarm, Tolerance, place, quality
from swarmgrasp.plot import plan

TURN = math.radians(8.0)
DOUBT = Tolerance(contact=(-3.0, 2.0), direction=TURN)


def by_gid(figure, gid):
    return figure.findobj(lambda artist: artist.get_gid() == gid)


def entries(figure):
    return [text.get_text() for text in figure.axes[0].get_legend().get_texts()]


def texts(figure):
    return " ".join(text.get_text() for text in figure.findobj(Text)).replace("\xa0", " ")


@pytest.fixture(scope="module")
def rough(barge):
    return barge.with_tolerance(DOUBT)


def test_every_robot_has_its_ranges_and_its_worst_pose(rough):
    """Bands as long as the contact's interval, wedges as wide as the direction's."""
    worst = quality(rough, worst_case=True)
    figure = plan(rough, quality=worst)
    (bands,) = by_gid(figure, "contact-range")
    lengths = [np.linalg.norm(np.diff(band, axis=0)) for band in bands.get_segments()]
    assert sum(lengths) == pytest.approx(5.0 * len(rough))
    (wedges,) = by_gid(figure, "direction-range")
    for robot, path in zip(rough.robots, wedges.get_paths(), strict=True):
        corners = path.vertices - robot.contact
        angles = np.arctan2(*corners[1:-1].T[::-1])
        assert np.ptp(np.unwrap(angles)) == pytest.approx(2.0 * TURN)
        assert np.allclose(corners[0], 0.0)
    (poses,) = by_gid(figure, "worst-pose")
    ways = np.arctan2(poses.V, poses.U)
    expected = [math.remainder(r.direction, math.tau) for r in worst.worst_swarm.robots]
    np.testing.assert_allclose(np.cos(ways - expected), 1.0)
    assert entries(figure) == [
        "robot", "contact range", "direction range", "worst pose",
        "weakest wrench (direction only)",
    ]  # fmt: skip
    assert "in the worst poses" in texts(figure)


def test_as_they_stand_no_tolerance_is_drawn(rough):
    """The nominal quality takes every robot at its word."""
    figure = plan(rough, quality=quality(rough))
    assert entries(figure) == ["robot", "weakest wrench (direction only)"]
    assert not by_gid(figure, "contact-range")


def test_robots_lost_and_absent_are_hollow(crowd):
    """Two that are lost and one that may not come; the others stay as they are."""
    robots = [*crowd.robots]
    robots[4] = replace(robots[4], tolerance=Tolerance(may_be_absent=True))
    swarm = Swarm(crowd.outline, robots, 1.0)
    worst = quality(swarm, worst_case=True, losing=2)
    figure = plan(swarm, quality=worst)
    (hollow,) = by_gid(figure, "missing")
    gone = {*worst.lost, swarm.names[4]}
    assert hollow.N == len(gone) == 3
    tails = np.asarray(hollow.XY)
    tips = tails + np.column_stack([hollow.U, hollow.V])
    for name in gone:
        ends = np.vstack([tails, tips]) - swarm[name].contact
        assert np.hypot(*ends.T).min() < 1e-9
    (full,) = by_gid(figure, "robot")
    assert full.N == 12
    assert "missing at worst" in entries(figure)
    lost_only = plan(swarm, quality=quality(swarm, losing=2))
    assert "lost at worst" in entries(lost_only)


def test_a_newcomer_shows_where_it_may_end_up(rough, zones):
    """The worst case drawn is that with the newcomer, and the small print says so."""
    newcomer = Newcomer(100e3, "push", name="Fred", tolerance=Tolerance(contact=4.0))
    answer = place(rough, newcomer, zones, worst_case=True, gap=1e-3)
    figure = plan(rough, placements=[answer])
    (poses,) = by_gid(figure, "worst-pose")
    assert len(rough) + 1 == poses.N
    assert "with every newcomer there" in texts(figure)


def test_labels_keep_clear_of_each_other_in_the_worst_case(rough, zones):
    """As in any other plan."""
    worst = quality(rough, worst_case=True, losing=1)
    figure = plan(rough, quality=worst, zones=zones)
    kinds = ("robot-label", "edge-label", "weakest-label", "bollard-label")
    boxes = [text.get_window_extent() for kind in kinds for text in by_gid(figure, kind)]
    assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))


def test_everything_written_stays_on_the_page(rough, zones, no_go):
    """Title, words and legend, with as many entries as there can be."""
    terms = {"worst_case": True, "losing": 1, "load": (0.0, -5e3, 2e5)}
    task = Polytope([(50e3, 0, 0), (0, 20e3, 0)])
    answer = place(rough, Newcomer(100e3), zones, no_go=no_go, runners_up=0.0, task=task, **terms)
    figure = plan(rough, quality=quality(rough, task=task, **terms), placements=[answer])
    figure.draw_without_rendering()
    written = [figure.axes[0].get_legend(), *figure.axes[0].texts]
    for artist in written:
        box = artist.get_window_extent()
        assert box.x0 >= 0.0
        assert box.x1 <= figure.bbox.x1 + 1.0
        assert box.y0 >= 0.0
        assert box.y1 <= figure.bbox.y1
    said = texts(figure)
    assert "5 kN to starboard" in said
    assert "times the task" in said
    assert "quality 0 kN" not in said


def test_a_load_that_is_not_held_is_said(barge):
    """And a task that cannot be done."""
    figure = plan(barge, quality=quality(barge, load=(0.0, -9e6, 0.0)))
    assert "load not held" in texts(figure)
    two = Swarm(barge.outline, [Robot((38, 4), math.pi), Robot((-38, 4), 0.0)])
    figure = plan(two, quality=quality(two, task=Polytope([(0, 1, 0)])))
    assert "task not possible" in texts(figure)
