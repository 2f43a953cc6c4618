"""Running a study's draws: here, or in processes of their own."""

import os
import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context
from typing import TypeVar

Task = TypeVar("Task")
Found = TypeVar("Found")

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
"""What tells NumPy how many threads a matrix product may use."""
MOST_WORKERS = 4
SHARE = 16
"""Parts that the draws of each process are handed out in."""


def _nothing(_: int) -> None:
    """Show no progress."""


class Runner:
    """Runs functions over many draws, and says how many are done.

    Parameters
    ----------
    executor : Executor, optional
        Where they run; in this process when left out.
    progress : callable, optional
        Called with the number of draws done so far, of all studies.
    """

    def __init__(
        self, executor: Executor | None = None, progress: Callable[[int], object] | None = None
    ) -> None:
        self.executor, self.progress = executor, progress or _nothing
        self.done = 0

    def map(self, work: Callable[[Task], Found], tasks: Sequence[Task]) -> list[Found]:
        """Run a function on all tasks, in any order; return what it found, in theirs."""
        if self.executor is None:
            return [self._counted(work(task)) for task in tasks]
        chunk = max(1, len(tasks) // (MOST_WORKERS * SHARE))
        found = self.executor.map(work, tasks, chunksize=chunk)
        return [self._counted(one) for one in found]

    def each(self, work: Callable[[Task], Found], tasks: Sequence[Task]) -> list[Found]:
        """Run a function on one task at a time, for it takes times."""
        if self.executor is None:
            return [self._counted(work(task)) for task in tasks]
        return [self._counted(self.executor.submit(work, task).result()) for task in tasks]

    def _counted(self, found: Found) -> Found:
        """Return what was found, one draw further."""
        self.advance(1)
        return found

    def advance(self, steps: int) -> None:
        """Say that the work is so much further."""
        self.done += steps
        self.progress(self.done)


@contextmanager
def workers() -> Iterator[Executor]:
    """Offer a process for each core, up to four, in which a matrix product uses one thread.

    Small products are slower on several, and times would hang on what else is running.
    """
    kept = {name: os.environ.get(name) for name in THREADS}
    os.environ.update(dict.fromkeys(THREADS, "1"))
    count = min(os.cpu_count() or 1, MOST_WORKERS)
    executor = ProcessPoolExecutor(count, get_context("spawn"), _leave_interrupts)
    try:
        yield executor
    finally:
        executor.shutdown(cancel_futures=True)
        for name, value in kept.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


def _leave_interrupts() -> None:
    """Leave Ctrl-C to the process that started this one."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
