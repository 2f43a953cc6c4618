"""How `swarmgrasp capability --numbers` tells its answer."""

from swarmgrasp.capability import ALLOWANCE, CapabilityNumbers
from swarmgrasp.cli.show.all_round import (
    bare,
    clockwise_note,
    decimals,
    degrees,
    drag,
    shown,
    step_note,
)
from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.environment import KNOT, STEPS
from swarmgrasp.quality import Criterion
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms

NO_ASSESSMENT = (
    "These are no capability numbers by DNV-ST-0111: thrusters are as the scenario has them, "
    "without that standard's losses and power balance, and nobody has assessed them."
)


def show(name: str, found: CapabilityNumbers, terms: Terms) -> None:
    """Write capability numbers for people."""
    report, tell = Report(), telling_of(terms, found.swarm, [])
    least, after = int(found.intact.min()), int(found.after_loss.min())
    report.headline(
        f"{name}: holds step {least} of 11 from any bearing, {after} after the worst "
        f"{found.less_by}",
        "good" if after > 0 else "caution" if least > 0 else "bad",
    )
    report.blank()
    report.facts(_facts(found, tell))
    report.blank()
    columns = [
        Column("from [deg]", is_number=True), Column("intact", is_number=True),
        Column(f"after a {found.less_by}", is_number=True),
        Column(f"worst {found.less_by}", is_spare=True),
    ]  # fmt: skip
    rows = [
        [bare(found.bearings[i], tell), *map(_number, (found.intact[i], found.after_loss[i])),
         found.lost_words(i)]
        for i in shown(found.bearings, tell, found.worst, found.worst_after_loss)
    ]  # fmt: skip
    report.table(columns, rows, "bearings")
    step_note(report, found.bearings, len(rows))
    report.blank()
    for note in (
        clockwise_note(tell),
        "Steps: those by which DNV-ST-0111 numbers capabilities, by Beaufort, with the sea of the "
        "wind and a current, all from one bearing; the largest held, all those before it held too.",
        NO_ASSESSMENT,
    ):
        report.note(note)


def step_words(number: int) -> str:
    """Say what weather a step is.

    Examples
    --------
    >>> step_words(5)
    'step 5 (wind 20.8 kn, waves 2.1 m and 7.5 s, current 1.46 kn)'
    """
    if number <= 0:
        return "step 0 (a calm)" if number == 0 else "not even a calm"
    wind, height, period, current = STEPS[number]
    return (
        f"step {number} (wind {decimals(wind / KNOT)} kn, waves {height:g} m and {period:g} s, "
        f"current {decimals(current / KNOT)} kn)"
    )


def _facts(found: CapabilityNumbers, tell: Telling) -> list[tuple[str, str]]:
    """Tell where the least is held, after which loss, and with what allowance."""
    i, j = found.worst, found.worst_after_loss
    facts = [("Intact", _least(found.bearings[i], int(found.intact[i]), tell))]
    least = _least(found.bearings[j], int(found.after_loss[j]), tell)
    if found.failures:
        asked = Criterion(losing=found.losing, failures=found.failures)
        facts += [("After a failure", least), ("", asked.words(found.swarm, tell.terms.robot))]
    else:
        facts.append((f"Without {found.loss_words(tell.terms.robot)}", least))
    if found.lost_words(j):
        facts.append(("", f"the worst {found.less_by} there: {found.lost_words(j)}"))
    facts.append(drag(found.environment, tell))
    if found.worst_case:
        facts.append(("Poses", f"the worst that the {tell.terms.several}' tolerances allow"))
    factor = found.environment.dynamic_factor
    beside = "" if factor == ALLOWANCE else f"; the standard takes {ALLOWANCE:g}"
    return [*facts, ("Allowance", f"all loads times {factor:g}{beside}")]


def _least(bearing: float, number: int, tell: Telling) -> str:
    """Tell the least step held and where from."""
    return f"least from {degrees(bearing, tell)}: {step_words(number)}"


def _number(number: int) -> str:
    """Return the number of a step, for a table."""
    return "none" if number < 0 else str(int(number))
