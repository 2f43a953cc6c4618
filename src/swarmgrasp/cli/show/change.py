"""What a change of quality is called, and where robots are, in the reports of several commands."""

from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.outline import Outline
from swarmgrasp.placement import Together
from swarmgrasp.swarm import Robot
from swarmgrasp.swarm.force_words import heading
from swarmgrasp.swarm.stance import stance
from swarmgrasp.words import Lengths, Unit, percent

SAME = 1e-9
"""Relative difference of two qualities that is none."""
FINE = 1e-6
"""Relative difference, 0.0001 %, below which it is not told to the digit."""


def change(before: float, after: float, unit: Unit) -> str:
    """Say how a quality changes."""
    if abs(after - before) <= SAME * before:
        return f"stays {unit.text(before)}"
    share = "from none" if before == 0.0 else f"{after / before - 1.0:+.0%}".replace("%", " %")
    return f"{unit.number(before)} -> {unit.text(after)} ({share})"


def proven(what: str, bound: float, quality: float, unit: Unit) -> str:
    """Say how far a bound is above a quality: what else is better by how much at most."""
    told = f"(upper bound {unit.text(bound)})"
    if bound <= quality * (1.0 + SAME):
        return f"no {what} is better {told}"
    if quality == 0.0:
        return f"no {what} brings more than {unit.text(bound)}"
    share = max(bound / quality - 1.0, FINE)
    return f"no {what} is better by more than {percent(share)} {told}"


def spot(outline: Outline, robot: Robot) -> list[str]:
    """Return x, y, the arc length, the direction and what it is off the normal, for a table."""
    placed, lengths = stance(outline, robot), Lengths.for_extent(outline.extent)
    along = "" if placed.arc_length is None else lengths.number(placed.arc_length)
    return [*map(lengths.number, robot.contact), along, heading(robot), placed.short]


def show_robots(report: Report, found: Together) -> None:
    """Write where robots go that are placed together."""
    columns = [
        *(Column(text) for text in ("robot", "place")),
        *(Column(text, is_number=True) for text in ("x [m]", "y [m]")),
        Column("along [m]", is_number=True, is_spare=True),
        Column("to [deg]", is_number=True),
        Column("off the normal [deg]", is_spare=True),
    ]
    outline = found.problem.swarm.outline
    rows = [
        [robot.name, place, *spot(outline, robot)]
        for robot, place in zip(found.robots, found.places, strict=True)
    ]
    report.blank()
    report.table(columns, rows)
