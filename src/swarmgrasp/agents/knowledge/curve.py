"""The curve: final quality against what is communicated, over many swarms."""

from collections.abc import Callable, Container, Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from swarmgrasp.agents.knowledge.beliefs import ALL, KNOWN
from swarmgrasp.agents.knowledge.cases import (
    BARGE,
    FREE,
    HULL,
    NEWCOMERS,
    PUSH,
    STEER,
    TANK,
    Case,
)
from swarmgrasp.agents.knowledge.growing import Growth, Task, grow
from swarmgrasp.plain import Told

Grown = dict[str, Growth]
Over = Callable[[Callable[[Task], Grown], Sequence[Task]], Iterable[Grown]]
"""Runs a function on all tasks; gives what it found, in their order."""
SHOWN = (10.0, 50.0, 90.0)
"""The percentiles that are told."""


class Size(NamedTuple):
    """How much is measured.

    Attributes
    ----------
    name : str
    draws : dict of Case to int
        How many swarms of each case are drawn.
    """

    name: str
    draws: dict[Case, int]


@dataclass(frozen=True)
class Line(Told):
    """What one knowledge is worth.

    Attributes
    ----------
    known : str
        What a newcomer knows.
    draws : int
        Swarms.
    low, median, high : float
        The 10, 50 and 90 % points of the final quality, as a share of that with everything known.
    decisions : int
        Those that rest on a belief whose support function is known; of these are the next three.
    regret : float [N]
        By how much the best place was better, in the mean.
    bound : float [N]
        What T30 says that it is at most, in the mean.
    broken : int
        Decisions whose regret is above that: none, if the theory is right.
    """

    known: str
    draws: int
    low: float
    median: float
    high: float
    decisions: int
    regret: float
    bound: float
    broken: int


@dataclass(frozen=True)
class Lines(Told):
    """What each knowledge is worth to some swarms.

    Attributes
    ----------
    of : str
        The swarms in a few words.
    quality : float [N]
        Of all robots in the end with everything known, at the median.
    lines : tuple of Line
        From most known to least.
    """

    of: str
    quality: float
    lines: tuple[Line, ...]

    def __getitem__(self, known: str) -> Line:
        """Return what one knowledge is worth."""
        return next(line for line in self.lines if line.known == known)

    def __contains__(self, known: str) -> bool:
        """Tell whether it was asked what a knowledge is worth."""
        return any(line.known == known for line in self.lines)


@dataclass(frozen=True)
class Curve(Told):
    """Final quality against what is communicated.

    Attributes
    ----------
    size : str
        "full" or "quick".
    seed : int
    every : Lines
        Over all swarms.
    kinds : tuple of Lines
        Over those of each kind of robot.
    cases : tuple of Lines
        Over those that are alike.
    """

    size: str
    seed: int
    every: Lines
    kinds: tuple[Lines, ...]
    cases: tuple[Lines, ...]

    def kind(self, name: str) -> Lines:
        """Return what each knowledge is worth to robots of a kind."""
        return next(lines for lines in self.kinds if lines.of == name)

    def case(self, case: Case) -> Lines:
        """Return what each knowledge is worth to the swarms of a case."""
        return next(lines for lines in self.cases if lines.of == case.words)


def tasks_of(size: Size, seed: int) -> list[Task]:
    """Return all draws of a study.

    Parameters
    ----------
    size : Size
    seed : int
        Of the random draws, at least 0.
    """
    return [Task(case, seed, k) for case, count in size.draws.items() for k in range(count)]


def measure(size: Size, seed: int, over: Over = map) -> Curve:
    """Let swarms grow with each knowledge.

    Parameters
    ----------
    size : Size
    seed : int
        Of the random draws, at least 0. The same seed gives the same curve.
    over : callable
        Runs the draws: `map`, or what does so in other processes.
    """
    tasks = tasks_of(size, seed)
    found = list(zip(tasks, over(grow, tasks), strict=True))

    kinds = {
        case.kind: {each for each in size.draws if each.kind == case.kind} for case in size.draws
    }

    def lines(of: str, cases: Container[Case]) -> Lines:
        """Sum up the swarms of some cases."""
        return _lines(of, [grown for task, grown in found if task.case in cases])

    return Curve(
        size.name,
        seed,
        lines("all swarms", size.draws),
        tuple(lines(kind, cases) for kind, cases in kinds.items()),
        tuple(lines(case.words, {case}) for case in size.draws),
    )


def _lines(of: str, every: Sequence[Grown]) -> Lines:
    """Return what each knowledge is worth to some swarms."""
    names = [name for name in KNOWN if any(name in grown for grown in every)]
    quality = float(np.median([grown[ALL].quality for grown in every]))
    return Lines(of, quality, tuple(_line(name, every) for name in names))


def _line(name: str, every: Sequence[Grown]) -> Line:
    """Return what one knowledge is worth to those swarms that ask for it."""
    asked = [grown for grown in every if name in grown]
    shares = [grown[name].quality / grown[ALL].quality for grown in asked]
    low, median, high = (float(np.percentile(shares, at)) for at in SHOWN)
    regrets = np.array([regret for grown in asked for regret in grown[name].regrets])
    bounds = np.array([bound for grown in asked for bound in grown[name].bounds])
    mean_regret, mean_bound = (float(x.mean()) if len(x) else 0.0 for x in (regrets, bounds))
    broken = int((regrets > bounds).sum())
    return Line(name, len(asked), low, median, high, len(regrets), mean_regret, mean_bound, broken)


def _size(name: str, rays: int, steering: int, cases: Iterable[Case]) -> Size:
    """Return a size with so many draws of each case, fewer where robots steer."""
    return Size(name, {case: steering if case.kind == STEER else rays for case in cases})


_SMALL = [Case(BARGE, kind, 3, 8) for kind in NEWCOMERS]
_BARGES = [Case(BARGE, kind, 6, 20) for kind in NEWCOMERS]
_TANKS, _HULLS = ([Case(shape, kind, 6, 20) for kind in NEWCOMERS] for shape in (TANK, HULL))
_LARGE = [Case(BARGE, kind, 12, 40) for kind in (PUSH, FREE)]

FULL = _size("full", 12, 6, [*_BARGES, *_HULLS, *_TANKS, *_SMALL, *_LARGE])
QUICK = _size("quick", 2, 1, [*_BARGES, *_TANKS[:2], *_SMALL])
