"""What commands share that last: they tell what happens as it does, and end on a signal."""

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager

INTERRUPTED = 130
"""The exit status after Ctrl-C."""


def end_on_signals(stop: Callable[[], None]) -> None:
    """End in order when Ctrl-C or SIGTERM asks to.

    Parameters
    ----------
    stop : callable
        Called from the signal's handler; it should return at once.
    """
    for each in (signal.SIGINT, signal.SIGTERM):
        signal.signal(each, lambda *_: stop())


def say(words: str) -> None:
    """Print a line at once, also into a pipe."""
    print(words, flush=True)


@contextmanager
def stoppable() -> Iterator[Callable[[], bool]]:
    """Yield what tells whether Ctrl-C was pressed, once; pressed again, it interrupts as usual."""
    asked: list[bool] = []
    before = signal.getsignal(signal.SIGINT)

    def note(*_: object) -> None:
        """Note that an end was asked for."""
        asked.append(True)
        signal.signal(signal.SIGINT, before)

    signal.signal(signal.SIGINT, note)
    try:
        yield lambda: bool(asked)
    finally:
        signal.signal(signal.SIGINT, before)
