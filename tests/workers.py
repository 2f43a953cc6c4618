"""Executors that do everything at once, in this process, or break; and whether processes live."""

import os
from concurrent.futures import BrokenExecutor, Executor, Future
from pathlib import Path

import pytest

needs_proc = pytest.mark.skipif(
    not Path("/proc/self/stat").exists(), reason="looks at processes in /proc"
)


def wait_for_the_end(processes):
    """Wait until no process of these ids is there; a hang is a failure: tests have a limit."""
    while any(map(_is_alive, processes)):
        os.sched_yield()


def _is_alive(process):
    """Tell whether a process is there, and not only waits to be collected."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


class Inline(Executor):
    """Does what it is given as it is given."""

    def __init__(self):
        self.given = []

    def submit(self, work, *arguments):
        """Do it."""
        self.given.append(arguments[-1])
        future = Future()
        try:
            future.set_result(work(*arguments))
        except Exception as error:
            future.set_exception(error)
        return future


class InlinePool(Inline):
    """A pool of no processes."""

    def __init__(self, _):
        super().__init__()

    def close(self):
        """End nothing."""


class Deadly(Inline):
    """Breaks, with all that is handed out, when it is given the shard that ends a process."""

    def __init__(self, shard):
        super().__init__()
        self.deadly, self.broken, self.pending = shard, False, []

    def submit(self, _, *arguments):
        """Hold it, or break."""
        if self.broken:
            raise BrokenExecutor("a process ended")
        if arguments[-1] != self.deadly:
            self.pending.append(Future())
            return self.pending[-1]
        self.broken = True
        self.given.append(arguments[-1])
        for future in self.pending:
            future.set_exception(BrokenExecutor("a process ended"))
        future = Future()
        future.set_exception(BrokenExecutor("a process ended"))
        return future
