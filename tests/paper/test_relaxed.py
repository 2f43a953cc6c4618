import numpy as np
import pytest

import reference
from swarmgrasp import Newcomer, Problem, place
from swarmgrasp.paper import relaxed_optimum
from swarmgrasp.paper.cylinder import Cylinder
from swarmgrasp.paper.draws import NEWCOMERS, problem
from swarmgrasp.paper.studies.helpless import REACH, square


@pytest.mark.parametrize("task", [(4, n, k) for n in (5, 15) for k in range(3)])
def test_the_optimum_is_attained_and_cannot_be_beaten(task):
    """Attained by the slow formula, and bounded by linear programs that share nothing with it."""
    question = problem(task)
    found, cylinder = relaxed_optimum(question), Cylinder(question)
    base = question.swarm.scaled_generators
    attained = reference.quality(np.vstack([base, found.wrench * question.swarm.scale]))
    assert attained == pytest.approx(found.quality, abs=1e-9)
    assert found.quality <= found.upper_bound <= found.quality * (1.0 + 1e-6) + 1e-8
    assert reference.most_in_cylinder(base, cylinder.size) <= found.upper_bound + 1e-4


@pytest.mark.parametrize("kind", NEWCOMERS)
def test_no_robot_beats_it(kind):
    """Every robot's wrench is in the cylinder."""
    for k in range(10):
        question = problem((5, 15, k), kind)
        best = place(question.swarm, question.newcomer).quality
        assert best <= relaxed_optimum(question).upper_bound + 1e-9


def test_nothing_helps_a_balanced_square():
    """Not even a wrench that no robot can make (T17): min(1, 2 t / sqrt(1 + 2 t^2)) stays."""
    found = relaxed_optimum(Problem(square(), Newcomer()))
    known = 2.0 * REACH / np.sqrt(1.0 + 2.0 * REACH**2)
    assert (found.quality, found.upper_bound) == pytest.approx((known, known), rel=2e-6)
