"""The pictures that commands write with `--plot`, and `plot`."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from swarmgrasp.cli.show.report import complain
from swarmgrasp.errors import ForceSetUnsupported, WrenchSetTooLarge

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from swarmgrasp.pages import page
    from swarmgrasp.placement import Move, Placement, Together
    from swarmgrasp.quality import Criterion
    from swarmgrasp.scenario import Scenario

Picture = Literal["plan", "wrenches", "landscape"]


def pictures(
    wanted: dict[Picture, Path],
    scenario: "Scenario",
    answers: "Sequence[Placement]",
    criterion: "Criterion",
    look: dict[str, Any],
) -> list[Path]:
    """Write pictures, once all of them are drawn.

    Parameters
    ----------
    wanted : dict of {"plan", "wrenches", "landscape"} to Path
        The suffix of a path is the format.
    scenario : Scenario
        The robots already there, and the weather.
    answers : sequence of Placement
        The newcomers; a landscape needs one, and shows what the first could choose from.
    criterion : Criterion
        What quality means.
    look : dict
        As from `Drawing.look`.

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
            drawn[path] = _figure(what, scenario, answers, criterion, look)
        except (ForceSetUnsupported, WrenchSetTooLarge) as error:
            if len(wanted) == 1:
                raise
            complain(f"{path}: not drawn: {fault}" for fault in error.faults)
    return [save(figure, path) for path, figure in drawn.items()]


def pictures_together(
    wanted: dict[Picture, Path], scenario: "Scenario", found: "Together", look: dict[str, Any]
) -> list[Path]:
    """Write the plan and the wrenches of newcomers that are placed together."""
    from swarmgrasp.plot import save, wrench_sets

    criterion = found.problem.criterion
    sets = wrench_sets(scenario.swarm, found.swarm_after, criterion=criterion, **look)
    drawn = {
        wanted["plan"]: _plan(scenario, found, criterion, look),
        wanted["wrenches"]: sets,
    }
    return [save(figure, path) for path, figure in drawn.items()]


def picture_of_plan(
    path: Path | None,
    scenario: "Scenario",
    answer: "Sequence[Placement] | Together | Move",
    criterion: "Criterion",
    look: dict[str, Any],
) -> list[Path]:
    """Write the plan alone, if a path is given for it."""
    if path is None:
        return []
    from swarmgrasp.plot import save

    return [save(_plan(scenario, answer, criterion, look), path)]


def _plan(
    scenario: "Scenario",
    answer: "Sequence[Placement] | Together | Move",
    criterion: "Criterion",
    look: dict[str, Any],
) -> "Figure":
    """Draw the object from above, with its robots, newcomers, zones and weather."""
    from swarmgrasp.plot import plan
    from swarmgrasp.quality import quality

    newcomer = scenario.newcomer
    return plan(
        scenario.swarm,
        quality=quality(scenario.swarm, **criterion.keywords),
        placements=answer,
        zones=(scenario.zones or ()) if newcomer else (),
        no_go=scenario.no_go if newcomer else (),
        environment=scenario.environment,
        **look,
    )


def _figure(
    what: Picture,
    scenario: "Scenario",
    answers: "Sequence[Placement]",
    criterion: "Criterion",
    look: dict[str, Any],
) -> "Figure":
    """Draw one picture."""
    from swarmgrasp.plot import landscape, wrench_sets

    if what == "plan":
        return _plan(scenario, answers, criterion, look)
    if what == "wrenches":
        after = answers[-1].swarm_after if answers else None
        return wrench_sets(scenario.swarm, after, criterion=criterion, **look)
    return landscape(answers[0], **look)


def drawing(name: str, figure: "Figure", caption: str) -> "page.Drawing":
    """Return a picture as a part of a page."""
    from swarmgrasp.pages.page import Drawing
    from swarmgrasp.plot import svg

    return Drawing(f"{name}.svg", svg(figure, name, caption), caption)
