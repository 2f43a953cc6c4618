"""The check's own bound on what rounding may change."""

import pytest

from cases import rounded_tank
from swarmgrasp import Newcomer, Outline, Robot, Swarm, place
from swarmgrasp.answer_file import document_of
from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.claims import read_claims
from swarmgrasp.verify.rounding import noise_of

CHAMFERED = Outline([(0, 0), (10.192, 0), (12.192, 2.0), (12.192, 6.0), (0, 6.0)])
SPOTS = [CHAMFERED.on_edge(edge, 1.0) for edge in range(5)] + [CHAMFERED.at_point((10.192, 0))]
MIXED = [Robot(at.point, at.inward + turn) for at in SPOTS for turn in (0.0, 0.1)]
BOARD = Robot(SPOTS[1].point, SPOTS[1].inward, mounted=True)


@pytest.mark.parametrize(
    "swarm", [rounded_tank(36, 5, 3), Swarm(CHAMFERED, MIXED), Swarm(CHAMFERED, [BOARD, MIXED[2]])]
)
def test_the_check_finds_the_swarms_noise(swarm):
    """By code that shares nothing with the swarm's."""
    claim = read_claims(document_of(place(swarm, Newcomer(limit=1.0)))).problem.swarm
    found = noise_of(claim.robots, Boundary(claim.outline), swarm.scale)
    assert found == pytest.approx(swarm.noise, rel=1e-9)
    assert found > 0.0
