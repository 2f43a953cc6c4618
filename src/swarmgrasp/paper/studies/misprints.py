"""What comes of the paper's misprints when they are followed to the letter."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.pages.runner import Runner
from swarmgrasp.pages.statements import Statement, largest, newtons, percent
from swarmgrasp.paper.algorithm_1 import MOST_QUERIES, Printed, algorithm_1
from swarmgrasp.paper.draws import FREE, Task, problem, tasks
from swarmgrasp.paper.relaxed import relaxed_optimum
from swarmgrasp.placement import place
from swarmgrasp.quality import quality
from swarmgrasp.quality.weakest import weakest_of

Array = NDArray[np.float64]

ROBOTS = 15
COUNTS = 1e-3
"""Difference of two qualities that is counted [N]."""


class Erratum(NamedTuple):
    """A misprint.

    Attributes
    ----------
    where, printed, meant : str
    """

    where: str
    printed: str
    meant: str


ERRATA = {
    "force": Erratum(
        "B, Section III-A", "(sin alpha, cos alpha, ...)", "(cos alpha, sin alpha, ...)"
    ),
    "loop": Erratum("Algorithm 1, loop", "while Q_upper - Q_lower < epsilon", "> epsilon"),
    "midpoint": Erratum(
        "Algorithm 1, bisection", "(Q_upper - Q_lower) / 2", "(Q_upper + Q_lower) / 2"
    ),
    "sets": Erratum("Section IV-B", "superlevel sets are concave", "convex"),
    "torque": Erratum("feasibility query", "tau ≤ r_max", "-r_max ≤ tau ≤ r_max; but tau = c x F"),
    "cost": Erratum("complexity", "O(N²)", "O(N³) for one printed objective"),
}
"""The paper's misprints."""


class Followed(NamedTuple):
    """One draw with the misprints followed, one at a time.

    Attributes
    ----------
    mirrored : float [N]
        Difference of the qualities by the printed and by the true generators.
    best : float [N]
        What a newcomer free in its direction attains, over what was there.
    loop_queries : int
    loop : float [N]
        What the loop as printed attains, over what was there.
    midpoint_ended : bool
    midpoint_share : float
        Q_lower over Q_upper where it stopped.
    torque : float [N]
        By how much the promise with the printed torque bound exceeds the cylinder's optimum.
    """

    mirrored: float
    best: float
    loop_queries: int
    loop: float
    midpoint_ended: bool
    midpoint_share: float
    torque: float


@dataclass(frozen=True, eq=False)
class Misprints:
    """All draws, as columns of `Followed`."""

    mirrored: Array
    best: Array
    loop_queries: NDArray[np.int64]
    loop: Array
    midpoint_ended: NDArray[np.bool_]
    midpoint_share: Array
    torque: Array


def followed(task: Task) -> Followed:
    """Follow each misprint on one draw."""
    question = problem(task, FREE)
    swarm = question.swarm
    before = quality(swarm).value
    printed = weakest_of(swarm.scaled_generators[:, [1, 0, 2]]).quality
    loop = algorithm_1(question, printed=Printed.LOOP)
    midpoint = algorithm_1(question, printed=Printed.MIDPOINT)
    return Followed(
        abs(printed - before),
        place(swarm, question.newcomer).quality - before,
        loop.queries,
        quality(swarm.with_robot(loop.attach().robot)).value - before,
        midpoint.ended,
        midpoint.promised / midpoint.refuted,
        algorithm_1(question, printed=Printed.TORQUE).promised
        - relaxed_optimum(question).upper_bound,
    )


def measure(runner: Runner, seed: int, count: int) -> Misprints:
    """Follow them on draws of 15 robots."""
    found = runner.map(followed, tasks(seed, ROBOTS, count))
    return Misprints(*map(np.array, zip(*found, strict=True)))


def statements(found: Misprints) -> dict[str, Statement]:
    """State what comes of each misprint, by its key in `ERRATA`."""
    count = len(found.best)
    helped = found.best > COUNTS
    gained = float(found.loop.sum() / found.best.sum())
    stuck = ~found.midpoint_ended
    over = found.torque > COUNTS
    return {
        "force": Statement(
            "Harmless for the quality, for it mirrors every force alike: on all "
            f"{count} draws the two differ by {found.mirrored.max():.0e} N at most. But the moment "
            "printed beside it belongs to another force.",
            bool(found.mirrored.max() <= 1e-12),
            rests_on=("T1",),
        ),
        "loop": Statement(
            f"The loop is never entered: {found.loop_queries.max()} queries on all draws. The "
            "starting direction, attached, brings "
            f"{percent(gained)} of the gain that the best robots bring.",
            bool(found.loop_queries.max() == 0) and gained < 0.999,
            rests_on=("T5",),
        ),
        "midpoint": Statement(
            f"The bisection does not end within {MOST_QUERIES} queries on "
            f"{percent(float(np.mean(stuck)))} of the draws: Q_lower comes to rest at a third of "
            "Q_upper.",
            bool(stuck[helped].all())
            and bool(np.allclose(found.midpoint_share[stuck], 1.0 / 3.0, atol=1e-6)),
            rests_on=("T5",),
        ),
        "torque": Statement(
            "It matters on some draws only: without a lower bound on the torque Algorithm 1 "
            f"promises more than the cylinder allows on {percent(float(np.mean(over)))} of them, "
            f"by {newtons(max(largest(found.torque), 0.0))} at most.",
            not over.all(),
            rests_on=("T7",),
        ),
    }
