"""Processes that work for this one, and end when it does."""

import os
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context, parent_process
from multiprocessing.connection import Connection, wait
from threading import Thread
from typing import Any, ParamSpec, TypeVar

Given = ParamSpec("Given")
Found = TypeVar("Found")
THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
"""What tells NumPy how many threads a matrix product may use."""


def cores() -> int:
    """Return how many processes run at once on this machine."""
    return os.cpu_count() or 1


class Pool(ProcessPoolExecutor):
    """Processes that run functions of modules, each with arguments that can be pickled.

    They are started anew, without the state of this one. They do not hear Ctrl-C, which is this
    one's, and end when it does, even if it is killed, and when the pool is closed, whatever they
    are at.

    Parameters
    ----------
    count : int
        How many processes.
    """

    def __init__(self, count: int) -> None:
        context = get_context("spawn")
        theirs, self._held = context.Pipe(duplex=False)
        super().__init__(count, context, _end_with_parent, (theirs,))

    def submit(
        self, work: Callable[Given, Found], /, *args: Given.args, **kwargs: Given.kwargs
    ) -> Future[Found]:
        """Hand out work; a process that is started for it does not hear Ctrl-C, not even at first.

        It inherits which signals are held back. Here Ctrl-C is only late.
        """
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            return super().submit(work, *args, **kwargs)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)

    def close(self) -> None:
        """End the processes; what they have not finished is lost."""
        self._held.close()
        self.shutdown(cancel_futures=True)


@contextmanager
def one_thread_each() -> Iterator[None]:
    """Let the processes started meanwhile use one thread for a matrix product."""
    kept = {name: os.environ.get(name) for name in THREADS}
    os.environ.update(dict.fromkeys(THREADS, "1"))
    try:
        yield
    finally:
        for name, value in kept.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


def _end_with_parent(held: "Connection[None, None]") -> None:
    """Let this process end when its parent does, or lets go of what it holds the other end of."""
    parent = parent_process()
    watched: list[Any] = [held] if parent is None else [held, parent.sentinel]

    def watch() -> None:
        """Wait for that, and end at once."""
        wait(watched)
        os._exit(1)

    Thread(target=watch, daemon=True).start()
