"""How `swarmgrasp verify` tells its verdict."""

import math
from typing import Any

from swarmgrasp.cli.show.report import Report
from swarmgrasp.swarm import Newcomer, Robot
from swarmgrasp.swarm.force_words import force_words, newcomer_words
from swarmgrasp.telling import Telling
from swarmgrasp.terms import SI
from swarmgrasp.verify import Verdict
from swarmgrasp.words import TIMES, Unit, list_words, machine_words, percent

FEWEST = 1e-12
"""Relative gap below which bound and answer count as equal."""


def largest_gap(document: dict[str, Any], verdict: Verdict) -> float | None:
    """Return the largest gap of all placements, relative to the answer; None if it is infinite."""
    pairs = zip(document["placements"], verdict.upper_bounds, strict=True)
    gap = max(gap_of(claim["quality"], bound) for claim, bound in pairs)
    return gap if math.isfinite(gap) else None


def gap_of(quality: float, bound: float) -> float:
    """Return by how much a bound exceeds a quality, relative to the quality.

    Examples
    --------
    >>> gap_of(2.0, 2.5), gap_of(2.0, 1.9999999), gap_of(0.0, 0.0), gap_of(0.0, 1.0)
    (0.25, 0.0, 0.0, inf)
    """
    if bound <= quality:
        return 0.0
    return (bound - quality) / quality if quality > 0.0 else math.inf


def show(name: str, document: dict[str, Any], verdict: Verdict) -> None:
    """Write a verdict for people."""
    report = Report()
    if verdict:
        report.headline(f"{name}: verified", "good")
    else:
        report.headline(f"{name}: refused, for {_count(len(verdict.faults), 'fault')}", "bad")
        for fault in verdict.faults:
            report.sentence(f"- {fault}")
        return
    report.blank()
    report.facts(_questions(document["problem"]) + _answers(document, verdict))
    report.blank()
    report.sentence(
        "Recomputed from the file alone: digest, contacts, directions, zones, qualities, and "
        "a bound for every allowed place."
    )
    for trusted in verdict.unchecked:
        report.sentence(f"Taken on trust: {trusted}.")
    report.sentence(
        "Checked is the answer to the question in the file, not whether the file asks your "
        "question; reasons given in words are not checked."
    )
    metric = document["problem"]["swarm"]
    a1, a2 = metric["force_weights"]
    report.note(
        f"Metric: force weights {a1:g} and {a2:g}, characteristic length "
        f"{metric['characteristic_length']:.6g} m."
    )


def _telling(problem: dict[str, Any]) -> Telling:
    """Choose how to tell the answer to a problem: with the prefix of the limits."""
    limits = [robot["limit"] for robot in problem["swarm"]["robots"]]
    return Telling.of(SI, 1.0, [problem["newcomer"]["limit"], *limits])


def _answers(document: dict[str, Any], verdict: Verdict) -> list[tuple[str, str]]:
    """Return as facts where each robot goes, its quality, and the bound recomputed."""
    problem, facts = document["problem"], list[tuple[str, str]]()
    tell = _telling(problem)
    unit = Unit(1.0, TIMES) if problem["criterion"]["task"] else tell.force
    for claim, bound in zip(document["placements"], verdict.upper_bounds, strict=True):
        robot = Robot.from_data(claim["robot"])
        x, y = robot.contact
        way = tell.direction(robot.direction) if robot.is_ray else force_words(robot, tell)
        before, after = unit.number(claim["quality_before"]), unit.text(claim["quality"])
        gap = gap_of(claim["quality"], bound)
        near = "the answer is the best possible, rounding aside"
        if FEWEST < gap < math.inf:
            near = f"the answer is at most {percent(gap)} below the best possible"
        facts += [
            (robot.name, f"at ({x:.6g}, {y:.6g}) m, {way}"),
            ("", f"quality {before} -> {after}" if claim["improves"] else f"quality {after}"),
            ("", f"no allowed place exceeds {unit.text(bound)}, by a bound recomputed"),
            *([("", near)] if math.isfinite(gap) else []),
        ]
    return facts


def _questions(problem: dict[str, Any]) -> list[tuple[str, str]]:
    """Return as facts what was asked, and by what criterion if not as things stand."""
    has_groups = any(robot["group"] for robot in problem["swarm"]["robots"])
    words = criterion_words(problem["criterion"], has_groups)
    return [("Question", _question(problem)), *([("", f"quality {words}")] if words else [])]


def criterion_words(criterion: dict[str, Any], has_groups: bool) -> str:
    """Say in words what a criterion asks, as a document has it; nothing if it is nominal.

    Examples
    --------
    >>> asked = {"losing": 2, "worst_case": False, "load": [0, 0.0, 0], "task": None}
    >>> criterion_words({**asked, "failures": [["bus A"], ["R1", "R2"]]}, has_groups=True)
    'after the failure of bus A or R1 and R2, after the worst loss of 2 robots or groups'
    """
    parts, task = [], criterion["task"]
    if criterion["worst_case"]:
        parts.append("in the worst poses that the tolerances allow")
    if failures := criterion["failures"]:
        parts.append(f"after the failure of {' or '.join(map(list_words, failures))}")
    if criterion["losing"]:
        lost = machine_words(criterion["losing"], has_groups)
        parts.append(f"after the worst loss of {criterion['losing']} {lost}")
    x, y, torque = criterion["load"]
    if (x, y, torque) != (0.0, 0.0, 0.0):
        parts.append(f"beside a load of ({x:.6g}, {y:.6g}) N and {torque:.6g} N m")
    if task and "vertices" in task:
        wrenches = _count(len(task["vertices"]), "wrench", "wrenches")
        parts.append(f"relative to a polytope of {wrenches}")
    elif task:
        parts.append(f"relative to an ellipsoid of {_count(len(task['axes']), 'axis', 'axes')}")
    return ", ".join(parts)


def _question(problem: dict[str, Any]) -> str:
    """Say what was asked: the newcomer, and where it may attach."""
    zones = problem["zones"]
    where = "the whole boundary" if zones is None else _count(len(zones), "zone")
    spacing = f"spacing {problem['spacing']:.6g} m" if problem["spacing"] else "no spacing"
    no_go = _count(len(problem["no_go"]), "no-go stretch", "no-go stretches")
    newcomer = newcomer_words(Newcomer.from_data(problem["newcomer"]), _telling(problem))
    return f"a robot of {newcomer}; {where}, {no_go}, {spacing}"


def _count(number: int, noun: str, several: str = "") -> str:
    """Return a number of things in words."""
    return f"{number or 'no'} {noun if number == 1 else several or noun + 's'}"
