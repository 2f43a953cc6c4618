"""What the commands that write a page into a folder share."""

import re
from pathlib import Path
from typing import TYPE_CHECKING

from swarmgrasp.cli.inputs import UsageFault
from swarmgrasp.cli.show.report import Report, told_written
from swarmgrasp.files import folder_faults

if TYPE_CHECKING:
    from swarmgrasp.pages.writing import Report as Page

FALSE = 1
"""Exit status when a statement does not hold."""


def checked_seed(folder: Path, seed: str) -> int:
    """Return the seed of a page's random draws.

    Raises
    ------
    UsageFault
        If it is none, or the folder cannot be written to; both at once.
    """
    faults = folder_faults(folder)
    if not re.fullmatch(r"[0-9]{1,9}", seed):  # int() would also take 1_0, and cyclopts 1.5
        faults.append(f"--seed is {seed}; it should be a whole number from 0 to 999999999")
    if faults:
        raise UsageFault(faults)
    return int(seed)


def told_page(page: "Page") -> int:
    """Tell how much of what a page states holds, and what was written; return the exit status."""
    report, count, failed = Report(), len(page.statements), page.failed
    if not failed:
        report.headline(f"All {count} statements of the report hold", "good")
    else:
        report.headline(f"{count - len(failed)} of {count} statements of the report hold", "bad")
        for one in failed:
            report.sentence(f"not so: {one.text}")
    report.blank()
    told_written(page.paths)
    return FALSE if failed else 0
