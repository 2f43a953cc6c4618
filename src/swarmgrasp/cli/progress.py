"""A bar on the terminal while a command takes its time."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

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
