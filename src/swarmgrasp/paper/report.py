"""The paper made again: a report with its pictures, in a folder."""

import tempfile
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path

from swarmgrasp.paper.algorithm_1 import local_solver
from swarmgrasp.paper.measured import Measured, measure
from swarmgrasp.paper.page import Block, Picture, html_page, markdown
from swarmgrasp.paper.runner import Runner, workers
from swarmgrasp.paper.sections import PICTURES, TITLE, sections
from swarmgrasp.paper.sizes import FULL, Size
from swarmgrasp.paper.statements import Statement
from swarmgrasp.plot import save

MARKDOWN, HTML = "paper.md", "paper.html"
PICTURE = 15
"""A picture takes about as long as so many draws."""


@dataclass(frozen=True)
class Report:
    """What was written, and what it says.

    Attributes
    ----------
    paths : tuple of Path
        The page as HTML, the same as Markdown, and its pictures.
    statements : tuple of Statement
    """

    paths: tuple[Path, ...]
    statements: tuple[Statement, ...]

    @property
    def failed(self) -> tuple[Statement, ...]:
        """The statements that do not hold in this run."""
        return tuple(one for one in self.statements if not one.holds)


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
    return _write(Path(folder), found, runner)


def _write(folder: Path, found: Measured, runner: Runner) -> Report:
    """Write the report, whole."""
    blocks = sections(found)
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".paper-", dir=folder) as scratch:
        names = _draft(Path(scratch), blocks, runner)
        for name in names:
            (Path(scratch) / name).replace(folder / name)
    return Report(tuple(folder / name for name in names), tuple(found.every))


def _draft(scratch: Path, blocks: Sequence[Block], runner: Runner) -> list[str]:
    """Write all files to a scratch folder; return their names."""
    contents = {}
    for block in blocks:
        if isinstance(block, Picture):
            contents[block.name] = save(block.figure, scratch / block.name).read_bytes()
            runner.advance(PICTURE)
    (scratch / HTML).write_text(html_page(TITLE, blocks, contents), encoding="utf-8")
    (scratch / MARKDOWN).write_text(markdown(blocks), encoding="utf-8")
    return [HTML, MARKDOWN, *contents]
