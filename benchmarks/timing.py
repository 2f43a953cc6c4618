"""Wall-clock times, taken in turn so that a busy moment of the machine hits both sides."""

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any


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

    def run(self, work: Callable[[], Any]) -> Any:
        """Call, clock and return."""
        start = time.perf_counter()
        self.value = work()
        self.seconds.append(time.perf_counter() - start)
        return self.value


def in_turn(
    ours: Callable[[], Any], theirs: Callable[[], Any], rounds: int, patience: float = 2.0
) -> tuple[Clocked, Clocked]:
    """Clock two calls in turn: ours, theirs, ours, theirs, ... and ours once more.

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
    for turn in range(rounds):
        if turn and time.perf_counter() > end:
            break
        mine.run(ours)
        other.run(theirs)
    mine.run(ours)
    return mine, other
