"""The quality of robots that steer, reverse, or have friction: sets of forces (T20)."""

import json
import math
from pathlib import Path

import pytest

from swarmgrasp import Outline, Robot, Swarm, quality

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
FILE = Path(__file__).parent.parent / "data" / "steering.json"
CASES = json.loads(FILE.read_text(encoding="utf-8"))["qualities"]
MIDDLES = [((1, 0), math.pi), ((-1, 0), 0.0), ((0, 1), -math.pi / 2), ((0, -1), math.pi / 2)]
CORNERS = [(1, 1), (-1, 1), (-1, -1), (1, -1)]


def swarm_of(case):
    """Return the swarm of a reference case."""
    robots = []
    for row in case["robots"]:
        lo, hi = row["directions"]
        steers = min(math.pi, 0.5 * (hi - lo))
        robots.append(
            Robot(
                row["contact"], 0.5 * (lo + hi), row["limit"], steers=steers,
                reverse_limit=row["reverse_limit"],
            )
        )  # fmt: skip
    outline = Outline(case["outline"])
    return Swarm(outline, robots, characteristic_length=case["characteristic_length"])


def unit(robots):
    """Return robots on the square, in the unit metric."""
    return Swarm(SQUARE, robots, characteristic_length=1.0)


@pytest.mark.parametrize("number", range(len(CASES)))
def test_reference_values(number):
    """Another program found the same, after the worst losses too."""
    case, keys = CASES[number], ("quality", "quality_after_losing_1", "quality_after_losing_2")
    swarm = swarm_of(case)
    for losing, key in enumerate(keys):
        if key in case:
            found = quality(swarm, losing=losing)
            assert found.value == pytest.approx(case[key], rel=1e-7, abs=1e-8)
            assert found.value * (1.0 - 2e-7) <= found.bound <= found.value


def test_two_azimuths_close_a_grasp():
    """Their quality is 2 u r / sqrt(1 + r^2), and 0 without either."""
    pair = unit([Robot((x, 0), 0.0, 3.0, steers=math.pi) for x in (1.0, -1.0)])
    found = quality(pair)
    assert found.value == pytest.approx(6.0 / math.sqrt(2.0), rel=1e-9)
    assert found.is_force_closure
    assert quality(pair, losing=1).value == 0.0


def test_azimuths_at_the_corners():
    """They are weakest at a pole, where one of them adds nothing."""
    swarm = unit([Robot(corner, 0.0, steers=math.pi) for corner in CORNERS])
    values = [quality(swarm, losing=k).value for k in range(3)]
    root = math.sqrt(3.0)
    wanted = [(4.0 + 2.0 * math.sqrt(2.0)) / root, 4.0 / root, 2.0 / root]
    assert values == pytest.approx(wanted, rel=1e-8)


@pytest.mark.parametrize(
    ("steers", "wanted"),
    [
        (math.pi / 6, 2.0 * math.sqrt(6.0) / 3.0),
        (math.pi / 2, (3.0 + 3.0 * math.sqrt(2.0)) / math.sqrt(6.0)),
    ],
)
def test_sectors_at_the_middles(steers, wanted):
    """Four tugs that push in, each within a sector; of half a turn exactly, too."""
    swarm = unit([Robot(contact, way, steers=steers) for contact, way in MIDDLES])
    assert quality(swarm).value == pytest.approx(wanted, rel=1e-8)
