"""`swarmgrasp paper`: the source paper made again."""

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from swarmgrasp.cli.inputs import UsageFault
from swarmgrasp.cli.show.report import told_written
from swarmgrasp.files import folder_faults

if TYPE_CHECKING:
    from swarmgrasp.paper.report import Report


def paper(
    folder: Path,
    /,
    *,
    quick: Annotated[bool, Parameter(negative="")] = False,
    seed: Annotated[str, Parameter(metavar="INT")] = "1",
) -> None:
    """Make the source paper again: its figures and numbers, and what is true.

    Runs the paper's Algorithm 1, with its misprints corrected, beside the true optimum on
    many random swarms, checks every sentence it writes, and takes a few minutes. Needs
    SciPy: pip install 'swarmgrasp[paper]'.

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
    faults = folder_faults(folder)
    if not re.fullmatch(r"[0-9]{1,9}", seed):  # int() would also take 1_0, and cyclopts 1.5
        faults.append(f"--seed is {seed}; it should be a whole number from 0 to 999999999")
    if faults:
        raise UsageFault(faults)
    from swarmgrasp.cli.progress import shown_progress
    from swarmgrasp.paper.report import report_steps, write_report
    from swarmgrasp.paper.sizes import FULL, QUICK

    size = QUICK if quick else FULL
    with shown_progress(report_steps(size), "making the paper again") as progress:
        written = write_report(folder, size, int(seed), progress=progress)
    _show(written)
    told_written(written.paths)


def _show(written: "Report") -> None:
    """Tell how much of what the report states holds."""
    from swarmgrasp.cli.show.report import Report

    report, count, failed = Report(), len(written.statements), written.failed
    if not failed:
        report.headline(f"All {count} statements of the report hold", "good")
    else:
        report.headline(f"{count - len(failed)} of {count} statements of the report hold", "bad")
        for one in failed:
            report.sentence(f"not so: {one.text}")
    report.blank()
