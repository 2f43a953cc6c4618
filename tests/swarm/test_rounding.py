"""What rounded coordinates leave open about the robots."""

import math

import numpy as np
import pytest

from cases import rounded_tank
from swarmgrasp import Outline, Robot, Swarm
from swarmgrasp.swarm.rounding import largest_error


@pytest.mark.parametrize("corners", [8, 36, 360])
def test_no_outline_within_its_precision_moves_a_generator_by_more(corners):
    """Inward tugs set up anew on outlines that round to the same coordinates."""
    rng = np.random.default_rng(12)
    swarm = rounded_tank(corners, 5, 4)
    outline, half = swarm.outline, swarm.outline.precision
    assert half == 0.5e-4
    most = np.zeros(5)
    for _ in range(200):
        off = half * rng.choice([-1.0, 1.0], size=outline.vertices.shape)
        other = Outline(outline.vertices + off)
        spots = [outline.at_point(robot.contact) for robot in swarm.robots]
        found = [
            other.on_edge(at.edge, at.arc_length - outline.corner_arc_lengths[at.edge])
            for at in spots
        ]
        robots = [Robot(at.point, at.inward, 392_266.0) for at in found]
        moved = Swarm(other, robots, swarm.characteristic_length).scaled_generators
        most = np.maximum(most, np.linalg.norm(moved - swarm.scaled_generators, axis=1))
    assert (most <= swarm.errors * (1.0 + 1e-6)).all()
    assert (most >= 0.3 * swarm.errors).all()
    assert (swarm.errors <= largest_error(outline, swarm.scale) * swarm.limits).all()


def test_only_robots_along_a_normal_have_their_direction_from_the_outline():
    """Others, those on board and those on edges along x or y are where they are said to be."""
    outline = Outline([(0, 0), (10.192, 0), (12.192, 2.0), (12.192, 6.0), (0, 6.0)])
    oblique = outline.on_edge(1, 1.0)
    robots = [
        Robot(oblique.point, oblique.inward),
        Robot(oblique.point, oblique.inward + math.pi),
        Robot((10.192, 0), oblique.inward),  # the corner belongs to both edges
        Robot(oblique.point, oblique.inward + 0.1),
        Robot(oblique.point, oblique.inward, mounted=True),
        Robot((5.0, 0.0), math.pi / 2),
        Robot((12.192, 2.0), math.pi),
    ]
    swarm = Swarm(outline, robots)
    assert (swarm.errors > 0.0).tolist() == [True, True, True, False, False, False, False]
    assert swarm.noise == swarm.errors.sum()
    exact = Swarm(Outline(outline.vertices, precision=0.0), robots)
    assert exact.noise == 0.0
