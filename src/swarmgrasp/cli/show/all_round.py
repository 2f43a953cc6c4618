"""What reports of weather from all round share: bearings, speeds, and what is around."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.cli.show.report import Report
from swarmgrasp.environment import KNOT, Environment, Waves, WindTable, vessel_type
from swarmgrasp.telling import Telling
from swarmgrasp.units import SPEEDS

Array = NDArray[np.float64]

ROWS = 12
"""Of a table: more bearings than this are told every 30 degrees, and where it matters most."""


def clockwise_note(tell: Telling, when: str = "") -> str:
    """Say how bearings are told: from a bow that is where it is at some time."""
    if tell.terms.frame.heading is None:
        ours = f"degrees clockwise from the bow{when}, where it comes from; 90 is starboard"
        return f"Bearings: {ours}."
    return f"Bearings: true, where it comes from; the bow is at {bare(0.0, tell)} deg{when}."


def bare(bearing: float, tell: Telling) -> str:
    """Return a bearing [rad], clockwise from the bow, in degrees as it is told, without unit."""
    return f"{tell.from_degrees(bearing):.4g}"


def degrees(bearing: float, tell: Telling) -> str:
    """Return a bearing [rad], clockwise from the bow, in degrees as it is told."""
    true = "" if tell.terms.frame.heading is None else " true"
    return f"{bare(bearing, tell)} deg{true}"


def ranges(bearings: list[float], chosen: Any, tell: Telling) -> str:
    """Tell some of the bearings [rad] as ranges, clockwise.

    Examples
    --------
    >>> from swarmgrasp.terms import SI
    >>> compass = [math.radians(45 * k) for k in range(8)]
    >>> chosen = [True, True, False, True, False, False, False, True]
    >>> ranges(compass, chosen, Telling.of(SI, 1.0, []))
    '315 to 45 deg and 135 deg'
    """
    count = len(bearings)
    starts = [i for i in range(count) if chosen[i] and not chosen[i - 1]]
    said = []
    for start in sorted(starts, key=lambda i: i - count * (i == max(starts) and bool(chosen[0]))):
        end = start
        while chosen[(end + 1) % count]:
            end += 1
        last = degrees(bearings[end % count], tell)
        said.append(last if end == start else f"{bare(bearings[start], tell)} to {last}")
    return " and ".join([", ".join(said[:-1]), said[-1]] if len(said) > 1 else said)


def shown(bearings: Array, tell: Telling, *worst: int) -> list[int]:
    """Return the bearings to tell: all of a few, or every 30 degrees and the worst, by index."""
    each = np.array([tell.from_degrees(bearing) for bearing in bearings])
    chosen = set(range(len(each)))
    if len(each) > ROWS:
        round_ones = np.flatnonzero(np.abs(each - 30.0 * np.round(each / 30.0)) < 1e-6)
        chosen = {*round_ones.tolist(), *worst}
    return sorted(chosen, key=lambda i: each[i])


def step_note(report: Report, bearings: Array, rows: int) -> None:
    """Say that more was computed than told, if it was."""
    if rows < len(bearings):
        step = math.degrees(bearings[1] - bearings[0]) % 360.0
        report.note(f"Computed every {step:.4g} degrees; --json has them all.")


def speed_text(speed: float, tell: Telling) -> str:
    """Return a speed [m/s] as text, in knots and in the second unit.

    Examples
    --------
    >>> from swarmgrasp.terms import Terms
    >>> speed_text(10.0, Telling.of(Terms(), 1.0, []))
    '19.4 kn (10.0 m/s)'
    """
    second = second_unit(tell)
    return f"{decimals(speed / KNOT)} kn ({decimals(speed / SPEEDS[second])} {second})"


def second_unit(tell: Telling) -> str:
    """Return the unit that winds are told in beside knots: the file's, or m/s."""
    return "m/s" if tell.terms.speed == "kn" else tell.terms.speed


def decimals(value: float) -> str:
    """Return a speed with a decimal, or two below 10."""
    return f"{value:.1f}" if value >= 10.0 else f"{value:.2f}"


def rounded(value: float) -> str:
    """Return a number without decimals that say nothing."""
    return f"{round(value, 1):g}"


def drag(environment: Environment, tell: Telling) -> tuple[str, str]:
    """Tell the wind drag."""
    wind = environment.wind
    if isinstance(wind, WindTable):
        return ("Wind drag", _table_words(wind, tell))
    vessel = vessel_type(wind.coefficients)
    by = f"Blendermann's for {vessel!r}" if vessel else "the scenario's coefficients"
    areas = f"{tell.area(wind.frontal_area)} ahead and {tell.area(wind.lateral_area)} abeam"
    return ("Wind drag", f"{by}, {areas}")


def _table_words(table: WindTable, tell: Telling) -> str:
    """Say what table the loads of winds are of."""
    winds = speed_text(table.speeds[0], tell)
    if not table.grows_with_square:
        winds = f"{len(table.speeds)} speeds, {winds} to {speed_text(table.speeds[-1], tell)}"
    sides = ", mirrored for port" if table.is_of_one_side else ""
    return f"by a table of {len(table.bearings)} bearings at {winds}{sides}"


def surroundings(
    environment: Environment, tell: Telling, *, worst_case: bool = False
) -> list[tuple[str, str]]:
    """Tell the wind drag, the current, the waves and the allowance."""
    current, facts = environment.current, [drag(environment, tell)]
    if current is None or current.speed == 0.0:
        facts.append(("Current", "none"))
    else:
        way = "from where the wind comes"
        if current.bearing is not None:
            way = tell.from_words(current.bearing)
        facts.append(("Current", f"{speed_text(current.speed, tell)}, {way}"))
    if environment.waves is not None:
        facts.append(("Waves", waves_words(environment.waves, tell)))
    if worst_case:
        facts.append(("Poses", f"the worst that the {tell.terms.several}' tolerances allow"))
    if environment.dynamic_factor != 1.0:
        factor = environment.dynamic_factor
        facts.append(("Allowance", f"all loads times {factor:g}"))
    return facts


def waves_words(waves: Waves, tell: Telling) -> str:
    """Say which sea it is: a given one, or the one that goes with the wind."""
    way = "from where the wind comes" if waves.bearing is None else tell.from_words(waves.bearing)
    if waves.height is None or waves.period is None:
        return f"the sea that goes with the wind by the steps of DNV-ST-0111, {way}"
    height = tell.length.text(waves.height)
    return f"a given sea, significant height {height}, peak period {waves.period:.3g} s, {way}"
