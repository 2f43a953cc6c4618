"""How `swarmgrasp capability --with-newcomer` tells its answer."""

from swarmgrasp.capability import CapabilityJoined
from swarmgrasp.cli.show.all_round import (
    bare,
    clockwise_note,
    degrees,
    shown,
    step_note,
    surroundings,
)
from swarmgrasp.cli.show.capability import (
    calm_words,
    most,
    none_words,
    numbers,
    sea_words,
    wind_text,
)
from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.placement import place_facts
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms


def show(name: str, found: CapabilityJoined, terms: Terms) -> None:
    """Write a capability before and after a newcomer for people."""
    report, tell = Report(), telling_of(terms, found.after.swarm, [])
    joined, after = found.placement.robot.name, found.after
    least = float(after.intact.min())
    said = none_words(after.bearings, after.intact == 0.0, tell)
    if least:
        said = f"{wind_text(after, least, tell)} from any bearing"
    report.headline(f"{name}: holds {said} with {joined}", "good" if least else "caution")
    report.blank()
    report.facts([
        *place_facts(found.placement, tell),
        *_change(found, tell),
        *surroundings(after.environment, tell, worst_case=after.worst_case),
    ])  # fmt: skip
    report.blank()
    _show_bearings(report, found, tell)
    report.blank()
    report.note(clockwise_note(tell))
    report.note(
        f"The largest winds held beside {calm_words(after)}, before {joined} joins and after; "
        f"loads are steady, and {sea_words(after)}."
    )


def _show_bearings(report: Report, found: CapabilityJoined, tell: Telling) -> None:
    """Write the table of bearings, before and after."""
    before, after = found.before, found.after
    less = after.less_by
    columns = [
        Column("from [deg]", is_number=True),
        *(Column(f"{text} [kn]", is_number=True)
          for text in ("before", "after", f"{less}, before", f"{less}, after")),
    ]  # fmt: skip
    rows = [
        [
            bare(after.bearings[i], tell),
            *(numbers(one, speeds[i], tell)[0] for one, speeds in (
                (before, before.intact), (after, after.intact),
                (before, before.after_loss), (after, after.after_loss),
            )),
        ]
        for i in shown(
            after.bearings, tell, before.worst, after.worst, before.worst_after_loss,
            after.worst_after_loss,
        )
    ]  # fmt: skip
    report.table(columns, rows, "bearings")
    step_note(report, after.bearings, len(rows))


def _change(found: CapabilityJoined, tell: Telling) -> list[tuple[str, str]]:
    """Tell the least winds, before and after, intact and after a loss."""
    before, after = found.before, found.after
    less = "After a failure" if after.failures else f"Without {after.loss_words(tell.terms.robot)}"
    return [
        ("Intact", _both(
            _least(found, before.intact, before.worst, tell),
            _least(found, after.intact, after.worst, tell),
        )),
        (less, _both(
            _least(found, before.after_loss, before.worst_after_loss, tell),
            _least(found, after.after_loss, after.worst_after_loss, tell),
        )),
    ]  # fmt: skip


def _both(before: str, after: str) -> str:
    """Say what becomes of something."""
    return f"stays {after}" if before == after else f"{before} -> {after}"


def _least(found: CapabilityJoined, speeds: object, index: int, tell: Telling) -> str:
    """Tell the least of some winds, and where it comes from."""
    speed = float(speeds[index])  # type: ignore[index]
    if speed == 0.0:
        return "none"
    from_ = (
        degrees(found.after.bearings[index], tell) if speed < most(found.after) else "any bearing"
    )
    return f"{wind_text(found.after, speed, tell)} from {from_}"
