"""The paper made again: a report with its pictures, in a folder."""

from collections.abc import Callable
from contextlib import nullcontext
from pathlib import Path

from swarmgrasp.pages.runner import Runner, workers
from swarmgrasp.pages.writing import Report, write
from swarmgrasp.paper.algorithm_1 import local_solver
from swarmgrasp.paper.measured import measure
from swarmgrasp.paper.sections import PICTURES, TITLE, sections
from swarmgrasp.paper.sizes import FULL, Size

NAME = "paper"
"""Of the page's files."""
PICTURE = 15
"""A picture takes about as long as so many draws."""


def report_steps(size: Size) -> int:
    """Return how far a progress bar goes."""
    return size.steps + PICTURE * PICTURES


def write_report(
    folder: str | Path,
    size: Size = FULL,
    seed: int = 1,
    *,
    progress: Callable[[int], object] | None = None,
    in_processes: bool = True,
) -> Report:
    """Measure everything the source paper shows, and write a report on it.

    Parameters
    ----------
    folder : str or Path
        Created if need be. Files of an earlier report in it are replaced; all appear at the end,
        or none.
    size : Size
        How much to measure.
    seed : int
        Of the random draws, at least 0.
    progress : callable, optional
        Called with a number that goes up to `report_steps`.
    in_processes : bool
        Measure in processes of their own, one for each core; otherwise in this one. A script that
        asks for them should do so under ``if __name__ == "__main__":``.

    Returns
    -------
    Report

    Raises
    ------
    PackageMissing
        If SciPy is not installed.
    OSError
        If the folder cannot be written to.
    """
    local_solver()  # missing, it is missed before anything is measured
    with workers() if in_processes else nullcontext() as executor:
        runner = Runner(executor, progress)
        found = measure(runner, size, seed)
    blocks = sections(found)
    return write(Path(folder), NAME, TITLE, blocks, found.every, lambda: runner.advance(PICTURE))
