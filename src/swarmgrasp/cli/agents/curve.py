"""`swarmgrasp agents curve`: final quality against what is communicated."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from swarmgrasp.cli.show.page import checked_seed, told_page


def curve(
    folder: Path,
    /,
    *,
    quick: Annotated[bool, Parameter(negative="")] = False,
    seed: Annotated[str, Parameter(metavar="INT")] = "1",
) -> int:
    """Measure what robots must tell each other: final quality against what is communicated.

    Grows many swarms, each newcomer knowing everything of the others, summaries, some records,
    its neighbours, what can be seen, or nothing, and checks every sentence it writes. Takes
    some minutes.

    Exit status: 0 when all statements hold, 1 when one does not.

    Example: swarmgrasp agents curve report --quick

    Parameters
    ----------
    folder
        Folder to write communication.html, communication.md and the picture into, created if need
        be. Those of an earlier run are replaced; all appear at the end, or none.
    quick
        Measure less, in half a minute; the page says so.
    seed
        Of the random draws. The same seed gives the same numbers.
    """
    number = checked_seed(folder, seed)
    from swarmgrasp.agents.knowledge import FULL, QUICK
    from swarmgrasp.cli.progress import shown_progress
    from swarmgrasp.pages.curve import curve_steps, write_curve

    size = QUICK if quick else FULL
    with shown_progress(curve_steps(size), "growing swarms") as progress:
        page, _ = write_curve(folder, size, number, progress=progress)
    return told_page(page)
