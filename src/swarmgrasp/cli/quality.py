"""`swarmgrasp quality`: how well the robots hold the object."""

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from swarmgrasp.cli.criteria import criterion_data, criterion_of, losing_faults
from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import (
    UsageFault,
    json_faults,
    json_text,
    print_json,
    put_json,
    read_scenario,
    source_of,
)
from swarmgrasp.cli.report import told_written

if TYPE_CHECKING:
    from collections.abc import Sequence

    from swarmgrasp.quality import Loss, Quality
    from swarmgrasp.scenario import Scenario
    from swarmgrasp.swarm import Robot


def quality(
    file: Dashed,
    /,
    *,
    losing: Annotated[str | None, Parameter(metavar="INT")] = None,
    worst_case: Annotated[bool, Parameter(negative="")] = False,
    sensitivities: Annotated[bool, Parameter(negative="")] = False,
    json: Dashed | None = None,
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
    worst_case
        The quality in the worst poses that the robots' tolerances allow, and these poses.
    sensitivities
        Also what the quality gains or loses per metre of contact, per degree of direction and
        per unit of limit of each robot.
    json
        Also write the numbers to this .json file; "-" prints them and nothing else.
        SI units.
    """
    faults = json_faults(json) + losing_faults(losing)
    if worst_case and sensitivities:
        faults.append("--sensitivities are of known poses: leave out --worst-case")
    scenario = read_scenario(file, faults)
    criterion = criterion_of(scenario, file, losing, worst_case)
    if sensitivities and criterion.worst_case:
        raise UsageFault(
            f"{source_of(file)}: its criterion is the worst case, and --sensitivities are of known "
            "poses"
        )
    from swarmgrasp.quality import losses
    from swarmgrasp.quality import quality as quality_of

    found = quality_of(scenario.swarm, **criterion.terms)
    rest = replace(criterion, losing=0).terms
    lost = losses(scenario.swarm, **rest) if criterion.losing else ()
    data = data_of(scenario, found, lost)
    slopes = None
    if sensitivities:
        from swarmgrasp.cli.sensitivities import sensitivities_data
        from swarmgrasp.quality import sensitivities as sensitivities_of

        slopes = sensitivities_of(scenario.swarm, **criterion.terms)
        data["sensitivities"] = sensitivities_data(slopes)
    if json == DASH:
        print_json(json_text(data))
        return
    written = put_json(json, data)  # before the report, whose reader may leave
    from swarmgrasp.cli.graded import show

    show(scenario, found, lost, slopes)
    told_written(written)


def data_of(scenario: "Scenario", found: "Quality", lost: "Sequence[Loss]") -> dict[str, Any]:
    """Return a quality as plain data, in SI units."""
    swarm = scenario.swarm
    asked: dict[str, Any] = {}
    if not found.criterion.is_nominal:
        asked = {
            "criterion": criterion_data(found.criterion),
            "bound": found.bound,
            "lost": [swarm.robot_label(i) for i in found.lost],
            "worst_robots": [_robot_data(robot) for robot in found.worst_swarm.robots],
            "losses": [{"robot": loss.name, "quality": loss.quality} for loss in lost],
        }
    return {
        "name": scenario.name,
        **asked,
        "quality": found.value,
        "noise": found.noise,
        "force_closure": str(found.force_closure),
        "explanation": found.explanation.split("\n"),
        "weakest_direction": found.direction.tolist(),
        "weakest_wrench": found.weakest_wrench.tolist(),
        "weakest_robots": [swarm.robot_label(i) for i in found.facet_robots],
        "efficiency": None if found.criterion.task else found.efficiency,
        "metric": {
            "force_weights": list(swarm.force_weights),
            "characteristic_length": swarm.characteristic_length,
        },
    }


def _robot_data(robot: "Robot") -> dict[str, Any]:
    """Return a robot as plain data."""
    return {
        "name": robot.name,
        "contact": list(robot.contact),
        "direction": robot.direction,
        "limit": robot.limit,
    }
