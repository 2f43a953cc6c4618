"""`swarmgrasp quality`: how well the robots hold the object."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from swarmgrasp.cli.criteria import criterion_of, losing_faults
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.drawing import USUAL, Drawing
from swarmgrasp.cli.inputs import UsageFault, blaming, json_faults, read_scenario, source_of
from swarmgrasp.cli.question import asked_before, tell_omitted
from swarmgrasp.cli.weather import CALM, Weather
from swarmgrasp.cli.wording import FILE, Wording

if TYPE_CHECKING:
    from swarmgrasp.quality import Criterion, Loss
    from swarmgrasp.scenario import Scenario

MOST_TRIED = 100
"""Robots and groups up to which each is left out in turn to tell whether a load is held then."""


def quality(
    file: Dashed,
    /,
    *,
    losing: Annotated[str | None, Parameter(metavar="INT")] = None,
    failures: Annotated[list[str] | None, Parameter(metavar="NAMES", negative="")] = None,
    worst_case: Annotated[bool, Parameter(negative="")] = False,
    sensitivities: Annotated[bool, Parameter(negative="")] = False,
    plot: Path | None = None,
    drawing: Drawing = USUAL,
    json: Dashed | None = None,
    weather: Weather = CALM,
    wording: Wording = FILE,
) -> None:
    """Tell how well the robots hold the object, and where worst.

    The quality is the force, in newtons, that the robots can exert in every direction,
    turning included: the worst direction decides. It is 0 without force closure.

    Example: swarmgrasp quality supply-vessel --losing 1

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as
        supply-vessel. Its newcomer is left out.
    losing
        The quality after the worst loss of so many robots, and what the loss of each robot
        leaves.
    failures
        The quality after the worst of these failures, before any loss: a robot or a group by
        name, or several that fail together, with commas. Give it once for each:
        --failures "bus A" --failures Ajax,Boreas. Instead of those in the file.
    worst_case
        The quality in the worst poses that the robots' tolerances allow, and these poses.
    sensitivities
        Also what the quality gains or loses per metre of contact, per degree of direction and of
        the ends of what steers, and per unit of limit and of reverse limit of each robot.
    plot
        Draw the plan to this .png, .svg or .pdf: the object from above with its robots, its zones,
        the weather and the wrench that is weakest.
    json
        Also write the numbers to this .json file; "-" prints them and nothing else.
        SI units.
    """
    faults = json_faults(json) + wording.faults(json) + losing_faults(losing)
    faults += drawing.faults(plot)
    if worst_case and sensitivities:
        faults.append("--sensitivities are of known poses: leave out --worst-case")
    scenario = weather.on(read_scenario(file, faults + weather.faults()), file, wording)
    criterion = criterion_of(scenario, file, losing, worst_case, failures)
    sensitivities |= asked_before(scenario, "quality").get("sensitivities") is not None
    if sensitivities and criterion.worst_case:
        raise UsageFault(
            f"{source_of(file)}: its criterion is the worst case, and --sensitivities are of known "
            "poses"
        )
    tell_omitted(
        scenario, file, "quality",
        losing=losing, failures=failures, worst_case=worst_case,
        load=weather.given, task=None,
    )  # fmt: skip
    from swarmgrasp.answer_file import sealed
    from swarmgrasp.plain import plain
    from swarmgrasp.quality import losses
    from swarmgrasp.quality import quality as quality_of
    from swarmgrasp.quality import sensitivities as sensitivities_of

    with blaming(file):
        found = quality_of(scenario.swarm, **criterion.keywords)
        rest = replace(criterion, losing=0).keywords
        lost = losses(scenario.swarm, **rest) if criterion.losing else ()
        slopes = sensitivities_of(scenario.swarm, **criterion.keywords) if sensitivities else None
        alone = _alone(scenario, criterion)
    told = {**found.to_data(), "losses": plain(lost), "sensitivities": plain(slopes)}
    from swarmgrasp.cli.pictures import picture_of_plan
    from swarmgrasp.cli.show.quality import show

    terms = wording.terms(scenario)
    deliver(
        json,
        sealed(found.kind, told, scenario.name, terms=scenario.terms),
        lambda: show(scenario, found, lost, slopes, terms, alone),
        lambda: picture_of_plan(plot, scenario, (), criterion, drawing.look(scenario.name, terms)),
        csv=wording.csv,
    )


def _alone(scenario: "Scenario", criterion: "Criterion") -> "tuple[Loss, ...] | None":
    """Return what the loss of each robot or group leaves beside a load, if that is soon known."""
    from swarmgrasp.quality import losses

    machines = int(scenario.swarm.machines.max(initial=-1)) + 1
    if not criterion.has_load or criterion.is_of_worst or machines > MOST_TRIED:
        return None
    return losses(scenario.swarm, **replace(criterion, task=None).keywords)
