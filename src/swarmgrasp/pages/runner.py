"""Running a study's draws: here, or in processes of their own."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager
from typing import TypeVar

from swarmgrasp.processes import Pool, cores, one_thread_each

Task = TypeVar("Task")
Found = TypeVar("Found")

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

    Times would hang on what else is running if it used several.
    """
    with one_thread_each():
        pool = Pool(min(cores(), MOST_WORKERS))
        try:
            yield pool
        finally:
            pool.close()
