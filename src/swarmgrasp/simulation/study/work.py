"""Doing a study: shards handed to any executor, each written whole or not at all."""

import os
from collections import Counter, deque
from collections.abc import Callable
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    wait,
)
from pathlib import Path
from typing import Protocol

from swarmgrasp.errors import StudyInvalid, StudyStopped, SwarmGraspError, refuse
from swarmgrasp.files import write_whole
from swarmgrasp.packages import check_installed
from swarmgrasp.processes import Pool, cores, one_thread_each
from swarmgrasp.ranges import call_faults, is_whole, kind_faults, shown
from swarmgrasp.simulation.study.plan import Plan, folder_of

TRIES = 3
"""How often a shard may be lost with the process that is at it."""
MOST_WORKERS = 1000
WINDOW = 4
"""Shards handed out at once for each worker: none is idle, and few are lost with a pool."""

RunsDone = Callable[[int], object]
"""Called with the number of runs that are done, those found done at the start among them."""


class _Workers(Protocol):
    """Who does the work."""

    width: int

    @property
    def executor(self) -> Executor:
        """Where shards go."""

    def renew(self, broken: BrokenExecutor) -> None:
        """Replace an executor that broke, or raise."""


class _Own:
    """Processes on this machine, replaced when one of them is lost."""

    def __init__(self, width: int) -> None:
        self.width, self._pool = width, Pool(width)

    @property
    def executor(self) -> Executor:
        """Where shards go."""
        return self._pool

    def renew(self, broken: BrokenExecutor) -> None:  # noqa: ARG002
        """Begin with new processes."""
        self.close()
        self._pool = Pool(self.width)

    def close(self) -> None:
        """End the processes."""
        self._pool.close()


class _Given:
    """An executor that somebody else looks after."""

    def __init__(self, executor: Executor, width: int) -> None:
        self.executor, self.width = executor, width

    def renew(self, broken: BrokenExecutor) -> None:
        """Give up: what is done is kept."""
        raise StudyStopped(
            f"the executor broke: {broken}; what is done is kept: go on with another one"
        ) from broken


def run_plan(
    folder: str | os.PathLike[str], plan: Plan, *, workers: int | None = None,
    executor: Executor | None = None, progress: RunsDone | None = None,
) -> None:  # fmt: skip
    """Do what is left to do of a study.

    The rows are the same, byte for byte, whoever does them and in whatever order: each shard has a
    seed of its own. Only this process writes: a worker that is lost loses what it was at, and that
    is done again. So may this process be, at any time: call it again.

    Parameters
    ----------
    folder : path-like
        Created if need be; one that is there should be of the same plan.
    plan : Plan
    workers : int, optional
        Processes, or what the executor has of them; as many as there are cores when left out.
    executor : Executor, optional
        Instead of processes on this machine: any that takes functions of modules.
    progress : callable, optional
        Called after each shard with the number of runs that are done, earlier calls included.

    Raises
    ------
    StudyInvalid
        If an argument is not what it should be, the folder is of another study, or a worker has
        another version of this package.
    StudyStopped
        If shards were lost with their processes again and again; all others are done then.
    PackageMissing
        If pyarrow is not installed.
    """
    check_installed("pyarrow", extra="studies", purpose="A study")
    faults = kind_faults(plan, Plan, "Plan.of(name, study, runs)") + call_faults(progress)
    if workers is not None and not (is_whole(workers) and 1 <= workers <= MOST_WORKERS):
        wanted = f"they should be a whole number from 1 to {MOST_WORKERS}"
        faults.append(f"the workers are {shown(workers)}; {wanted}")
    if executor is not None:
        faults += kind_faults(executor, Executor, "concurrent.futures.ProcessPoolExecutor()")
    refuse((StudyInvalid, faults))
    width, folder = workers or cores(), Path(folder)
    with folder_of(folder, plan):
        missing = plan.missing(folder)
        if not missing:
            return
        if executor is not None:
            _Work(folder, plan, missing, _Given(executor, width), progress).go()
            return
        with one_thread_each():
            own = _Own(min(width, len(missing)))
            try:
                _Work(folder, plan, missing, own, progress).go()
            finally:
                own.close()


class _Work:
    """What is to be done, and by whom."""

    def __init__(
        self, folder: Path, plan: Plan, missing: list[int], workers: _Workers,
        progress: RunsDone | None,
    ) -> None:  # fmt: skip
        self.folder, self.plan, self.workers, self.progress = folder, plan, workers, progress
        self.waiting, self.running = deque(missing), dict[Future[bytes], int]()
        self.suspects, self.tries = deque[int](), Counter[int]()
        self.given_up: dict[int, BaseException] = {}
        self.done = plan.runs - sum(map(plan.count, missing))

    def go(self) -> None:
        """Do all shards."""
        try:
            while self.waiting or self.suspects or self.running:
                self._hand_out()
                done, _ = wait(self.running, return_when=FIRST_COMPLETED)
                self._take_in(done)
        except KeyboardInterrupt:
            self.progress = None
            self._take_in({future for future in self.running if future.done()})
            raise
        finally:
            for future in self.running:
                future.cancel()
        if self.given_up:
            raise StudyStopped(
                f"runs {shard * self.plan.size} to "
                f"{shard * self.plan.size + self.plan.count(shard) - 1} were lost {TRIES} times "
                f"with the process that was at them ({_words(error)}); all others are done. Try "
                "them again, or with fewer workers if memory is short"
                for shard, error in sorted(self.given_up.items())
            )

    def _hand_out(self) -> None:
        """Hand out as many shards as workers need; one alone that may be what ends a process."""
        while self._next() is not None:
            queue = self._next() or self.waiting
            try:
                future = self.workers.executor.submit(_task(), self.plan.text, queue[0])
            except BrokenExecutor as broken:  # what ran tells of it when it is taken in
                if self.running:
                    return
                self.workers.renew(broken)
            except Exception as error:  # of an executor of any make
                raise StudyStopped(
                    f"the executor takes no more work ({_words(error)}); what is done is kept: go "
                    "on with another one"
                ) from error
            else:
                self.running[future] = queue.popleft()

    def _next(self) -> deque[int] | None:
        """Return the queue that a shard is to be taken from now, if any is."""
        if self.suspects:
            return None if self.running else self.suspects
        has_room = len(self.running) < WINDOW * self.workers.width
        return self.waiting if self.waiting and has_room else None

    def _take_in(self, done: set[Future[bytes]]) -> None:
        """Write what was done, and see to what was lost."""
        lost: BrokenExecutor | None = None
        for future in sorted(done, key=self.running.__getitem__):
            shard = self.running.pop(future)
            error = _error_of(future)
            if error is None:
                self._write(shard, future.result())
            elif isinstance(error, SwarmGraspError):
                raise error
            else:
                lost = error if isinstance(error, BrokenExecutor) else lost
                self._suspect(shard, error)
        if lost is not None:
            for shard in self.running.values():
                self._suspect(shard, lost)
            self.running.clear()
            self.workers.renew(lost)

    def _suspect(self, shard: int, error: BaseException) -> None:
        """Note that a shard was lost: it is tried again alone, for it may be what did it."""
        self.tries[shard] += 1
        if self.tries[shard] < TRIES:
            self.suspects.append(shard)
        else:
            self.given_up[shard] = error

    def _write(self, shard: int, content: bytes) -> None:
        """Write a shard, and say so."""
        write_whole(self.plan.part(self.folder, shard), content, durable=True)
        self.done += self.plan.count(shard)
        if self.progress is not None:
            self.progress(self.done)


def _task() -> Callable[[str, int], bytes]:
    """Return what workers do; what it needs is not always installed."""
    from swarmgrasp.simulation.study.shard import shard_bytes

    return shard_bytes


def _error_of(future: "Future[bytes]") -> BaseException | None:
    """Return what became of a shard instead of its bytes, if anything."""
    try:
        return future.exception()
    except CancelledError as cancelled:
        return cancelled


def _words(error: BaseException) -> str:
    """Return an error in a few words."""
    return f"{type(error).__name__}: {error}".rstrip(": ")
