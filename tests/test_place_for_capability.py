"""The place that is best for the least wind held, beside linear programs on a grid of places."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest

from reference import generators, largest_wind
from swarmgrasp import (
    Current,
    Environment,
    Newcomer,
    Outline,
    Problem,
    Robot,
    Swarm,
    Waves,
    Wind,
    WindCoefficients,
    capability,
    place_for_capability,
)
from swarmgrasp.errors import EnvironmentInvalid, ProblemInvalid

BARGE = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
FLAT = Wind(150.0, 500.0, WindCoefficients(transverse=0.9, bow=0.7, stern=0.7))
BEARINGS = np.radians([0.0, 80.0, 215.0, 300.0])
CREW = [
    Robot((-40, 3), 0.2, 80e3), Robot((40, -2), math.pi - 0.1, 70e3),
    Robot((-25, -10), 1.8, 60e3), Robot((20, -10), 1.4, 60e3),
    Robot((-20, 10), -1.3, 50e3), Robot((28, 10), -1.7, 50e3),
]  # fmt: skip
ASKED = Problem(Swarm(BARGE, CREW), Newcomer(60e3, attachment="push", half_angle=0.5))


def least_by_programs(swarm, environment, contacts, ways, limits, losing=0):
    """Compute the least wind over the bearings [m/s] from contacts and directions alone."""
    rows = generators(contacts, ways, limits, swarm.outline.origin, swarm.scale)
    calm = environment.load_in(swarm.outline, BEARINGS, 0.0) * swarm.scale
    winds = environment.wind_load(swarm.outline, BEARINGS, 1.0) * swarm.scale
    held = [largest_wind(rows, c, w, losing) for c, w in zip(calm, winds, strict=True)]
    return math.sqrt(min(held))


def with_newcomer(contact, way):
    """Return contacts, directions and limits of the crew and of a newcomer."""
    contacts = [*(robot.contact for robot in CREW), contact]
    ways = [*(robot.direction for robot in CREW), way]
    return contacts, ways, [*(robot.limit for robot in CREW), 60e3]


@pytest.mark.parametrize(
    ("current", "losing", "contacts"),
    [
        (None, 0, 4),
        (Current(60.0, 240.0, speed=0.4, bearing=0.6), 1, 1),
        (Current(60.0, 240.0, speed=0.4), 0, 4),
    ],
)
def test_no_place_of_a_grid_holds_more(current, losing, contacts):
    """Without a current, beside one that stays, and in one that comes with the wind."""
    around = Environment(FLAT, current, 1.25)
    asked = replace(ASKED, criterion=replace(ASKED.criterion, losing=losing))
    found = place_for_capability(asked, around, BEARINGS)
    robot = found.placement.robot
    its = with_newcomer(robot.contact, robot.direction)
    least = least_by_programs(asked.swarm, around, *its, losing)
    assert found.after == pytest.approx(least, rel=1e-6)
    assert found.after > 1.05 * found.before
    assert found.placement.verify().faults == ()
    comes_with_the_wind = current is not None and current.bearing is None
    if comes_with_the_wind:
        assert found.bound is None
        assert found.placement.upper_bound == pytest.approx(1.0, abs=2e-6)
    else:
        assert found.bound == pytest.approx(found.after, rel=1e-6)
    for arc, off in itertools.product(np.linspace(1.0, 199.0, contacts), (0.0, 0.5)):
        at = BARGE.at_arc_length(arc)
        way = BARGE.inward_normals[at.edge] + off
        grid = least_by_programs(asked.swarm, around, *with_newcomer(at.point, way), losing)
        assert grid <= found.after * (1.0 + 1e-6)


def test_in_the_sea_of_the_wind():
    """The least wind is that of the capability with the newcomer, and nothing is left in hand."""
    around = Environment(FLAT, Current(60.0, 240.0, speed=0.4), waves=Waves())
    found = place_for_capability(ASKED, around, BEARINGS)
    held = capability(found.placement.swarm_after, around, BEARINGS).intact
    assert found.after == pytest.approx(held.min(), rel=1e-9)
    assert found.bearing_after == BEARINGS[held.argmin()]
    assert found.after > found.before > 0.0
    assert found.placement.upper_bound == pytest.approx(1.0, abs=1e-5)
    assert found.placement.verify().faults == ()


def test_a_current_that_nobody_holds_leaves_no_wind():
    """No place helps, and the certificate says so of the least wind tried."""
    strong = Environment(FLAT, Current(60.0, 240.0, speed=9.0))
    found = place_for_capability(ASKED, strong, BEARINGS)
    assert (found.before, found.after, found.tried, found.bound) == (0.0, 0.0, 1.0, 1.0)
    assert found.placement.upper_bound < 1.0


def test_what_is_no_question_is_refused():
    """A problem, an environment and bearings."""
    with pytest.raises(ProblemInvalid):
        place_for_capability(ASKED.swarm, Environment(FLAT))  # type: ignore[arg-type]
    with pytest.raises(EnvironmentInvalid):
        place_for_capability(ASKED, Environment(FLAT), ["north"])  # type: ignore[list-item]
