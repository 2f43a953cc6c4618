"""Numbers of a file that are beyond anything real: a decimal point, a unit or a meaning slipped."""

import math
from collections.abc import Iterator

from swarmgrasp.environment import AIR, WATER
from swarmgrasp.environment.waves import GRAVITY
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.force_sets import largest
from swarmgrasp.scenario.tolerances import DEFAULT, holders
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.scenario.weather_schema import (
    CurrentCoefficientsSection,
    EnvironmentSection,
    WavesSection,
    WindCoefficientsSection,
)
from swarmgrasp.swarm.robot import ROUGHEST
from swarmgrasp.words import trimmed

LARGEST_FACTOR = 3.0
"""Of all loads; allowances are 1 to 1.5."""
LARGEST_DRAG = 3.0
"""A flat plate across a stream has 2."""
DENSER = 3.0
"""How many times as dense, or as thin, as air or water something is that is neither."""
FASTEST_WIND, FASTEST_CURRENT, HIGHEST = 120.0, 15.0, 30.0
"""Gusts of cyclones and tidal races [m/s], the height of the highest seas [m]."""
STEEPEST = 1.0 / 7.0
"""Height of a wave over its length in deep water at which it breaks (Michell 1893)."""
LEAST_SHARE = 0.05
"""Of a limit: less of it left is hardly meant, and may be a share instead of a force."""

Slip = tuple[Path, str]


def unreal(checked: Checked, units: Units) -> Iterator[Slip]:
    """Yield what is beyond anything real in a document without faults, each with its path."""
    for section, path in holders(checked):
        if section.friction is not None and section.friction > ROUGHEST:
            said = f"{section.friction:.6g} is beyond any real friction: rubber on dry stone has "
            yield (*path, "friction"), f"{said}about 1"
    yield from _tolerances(checked, units)
    around = checked.file.environment
    if around is not None:
        yield from _streams(around, units)
        yield from _drags(around)
        if around.waves is not None:
            yield from _sea(around.waves, units)
        if around.dynamic_factor > LARGEST_FACTOR:
            said = f"multiplies all loads by {around.dynamic_factor:.6g}; an allowance is 1 to 1.5"
            yield ("environment", "dynamic_factor"), said


def _tolerances(checked: Checked, units: Units) -> Iterator[Slip]:
    """Tell degrees that are read as radians, and shares of a limit that are read as forces."""
    file = checked.file
    own = [
        (section.tolerance, (*path, "tolerance"), [section]) for section, path in holders(checked)
    ]
    others = [section for section, _ in holders(checked) if section.tolerance is None]
    for tolerance, path, whose in [*own, (file.tolerance, DEFAULT, others)]:
        if tolerance is None:
            continue
        far = tolerance.direction or 0.0
        far = max(map(abs, far)) if isinstance(far, list) else far
        if units.angle == "rad" and _is_whole(far):
            said = f"{far:.6g} rad is {math.degrees(far):.3g} deg; for degrees, write {far:.6g} deg"
            yield (*path, "direction"), said
        least = tolerance.least_limit
        limit = min(map(largest, whose), default=0.0)
        if least is not None and least <= 1.0 and least < LEAST_SHARE * limit:
            told = [f"{trimmed(v, 6)} {units.force}" for v in (least, limit, least * limit)]
            said = f"{told[0]} is {100.0 * least / limit:.2g} % of the limit, {told[1]}; a share "
            yield (*path, "least_limit"), f"{said}of {least:.6g} is {told[2]}"


def _is_whole(angle: float) -> bool:
    """Tell whether an angle is a whole number as people write degrees, and radians hardly ever."""
    return angle >= 1.0 and angle == round(angle)


def _streams(around: EnvironmentSection, units: Units) -> Iterator[Slip]:
    """Tell what blows or flows faster than anything, and what is neither air nor water."""
    for stream, section, fastest, what, usual in (
        ("wind", around.wind, FASTEST_WIND, "air", AIR),
        ("current", around.current, FASTEST_CURRENT, "water", WATER),
        ("waves", around.waves, math.inf, "water", WATER),
    ):
        if section is None:
            continue
        path: Path = ("environment", stream)
        if not usual / DENSER <= section.density <= usual * DENSER:
            said = f"{section.density:.6g} kg/m^3 is no {what}, which has about {usual:.4g}; it is "
            yield (*path, "density"), f"{said}in kg/m^3 whatever the units"
        speed = getattr(section, "speed", None)
        if speed is not None and units.metres_per_second(speed) > fastest:
            said = f"{speed:.6g} {units.speed} is faster than any {stream}; is it in {units.speed}?"
            yield (*path, "speed"), said


def _drags(around: EnvironmentSection) -> Iterator[Slip]:
    """Tell drag coefficients that nothing has."""
    given: list[tuple[str, WindCoefficientsSection | CurrentCoefficientsSection | None]] = [
        ("wind", around.wind.coefficients),
        ("current", None if around.current is None else around.current.coefficients),
    ]
    for stream, section in given:
        for key, drag in section or ():
            if drag > LARGEST_DRAG:
                said = f"{drag:.6g} is beyond any real drag: a flat plate across has about 2"
                yield ("environment", stream, "coefficients", key), said


def _sea(waves: WavesSection, units: Units) -> Iterator[Slip]:
    """Tell a sea that is higher than any, or so short that it breaks."""
    path: Path = ("environment", "waves", "height")
    if waves.height is None or waves.period is None:
        return
    height, most = units.metres(waves.height), highest(waves.period)
    said = f"{waves.height:.6g} {units.length}"
    if height > HIGHEST:
        yield path, f"{said} is higher than any sea; is it in {units.length}?"
    elif height > most:
        known = f"{trimmed(most / units.metres(1.0), 3)} {units.length}"
        begin = f"a sea with a period of {waves.period:.6g} s breaks before it is {said} high; it "
        yield path, f"{begin}is at most {known} then"


def highest(period: float) -> float:
    """Return the height [m] that no sea has, or that one of this period [s] has when it breaks."""
    return min(HIGHEST, STEEPEST * GRAVITY * period**2 / math.tau)
