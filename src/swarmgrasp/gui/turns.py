"""Whose turn it is: answers first for everybody, then the parts that are cheap enough.

A pure function of what happened: messages and finished jobs with their costs come in, jobs come
out. It has no clock, no thread and no socket.
"""

import math
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

CHEAP = 0.030
"""Seconds of thread time up to which a part is told in a gesture."""
SHARE = 0.25
"""Of the time that a part may take in a gesture."""
PASSED_BY = 64
"""Answers that a part of a page at rest lets pass at most."""
ANSWER = "answer"


@dataclass
class Job:
    """Something to compute for a window.

    Attributes
    ----------
    window : int
    kind : str
        "answer", the name of a part, or the kind of an errand.
    work : object
        The ask, or the errand's message.
    """

    window: int
    kind: str
    work: Any
    is_errand: bool = False


@dataclass
class Asked:
    """An ask on its way."""

    work: Any
    is_moving: bool
    parts: list[str]
    passed_by: int = 0


@dataclass
class _Window:
    """What one window waits for."""

    waiting: Asked | None = None
    current: Asked | None = None
    is_busy: bool = False
    is_taking: bool = False
    errands: "OrderedDict[str, Any]" = field(default_factory=OrderedDict)
    has_errand: bool = False
    costs: dict[str, float] = field(default_factory=dict)
    last: dict[str, float] = field(default_factory=dict)

    @property
    def is_free(self) -> bool:
        """Whether nothing is computed for it, or on its way to it."""
        return not self.is_busy and not self.is_taking


class Turns:
    """The turns of all windows.

    Parameters
    ----------
    workers : int
        Jobs at once, at least 3: one of them is for errands alone, and one of the others is kept
        for answers.
    finer : mapping of str to str, optional
        Parts that say the same more finely: at rest the finer one, where it was cheap, takes the
        place of the coarse one.
    """

    def __init__(self, workers: int = 3, finer: Mapping[str, str] | None = None) -> None:
        self.workers = workers
        self.finer = finer or {}
        self.asks_running = 0
        self.parts_running = 0
        self.errands_running = 0
        self._windows: OrderedDict[int, _Window] = OrderedDict()

    # -- what happens ----------------------------------------------------------------------

    def join(self, window: int) -> None:
        """Take up a window."""
        self._windows[window] = _Window()

    def leave(self, window: int) -> None:
        """Forget a window; what is computed for it comes to an end by itself."""
        self._windows.pop(window, None)

    def ask(self, window: int, work: Any, is_moving: bool, parts: Sequence[str]) -> None:
        """Take an ask: the newest wins."""
        self._windows[window].waiting = Asked(work, is_moving, list(parts))

    def errand(self, window: int, kind: str, work: Any) -> Any | None:
        """Take an errand: of each kind the newest wins; return the one that is overtaken."""
        errands = self._windows[window].errands
        overtaken = errands.get(kind)
        errands[kind] = work
        return overtaken

    def cancel(self, window: int) -> None:
        """Leave the parts that are not begun."""
        holder = self._windows[window]
        holder.waiting = None
        if holder.current is not None:
            holder.current.parts.clear()

    def refuse(self, window: int) -> None:
        """Leave the parts of an ask that has no answer."""
        holder = self._windows.get(window)
        if holder is not None:
            holder.current = None

    def finish(self, job: Job, cost: float, now: float) -> None:
        """Note that a job is done, at a time [s], for so many seconds of thread time.

        Its window has no other turn before it has taken what came of it: one that is slow to read
        keeps nobody else waiting.
        """
        self._count(job, -1)
        holder = self._windows.get(job.window)
        if holder is None or job.is_errand:
            return
        holder.is_busy, holder.is_taking = False, True
        holder.costs[job.kind] = cost
        holder.last[job.kind] = now

    def take(self, job: Job) -> None:
        """Note that a window has taken what came of a job."""
        holder = self._windows.get(job.window)
        if holder is None:
            return
        if job.is_errand:
            holder.has_errand = False
        else:
            holder.is_taking = False

    def is_overtaken(self, window: int, work: Any) -> bool:
        """Tell whether a window waits for the answer to another ask than this."""
        holder = self._windows.get(window)
        if holder is None or holder.current is None or holder.current.work is not work:
            return True
        return holder.waiting is not None

    # -- what is next ----------------------------------------------------------------------

    def next(self, now: float) -> Job | None:
        """Return the next job at a time [s]; None if none may begin."""
        job = None
        if self.asks_running < self.workers - 1:
            job = self._answer()
            if job is None and self.parts_running < self.workers - 2:
                job = self._part(now)
        if job is None and not self.errands_running:
            job = self._errand()
        if job is not None:
            self._count(job, 1)
        return job

    def _count(self, job: Job, by: int) -> None:
        """Count a job that begins, or is done."""
        if job.is_errand:
            self.errands_running += by
        else:
            self.asks_running += by
            self.parts_running += by * (job.kind != ANSWER)

    def finished(self) -> list[tuple[int, Any]]:
        """Return the asks all of whose parts are told, once each, with their windows."""
        told = []
        for number, holder in self._windows.items():
            current = holder.current
            if current is not None and not current.parts and holder.is_free:
                holder.current = None
                if holder.waiting is None:
                    told.append((number, current.work))
        return told

    def _answer(self) -> Job | None:
        """Return an answer that is owed, of the window that had its turn first."""
        for number, holder in self._windows.items():
            if holder.waiting is not None and holder.is_free:
                holder.current, holder.waiting, holder.is_busy = holder.waiting, None, True
                self._windows.move_to_end(number)
                for other in self._windows.values():
                    if other.current is not None:
                        other.current.passed_by += 1
                holder.current.passed_by = 0
                return Job(number, ANSWER, holder.current.work)
        return None

    def _errand(self) -> Job | None:
        """Return an errand, of the window that had its turn first."""
        for number, holder in self._windows.items():
            if holder.errands and not holder.has_errand:
                kind, work = holder.errands.popitem(last=False)
                holder.has_errand = True
                self._windows.move_to_end(number)
                return Job(number, kind, work, is_errand=True)
        return None

    def _part(self, now: float) -> Job | None:
        """Return a part, of the window that had its turn first."""
        is_owed = any(holder.waiting and not holder.is_taking for holder in self._windows.values())
        for number, holder in self._windows.items():
            current = holder.current
            if current is None or not holder.is_free or holder.waiting is not None:
                continue
            if is_owed and (current.is_moving or current.passed_by < PASSED_BY):
                continue
            while current.parts:
                part = current.parts.pop(0)
                if current.is_moving and not _is_cheap(holder, part, now):
                    continue
                finer = self.finer.get(part)
                if finer in current.parts and holder.costs.get(finer, math.inf) <= CHEAP:
                    current.parts.remove(finer)
                    part = finer
                holder.is_busy = True
                current.passed_by = 0
                self._windows.move_to_end(number)
                return Job(number, part, current.work)
        return None


def _is_cheap(holder: _Window, part: str, now: float) -> bool:
    """Tell whether a part may be told in a gesture; the first time it may."""
    cost = holder.costs.get(part)
    if cost is None:
        return True
    return cost <= CHEAP and cost <= SHARE * (now - holder.last[part])
