"""`swarmgrasp move`: which one robot should attach elsewhere."""

from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from swarmgrasp.cli.criteria import criterion_of, losing_faults, unit_for
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.inputs import (
    UsageFault,
    json_faults,
    read_scenario,
    source_of,
)
from swarmgrasp.errors import SwarmGraspError

if TYPE_CHECKING:
    from swarmgrasp.cli.report import Forces, Report
    from swarmgrasp.placement import Move
    from swarmgrasp.swarm import Robot


def move(
    file: Dashed,
    /,
    *,
    losing: Annotated[str | None, Parameter(metavar="INT")] = None,
    worst_case: Annotated[bool, Parameter(negative="")] = False,
    json: Dashed | None = None,
) -> None:
    """Find the one robot that should attach elsewhere, and where.

    Each robot in turn lets go and is placed anew beside all the others. Prints the best
    move, what it is worth, what is left meanwhile, and the best move of every robot.

    Example: swarmgrasp move deck-barge

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as
        deck-barge. Robots may go where its newcomer may, and hold on as it does, each at
        its own limit; without a newcomer, anywhere and in any direction.
    losing
        Look at the quality after the worst loss of so many robots.
    worst_case
        Look at the quality in the worst poses that the robots' tolerances allow.
    json
        Also write the moves to this .json file; "-" prints them and nothing else. SI
        units and radians.
    """
    scenario = read_scenario(file, losing_faults(losing) + json_faults(json))
    criterion = criterion_of(scenario, file, losing, worst_case)
    from swarmgrasp.placement import best_move

    try:
        found = best_move(scenario.problem(criterion))
    except SwarmGraspError as error:
        source = source_of(file)
        raise UsageFault(f"{source}:1:1: {fault}" for fault in error.faults) from error
    from swarmgrasp.answer_file import document_of

    deliver(json, document_of(found, scenario.name), lambda: show(scenario.name, found))


def show(name: str, found: "Move") -> None:
    """Write moves for people."""
    from swarmgrasp.cli.gains import change, proven
    from swarmgrasp.cli.report import ALONG, NOTES, Report

    report, swarm, best = Report(), found.problem.swarm, found.best
    criterion, before = found.problem.criterion, found.quality_before
    most = max(found.upper_bound, before) or max(swarm.limits.tolist())
    unit = unit_for(criterion, most)
    label, facts = best.name, []
    if found.improves:
        report.headline(f"{name}: {label} had better be on {best.place}", "good")
        facts += [("From", _pose_words(found, best.old)), ("To", _pose_words(found, best.new))]
    else:
        report.headline(f"{name}: no robot had better be elsewhere", "caution")
    after = max(found.quality, before)
    facts.append(("Quality", change(before, after, unit)))
    if criterion.words:
        facts.append(("", criterion.words))
    if found.improves:
        facts.append(("Meanwhile", f"{unit.text(best.quality_without)} without {label}"))
    facts.append(("Proven", proven("move of one robot", found.upper_bound, after, unit)))
    facts.append(("Why", found.reason))
    report.blank()
    report.facts(facts)
    _table(report, found, unit)
    report.blank()
    report.note(f"Metric: {swarm.metric_sentence}.")
    for note in (*NOTES, ALONG):
        report.note(note)


def _pose_words(found: "Move", robot: "Robot") -> str:
    """Say where a robot is."""
    from swarmgrasp.cli.report import Lengths
    from swarmgrasp.cli.words import degrees, stance

    outline = found.problem.swarm.outline
    placed, lengths = stance(outline, robot), Lengths.for_outline(outline)
    where = f"{placed.where}, contact {lengths.point(robot.contact)}"
    return f"{where}, {degrees(robot.direction)} deg: {placed.way}"


def _table(report: "Report", found: "Move", unit: "Forces") -> None:
    """Write the best move of every robot."""
    from swarmgrasp.cli.gains import spot
    from swarmgrasp.cli.report import Column

    swarm = found.problem.swarm
    columns = [
        *(Column(text) for text in ("robot", "to")),
        *(Column(text, is_number=True) for text in ("x [m]", "y [m]")),
        Column("along [m]", is_number=True, is_spare=True),
        Column("to [deg]", is_number=True),
        Column(f"quality [{unit.name}]", is_number=True),
        Column(f"meanwhile [{unit.name}]", is_number=True),
        Column("off the normal [deg]", is_spare=True),
    ]
    rows = []
    for each in found.ranked:
        *figures, off = spot(swarm.outline, each.new)
        numbers = [unit.number(each.quality), unit.number(each.quality_without)]
        rows.append([each.name, each.place, *figures, *numbers, off])
    report.blank()
    report.headline("The best move of each robot")
    report.table(columns, rows)
