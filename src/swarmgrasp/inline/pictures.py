"""The picture of each kind of object: the same that the command line writes of it."""

from functools import singledispatch
from typing import Any

from matplotlib.figure import Figure

from swarmgrasp.capability import (
    Capability,
    CapabilityJoined,
    CapabilityNumbers,
    CapabilityPlacement,
    ThrustUse,
)
from swarmgrasp.forces import Forces, ForcesAlong
from swarmgrasp.outline import Outline
from swarmgrasp.placement import HowMany, Move, Placement, Placements, Problem, Together
from swarmgrasp.plot import (
    capability_diagram,
    forces_plan,
    numbers_diagram,
    plan,
    sensitivity_plan,
    thrust_use_picture,
)
from swarmgrasp.plot.sheet_of_run import run_sheet
from swarmgrasp.quality import Quality, Sensitivities, quality
from swarmgrasp.scenario import Scenario
from swarmgrasp.simulation import Run, verdict_of
from swarmgrasp.swarm import Swarm


def figure_of(shown: object, title: str = "", width: float | None = None) -> Figure:
    """Draw an object of any kind that can be drawn.

    Parameters
    ----------
    shown : object
    title : str
    width : float [in], optional
        The usual one when left out.
    """
    return draw(shown, {"title": title} | ({} if width is None else {"width": width}))


@singledispatch
def draw(shown: Any, look: dict[str, Any]) -> Figure:
    """Draw an object; `look` holds title and width."""
    raise NotImplementedError(f"{type(shown).__name__} has no picture")


@draw.register
def _(shown: Outline, look: dict[str, Any]) -> Figure:
    return plan(Swarm(shown, []), **look)


@draw.register
def _(shown: Swarm, look: dict[str, Any]) -> Figure:
    return plan(shown, quality=quality(shown), **look)


@draw.register
def _(shown: Quality, look: dict[str, Any]) -> Figure:
    return plan(shown.swarm, quality=shown, **look)


@draw.register
def _(shown: Problem, look: dict[str, Any]) -> Figure:
    zones = shown.zones or ()
    found = quality(shown.swarm, **shown.criterion.keywords)
    return plan(shown.swarm, quality=found, zones=zones, no_go=shown.no_go, **look)


@draw.register
def _(shown: Scenario, look: dict[str, Any]) -> Figure:
    around = {"environment": shown.environment, "terms": shown.terms}
    return draw(shown.problem(), {**look, **around, "title": look["title"] or shown.name})


@draw.register
def _(shown: Placement, look: dict[str, Any]) -> Figure:
    return draw(Placements([shown]), look)


@draw.register
def _(shown: Placements, look: dict[str, Any]) -> Figure:
    return _answered(shown[0].problem, shown, look)


@draw.register
def _(shown: Together, look: dict[str, Any]) -> Figure:
    return _answered(shown.problem, shown, look)


@draw.register
def _(shown: HowMany, look: dict[str, Any]) -> Figure:
    return draw(shown.problem if shown.answer is None else shown.answer, look)


@draw.register
def _(shown: Move, look: dict[str, Any]) -> Figure:
    return _answered(shown.problem, shown, look)


def _answered(problem: Problem, answer: Any, look: dict[str, Any]) -> Figure:
    """Draw a question with its answer."""
    before = quality(problem.swarm, **problem.criterion.keywords)
    return plan(problem.swarm, quality=before, placements=answer, **look)


@draw.register
def _(shown: Forces, look: dict[str, Any]) -> Figure:
    return forces_plan(shown, **look)


@draw.register
def _(shown: ForcesAlong, look: dict[str, Any]) -> Figure:
    return draw(shown.swarm, look)


@draw.register
def _(shown: Sensitivities, look: dict[str, Any]) -> Figure:
    return sensitivity_plan(shown, **look)


@draw.register
def _(shown: Capability, look: dict[str, Any]) -> Figure:
    return capability_diagram(shown, **look)


@draw.register
def _(shown: CapabilityNumbers, look: dict[str, Any]) -> Figure:
    return numbers_diagram(shown, **look)


@draw.register
def _(shown: CapabilityJoined, look: dict[str, Any]) -> Figure:
    return capability_diagram(shown.after, before=shown.before, **look)


@draw.register
def _(shown: CapabilityPlacement, look: dict[str, Any]) -> Figure:
    return draw(shown.placement, look)


@draw.register
def _(shown: ThrustUse, look: dict[str, Any]) -> Figure:
    return thrust_use_picture(shown, **look)


@draw.register
def _(shown: Run, look: dict[str, Any]) -> Figure:
    return run_sheet(shown, verdict_of(shown), **look)
