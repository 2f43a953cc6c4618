"""Fig. 6: the time of one placement over the number of robots."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.pages.runner import Runner
from swarmgrasp.pages.statements import Statement, seconds, spaced
from swarmgrasp.paper.algorithm_1 import algorithm_1
from swarmgrasp.paper.all_pairs import facets
from swarmgrasp.paper.draws import FREE, Task, problem, tasks
from swarmgrasp.paper.published import EXAMPLES, TIME_FITS
from swarmgrasp.placement import place

Array = NDArray[np.float64]

SPAN = 5e-3
"""Time that our placement is repeated for [s]: one takes less than clocks and caches tell."""


@dataclass(frozen=True, eq=False)
class Speeds:
    """Times of both methods on the same configurations.

    Attributes
    ----------
    robots : (m,)
        Numbers of robots already there.
    ours, theirs : (m, k) [s]
        Of `place`, proof included, and of Algorithm 1 without the attachment.
    """

    robots: NDArray[np.int64]
    ours: Array
    theirs: Array

    @property
    def exponents(self) -> tuple[float, float]:
        """The power of the growth, ours and theirs: slopes of log median time over log robots."""
        logs = (np.log(np.median(times, axis=1)) for times in (self.ours, self.theirs))
        ours, theirs = (float(np.polyfit(np.log(self.robots), row, 1)[0]) for row in logs)
        return ours, theirs

    def quadratic(self, times: Array) -> dict[str, float]:
        """Fit C in C N^2 [s] by least squares to the best, median and worst times."""
        squares = self.robots.astype(float) ** 2
        rows = {"best": times.min(1), "median": np.median(times, 1), "worst": times.max(1)}
        return {name: float(squares @ row / (squares @ squares)) for name, row in rows.items()}


def times_of(task: Task) -> tuple[float, float]:
    """Clock both methods on one configuration [s, s], ours first."""
    question = problem(task, FREE)
    place(question.swarm, question.newcomer)  # lists the outline's pieces, once
    first = _clock(lambda: place(question.swarm, question.newcomer))
    calls = max(1, round(SPAN / first))
    ours = _clock(lambda: [place(question.swarm, question.newcomer) for _ in range(calls)]) / calls
    return ours, _clock(lambda: algorithm_1(question))


def _clock(work: Callable[[], object]) -> float:
    """Return the seconds that a call takes."""
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def measure(runner: Runner, seed: int, robots: Sequence[int], configurations: int) -> Speeds:
    """Clock both methods, one configuration at a time."""
    found = [runner.each(times_of, tasks(seed, n, configurations)) for n in robots]
    table = np.array(found)
    return Speeds(np.array(robots), table[:, :, 0], table[:, :, 1])


def statements(found: Speeds) -> list[Statement]:
    """State how fast both are, and how that grows."""
    ours, theirs = (np.median(times, axis=1) for times in (found.ours, found.theirs))
    slowest = float((found.theirs / found.ours).min())
    fits, (growth, their_growth) = found.quadratic(found.theirs), found.exponents
    n = int(found.robots[-1])
    published = TIME_FITS["median"] * n**2
    return [
        Statement(
            f"Around {n} robots, Algorithm 1 takes {seconds(theirs[-1])} in the median here, and "
            f"{seconds(published)} by the paper's fit; the certified optimum takes "
            f"{seconds(ours[-1])}.",
            bool(ours[-1] < theirs[-1] < published),
            is_timing=True,
            rests_on=("T9", "T11"),
        ),
        Statement(
            f"On every configuration the certified optimum is faster than Algorithm 1, by a factor "
            f"of {slowest:.0f} at least and of {np.median(found.theirs / found.ours):.0f} in the "
            "median.",
            slowest > 1.0,
            is_timing=True,
            rests_on=("T9", "T11"),
        ),
        Statement(
            f"From {found.robots[0]} to {n} robots the median time grows as N to the power "
            f"{growth:.2f} for ours and {their_growth:.2f} for Algorithm 1 (slopes of lines fitted "
            "to the logarithms): what does not hang on N outweighs the rest. Fitted like the "
            f"paper's, Algorithm 1's C is {seconds(fits['best'])}, {seconds(fits['median'])} and "
            f"{seconds(fits['worst'])} for its best, median and worst times.",
            max(growth, their_growth) < 2.0,
            is_timing=True,
            rests_on=("T9", "T11"),
        ),
        _own_times(),
        objective_cost(n),
    ]


def statements_beyond(found: Speeds, beyond: Speeds) -> list[Statement]:
    """State how both go on beyond the paper's numbers of robots."""
    ours, theirs = (float(np.median(times[-1])) for times in (beyond.ours, beyond.theirs))
    both = Speeds(
        np.append(found.robots[-1:], beyond.robots),
        np.vstack([found.ours[-1:], beyond.ours]),
        np.vstack([found.theirs[-1:], beyond.theirs]),
    )
    growth, their_growth = both.exponents
    return [
        Statement(
            f"Beyond the paper's figure, from {both.robots[0]} to {both.robots[-1]} robots, the "
            f"powers are {growth:.2f} and {their_growth:.2f}: in the end Algorithm 1 takes "
            f"{seconds(theirs)} in the median, and the certified optimum {seconds(ours)}.",
            ours < theirs,
            is_timing=True,
            rests_on=("T12",),
        )
    ]


def _own_times() -> Statement:
    """State how the times of the paper's examples go with its fit."""
    parts = [
        f"{e.seconds / e.robots**2:.4f} s for the {e.robots} robots of {e.figure}" for e in EXAMPLES
    ]
    low, high = TIME_FITS["best"], TIME_FITS["worst"]
    return Statement(
        f"The times the paper gives for its examples, over N², are {' and '.join(parts)}: above "
        f"its median of {TIME_FITS['median']} s, and within its best and worst.",
        all(low <= TIME_FITS["median"] <= e.seconds / e.robots**2 <= high for e in EXAMPLES),
        rests_on=("T11",),
    )


def objective_cost(most: int) -> Statement:
    """State what one evaluation of the paper's objective costs, with so many robots."""
    rng = np.random.default_rng(most)
    terms = [n * len(facets(rng.normal(size=(n, 3)))[0]) for n in (most, 2 * most)]
    return Statement(
        f"One evaluation of the printed objective adds {spaced(terms[0])} terms with {most} "
        f"robots in general position and {spaced(terms[1])} with twice as many, "
        f"{terms[1] / terms[0]:.1f} times more: it grows as N³, not as N².",
        terms == [n**2 * (n - 1) for n in (most, 2 * most)],
        rests_on=("T2",),
    )
