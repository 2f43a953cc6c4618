import math

import numpy as np
import pytest

from swarmgrasp import Newcomer, Problem, Stretch, Zone
from swarmgrasp.paper import nearest_attachment
from swarmgrasp.paper.draws import pulling
from swarmgrasp.swarm import wrenches

SWARM = pulling((1, 3, 0))


@pytest.mark.parametrize("attachment", ["push", "pull", "free"])
def test_no_contact_and_direction_is_nearer(attachment):
    """Against a dense grid of both; and the robot exerts the wrench that is told."""
    problem = Problem(SWARM, Newcomer(2.0, attachment))
    outline, rng = SWARM.outline, np.random.default_rng(2)
    contacts = [outline.at_arc_length(s) for s in np.linspace(0.0, outline.perimeter, 241)[:-1]]
    turns = np.linspace(-math.pi, math.pi, 361)
    allowed = {"push": np.cos(turns) >= 0.0, "pull": np.cos(turns) <= 0.0, "free": turns < 9.0}
    turns = turns[allowed[attachment]]
    arms = np.repeat([c.point for c in contacts], len(turns), axis=0)
    directions = np.concatenate([c.inward + turns for c in contacts])
    grid = wrenches(arms, directions, 1.0)
    for wanted in rng.uniform(-1.0, 1.0, (5, 3)):
        found = nearest_attachment(problem, wanted)
        apart = 2.0 * np.linalg.norm((grid - wanted) * SWARM.scale, axis=1)
        assert apart.min() - 0.03 <= found.distance <= apart.min() + 1e-6
        there = SWARM.with_robot(found.robot).generators[-1] / 2.0
        assert there == pytest.approx(found.wrench, abs=1e-9)


def test_what_a_robot_can_make_is_kept():
    """Along the normal there is one direction for each side."""
    problem = Problem(SWARM, Newcomer(1.0, "pull", 0.0))
    found = nearest_attachment(problem, np.array([1.0, 0.0, 0.25]))
    assert found.distance == pytest.approx(0.0, abs=1e-12)
    assert found.robot.contact == pytest.approx((1.0, -0.25))
    assert math.remainder(found.robot.direction, math.tau) == pytest.approx(0.0)


def test_zones_are_kept_to():
    """The nearest of what the problem allows: here one bollard, at the lower left corner."""
    zone = Zone(Stretch(0.0, 0.0, "bollard"), "free")
    found = nearest_attachment(Problem(SWARM, Newcomer(), (zone,)), np.array([1.0, 0.0, 0.0]))
    assert found.robot.contact == pytest.approx((-1.0, -0.5))
