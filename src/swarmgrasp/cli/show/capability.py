"""How `swarmgrasp capability` tells its answer."""

import math
from typing import Any

from swarmgrasp.capability import Capability
from swarmgrasp.cli.show.all_round import (
    bare,
    clockwise_note,
    decimals,
    degrees,
    ranges,
    rounded,
    second_unit,
    shown,
    speed_text,
    step_note,
    surroundings,
)
from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.environment import KNOT, beaufort_number
from swarmgrasp.quality import Criterion
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.units import SPEEDS
from swarmgrasp.words import wrench_words

MOST_SHOWN = 100.0
"""Winds above this [kn] are told as such: capability plots end here."""


def show(name: str, found: Capability, terms: Terms) -> None:
    """Write a capability for people."""
    report, tell = Report(), telling_of(terms, found.swarm, [])
    worst, after = float(found.intact.min()), float(found.after_loss.min())
    held = (
        f"holds {wind_text(found, worst, tell)} from any bearing"
        if worst
        else f"holds {none_words(found.bearings, found.intact == 0.0, tell)}"
    )
    report.headline(f"{name}: {held}", "good" if after else "caution" if worst else "bad")
    report.blank()
    report.facts(_facts(found, tell))
    report.blank()
    _show_bearings(report, found, tell)
    report.blank()
    for note in (
        clockwise_note(tell),
        f"The largest winds held beside {calm_words(found)}; loads are steady, and "
        f"{sea_words(found)}.",
    ):
        report.note(note)


def _facts(found: Capability, tell: Telling) -> list[tuple[str, str]]:
    """Tell the worst bearings, what limits the robots there, and the surroundings."""
    i, j = found.worst, found.worst_after_loss
    lost = found.lost_words(j)
    facts = [("Intact", _least(found, found.intact, i, found.holds_calm, tell))]
    if found.intact[i] > 0.0:
        weakest = wrench_words(found.directions[i])
        facts.append(("", f"there the {tell.terms.several} are weakest at {weakest}"))
    least = _least(found, found.after_loss, j, found.holds_calm_after_loss, tell)
    if found.failures:
        asked = Criterion(losing=found.losing, failures=found.failures)
        facts += [("After a failure", least), ("", asked.words(found.swarm, tell.terms.robot))]
    else:
        facts.append((f"Without {found.loss_words(tell.terms.robot)}", least))
    if lost:
        said = f"the worst {found.less_by} there: {lost}"
        facts.append(("", said if found.after_loss[j] > 0.0 else f"losing {lost} is enough"))
    return [*facts, *surroundings(found.environment, tell, worst_case=found.worst_case)]


def _least(found: Capability, speeds: Any, index: int, holds: Any, tell: Telling) -> str:
    """Tell the least of some winds [m/s] and where it comes from."""
    none = speeds == 0.0
    if not none.any():
        from_ = degrees(found.bearings[index], tell)
        return f"least from {from_}: {wind_text(found, speeds[index], tell)}"
    said = none_words(found.bearings, none, tell)
    if holds[none].all():
        return said
    return f"{said}{', in part' if holds[none].any() else ','} not even {calm_words(found)} alone"


def none_words(bearings: Any, none: Any, tell: Telling) -> str:
    """Say from which of some bearings (m,) [rad] no wind is held."""
    if none.all():
        return "no wind from any bearing"
    few = none.sum() <= 0.5 * len(none)
    where = ranges(bearings.tolist(), none if few else ~none, tell)
    return f"no wind {'from' if few else 'but from'} {where}"


def calm_words(found: Capability) -> str:
    """Say what is there without wind."""
    waves = found.environment.waves
    return "the current" if waves is None or waves.goes_with_wind else "current and waves"


def sea_words(found: Capability) -> str:
    """Say in a few words what of the sea is counted."""
    if found.environment.waves is None:
        return "there are no waves"
    if found.most_told == math.inf:
        return "of the waves the mean drift is counted"
    return f"of the waves the mean drift is counted, up to {decimals(found.most_told / KNOT)} kn"


def _show_bearings(report: Report, found: Capability, tell: Telling) -> None:
    """Write the table of bearings."""
    second = f"[{second_unit(tell)}]"
    columns = [
        *(Column(text, is_number=True) for text in ("from [deg]", "intact [kn]", second)),
        Column("Beaufort", is_number=True),
        *(Column(text, is_number=True) for text in (f"after a {found.less_by} [kn]", second)),
        Column("Beaufort", is_number=True), Column(f"worst {found.less_by}", is_spare=True),
    ]  # fmt: skip
    rows = [
        [
            bare(found.bearings[i], tell), *numbers(found, found.intact[i], tell),
            *numbers(found, found.after_loss[i], tell), found.lost_words(i),
        ]
        for i in shown(found.bearings, tell, found.worst, found.worst_after_loss)
    ]  # fmt: skip
    report.table(columns, rows, "bearings")
    step_note(report, found.bearings, len(rows))


def numbers(found: Capability, speed: float, tell: Telling) -> list[str]:
    """Return a wind [m/s] in knots, in the second unit and as Beaufort."""
    if speed == 0.0:
        return ["none", "", ""]
    limit, size = most(found), SPEEDS[second_unit(tell)]
    if speed >= limit:
        return [f">{rounded(limit / KNOT)}", f">{limit / size:.1f}", str(beaufort_number(limit))]
    return [decimals(speed / KNOT), decimals(speed / size), str(beaufort_number(speed))]


def most(found: Capability) -> float:
    """Return the wind [m/s] from which on winds are told as more than that."""
    return min(MOST_SHOWN * KNOT, found.most_told)


def wind_text(found: Capability, speed: float, tell: Telling) -> str:
    """Return a wind [m/s] as text."""
    if speed >= most(found):
        return f"more than {rounded(most(found) / KNOT)} kn"
    return f"{speed_text(speed, tell)[:-1]}, Beaufort {beaufort_number(speed)})"
