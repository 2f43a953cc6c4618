"""Write a scenario as a file that people can edit, and that is read back to the last bit."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from swarmgrasp.environment import Environment
from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.files import write_whole
from swarmgrasp.placement import Problem
from swarmgrasp.plain import plain
from swarmgrasp.scenario.file_keys import FileKeys
from swarmgrasp.scenario.reading import parse_scenario
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.yaml_lines import lines

STRONG = 1000.0
"""Largest limit [N] from which on forces are in kilonewtons."""


def write(asked: Problem | Scenario, path: str | Path, **named: Any) -> None:
    """Write a problem or a scenario to a YAML file, whole or not at all.

    Parameters
    ----------
    asked : Problem or Scenario
    path : str or Path
    name, environment
        As for `scenario_text`.

    Raises
    ------
    ScenarioInvalid
        As for `scenario_text`.
    """
    write_whole(path, scenario_text(asked, **named).encode())


def scenario_text(
    asked: Problem | Scenario, *, name: str = "", environment: Environment | None = None
) -> str:
    """Return a problem or a scenario as the text of a YAML file.

    Lengths are in metres; angles in degrees and forces in kilonewtons where that loses nothing,
    else in radians and newtons. What is read of the text is equal to what was written.

    Parameters
    ----------
    asked : Problem or Scenario
    name : str
        A title for a problem; a scenario has its own.
    environment : Environment, optional
        Of a problem; a scenario has its own.

    Raises
    ------
    ScenarioInvalid
        If a scenario file cannot say it: numbers beyond what files may hold, robots of one name,
        ends of stretches next to a corner but not at it. All faults at once.

    Examples
    --------
    >>> from swarmgrasp import Newcomer, Outline, Problem, Robot, Swarm
    >>> barge = Outline([(0, 0), (4, 0), (4, 2), (0, 2)])
    >>> swarm = Swarm(barge, [Robot((4, 0.5), 3.14, 1.5, "Ajax")], 2.0)
    >>> print(scenario_text(Problem(swarm, Newcomer(2.0, "push")), name="Barge"), end="")
    name: Barge
    units: {length: m, force: N, angle: rad, speed: m/s}
    outline:
      vertices:
        - [0, 0]
        - [4, 0]
        - [4, 2]
        - [0, 2]
    metric: {characteristic_length: 2}
    robots:
      - {name: Ajax, contact: [4, 0.5], direction: 3.14, limit: 1.5}
    newcomer: {limit: 2, attachment: push}
    """
    scenario = asked if isinstance(asked, Scenario) else _scenario(asked, name, environment)
    limits = [float(scenario.swarm.limits.max(initial=0.0))]
    limits += [scenario.newcomer.limit] if scenario.newcomer else []
    file = FileKeys(Units(force="kN" if max(limits) >= STRONG else "N", angle="deg"))
    document = file.document(scenario)
    if file.lost:
        file = FileKeys(replace(file.units, **file.lost))
        document = file.document(scenario)
    text = "\n".join(lines(document)) + "\n"
    again = parse_scenario(text, "as written")
    faults = [*_differences(told(scenario), told(again), ())]
    if faults:
        raise ScenarioInvalid(faults)
    return text


def _scenario(problem: Problem, name: str, environment: Environment | None) -> Scenario:
    """Return the scenario of a problem."""
    return Scenario(
        name,
        "",
        problem.swarm,
        problem.newcomer,
        problem.zones,
        problem.no_go,
        problem.spacing,
        environment,
        problem.criterion,
    )


def told(scenario: Scenario) -> dict[str, Any]:
    """Return what is to come back of a scenario as plain data."""
    return {
        "problem": scenario.problem().to_data(),
        "has_newcomer": scenario.newcomer is not None,
        "environment": plain(scenario.environment),
        "description": scenario.description,
        "simulation": plain(scenario.simulation),
    }


def _differences(one: Any, other: Any, path: tuple[str, ...]) -> Iterator[str]:
    """Tell where plain data are not what they should be."""
    if isinstance(one, dict) and isinstance(other, dict):
        for key in one:
            yield from _differences(one[key], other[key], (*path, key))
    elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        for i, pair in enumerate(zip(one, other, strict=True)):
            yield from _differences(*pair, (*path, str(i)))
    elif one != other:
        yield f"{'.'.join(path)}: {one!r} would be read back as {other!r}; change it to that first"
