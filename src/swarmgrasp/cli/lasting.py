"""What commands share that last: they tell what happens as it does, and end on a signal."""

import signal
from collections.abc import Callable


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
