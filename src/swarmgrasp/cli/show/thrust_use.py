"""How `swarmgrasp capability --use` tells its answer."""

import numpy as np

from swarmgrasp.capability import ThrustUse
from swarmgrasp.cli.show.all_round import (
    bare,
    clockwise_note,
    degrees,
    ranges,
    shown,
    speed_text,
    step_note,
    surroundings,
)
from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms

MOST_COLUMNS = 8
"""Robots that have a column each."""


def show(name: str, found: ThrustUse, terms: Terms) -> None:
    """Write thrust use over bearings for people."""
    report, tell = Report(), telling_of(terms, found.swarm, [])
    wind, busy = speed_text(found.speed, tell), found.busiest
    if found.held.all():
        said = f"held in {wind} from every bearing; busiest {_busiest(found, busy, tell)}"
        report.headline(f"{name}: {said}", "good")
    else:
        where = ranges(found.bearings.tolist(), ~found.held, tell)
        short = tell.force.text(float(found.shortfalls[busy]))
        said = f"not held in {wind} from {where}; most is missing from"
        report.headline(f"{name}: {said} {degrees(found.bearings[busy], tell)}, {short}", "bad")
    report.blank()
    report.facts(surroundings(found.environment, tell))
    report.blank()
    names = list(found.swarm.names) if len(found.swarm) <= MOST_COLUMNS else []
    columns = [
        Column("from [deg]", is_number=True), Column("busiest"), Column("share", is_number=True),
        *(Column(name, is_number=True, is_spare=True) for name in names),
    ]  # fmt: skip
    rows = [
        [bare(found.bearings[i], tell), found.busiest_at(i), _share(found, i, found.largest[i]),
         *(_share(found, i, share) for share in found.shares[i, : len(names)])]
        for i in shown(found.bearings, tell, busy)
    ]  # fmt: skip
    report.table(columns, rows, "bearings")
    step_note(report, found.bearings, len(rows))
    report.blank()
    report.note(clockwise_note(tell))
    report.note(
        f"Shares: parts of each {tell.terms.robot}'s limit; the largest is as small as it can be. "
        "They are those of a steady wind."
    )


def _busiest(found: ThrustUse, index: int, tell: Telling) -> str:
    """Say who is busiest at a bearing."""
    share = f"{100.0 * found.largest[index]:.0f} %"
    return f"{found.busiest_at(index)}, {share} from {degrees(found.bearings[index], tell)}"


def _share(found: ThrustUse, index: int, share: np.float64) -> str:
    """Return a share, for a table; nothing where the weather is not held."""
    return f"{100.0 * share:.0f} %" if found.held[index] else "not held"
