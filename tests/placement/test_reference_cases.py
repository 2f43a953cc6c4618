"""Placements computed by other programs, and the object of the theory's examples."""

import math

import numpy as np
import pytest

import reference
from cases import PLACEMENTS, newcomer_of_case, swarm_of_case
from swarmgrasp import place


@pytest.mark.parametrize("name", PLACEMENTS)
def test_reference_cases(name):
    """As good as the best known robot, no better than possible, real, exact and proven."""
    case = PLACEMENTS[name]
    swarm, newcomer = swarm_of_case(case), newcomer_of_case(case)
    answer = place(swarm, newcomer, gap=1e-8)
    assert answer.quality_before == pytest.approx(case["quality_before"], rel=1e-9, abs=1e-12)
    assert case["quality_after"] - 1e-6 <= answer.quality <= case["upper_bound"] + 1e-6
    assert answer.quality <= answer.upper_bound <= case["upper_bound"] + 1e-6
    # a real robot of the right kind
    outline, robot = swarm.outline, answer.robot
    assert robot.limit == newcomer.limit
    assert outline.nearest([robot.contact])[0][0] <= 1e-12 * outline.extent
    assert _turn_off_normals(outline, answer) <= 1e-9
    # of exactly that quality
    B = np.vstack([swarm.scaled_generators, _generator(swarm, robot)])
    assert reference.quality(B) == pytest.approx(answer.quality, rel=1e-9, abs=1e-12 * len(B))
    assert answer.verify()


def _generator(swarm, robot):
    """Compute the scaled wrench of a robot from the formula."""
    return reference.generators(
        [robot.contact], [robot.direction], [robot.limit], swarm.outline.origin, swarm.scale
    )


def _turn_off_normals(outline, answer):
    """Return by how much [rad] a robot leaves the sectors of all edges at its contact."""
    newcomer = answer.problem.newcomer
    if newcomer.attachment == "free":
        return 0.0
    half = math.pi / 2 if newcomer.half_angle is None else newcomer.half_angle
    contact, off = np.array(answer.robot.contact), []
    for edge in range(len(outline)):
        p, q = outline.edge_ends(edge)
        share = np.clip((contact - p) @ (q - p) / ((q - p) @ (q - p)), 0.0, 1.0)
        if np.linalg.norm(p + share * (q - p) - contact) <= outline.tolerance:
            middle = outline.inward_normal(edge) + math.pi * (newcomer.attachment == "pull")
            turn = (answer.robot.direction - middle + math.pi) % (2.0 * math.pi) - math.pi
            off.append(abs(turn) - half)
    return min(off)
