"""Fig. 2 in kind: how the wrench set is built, and what quality means in it."""

import numpy as np

from swarmgrasp.pages.statements import Statement, newtons
from swarmgrasp.paper.draws import NORMAL, Task, problem
from swarmgrasp.placement import place
from swarmgrasp.quality import quality
from swarmgrasp.swarm import Swarm
from swarmgrasp.wrench_set import WrenchSet

DIRECTIONS = 200
"""In which support functions are compared."""
ROUNDING = 1e-9
"""Relative difference of two ways to the same number."""


def steps_of(task: Task) -> list[Swarm]:
    """Return the swarms that grow, one robot at a time, to a draw and its best newcomer."""
    question = problem(task, NORMAL)
    last = place(question.swarm, question.newcomer).swarm_after
    return [last.without_rows(range(k, len(last))) for k in range(1, len(last) + 1)]


def statements(steps: list[Swarm]) -> list[Statement]:
    """State what the picture shows: a sum of segments, and its largest ball."""
    last = steps[-1]
    normals = np.random.default_rng(len(last)).normal(size=(DIRECTIONS, 3))
    alone = sum(np.maximum(normals @ b, 0.0) for b in last.generators)
    together = WrenchSet(last).support(normals)
    mesh = WrenchSet(last).mesh()
    closest, value = float(mesh.offsets.min()), quality(last).value
    earlier = [quality(step).value for step in steps[:-1]]
    return [
        Statement(
            f"In {DIRECTIONS} random directions the wrench set of the {len(last)} robots reaches "
            "as far as their segments do together: it is their Minkowski sum.",
            bool(np.allclose(alone, together, rtol=ROUNDING)),
            rests_on=("T1",),
        ),
        Statement(
            f"The closest of its {len(mesh.faces)} faces is {newtons(closest, 4)} from the origin, "
            "which is the radius of the largest ball inside, and the quality; with one robot less "
            f"it is {newtons(earlier[-1], 4)}, and with fewer 0.",
            abs(closest - value) <= ROUNDING * len(last) and max(earlier[:-1]) == 0.0,
            rests_on=("T1", "T2"),
        ),
    ]
