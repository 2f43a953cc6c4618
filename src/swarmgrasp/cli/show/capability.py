"""How `swarmgrasp capability` tells its answer."""

import math
from typing import Any

from swarmgrasp.capability import Capability
from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.environment import KNOT, beaufort, vessel_type
from swarmgrasp.quality import Criterion
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.words import wrench_words

MOST_SHOWN = 100.0
"""Winds above this [kn] are told as such: capability plots end here."""
ROWS = 12
"""Of the table: more bearings than this are told every 30 degrees, and where the least is held."""


def show(name: str, found: Capability, terms: Terms) -> None:
    """Write a capability for people."""
    report, tell = Report(), telling_of(terms, found.swarm, [])
    worst, after = float(found.intact.min()), float(found.after_loss.min())
    held = f"holds {_wind(worst)} from any bearing" if worst else "does not hold every wind"
    report.headline(f"{name}: {held}", "good" if after else "caution" if worst else "bad")
    report.blank()
    report.facts(_facts(found, tell))
    report.blank()
    _show_bearings(report, found)
    report.blank()
    for note in (
        "Bearings: degrees clockwise from the bow, where the wind comes from; 90 is starboard.",
        "The largest winds held beside the current; loads are steady, and there are no waves.",
    ):
        report.note(note)


def _facts(found: Capability, tell: Telling) -> list[tuple[str, str]]:
    """Tell the worst bearings, what limits the robots there, and the surroundings."""
    i, j = found.worst, found.worst_after_loss
    lost = found.lost_words(j)
    facts = [("Intact", _least(found, found.intact, i, found.holds_current))]
    if found.intact[i] > 0.0:
        weakest = wrench_words(found.directions[i])
        facts.append(("", f"there the {tell.terms.several} are weakest at {weakest}"))
    least = _least(found, found.after_loss, j, found.holds_current_after_loss)
    if found.failures:
        asked = Criterion(losing=found.losing, failures=found.failures)
        facts += [("After a failure", least), ("", asked.words(found.swarm, tell.terms.robot))]
    else:
        facts.append((f"Without {found.loss_words}", least))
    if lost:
        said = f"the worst {found.less_by} there: {lost}"
        facts.append(("", said if found.after_loss[j] > 0.0 else f"losing {lost} is enough"))
    return [*facts, *_surroundings(found, tell)]


def _least(found: Capability, speeds: Any, index: int, holds: Any) -> str:
    """Tell the least of some winds [m/s] and where it comes from."""
    none = speeds == 0.0
    if not none.any():
        return f"least from {_degrees(found.bearings[index])}: {_wind(speeds[index])}"
    said = "no wind from any bearing"
    if not none.all():
        few = none.sum() <= 0.5 * len(none)
        ranges = _ranges(found.bearings.tolist(), none if few else ~none)
        said = f"no wind {'from' if few else 'but from'} {ranges}"
    if holds[none].all():
        return said
    return f"{said}{', in part' if holds[none].any() else ','} not even the current alone"


def _ranges(bearings: list[float], chosen: Any) -> str:
    """Tell some of the bearings [rad] as ranges, clockwise.

    Examples
    --------
    >>> compass = [math.radians(45 * k) for k in range(8)]
    >>> _ranges(compass, [True, True, False, True, False, False, False, True])
    '315 to 45 deg and 135 deg'
    """
    count = len(bearings)
    starts = [i for i in range(count) if chosen[i] and not chosen[i - 1]]
    said = []
    for start in sorted(starts, key=lambda i: i - count * (i == max(starts) and bool(chosen[0]))):
        end = start
        while chosen[(end + 1) % count]:
            end += 1
        last = _degrees(bearings[end % count])
        said.append(last if end == start else f"{_bare(bearings[start])} to {last}")
    return " and ".join([", ".join(said[:-1]), said[-1]] if len(said) > 1 else said)


def _surroundings(found: Capability, tell: Telling) -> list[tuple[str, str]]:
    """Tell the wind drag, the current and the allowance."""
    wind, current = found.environment.wind, found.environment.current
    vessel = vessel_type(wind.coefficients)
    drag = f"Blendermann's for {vessel!r}" if vessel else "the scenario's coefficients"
    areas = f"{tell.area(wind.frontal_area)} ahead and {tell.area(wind.lateral_area)} abeam"
    facts = [("Wind drag", f"{drag}, {areas}")]
    if current is None or current.speed == 0.0:
        facts.append(("Current", "none"))
    else:
        way = "from where the wind comes"
        if current.bearing is not None:
            way = f"from {_degrees(current.bearing)}"
        facts.append(("Current", f"{_speed(current.speed)}, {way}"))
    if found.worst_case:
        facts.append(("Poses", f"the worst that the {tell.terms.several}' tolerances allow"))
    if found.environment.dynamic_factor != 1.0:
        factor = found.environment.dynamic_factor
        facts.append(("Allowance", f"both loads times {factor:g}"))
    return facts


def _show_bearings(report: Report, found: Capability) -> None:
    """Write the table of bearings."""
    columns = [
        *(Column(text, is_number=True) for text in ("from [deg]", "intact [kn]", "[m/s]")),
        Column("Beaufort", is_number=True),
        *(Column(text, is_number=True) for text in (f"after a {found.less_by} [kn]", "[m/s]")),
        Column("Beaufort", is_number=True), Column(f"worst {found.less_by}", is_spare=True),
    ]  # fmt: skip
    rows = [
        [
            _bare(found.bearings[i]), *_numbers(found.intact[i]), *_numbers(found.after_loss[i]),
            found.lost_words(i),
        ]
        for i in _shown(found)
    ]  # fmt: skip
    report.table(columns, rows)
    if len(rows) < len(found.bearings):
        step = math.degrees(found.bearings[1] - found.bearings[0])
        report.note(f"Computed every {step:.4g} degrees; --json has them all.")


def _shown(found: Capability) -> list[int]:
    """Return the bearings to tell: all of a few, or every 30 degrees and the worst."""
    count = len(found.bearings)
    if count <= ROWS:
        return list(range(count))
    degrees = [math.degrees(bearing) for bearing in found.bearings]
    round_ones = {i for i, bearing in enumerate(degrees) if abs(math.remainder(bearing, 30)) < 1e-6}
    return sorted(round_ones | {found.worst, found.worst_after_loss})


def _numbers(speed: float) -> list[str]:
    """Return a wind [m/s] in knots, in m/s and as Beaufort."""
    if speed == 0.0:
        return ["none", "", ""]
    if speed >= MOST_SHOWN * KNOT:
        return [f">{MOST_SHOWN:g}", f">{MOST_SHOWN * KNOT:.1f}", "12"]
    return [_decimals(speed / KNOT), _decimals(speed), str(beaufort(speed))]


def _decimals(value: float) -> str:
    """Return a speed with a decimal, or two below 10."""
    return f"{value:.1f}" if value >= 10.0 else f"{value:.2f}"


def _wind(speed: float) -> str:
    """Return a wind [m/s] as text."""
    if speed >= MOST_SHOWN * KNOT:
        return f"more than {MOST_SHOWN:g} kn"
    return f"{_speed(speed)[:-1]}, Beaufort {beaufort(speed)})"


def _speed(speed: float) -> str:
    """Return a speed [m/s] as text.

    Examples
    --------
    >>> _speed(10.0)
    '19.4 kn (10.0 m/s)'
    """
    return f"{_decimals(speed / KNOT)} kn ({_decimals(speed)} m/s)"


def _bare(bearing: float) -> str:
    """Return a bearing [rad] in degrees, without the unit."""
    return f"{math.degrees(bearing) % 360.0:.4g}"


def _degrees(bearing: float) -> str:
    """Return a bearing [rad] in degrees."""
    return f"{_bare(bearing)} deg"
