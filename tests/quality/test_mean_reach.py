"""How far robots push on average: a ceiling of the quality."""

import math

import numpy as np
import pytest

from swarmgrasp import Outline, Robot, Swarm
from swarmgrasp.quality import quality
from swarmgrasp.quality.mean_reach import mean_reach
from swarmgrasp.swarm.force_set import boundary_of

BARGE = Outline([(-4, -1), (4, -1), (4, 1), (-4, 1)])
KINDS = (
    {"steers": 0.5}, {"steers": 2.5}, {"steers": math.pi}, {"reverse_limit": 0.5},
    {"friction": 0.5}, {"least": 0.3}, {"envelope": ((1.0, 0.0), (0.0, 0.6), (0.1, -0.8))}, {},
)  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("weights", [(1.0, 1.0), (0.3, 4.0)])
def test_it_is_the_mean_of_how_far_the_forces_reach(kind, weights):
    """By sums over many directions, of the corners of each force set."""
    robot = Robot((0, -1), 1.1, **kind)
    swarm = Swarm(BARGE, [robot, Robot((1, -1), 2.0)], force_weights=weights)
    turns = np.linspace(0.0, math.tau, 20_000, endpoint=False)
    ways = np.column_stack([np.cos(turns), np.sin(turns)]) * swarm.scale[:2]
    reach = sum((ways @ boundary_of(each).T).max(axis=1) for each in swarm)
    assert mean_reach(swarm) == pytest.approx(reach.mean(), rel=2e-4)


def test_no_quality_exceeds_it():
    """Whatever robots there are, and azimuths about the origin come near."""
    rng = np.random.default_rng(3)
    for _ in range(30):
        spots = [BARGE.at_arc_length(s).point for s in rng.uniform(0.0, BARGE.perimeter, 8)]
        robots = [Robot(spot, rng.uniform(-3, 3), **KINDS[rng.integers(8)]) for spot in spots]
        found = quality(Swarm(BARGE, robots, 1.0))
        assert 0.0 <= found.efficiency < 1.0
