"""How `swarmgrasp move` tells its answer."""

from swarmgrasp.cli.show.change import change, proven, spot
from swarmgrasp.cli.show.report import ALONG, Column, Report
from swarmgrasp.placement import Move
from swarmgrasp.swarm import Robot
from swarmgrasp.swarm.force_words import force_words
from swarmgrasp.swarm.stance import stance
from swarmgrasp.words import Lengths, Unit, degrees


def show(name: str, found: Move) -> None:
    """Write moves for people."""
    report, swarm, best = Report(), found.problem.swarm, found.best
    criterion, before = found.problem.criterion, found.quality_before
    most = max(found.upper_bound, before) or max(swarm.limits.tolist())
    unit = criterion.unit(most)
    label, facts = best.name, []
    if found.improves:
        report.headline(f"{name}: {label} had better be on {best.place}", "good")
        facts += [("From", _pose_words(found, best.old)), ("To", _pose_words(found, best.new))]
    else:
        report.headline(f"{name}: no robot had better be elsewhere", "caution")
    after = max(found.quality, before)
    facts.append(("Quality", change(before, after, unit)))
    if words := criterion.words(swarm):
        facts.append(("", words))
    if found.improves:
        facts.append(("Meanwhile", f"{unit.text(best.quality_without)} without {label}"))
    facts.append(("Proven", proven("move of one robot", found.upper_bound, after, unit)))
    facts.append(("Why", found.reason))
    report.blank()
    report.facts(facts)
    _table(report, found, unit)
    report.small_print(swarm, ALONG)


def _pose_words(found: Move, robot: Robot) -> str:
    """Say where a robot is."""
    outline = found.problem.swarm.outline
    placed, lengths = stance(outline, robot), Lengths.for_extent(outline.extent)
    where = f"{placed.where}, contact {lengths.point(robot.contact)}"
    way = f"{degrees(robot.direction)} deg" if robot.is_ray else force_words(robot)
    return f"{where}, {way}: {placed.way}"


def _table(report: Report, found: Move, unit: Unit) -> None:
    """Write the best move of every robot."""
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
