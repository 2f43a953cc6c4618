"""How `swarmgrasp capability` tells its answer."""

import math
from typing import Any

from swarmgrasp.capability import Capability
from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.environment import KNOT, Waves, beaufort, vessel_type
from swarmgrasp.quality import Criterion
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.units import SPEEDS
from swarmgrasp.words import wrench_words

MOST_SHOWN = 100.0
"""Winds above this [kn] are told as such: capability plots end here."""
ROWS = 12
"""Of the table: more bearings than this are told every 30 degrees, and where the least is held."""


def show(name: str, found: Capability, terms: Terms) -> None:
    """Write a capability for people."""
    report, tell = Report(), telling_of(terms, found.swarm, [])
    worst, after = float(found.intact.min()), float(found.after_loss.min())
    held = (
        f"holds {_wind(found, worst, tell)} from any bearing"
        if worst
        else "does not hold every wind"
    )
    report.headline(f"{name}: {held}", "good" if after else "caution" if worst else "bad")
    report.blank()
    report.facts(_facts(found, tell))
    report.blank()
    _show_bearings(report, found, tell)
    report.blank()
    for note in (
        "Bearings: degrees clockwise from the bow, where the wind comes from; 90 is starboard.",
        f"The largest winds held beside {_calm_words(found)}; loads are steady, and "
        f"{_sea_words(found)}.",
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
    return [*facts, *_surroundings(found, tell)]


def _least(found: Capability, speeds: Any, index: int, holds: Any, tell: Telling) -> str:
    """Tell the least of some winds [m/s] and where it comes from."""
    none = speeds == 0.0
    if not none.any():
        return f"least from {_degrees(found.bearings[index])}: {_wind(found, speeds[index], tell)}"
    said = "no wind from any bearing"
    if not none.all():
        few = none.sum() <= 0.5 * len(none)
        ranges = _ranges(found.bearings.tolist(), none if few else ~none)
        said = f"no wind {'from' if few else 'but from'} {ranges}"
    if holds[none].all():
        return said
    return f"{said}{', in part' if holds[none].any() else ','} not even {_calm_words(found)} alone"


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
    """Tell the wind drag, the current, the waves and the allowance."""
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
            way = tell.from_words(current.bearing)
        facts.append(("Current", f"{_speed(current.speed, tell)}, {way}"))
    if found.environment.waves is not None:
        facts.append(("Waves", waves_words(found.environment.waves, tell)))
    if found.worst_case:
        facts.append(("Poses", f"the worst that the {tell.terms.several}' tolerances allow"))
    if found.environment.dynamic_factor != 1.0:
        factor = found.environment.dynamic_factor
        facts.append(("Allowance", f"all loads times {factor:g}"))
    return facts


def waves_words(waves: Waves, tell: Telling) -> str:
    """Say which sea it is: a given one, or the one that goes with the wind."""
    way = "from where the wind comes" if waves.bearing is None else tell.from_words(waves.bearing)
    if waves.height is None or waves.period is None:
        return f"the sea that goes with the wind by the steps of DNV-ST-0111, {way}"
    height = tell.length.text(waves.height)
    return f"a given sea, significant height {height}, peak period {waves.period:.3g} s, {way}"


def _calm_words(found: Capability) -> str:
    """Say what is there without wind."""
    waves = found.environment.waves
    return "the current" if waves is None or waves.goes_with_wind else "current and waves"


def _sea_words(found: Capability) -> str:
    """Say in a few words what of the sea is counted."""
    if found.environment.waves is None:
        return "there are no waves"
    if found.most_told == math.inf:
        return "of the waves the mean drift is counted"
    return f"of the waves the mean drift is counted, up to {_decimals(found.most_told / KNOT)} kn"


def _show_bearings(report: Report, found: Capability, tell: Telling) -> None:
    """Write the table of bearings."""
    second = f"[{_second(tell)}]"
    columns = [
        *(Column(text, is_number=True) for text in ("from [deg]", "intact [kn]", second)),
        Column("Beaufort", is_number=True),
        *(Column(text, is_number=True) for text in (f"after a {found.less_by} [kn]", second)),
        Column("Beaufort", is_number=True), Column(f"worst {found.less_by}", is_spare=True),
    ]  # fmt: skip
    rows = [
        [
            _bare(found.bearings[i]), *_numbers(found, found.intact[i], tell),
            *_numbers(found, found.after_loss[i], tell), found.lost_words(i),
        ]
        for i in _shown(found)
    ]  # fmt: skip
    report.table(columns, rows, "bearings")
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


def _numbers(found: Capability, speed: float, tell: Telling) -> list[str]:
    """Return a wind [m/s] in knots, in the second unit and as Beaufort."""
    if speed == 0.0:
        return ["none", "", ""]
    most, size = _most(found), SPEEDS[_second(tell)]
    if speed >= most:
        return [f">{_round(most / KNOT)}", f">{most / size:.1f}", str(beaufort(most + 0.1))]
    return [_decimals(speed / KNOT), _decimals(speed / size), str(beaufort(speed))]


def _most(found: Capability) -> float:
    """Return the wind [m/s] from which on winds are told as more than that."""
    return min(MOST_SHOWN * KNOT, found.most_told)


def _round(value: float) -> str:
    """Return a number without decimals that say nothing."""
    return f"{round(value, 1):g}"


def _second(tell: Telling) -> str:
    """Return the unit that winds are told in beside knots: the file's, or m/s."""
    return "m/s" if tell.terms.speed == "kn" else tell.terms.speed


def _decimals(value: float) -> str:
    """Return a speed with a decimal, or two below 10."""
    return f"{value:.1f}" if value >= 10.0 else f"{value:.2f}"


def _wind(found: Capability, speed: float, tell: Telling) -> str:
    """Return a wind [m/s] as text."""
    if speed >= _most(found):
        return f"more than {_round(_most(found) / KNOT)} kn"
    return f"{_speed(speed, tell)[:-1]}, Beaufort {beaufort(speed)})"


def _speed(speed: float, tell: Telling) -> str:
    """Return a speed [m/s] as text, in knots and in the second unit.

    Examples
    --------
    >>> _speed(10.0, Telling.of(Terms(), 1.0, []))
    '19.4 kn (10.0 m/s)'
    """
    second = _second(tell)
    return f"{_decimals(speed / KNOT)} kn ({_decimals(speed / SPEEDS[second])} {second})"


def _bare(bearing: float) -> str:
    """Return a bearing [rad] in degrees, without the unit."""
    return f"{math.degrees(bearing) % 360.0:.4g}"


def _degrees(bearing: float) -> str:
    """Return a bearing [rad] in degrees."""
    return f"{_bare(bearing)} deg"
