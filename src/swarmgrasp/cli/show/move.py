"""How `swarmgrasp move` tells its answer."""

from swarmgrasp.cli.show.change import (
    change,
    proven,
    spot,
    spot_columns,
    telling_of,
    unit_of,
)
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.placement import Move
from swarmgrasp.swarm import Robot
from swarmgrasp.swarm.force_words import force_words
from swarmgrasp.swarm.stance import stance
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.words import Unit, list_words

MOST_NAMED = 8
"""Robots that were not looked at and are named."""


def show(name: str, found: Move, terms: Terms) -> None:
    """Write moves for people."""
    report, swarm, best = Report(), found.problem.swarm, found.best
    criterion, before = found.problem.criterion, found.quality_before
    tell = telling_of(terms, swarm, [found.upper_bound, before])
    unit = unit_of(criterion, tell)
    label, facts = best.name, []
    if found.improves:
        report.headline(f"{name}: {label} had better be on {best.place}", "good")
        facts += [("From", _pose_words(found, best.old, tell))]
        facts += [("To", _pose_words(found, best.new, tell))]
    else:
        none = f"none of the {terms.several} looked at" if found.untried else f"no {terms.robot}"
        report.headline(f"{name}: {none} had better be elsewhere", "caution")
    after = max(found.quality, before)
    facts.append(("Quality", change(before, after, unit)))
    if words := criterion.words(swarm, terms.robot):
        facts.append(("", words))
    if found.improves:
        facts.append(("Meanwhile", f"{unit.text(best.quality_without)} without {label}"))
    one = f"move of one {terms.robot}" if not found.untried else "move of those looked at"
    facts.append(("Proven", proven(one, found.upper_bound, after, unit)))
    if found.untried:
        facts.append(("Open", _untried_words(found)))
    facts.append(("Why", found.reason_in(terms)))
    report.blank()
    report.facts(facts)
    _table(report, found, unit, tell)
    report.small_print(swarm, tell, tell.along())


def _untried_words(found: Move) -> str:
    """Say whose moves were not looked at."""
    more = found.untried[MOST_NAMED:]
    who = list_words([*found.untried[:MOST_NAMED], *([f"{len(more)} more"] if more else [])])
    return f"Ctrl-C ended the search before {who}"


def _pose_words(found: Move, robot: Robot, tell: Telling) -> str:
    """Say where a robot is."""
    placed = stance(found.problem.swarm.outline, robot)
    where = f"{placed.where}, contact {tell.point(robot.contact)}"
    way = tell.direction(robot.direction) if robot.is_ray else force_words(robot, tell)
    return f"{where}, {way}: {placed.way}"


def _table(report: Report, found: Move, unit: Unit, tell: Telling) -> None:
    """Write the best move of every robot."""
    swarm = found.problem.swarm
    columns = [
        *(Column(text) for text in (tell.terms.robot, "place")),
        *spot_columns(tell),
        Column(f"quality [{unit.name}]", is_number=True),
        Column(f"meanwhile [{unit.name}]", is_number=True),
        Column("off the normal [deg]", is_spare=True),
    ]
    rows = []
    for each in found.ranked:
        *figures, off = spot(swarm.outline, each.new, tell)
        numbers = [unit.number(each.quality), unit.number(each.quality_without)]
        rows.append([each.name, each.place, *figures, *numbers, off])
    report.blank()
    report.headline(f"The best move of each {tell.terms.robot}")
    report.table(columns, rows, "moves")
