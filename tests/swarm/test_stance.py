"""How a robot stands on the hull, in words."""

import math

import pytest

from swarmgrasp import Outline, Robot
from swarmgrasp.swarm.stance import stance

BARGE = Outline([(-4, -1), (4, -1), (4, 1), (-4, 1)], edge_names=["stb", "bow", "port", "stern"])
STEERS = {"steers": math.pi / 6}


@pytest.mark.parametrize(
    ("robot", "where", "way", "short"),
    [
        (
            Robot((0, -1), math.pi / 2),
            "on stb", "pushing along the inward normal", "push along it",
        ),
        (
            Robot((0, -1), math.pi / 2, **STEERS),
            "on stb", "pushing along the inward normal, steering 30 deg either side",
            "push along it, 30 either side",
        ),
        (
            Robot((0, -1), -math.pi / 2 + 0.1, **STEERS),
            "on stb",
            "pulling, 5.7 deg counter-clockwise off the outward normal, steering 30 deg either "
            "side",
            "pull 5.7 counter-clockwise, 30 either side",
        ),
        (
            Robot((4, 0), math.pi, reverse_limit=0.5),
            "on bow", "pushing along the inward normal, and back", "push along it, and back",
        ),
        (Robot((4, 0), 0.0, steers=math.pi), "on bow", "pushing any way", "any way"),
        (Robot((1, 0), 0.0, mounted=True, steers=math.pi), "on board", "", ""),
    ],
)  # fmt: skip
def test_what_a_robot_may_do_is_told_beside_its_normal(robot, where, way, short):
    """How far it is off, how far it steers, and whether it goes the other way."""
    found = stance(BARGE, robot)
    assert (found.where, found.way, found.short) == (where, way, short)
