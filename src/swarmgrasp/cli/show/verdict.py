"""How `swarmgrasp verify` tells its verdict."""

import math
from typing import Any

from swarmgrasp.cli.show.report import Report, metric_words
from swarmgrasp.swarm import Newcomer, Robot
from swarmgrasp.swarm.force_words import force_words, newcomer_words
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.verify import Verdict
from swarmgrasp.words import TIMES, Unit, list_words, percent

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


def show(name: str, document: dict[str, Any], verdict: Verdict, terms: Terms) -> None:
    """Write a verdict for people."""
    report, tell = Report(), _telling(document["problem"], terms)
    if verdict:
        report.headline(f"{name}: verified", "good")
    else:
        report.headline(f"{name}: refused, for {_count(len(verdict.faults), 'fault')}", "bad")
        for fault in verdict.faults:
            report.sentence(f"- {fault}")
        return
    report.blank()
    report.facts(_questions(document["problem"], tell) + _answers(document, verdict, tell))
    report.blank()
    report.sentence(
        "Recomputed from the file alone: digest, contacts, directions, zones, qualities, and "
        "a bound for every allowed place."
    )
    for trusted in verdict.unchecked:
        report.sentence(f"Taken on trust: {trusted}.")
    report.sentence(
        "This checks the answer to the question in the file. It does not check whether the file "
        "asks your question, nor reasons given in words."
    )
    swarm = document["problem"]["swarm"]
    report.note(metric_words(swarm["force_weights"], swarm["characteristic_length"], tell))
    for note in tell.notes():
        report.note(note)


def _telling(problem: dict[str, Any], terms: Terms) -> Telling:
    """Choose how to tell the answer to a problem: with the prefix of the limits."""
    limits = [robot["limit"] for robot in problem["swarm"]["robots"]]
    vertices = problem["swarm"]["outline"]["vertices"]
    extent = math.dist(*(map(of, zip(*vertices, strict=True)) for of in (min, max)))
    return Telling.of(terms, extent, [problem["newcomer"]["limit"], *limits])


def _answers(document: dict[str, Any], verdict: Verdict, tell: Telling) -> list[tuple[str, str]]:
    """Return as facts where each robot goes, its quality, and the bound recomputed."""
    problem, facts = document["problem"], list[tuple[str, str]]()
    unit = Unit(1.0, TIMES) if problem["criterion"]["task"] else tell.force
    for claim, bound in zip(document["placements"], verdict.upper_bounds, strict=True):
        robot = Robot.from_data(claim["robot"])
        way = tell.direction(robot.direction) if robot.is_ray else force_words(robot, tell)
        before, after = unit.number(claim["quality_before"]), unit.text(claim["quality"])
        gap = gap_of(claim["quality"], bound)
        near = "the answer is the best possible, rounding aside"
        if FEWEST < gap < math.inf:
            near = f"the answer is at most {percent(gap)} below the best possible"
        facts += [
            (robot.name, f"at {tell.point(robot.contact)}, {way}"),
            ("", f"quality {before} -> {after}" if claim["improves"] else f"quality {after}"),
            ("", f"no allowed place exceeds {unit.text(bound)}, by a bound recomputed"),
            *([("", near)] if math.isfinite(gap) else []),
        ]
    return facts


def _questions(problem: dict[str, Any], tell: Telling) -> list[tuple[str, str]]:
    """Return as facts what was asked, and by what criterion if not as things stand."""
    has_groups = any(robot["group"] for robot in problem["swarm"]["robots"])
    words = _criterion_words(problem, has_groups, tell)
    return [("Question", _question(problem, tell)), *([("", f"quality {words}")] if words else [])]


def _criterion_words(problem: dict[str, Any], has_groups: bool, tell: Telling) -> str:
    """Say in words what the criterion of a problem asks; nothing if it is nominal."""
    criterion = problem["criterion"]
    parts, task = [], criterion["task"]
    if criterion["worst_case"]:
        parts.append("in the worst poses that the tolerances allow")
    if failures := criterion["failures"]:
        parts.append(f"after the failure of {' or '.join(map(list_words, failures))}")
    if criterion["losing"]:
        lost = tell.machines(criterion["losing"], has_groups)
        parts.append(f"after the worst loss of {criterion['losing']} {lost}")
    if any(criterion["load"]):
        load = tell.wrench(criterion["load"], problem["swarm"]["characteristic_length"])
        parts.append(f"beside a load of {list_words(load)}")
    if task and "vertices" in task:
        wrenches = _count(len(task["vertices"]), "wrench", "wrenches")
        parts.append(f"relative to a polytope of {wrenches}")
    elif task:
        parts.append(f"relative to an ellipsoid of {_count(len(task['axes']), 'axis', 'axes')}")
    return ", ".join(parts)


def _question(problem: dict[str, Any], tell: Telling) -> str:
    """Say what was asked: the newcomer, and where it may attach."""
    zones = problem["zones"]
    where = "the whole boundary" if zones is None else _count(len(zones), "zone")
    spacing = (
        f"spacing {tell.length.short(problem['spacing'])}" if problem["spacing"] else "no spacing"
    )
    no_go = _count(len(problem["no_go"]), "no-go stretch", "no-go stretches")
    newcomer = newcomer_words(Newcomer.from_data(problem["newcomer"]), tell)
    return f"a {tell.terms.robot} of {newcomer}; {where}, {no_go}, {spacing}"


def _count(number: int, noun: str, several: str = "") -> str:
    """Return a number of things in words."""
    return f"{number or 'no'} {noun if number == 1 else several or noun + 's'}"
