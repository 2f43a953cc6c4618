"""Wall-clock times, taken in turn so that a busy moment of the machine hits both sides."""

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

SPAN = 5e-3
"""Time [s] that a turn should take at least, by repeating short calls."""


def clock(work: Callable[[], Any]) -> float:
    """Return the seconds that a call takes."""
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


@dataclass
class Clocked:
    """Every time a call took, and what it last returned.

    Attributes
    ----------
    seconds : list of float [s]
    value
        What the last call returned.
    """

    seconds: list[float] = field(default_factory=list)
    value: Any = None

    @property
    def median(self) -> float:
        """Median time [s]."""
        return statistics.median(self.seconds)

    def run(self, work: Callable[[], Any], calls: int = 1) -> Any:
        """Clock some calls in a row as one time, that of one of them; return its value."""
        start = time.perf_counter()
        for _ in range(calls):
            self.value = work()
        self.seconds.append((time.perf_counter() - start) / calls)
        return self.value


def calls_in(work: Callable[[], Any], span: float = SPAN) -> int:
    """Return how many calls fill a span of time [s], one at least; the first is not counted."""
    work()
    return max(1, round(span / max(clock(work), 1e-7)))


def in_turn(
    ours: Callable[[], Any], theirs: Callable[[], Any], rounds: int, patience: float = 2.0
) -> tuple[Clocked, Clocked]:
    """Clock two calls in turn: ours, theirs, ours, theirs, ... and ours once more.

    Short calls are repeated in each turn.

    Parameters
    ----------
    ours, theirs : callable
        Without arguments, on the same input.
    rounds : int
        At most so many.
    patience : float [s]
        No new round begins after it; one is always finished.
    """
    mine, other = Clocked(), Clocked()
    end = time.perf_counter() + patience
    calls = calls_in(ours)
    other.run(theirs)
    other_calls = max(1, round(SPAN / other.seconds.pop()))
    for turn in range(rounds):
        if turn and time.perf_counter() > end:
            break
        mine.run(ours, calls)
        other.run(theirs, other_calls)
    mine.run(ours, calls)
    return mine, other
