"""`swarmgrasp paper`: the source paper made again."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from swarmgrasp.cli.show.page import checked_seed, told_page


def paper(
    folder: Path,
    /,
    *,
    quick: Annotated[bool, Parameter(negative="")] = False,
    seed: Annotated[str, Parameter(metavar="INT")] = "1",
) -> int:
    """Make the source paper again: its figures and numbers, and what is true.

    Runs the paper's Algorithm 1, with its misprints corrected, beside the true optimum on
    many random swarms, checks every sentence it writes, and takes a few minutes. Needs
    SciPy: pip install 'swarmgrasp[paper]'.

    Exit status: 0 when all statements hold, 1 when one does not.

    Example: swarmgrasp paper report --quick

    Parameters
    ----------
    folder
        Folder to write paper.html, paper.md and the pictures into, created if need be.
        Those of an earlier run are replaced; all appear at the end, or none.
    quick
        Measure less, in half a minute; the report says so.
    seed
        Of the random draws. The same seed gives the same numbers, but for the times.
    """
    number = checked_seed(folder, seed)
    from swarmgrasp.cli.progress import shown_progress
    from swarmgrasp.paper.report import report_steps, write_report
    from swarmgrasp.paper.sizes import FULL, QUICK

    size = QUICK if quick else FULL
    with shown_progress(report_steps(size), "making the paper again") as progress:
        page = write_report(folder, size, number, progress=progress)
    return told_page(page)
