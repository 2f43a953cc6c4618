"""A bar on the terminal while many robots are placed."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

FEW = 20
"""Robots that are placed before anyone would look up."""


@contextmanager
def shown_progress(robots: int) -> Iterator[Callable[[int], None] | None]:
    """Yield what shows how many robots are placed, on standard error if that is a terminal.

    The bar vanishes at the end.
    """
    if robots <= FEW or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("placing robots", total=robots)
        yield lambda placed: bar.update(task, completed=placed)
