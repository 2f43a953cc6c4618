"""Processes that work for this one, and end when it does."""

import os
import signal
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context, parent_process
from multiprocessing.connection import Connection, wait
from threading import Thread

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
"""What tells NumPy how many threads a matrix product may use."""


def cores() -> int:
    """Return how many processes run at once on this machine."""
    return os.cpu_count() or 1


class Pool:
    """Processes that run functions of modules, each with arguments that can be pickled.

    They are started anew, without the state of this one; a matrix product uses one thread, for
    small ones are slower on several. They leave Ctrl-C to this process, and end when it does, even
    if it is killed, and when the pool is closed, whatever they are at.

    Parameters
    ----------
    count : int
        How many processes.
    """

    def __init__(self, count: int) -> None:
        context = get_context("spawn")
        theirs, self._held = context.Pipe(duplex=False)
        self.executor = ProcessPoolExecutor(count, context, _serve, (theirs,))

    def close(self) -> None:
        """End the processes; what they have not finished is lost."""
        self._held.close()
        self.executor.shutdown(cancel_futures=True)


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


def _serve(held: "Connection[None, None]") -> None:
    """Get a process ready to work for its parent."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=_end_with_parent, args=(held,), daemon=True).start()


def _end_with_parent(held: "Connection[None, None]") -> None:
    """End this process when its parent does, or lets go of what it holds the other end of."""
    parent = parent_process()
    wait([held] if parent is None else [held, parent.sentinel])
    os._exit(1)
