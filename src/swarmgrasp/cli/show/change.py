"""What a change of quality is called, and where robots are, in the reports of several commands."""

from collections.abc import Sequence

from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.outline import Outline
from swarmgrasp.placement import Together
from swarmgrasp.quality import Criterion
from swarmgrasp.swarm import Newcomer, Robot, Swarm
from swarmgrasp.swarm.force_words import heading
from swarmgrasp.swarm.stance import stance
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.words import TIMES, Unit, percent

MANY = 100.0
"""Times the largest limit up to which a force is told with the prefix of the limits."""
SAME = 1e-9
"""Relative difference of two qualities that is none."""
FINE = 1e-6
"""Relative difference, 0.0001 %, below which it is not told to the digit."""


def telling_of(
    terms: Terms, swarm: Swarm, sizes: Sequence[float], newcomer: Newcomer | None = None
) -> Telling:
    """Choose how to tell an answer.

    Parameters
    ----------
    terms : Terms
    swarm : Swarm
    sizes : sequence of float [N]
        Forces of the answer, beside the limits.
    newcomer : Newcomer, optional
    """
    limit = max(float(swarm.limits.max(initial=0.0)), newcomer.limit if newcomer else 0.0)
    largest = max(sizes, default=0.0) / (MANY if limit else 1.0)
    return Telling.of(terms, swarm.outline.extent, [limit, largest])


def unit_of(criterion: Criterion, tell: Telling) -> Unit:
    """Return the unit of qualities: that of forces, or times the task if there is one."""
    return tell.force if criterion.task is None else Unit(1.0, TIMES)


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


def spot_columns(tell: Telling) -> list[Column]:
    """Return the columns of x, y, the arc length and the direction."""
    return [*xy_columns(tell), along_column(tell), Column(tell.way, is_number=True)]


def xy_columns(tell: Telling) -> list[Column]:
    """Return the columns of x and y."""
    return [Column(f"{axis} [{tell.length.name}]", is_number=True) for axis in "xy"]


def along_column(tell: Telling) -> Column:
    """Return the column of the arc length."""
    return Column(f"along [{tell.length.name}]", is_number=True, is_spare=True)


def spot(outline: Outline, robot: Robot, tell: Telling) -> list[str]:
    """Return x, y, the arc length, the direction and what it is off the normal, for a table."""
    placed = stance(outline, robot)
    along = ""
    if placed.arc_length is not None:
        along = tell.length.number(tell.arc(placed.arc_length, outline.perimeter))
    return [*tell.xy(robot.contact), along, heading(robot, tell), placed.short]


def room_facts(newcomer: Newcomer, tell: Telling) -> list[tuple[str, str]]:
    """Tell how much room a newcomer takes up, if it has a body."""
    body = newcomer.body
    return [] if body is None else [("", tell.room(body.length, body.beam))]


def show_robots(report: Report, found: Together, tell: Telling) -> None:
    """Write where robots go that are placed together."""
    columns = [
        *(Column(text) for text in (tell.terms.robot, "place")),
        *spot_columns(tell),
        Column("off the normal [deg]", is_spare=True),
    ]
    outline = found.problem.swarm.outline
    rows = [
        [robot.name, place, *spot(outline, robot, tell)]
        for robot, place in zip(found.robots, found.places, strict=True)
    ]
    report.blank()
    report.table(columns, rows, "robots")
