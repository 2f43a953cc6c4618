"""The pictures that `place --plot` and `plot` write."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from swarmgrasp.cli.show.report import complain
from swarmgrasp.errors import ForceSetUnsupported, WrenchSetTooLarge

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from swarmgrasp.pages.page import Drawing
    from swarmgrasp.placement import Placement, Together
    from swarmgrasp.quality import Criterion
    from swarmgrasp.swarm import Swarm

Picture = Literal["plan", "wrenches", "landscape"]


def pictures(
    wanted: dict[Picture, Path],
    swarm: "Swarm",
    answers: "Sequence[Placement]",
    criterion: "Criterion",
) -> list[Path]:
    """Write pictures, once all of them are drawn.

    Parameters
    ----------
    wanted : dict of {"plan", "wrenches", "landscape"} to Path
        The suffix of a path is the format.
    swarm : Swarm
        The robots already there.
    answers : sequence of Placement
        The newcomers; a landscape needs one, and shows what the first could choose from.
    criterion : Criterion
        What quality means.

    Returns
    -------
    list of Path
        Those written: of several pictures, a wrench set with too many faces, and the landscape of a
        mounted newcomer, are left out with a word on standard error.
    """
    from swarmgrasp.plot import save

    drawn = {}
    for what, path in wanted.items():
        try:
            drawn[path] = _figure(what, swarm, answers, criterion)
        except (ForceSetUnsupported, WrenchSetTooLarge) as error:
            if len(wanted) == 1:
                raise
            complain(f"{path}: not drawn: {fault}" for fault in error.faults)
    return [save(figure, path) for path, figure in drawn.items()]


def pictures_together(wanted: dict[Picture, Path], found: "Together") -> list[Path]:
    """Write the plan and the wrenches of newcomers that are placed together."""
    from swarmgrasp.plot import plan, save, wrench_sets
    from swarmgrasp.quality import quality

    criterion, after = found.problem.criterion, found.swarm_after
    drawn = {
        wanted["plan"]: plan(after, quality=quality(after, **criterion.terms)),
        wanted["wrenches"]: wrench_sets(found.problem.swarm, after, criterion=criterion),
    }
    return [save(figure, path) for path, figure in drawn.items()]


def _figure(
    what: Picture, swarm: "Swarm", answers: "Sequence[Placement]", criterion: "Criterion"
) -> "Figure":
    """Draw one picture."""
    from swarmgrasp.plot import landscape, plan, wrench_sets
    from swarmgrasp.quality import quality

    if what == "plan":
        return plan(swarm, quality=quality(swarm, **criterion.terms), placements=answers)
    if what == "wrenches":
        after = answers[-1].swarm_after if answers else None
        return wrench_sets(swarm, after, criterion=criterion)
    return landscape(answers[0])


def drawing(name: str, figure: "Figure", caption: str) -> "Drawing":
    """Return a picture as a part of a page."""
    from swarmgrasp.pages.page import Drawing
    from swarmgrasp.plot import svg

    return Drawing(f"{name}.svg", svg(figure, name, caption), caption)
