"""How `swarmgrasp place --where-not` tells where a newcomer may attach, and where not."""

from collections.abc import Sequence

from swarmgrasp.cli.show.change import unit_of
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.placement import Placement
from swarmgrasp.placement.grounds import Ground
from swarmgrasp.telling import Telling
from swarmgrasp.words import percent

SAME = 1e-9
"""Relative difference of two qualities that is none."""


def show_grounds(
    report: Report, answer: Placement, survey: Sequence[Ground], tell: Telling
) -> None:
    """Write the table of all zones and edges."""
    unit, length = unit_of(answer.problem.criterion, tell), tell.length
    columns = [
        Column("place"),
        Column(f"length [{length.name}]", is_number=True),
        Column(f"allowed [{length.name}]", is_number=True),
        Column(f"quality [{unit.name}]", is_number=True),
        Column("gain", is_number=True),
        Column("the rest is taken by", is_spare=True),
    ]
    before = answer.quality_before
    rows = []
    for ground in survey:
        best = before if ground.best is None else max(ground.best.quality, before)
        allowed = length.number(ground.allowed) if ground.length else "yes"
        rows.append([
            ground.place, length.number(ground.length) if ground.length else "",
            allowed if ground.is_allowed else "no",
            unit.number(best) if ground.is_allowed else "",
            _gain(answer, best) if ground.is_allowed else "",
            ", ".join(_taken(what, much, ground, tell) for what, much in ground.excluded),
        ])  # fmt: skip
    report.blank()
    report.headline(f"Where {answer.robot.name} may attach, and where not")
    report.table(columns, rows, "places")


def _gain(answer: Placement, best: float) -> str:
    """Say by what share a quality grows, by more than rounding."""
    before = answer.quality_before
    if best <= before * (1.0 + SAME) + answer.noise:
        return "none"
    return f"+{percent(best / before - 1.0)}" if before else "from none"


def _taken(what: str, much: float, ground: Ground, tell: Telling) -> str:
    """Say what takes how much of a place; how much only if it is not all of it."""
    if len(ground.excluded) == 1 and not ground.is_allowed:
        return what
    return f"{what} ({tell.length.text(much)})" if much else what
