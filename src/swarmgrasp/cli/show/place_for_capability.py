"""How `swarmgrasp place --for capability` tells its answer."""

import math

from swarmgrasp.capability import CapabilityPlacement
from swarmgrasp.cli.show.all_round import clockwise_note, degrees, speed_text, surroundings
from swarmgrasp.cli.show.change import spot, spot_columns, telling_of
from swarmgrasp.cli.show.placement import place_facts
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.environment import beaufort_number
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.words import percent

SAME = 1e-6
"""Relative difference of two winds, or of a bound and an answer, that is none."""
MOST_TOLD = 12
"""Runners-up that are told."""


def show(name: str, found: CapabilityPlacement, terms: Terms) -> None:
    """Write the best place for the least wind held for people."""
    placement = found.placement
    problem, robot = placement.problem, placement.robot
    report, tell = Report(), telling_of(terms, problem.swarm, [], problem.newcomer)
    if found.after > found.before * (1.0 + SAME):
        report.headline(
            f"{name}: the best place for {robot.name}: {_wind(found.after, tell)} held from any "
            "bearing", "good",
        )  # fmt: skip
    else:
        report.headline(
            f"{name}: no allowed place for {robot.name} raises the least wind held", "caution"
        )
    report.blank()
    report.facts([
        *place_facts(placement, tell),
        ("Least wind held", _change(found, tell)),
        *_words(found, tell),
        ("Proven", _proven(found, tell)),
        *surroundings(found.environment, tell, worst_case=problem.criterion.worst_case),
    ])  # fmt: skip
    _show_runners_up(report, found, tell)
    report.blank()
    step = math.degrees(found.bearings[1] - found.bearings[0]) if len(found.bearings) > 1 else 0.0
    report.note(f"Wind from {len(found.bearings)} bearings, every {step:.4g} degrees.")
    report.note(clockwise_note(tell))
    report.small_print(problem.swarm, tell, tell.along())


def _wind(speed: float, tell: Telling) -> str:
    """Return a wind [m/s] as text."""
    if speed == 0.0:
        return "no wind"
    return f"{speed_text(speed, tell)[:-1]}, Beaufort {beaufort_number(speed)})"


def _change(found: CapabilityPlacement, tell: Telling) -> str:
    """Say how the least wind changes, and where it comes from."""
    after = f"{_wind(found.after, tell)} from {degrees(found.bearing_after, tell)}"
    if found.after <= found.before * (1.0 + SAME):
        return f"stays {after if found.after else 'none'}"
    if found.before == 0.0:
        return f"none -> {after}"
    gain = percent(found.after / found.before - 1.0)
    before = f"{speed_text(found.before, tell)} from {degrees(found.bearing_before, tell)}"
    return f"{before} -> {after} (+{gain})"


def _words(found: CapabilityPlacement, tell: Telling) -> list[tuple[str, str]]:
    """Say after which losses it is meant."""
    from dataclasses import replace

    placement = found.placement
    asked = replace(placement.problem.criterion, load=(0.0, 0.0, 0.0))
    words = asked.words(placement.problem.swarm, tell.terms.robot)
    return [("", words)] if words else []


def _proven(found: CapabilityPlacement, tell: Telling) -> str:
    """Say what no allowed place exceeds."""
    if found.bound is not None:
        if found.after and found.bound <= found.after * (1.0 + SAME):
            return "no allowed place holds more from all these bearings"
        return f"no allowed place holds more than {_wind(found.bound, tell)} from all of them"
    hand = max(found.placement.upper_bound - 1.0, SAME)
    return (
        f"in {speed_text(found.tried, tell)} no allowed place has more than {percent(hand)} in "
        "hand from all these bearings, on wind and what comes with it"
    )


def _show_runners_up(report: Report, found: CapabilityPlacement, tell: Telling) -> None:
    """Tell the best robots in other places, and the least wind held with each."""
    placement = found.placement
    told = placement.runners_up[:MOST_TOLD]
    if not told or found.after <= found.before * (1.0 + SAME):
        return
    outline = placement.problem.swarm.outline
    columns = [
        Column("place"), *spot_columns(tell), Column("in hand", is_number=True),
        Column("off the normal [deg]", is_spare=True),
    ]  # fmt: skip
    rows = []
    for runner in told:
        *figures, off = spot(outline, runner.robot, tell)
        share = f"{100.0 * runner.quality / placement.quality:.1f} %"
        rows.append([runner.place, *figures, share, off])
    report.blank()
    report.headline(f"Next best: the best {tell.terms.robot} on each other edge, side or zone")
    report.table(columns, rows, "next best")
    report.note("In hand: by how much loads may grow there, of what they may at the best place.")
