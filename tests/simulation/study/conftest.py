import pytest

import swarmgrasp as sg
from swarmgrasp.simulation.study import Plan, Sizes
from swarmgrasp.simulation.study.plan import kernels_digest

BARGE = sg.Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
PROBLEM = sg.Problem(sg.Swarm(BARGE, []), sg.Newcomer(1.0, "push", half_angle=0.5))


@pytest.fixture
def problem():
    """Tugs of 1 N that push within half a radian of square, on a barge of 4 to 1."""
    return PROBLEM


@pytest.fixture
def plan_of(problem):
    """Return a plan of small shards."""

    def plan_of(runs, size, study=None, seed=1, version="0.1.0"):
        return Plan(
            "Barge", study or Sizes(problem, 4, 6), runs, seed, size, version, kernels_digest()
        )

    return plan_of
