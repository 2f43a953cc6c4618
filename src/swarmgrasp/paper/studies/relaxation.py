"""What the paper did not look at: its relaxed optimum, its local solver, its last step."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.pages.runner import Runner
from swarmgrasp.pages.statements import Statement, largest, listed, median, newtons, percent
from swarmgrasp.paper.algorithm_1 import algorithm_1
from swarmgrasp.paper.draws import FREE, NEWCOMERS, NORMAL, Task, pulling, tasks
from swarmgrasp.paper.relaxed import relaxed_optimum
from swarmgrasp.paper.sizes import ROBOTS
from swarmgrasp.placement import Problem, place
from swarmgrasp.quality import quality

Array = NDArray[np.float64]

GAP = 1e-6
"""Relative gap of every optimum here."""
COUNTS = 1e-3
"""Difference of two qualities that is counted [N]: ten times Algorithm 1's epsilon."""
ROUNDING = 1e-5
"""By how much a value may exceed what bounds it [N]: the gaps, and what a query may miss."""


class Case(NamedTuple):
    """One draw.

    Attributes
    ----------
    before : float [N]
    relaxed, bound : float [N]
        The optimum over the cylinder, and what no wrench in it exceeds.
    promised : float [N]
        By Algorithm 1.
    iterations : int
        Of its local solver.
    best, upper : tuple of float [N]
        What the best robot attains, and what none exceeds, for each kind in `NEWCOMERS`.
    attained : tuple of float [N]
        With the robot that Algorithm 1 attaches.
    """

    before: float
    relaxed: float
    bound: float
    promised: float
    iterations: int
    best: tuple[float, ...]
    upper: tuple[float, ...]
    attained: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Kind:
    """All draws of one number of robots, for one kind of newcomer.

    Attributes
    ----------
    before, relaxed, bound, promised, best, upper, attained : (k,) [N]
    iterations : (k,)
        As for `Case`.
    """

    before: Array
    relaxed: Array
    bound: Array
    promised: Array
    iterations: NDArray[np.int64]
    best: Array
    upper: Array
    attained: Array

    @property
    def unreal(self) -> NDArray[np.bool_]:
        """(k,): where no robot can make the relaxed optimum come true."""
        return self.relaxed > self.upper + COUNTS

    @property
    def phantom(self) -> Array:
        """(k,): the share of the relaxed gain that no robot can deliver; 0 where it can."""
        gain = np.where(self.unreal, self.relaxed - self.before, 1.0)
        return np.where(self.unreal, (self.relaxed - self.best) / gain, 0.0)

    @property
    def missed(self) -> NDArray[np.bool_]:
        """(k,): where the local solver stays below the relaxed optimum."""
        return self.promised < self.relaxed - COUNTS

    @property
    def can_help(self) -> NDArray[np.bool_]:
        """(k,): where the best robot raises the quality."""
        return self.best > self.before + COUNTS

    @property
    def lost(self) -> Array:
        """(k,): the share of the best robot's gain that the attached one does not bring."""
        gain = np.where(self.can_help, self.best - self.before, 1.0)
        return np.where(self.can_help, np.maximum(self.best - self.attained, 0.0) / gain, 0.0)

    @property
    def worse(self) -> NDArray[np.bool_]:
        """(k,): where the attached robot is worse than the best one."""
        return self.attained < self.best - COUNTS


Relaxations = dict[int, dict[str, Kind]]
"""By number of robots, then by kind of newcomer."""


def case_of(task: Task) -> Case:
    """Run Algorithm 1 on a draw, and find what is true."""
    swarm = pulling(task)
    problems = [Problem(swarm, newcomer) for newcomer in NEWCOMERS.values()]
    relaxed = relaxed_optimum(problems[0], GAP)
    theirs = algorithm_1(problems[0])
    ours = [place(swarm, problem.newcomer, gap=GAP) for problem in problems]
    robots = [theirs.attach(problem).robot for problem in problems]
    return Case(
        ours[0].quality_before,
        relaxed.quality,
        relaxed.upper_bound,
        theirs.promised,
        theirs.iterations,
        tuple(answer.quality for answer in ours),
        tuple(answer.upper_bound for answer in ours),
        tuple(quality(swarm.with_robot(robot)).value for robot in robots),
    )


def measure(runner: Runner, seed: int, count: int) -> Relaxations:
    """Run the draws of all numbers of robots."""
    return {n: _kinds(runner.map(case_of, tasks(seed, n, count))) for n in ROBOTS}


def _kinds(cases: list[Case]) -> dict[str, Kind]:
    """Return the draws of one number of robots by kind of newcomer."""
    columns = (np.array(column) for column in zip(*cases, strict=True))
    before, relaxed, bound, promised, iterations, *by_kind = columns
    return {
        kind: Kind(before, relaxed, bound, promised, iterations, *(rows[:, k] for rows in by_kind))
        for k, kind in enumerate(NEWCOMERS)
    }


def statements(found: Relaxations) -> list[Statement]:
    """State what becomes of the paper's relaxation."""
    return [
        *_bounds(found), _unreal(found), _phantoms(found), _nothing_there(found),
        _missed(found), _iterations(found), _lost(found),
    ]  # fmt: skip


def _all(found: Relaxations) -> list[Kind]:
    """Return the draws of all numbers of robots and kinds."""
    return [one for kinds in found.values() for one in kinds.values()]


def _bounds(found: Relaxations) -> list[Statement]:
    """State what bounds what, the check of everything below."""
    every = _all(found)
    count = sum(len(kinds[FREE].before) for kinds in found.values())
    below = max(largest(one.best - one.bound) for one in every)
    over = max(largest(one.promised - one.bound) for one in every)
    above = max(largest(one.attained - one.upper) for one in every)
    gaps = max(largest((one.bound - one.relaxed) / (one.relaxed + COUNTS)) for one in every)
    return [
        Statement(
            f"On all {count} draws the cylinder's optimum is known to {GAP:.0e} of its quality. It "
            "is at least what the best robot attains, as it should be for a larger set, and "
            "Algorithm 1 promises no more.",
            max(below, over) <= ROUNDING and gaps <= GAP,
            rests_on=("T7", "T10"),
        ),
        Statement(
            "On none of them does the robot that Algorithm 1 attaches exceed our upper bound.",
            above <= ROUNDING,
            rests_on=("T10",),
        ),
    ]


def _unreal(found: Relaxations) -> Statement:
    """State how often no robot can make the relaxed optimum come true."""
    free, normal = (
        [float(np.mean(k[kind].unreal)) for k in found.values()] for kind in (FREE, NORMAL)
    )
    first, second = (listed([percent(v) for v in kind]) for kind in (free, normal))
    return Statement(
        f"No robot at all can make the relaxed optimum come true on {first} of the draws of "
        f"{listed(list(found))} robots, and none along the normal on {second}.",
        all(0.0 < one <= other for one, other in zip(free, normal, strict=True)),
        rests_on=("T7",),
    )


def _phantoms(found: Relaxations) -> Statement:
    """State how much of the promised gain no robot can deliver."""
    free, normal = (
        np.concatenate([k[kind].phantom[k[kind].unreal] for k in found.values()])
        for kind in (FREE, NORMAL)
    )
    return Statement(
        f"On those draws no robot delivers {percent(median(free))} of the gain in the cylinder in "
        f"the median, and {percent(largest(free))} at worst; and none along the normal delivers "
        f"{percent(median(normal))} and {percent(largest(normal))}.",
        0.05 < largest(free) <= largest(normal),
        rests_on=("T7",),
    )


def _nothing_there(found: Relaxations) -> Statement:
    """State how often the relaxation promises a gain though no robot brings any."""
    counts = {
        kind: sum(int((k[kind].unreal & ~k[kind].can_help).sum()) for k in found.values())
        for kind in NEWCOMERS
    }
    total = sum(len(kinds[FREE].before) for kinds in found.values())
    return Statement(
        f"A gain is promised where no robot brings any on {counts[FREE]} of all {total} draws for "
        f"robots free in their direction, and on {counts[NORMAL]} for those along the normal.",
        counts[FREE] <= counts[NORMAL],
        rests_on=("T7", "T17"),
    )


def _missed(found: Relaxations) -> Statement:
    """State how often the local solver misses the relaxed optimum."""
    free = [kinds[FREE] for kinds in found.values()]
    shares = listed([percent(float(np.mean(one.missed))) for one in free])
    worst = max(largest(one.relaxed - one.promised) for one in free)
    count = sum(int(one.missed.sum()) for one in free)
    flat = sum(int((one.missed & (one.before == 0.0)).sum()) for one in free)
    return Statement(
        f"The local solver misses the relaxed optimum by more than {newtons(COUNTS, 3)} on {shares}"
        f" of the draws of {listed(list(found))} robots, by {newtons(worst)} at worst. {flat} of "
        f"these {count} draws have quality 0 before, where it may find no way up from its start.",
        2 * flat >= count > 0,
        rests_on=("T5",),
    )


def _iterations(found: Relaxations) -> Statement:
    """State how Algorithm 1's work hangs on the number of robots."""
    steps = [float(kinds[FREE].iterations.mean()) for kinds in found.values()]
    return Statement(
        f"It takes about as many iterations whatever the number of robots, "
        f"{listed([f'{step:.0f}' for step in steps])} on average, each of which costs more the "
        "more there are.",
        max(steps) < 2.0 * min(steps),
        rests_on=("T2",),
    )


def _lost(found: Relaxations) -> Statement:
    """State what is lost after the attachment, against the best robot."""
    free, normal = ([k[kind] for k in found.values()] for kind in (FREE, NORMAL))
    shares = [[float(np.mean(one.worse)) for one in kind] for kind in (free, normal)]
    lost = [np.concatenate([one.lost[one.worse] for one in kind]) for kind in (free, normal)]
    first, second = (listed([percent(v) for v in kind]) for kind in shares)
    return Statement(
        f"The robot attached in the end is worse than the best on {first} of the draws of "
        f"{listed(list(found))} robots, and forgoes {percent(median(lost[0]))} of the possible "
        f"gain there in the median and {percent(largest(lost[0]))} at worst; along the normal on "
        f"{second}, and {percent(median(lost[1]))} and {percent(largest(lost[1]))}.",
        min(largest(one) for one in lost) > 0.05,
        rests_on=("T7", "T8"),
    )
