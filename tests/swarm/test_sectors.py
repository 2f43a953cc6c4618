"""Sectors with gaps between: what is taken, what is joined, and what is refused."""

import math
from dataclasses import replace

import pytest

from swarmgrasp import Outline, Robot, Swarm
from swarmgrasp.errors import RobotInvalid

AT = (0.5, 0.0)


@pytest.mark.parametrize(
    ("sectors", "kept"),
    [
        ([(0.5, 1.0), (2.0, 3.0)], ((0.5, 1.0), (2.0, 3.0))),
        ([(2.0, 3.0), (0.5, 1.0), (1.0, 1.5)], ((0.5, 1.5), (2.0, 3.0))),
        ([(6.0, 6.2), (1.0, 2.0), (6.2, 6.2 + 0.5)], ((1.0, 2.0), (6.0, 6.7))),
        ([(0.0, 4.0)], ((0.0, 4.0),)),
        ([(1.0, 1.0), (4.0, 4.0)], ((1.0, 1.0), (4.0, 4.0))),
        ([(3.0, math.tau), (0.0, 1.0)], ((3.0, math.tau + 1.0),)),
    ],
)
def test_sectors_are_kept_in_order(sectors, kept):
    """Those that touch are one, across the x axis too; what is kept is kept as it is."""
    robot = Robot(AT, sectors=sectors)
    assert robot.sectors == kept
    assert replace(robot) == robot == Robot.from_data(robot.to_data())
    assert not robot.is_ray


@pytest.mark.parametrize(
    ("sectors", "direction", "steers"),
    [
        ([(0.5, 1.5)], 1.0, 0.5),
        ([(-0.5, 0.5)], 0.0, 0.5),
        ([(0.5, 1.0), (1.0, 1.5)], 1.0, 0.5),
        ([(2.0, 2.0)], 2.0, 0.0),
        ([(0.0, math.pi)], math.pi / 2, math.pi / 2),
        ([(0.0, math.tau)], math.pi, math.pi),
        ([(1.0, 4.0), (4.0, 1.0)], math.pi, math.pi),
    ],
)
def test_one_sector_is_what_steers(sectors, direction, steers):
    """One of half a turn or less, or of a whole one, is an ordinary robot."""
    robot = Robot(AT, sectors=sectors)
    assert (robot.direction, robot.steers) == pytest.approx((direction, steers))
    assert robot.sectors is None


FAULTS = {
    "overlap": ({"sectors": [(0.0, 2.0), (1.0, 3.0)]}, "sectors 1 and 2 overlap"),
    "across": ({"sectors": [(6.0, 0.5), (0.2, 1.0)]}, "sectors 1 and 2 overlap"),
    "none": ({"sectors": []}, "one or more"),
    "text": ({"sectors": "all"}, "one or more"),
    "half": ({"sectors": [(1.0,)]}, "sector 1 is"),
    "nan": ({"sectors": [(0.0, 1.0), (2.0, math.nan)]}, "sector 2 is"),
    "direction": ({"sectors": [(0.0, 1.0), (2.0, 4.0)], "direction": 0.5}, "may be left out"),
    "steers": ({"sectors": [(0.0, 1.0)], "steers": 0.5}, "leave out what it steers"),
    "friction": ({"sectors": [(0.0, 1.0)], "friction": 0.5}, "leave out the friction"),
    "reverse": ({"sectors": [(0.0, 1.0)], "reverse_limit": 0.5}, "leave out the reverse limit"),
    "least": ({"sectors": [(0.0, 1.0)], "least": 0.5}, "leave out the least force"),
    "envelope": ({"sectors": [(0.0, 1.0)], "envelope": [(1, 0), (0, 1)]}, "the envelope"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_what_does_not_go_together_is_refused(name):
    """In words, with every other fault at once."""
    said, words = FAULTS[name]
    with pytest.raises(RobotInvalid, match=words) as refused:
        Robot(AT, limit=-1.0, **said)
    assert any("the limit is -1.0" in fault for fault in refused.value.faults)


def test_a_direction_is_asked_for_without_sectors():
    """It may be left out with sectors only."""
    with pytest.raises(RobotInvalid, match="the direction is nan"):
        Robot(AT)


def test_a_swarm_keeps_sectors_of_its_robots():
    """Through leaving, joining and plain data; filled, it exerts the hull."""
    square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    one = Robot(AT, limit=2.0, sectors=[(0.0, 1.0), (2.0, 3.0)], mounted=True)
    swarm = Swarm(square, [Robot((1, 0), math.pi), one, Robot((-1, 0), 0.0)])
    left = swarm.without("R1").with_robot(replace(one, contact=(0.2, 0.0), name="Ajax"))
    assert [robot.sectors is None for robot in left] == [False, True, False]
    assert Swarm.from_data(swarm.to_data()) == swarm
    assert left.filled.force_sets.counts.tolist() == [7, 2, 7]
    assert left.filled.robots[0].sectors == one.sectors
