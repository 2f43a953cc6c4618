"""Who is heard, by a clock that stands still while this process does."""

import math
from collections.abc import Iterable


class Hearing:
    """When each robot was heard last.

    Time in which this process did not run is cut out: its own deafness is not others' silence.

    Parameters
    ----------
    silent : float [s]
        As in `Settings`.
    """

    def __init__(self, silent: float) -> None:
        self._silent = silent
        self._last: float | None = None
        self._lost = 0.0
        self._heard: dict[str, float] = {}
        self.now = 0.0
        self.since = 0.0
        """When it began to listen without a gap [s]."""

    def advance(self, clock: float) -> bool:
        """Take the time [s] of any steady clock; tell whether this process missed some.

        A clock that goes back, or ahead by more than half of `silent` at once, tells so.
        """
        if self._last is None:  # it begins to listen now, at 0, whatever the clock shows
            self._last = self._lost = clock
        last = self._last
        missed = not 0.0 <= clock - last <= 0.5 * self._silent
        if missed:
            self._lost += clock - last
            self.since = self.now
        self._last = clock
        self.now = clock - self._lost
        return missed

    def clock_at(self, time: float) -> float:
        """Return the time of the given clock at a time of this one."""
        return time + self._lost

    def hear(self, name: str) -> bool:
        """Note a sign of life; tell whether the robot was silent before."""
        was_silent = not self.is_heard(name)
        self._heard[name] = self.now
        return was_silent

    def drop(self, name: str) -> None:
        """Forget that a robot was heard: its process has ended."""
        self._heard[name] = min(self._heard.get(name, -math.inf), self.now - self._silent)

    def begin_anew(self) -> None:
        """Listen anew: all that were heard have to be silent for as long again."""
        self.since = self.now
        for name in self.heard:
            self._heard[name] = self.now

    def is_heard(self, name: str) -> bool:
        """Tell whether a robot was heard within `silent`."""
        return self.now - self._heard.get(name, -math.inf) < self._silent

    def silence(self, name: str) -> float:
        """Return for how long a robot has been silent [s]; inf if it never was heard."""
        return self.now - self._heard.get(name, -math.inf)

    @property
    def heard(self) -> list[str]:
        """All robots that are heard."""
        return [name for name in self._heard if self.is_heard(name)]

    @property
    def has_listened(self) -> bool:
        """Whether it has listened without a gap for `silent`."""
        return self.now - self.since >= self._silent

    def next_silences(self, names: Iterable[str]) -> list[float]:
        """Return when robots that are heard now will count as silent."""
        return [self._heard[n] + self._silent for n in names if self.is_heard(n)]
