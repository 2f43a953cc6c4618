"""What is seen while a command takes its time."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import datetime, timedelta

FEW = 20
"""Robots, or steps, that are done before anyone would look up."""


@contextmanager
def shown_progress(
    total: int, what: str = "placing robots"
) -> Iterator[Callable[[int], None] | None]:
    """Yield what shows how much of a total is done, on standard error if that is a terminal.

    The bar vanishes at the end; for a few there is none.
    """
    if total <= FEW or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(what, total=total)
        yield lambda done: bar.update(task, completed=done)


@contextmanager
def shown_search(what: str) -> Iterator[Callable[[str], None]]:
    """Yield what shows how far a search has come, on standard error if that is a terminal.

    The line vanishes at the end.
    """
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    from rich.console import Console

    with Console(stderr=True).status(what) as status:
        yield lambda words: status.update(f"{what}: {words} (Ctrl-C ends it with the best so far)")


LINES = 10
"""Lines that a long command writes into a pipe."""


@contextmanager
def shown_pace(total: int, before: int) -> Iterator[Callable[[int], None]]:
    """Yield what shows on standard error how many runs are done, how fast, and until when.

    A bar on a terminal, which vanishes at the end; some lines in a pipe.

    Parameters
    ----------
    total : int
    before : int
        Runs that were done before.
    """
    began, step = time.monotonic(), max(1, total // LINES)

    def words(done: int) -> str:
        """Return what is to be told."""
        return pace(done, before, total, time.monotonic() - began, datetime.now().astimezone())

    if not sys.stderr.isatty():
        told = [before]

        def line(done: int) -> None:
            """Write a line, if much has been done since the last one."""
            if done // step > told[0] // step:
                told[0] = done
                print(words(done), file=sys.stderr, flush=True)

        yield line
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn

    columns = BarColumn(), TextColumn("{task.description}")
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(f"{before} of {total} runs", total=total, completed=before)
        yield lambda done: bar.update(task, completed=done, description=words(done))


def pace(done: int, before: int, total: int, seconds: float, now: datetime) -> str:
    """Say how many runs are done, how fast it goes, and when it will end.

    Parameters
    ----------
    done, before, total : int
        Runs that are done, that were done at the start, and all.
    seconds : float [s]
        Since the start.
    now : datetime

    Examples
    --------
    >>> pace(3000, 1000, 9000, 10.0, datetime(2026, 3, 1, 12, 0))
    '3000 of 9000 runs, 200/s, until 12:00:30'
    >>> pace(20, 0, 60, 8000.0, datetime(2026, 3, 1, 23, 0))
    '20 of 60 runs, 0.0025/s, until 2026-03-02 03:26'
    """
    rate = (done - before) / max(seconds, 1e-9)
    end = now + timedelta(seconds=(total - done) / rate)
    until = f"{end:%H:%M:%S}" if end.date() == now.date() else f"{end:%Y-%m-%d %H:%M}"
    speed = f"{rate:.0f}" if rate >= 100.0 else f"{rate:.2g}"
    return f"{done} of {total} runs, {speed}/s, until {until}"
