"""`swarmgrasp capability`: the wind the robots hold, at every bearing."""

import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from swarmgrasp.cli.criteria import criterion_of
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.inputs import PICTURES, blaming, json_faults, output_faults, read_scenario
from swarmgrasp.cli.question import asked_before, missing
from swarmgrasp.cli.wording import FILE, Wording

if TYPE_CHECKING:
    from swarmgrasp.environment import Environment
    from swarmgrasp.scenario import Scenario

FASTEST_CURRENT = 100.0
"""That may be asked for [kn]."""
STEP = 5.0
"""Degrees between the bearings unless told otherwise."""


def capability(
    file: Dashed,
    /,
    *,
    losing: Annotated[str | None, Parameter(metavar="INT")] = None,
    failures: Annotated[list[str] | None, Parameter(metavar="NAMES", negative="")] = None,
    worst_case: Annotated[bool, Parameter(negative="")] = False,
    step: float | None = None,
    current: Annotated[float | None, Parameter(metavar="KNOTS")] = None,
    plot: Path | None = None,
    json: Dashed | None = None,
    wording: Wording = FILE,
) -> None:
    """Tell the largest wind the robots hold from every bearing, intact and after a loss.

    Needs the scenario's environment: what the object shows to wind and current. The current
    comes from where the wind comes, unless the scenario says otherwise; so do the waves, if it
    has any. Loads are steady.

    Example: swarmgrasp capability supply-vessel --plot capability.png

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as
        supply-vessel. Its newcomer is left out. Or an answer of this command, whose options hold
        unless given anew.
    losing
        How many robots, or groups, are lost, the worst ones at each bearing; at least 1, the
        default without failures.
    failures
        After the worst of these failures, before any loss: a robot or a group by name, or several
        that fail together, with commas. Give it once for each: --failures "bus A" --failures
        Ajax,Boreas. Instead of those in the file. No robot is lost besides unless --losing says so.
    worst_case
        In the worst poses that the robots' tolerances allow.
    step
        Degrees between the bearings, 1 to 90; 5 unless given.
    current
        Speed of the current in knots, instead of the scenario's.
    plot
        Draw the capability plot, a polar diagram with the bow up, to this .png, .svg or
        .pdf file.
    json
        Also write the numbers to this .json file; "-" prints them and nothing else.
        SI units and radians.
    """
    faults = _number_faults(losing, step, current) + json_faults(json) + wording.faults(json)
    scenario = read_scenario(file, faults + output_faults(plot, PICTURES))
    environment = _environment(scenario, file, current)
    criterion = criterion_of(scenario, file, losing, worst_case, failures)
    import numpy as np

    from swarmgrasp.answer_file import document_of
    from swarmgrasp.capability import capability as capability_of
    from swarmgrasp.cli.show.capability import show

    bearings = asked_before(scenario, "capability").get("bearings") if step is None else None
    if bearings is None:
        bearings = np.radians(np.arange(0.0, 360.0 - 1e-9, step or STEP))
    with blaming(file):
        found = capability_of(
            scenario.swarm, environment, bearings, criterion.losing or int(not criterion.failures),
            criterion.worst_case, criterion.failures,
        )  # fmt: skip

    def draw() -> list[Path]:
        """Draw the diagram if it is wanted."""
        if plot is None:
            return []
        from swarmgrasp.plot import capability_diagram, save

        return [save(capability_diagram(found, scenario.name), plot)]

    document, terms = document_of(found, scenario.name), wording.terms(scenario)
    deliver(json, document, lambda: show(scenario.name, found, terms), draw, csv=wording.csv)


def _number_faults(losing: str | None, step: float | None, current: float | None) -> list[str]:
    """Return what is wrong with the numbers given as options."""
    faults = []
    # int() would also take 1_0, and cyclopts 1.5 and 0x2
    if losing is not None and not re.fullmatch(r"0*[1-9][0-9]{0,5}", losing):
        faults.append(f"--losing is {losing}; it should be a whole number, at least 1")
    if step is not None and not 1.0 <= step <= 90.0:
        faults.append(f"--step is {step:g}; it should be from 1 to 90 degrees")
    if current is not None and not 0.0 <= current <= FASTEST_CURRENT:
        faults.append(f"--current is {current:g}; it should be from 0 to {FASTEST_CURRENT:g} knots")
    return faults


def _environment(scenario: "Scenario", file: str, current: float | None) -> "Environment":
    """Return the environment to compute with.

    Raises
    ------
    UsageFault
        If the scenario has none, or no current whose speed could be set.
    """
    environment = scenario.environment
    if environment is None:
        advice = (
            "environment: is missing; say what the object shows to the wind, such as "
            "`environment: {wind: {vessel: offshore supply vessel, frontal_area: 280, "
            "lateral_area: 700}}`"
        )
        raise missing(scenario, file, "environment", "`swarmgrasp capability`", advice)
    if current is None:
        return environment
    if environment.current is None:
        advice = (
            "environment.current: is missing, so --current has nothing to set; say what the object "
            "shows to it, such as `current: {frontal_area: 110, lateral_area: 465}`"
        )
        raise missing(scenario, file, "current", "--current", advice)
    from swarmgrasp.environment import KNOT

    return replace(environment, current=replace(environment.current, speed=current * KNOT))
