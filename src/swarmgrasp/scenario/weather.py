"""Build the environment of a scenario, and find the faults its schema does not see."""

import re
from typing import Final

import numpy as np

from swarmgrasp.environment import (
    BLENDERMANN,
    Current,
    CurrentCoefficients,
    Environment,
    Waves,
    Wind,
    WindCoefficients,
    WindTable,
)
from swarmgrasp.environment.limits import (
    AREA,
    BOW_ANGLE,
    COEFFICIENT,
    DENSITY,
    HEIGHT,
    OFFSET,
    SPEED,
)
from swarmgrasp.environment.sea import STRONGEST_SEA
from swarmgrasp.errors import EnvironmentInvalid
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.in_range import Keys, check_section
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.scenario.weather_schema import (
    CurrentSection,
    WavesSection,
    WindSection,
    WindTableSection,
)
from swarmgrasp.swarm.matrix import Axes
from swarmgrasp.terms import Frame

_DRAG = ("vessel", "coefficients", "frontal_area", "lateral_area")
_DRAGS = {"transverse", "bow", "stern", "surge", "sway"}
_STREAM: Final[Keys] = {
    "frontal_area": (AREA, "area"),
    "lateral_area": (AREA, "area"),
    "lateral_centroid": (OFFSET, "length"),
    "speed": (SPEED, "speed"),
    "density": (DENSITY, "density"),
}
_SEA: Final[Keys] = {
    "height": (HEIGHT, "length"),
    "bow_angle": (BOW_ANGLE, "angle"),
    "density": (DENSITY, "density"),
}
_WIND: Path = ("environment", "wind")
_WAVES: Path = ("environment", "waves")


def check_weather(checked: Checked, units: Units) -> None:
    """Note what is wrong with how a document says its wind and its waves."""
    _check_ranges(checked, units)
    if checked.file.environment is not None:
        if checked.is_known(*_WIND):
            _check_wind(checked.file.environment.wind, checked)
        if checked.has(*_WAVES) and checked.is_known(*_WAVES):
            _check_waves(checked)


def _check_ranges(checked: Checked, units: Units) -> None:
    """Note every number of an environment that is outside its range."""
    around = checked.file.environment
    if around is None:
        return
    for stream, keys in (("wind", _STREAM), ("current", _STREAM), ("waves", _SEA)):
        section, path = getattr(around, stream), ("environment", stream)
        if section is not None and checked.is_known(*path):
            check_section(section, path, keys, checked, units)
            drag = getattr(section, "coefficients", None)
            if drag is not None:
                known = dict.fromkeys(_DRAGS & set(type(drag).model_fields), (COEFFICIENT, ""))
                check_section(drag, (*path, "coefficients"), known, checked, units)
    speed = around.wind.speed
    with_wind = around.waves is not None and around.waves.with_wind and checked.is_sound(*_WAVES)
    if speed is None or not with_wind or not checked.is_sound("units", "speed"):
        return
    most = STRONGEST_SEA / units.metres_per_second(1.0)
    if speed > most and checked.is_sound(*_WIND, "speed"):
        said = f"the sea that goes with a wind is known up to {most:.4g} {units.speed}; give the "
        checked.fault((*_WIND, "speed"), f"{said}waves a height and a period")


def _check_wind(section: WindSection, checked: Checked) -> None:
    """Note a wind with no drag, with two, or without speed or bearing."""
    _check_moving(checked)
    if checked.has(*_WIND, "table"):
        for key in (*_DRAG, "density", "lateral_centroid"):
            if checked.has(*_WIND, key):
                checked.fault((*_WIND, key), "the table tells all loads already; leave it out")
        return
    for key in ("frontal_area", "lateral_area"):
        if not checked.has(*_WIND, key):
            seen = "ahead" if key == "frontal_area" else "the side"
            said = f"is missing; give the area seen from {seen}"
            checked.fault((*_WIND, key), said, got=False)
    given = [key for key in ("vessel", "coefficients") if checked.has(*_WIND, key)]
    if not given:
        said = (
            "should say its drag, by vessel, a type such as 'offshore supply vessel', or by "
            "coefficients"
        )
        checked.fault(_WIND, said, got=False)
    elif len(given) > 1:
        checked.fault(_WIND, "vessel and coefficients each say the drag; keep one", got=False)
    vessel = section.vessel
    if vessel is not None and vessel not in BLENDERMANN:
        checked.fault((*_WIND, "vessel"), f"there is no such type of vessel; {_types(vessel)}")


def _check_moving(checked: Checked) -> None:
    """Note a wind without speed or bearing."""
    for key, other, said in (
        ("speed", "from", "a wind also needs from, the bearing it comes from"),
        ("from", "speed", "a wind also needs its speed"),
    ):
        if checked.has(*_WIND, key) and not checked.has(*_WIND, other):
            checked.fault((*_WIND, key), said)


def _check_waves(checked: Checked) -> None:
    """Note a sea told in no way, in two, or in half of one."""
    told = [key for key in ("height", "period") if checked.has(*_WAVES, key)]
    with_wind = checked.has(*_WAVES, "with_wind")
    if with_wind and told:
        said = f"with_wind and {' and '.join(told)} each say the sea; keep one"
        checked.fault(_WAVES, said, got=False)
    elif len(told) == 1:
        other = "period" if told == ["height"] else "height"
        checked.fault((*_WAVES, told[0]), f"waves also need their {other}")
    elif not told and not with_wind:
        said = (
            "should say the sea, by height and period, or by `with_wind: true`, the sea that goes "
            "with the wind"
        )
        checked.fault(_WAVES, said, got=False)


def _types(vessel: str) -> str:
    """Say what types of vessel there are: a near miss in letters may be another kind of ship.

    Examples
    --------
    >>> _types("tanker")[:75]
    "put a type with a comma in quotes: 'tanker, loaded' or 'tanker, in ballast'"
    """
    begun = [repr(known) for known in BLENDERMANN if known.startswith(f"{vessel.lower()}, ")]
    if begun:
        return f"put a type with a comma in quotes: {' or '.join(begun)}"
    return f"the types are {', '.join(map(repr, BLENDERMANN))}"


def environment_of(checked: Checked, units: Units) -> Environment | None:
    """Return the environment of a document without faults, if it has one.

    Raises
    ------
    ScenarioInvalid
        If a number is too small to compute with.
    """
    section = checked.file.environment
    if section is None:
        return None
    try:
        current = None if section.current is None else _current(section.current, units)
        waves = None if section.waves is None else _waves(section.waves, units)
        return Environment(
            _wind(section.wind, units, checked.file.frame), current, section.dynamic_factor, waves
        )
    except EnvironmentInvalid as error:  # numbers next to zero, a wind beyond those with a sea
        at: Path = (*_WIND, "table") if checked.has(*_WIND, "table") else ("environment",)
        for fault in error.faults:
            checked.fault(at, _in_units(fault.removeprefix("wind: "), units), got=False)
        raise checked.faults.error() from error


def _in_units(fault: str, units: Units) -> str:
    """Return a sentence on a wind of a table with its speed in the file's unit."""

    def told(found: re.Match[str]) -> str:
        """Return one speed."""
        return f"the wind of {float(found[1]) / units.metres_per_second(1.0):.5g} {units.speed} "

    return re.sub(r"the wind of (\S+) m/s ", told, fault)


def _wind(section: WindSection, units: Units, frame: Axes) -> Wind | WindTable:
    """Return the wind in SI units."""
    if section.table is not None:
        return _table(section, section.table, units, frame)
    if section.coefficients is None:
        coefficients = BLENDERMANN[section.vessel or ""]
    else:
        coefficients = WindCoefficients(**section.coefficients.model_dump())
    return Wind(
        frontal_area=units.square_metres(section.frontal_area or 0.0),
        lateral_area=units.square_metres(section.lateral_area or 0.0),
        coefficients=coefficients,
        lateral_centroid=units.metres(section.lateral_centroid),
        speed=None if section.speed is None else units.metres_per_second(section.speed),
        bearing=None if section.bearing is None else units.radians(section.bearing),
        density=section.density,
    )


def _table(section: WindSection, table: WindTableSection, units: Units, frame: Axes) -> WindTable:
    """Return the loads of winds in SI units, in our frame."""
    rows = np.array(table.rows)
    metre, newton = units.metres(1.0), units.newtons(1.0)
    rows *= [units.metres_per_second(1.0), units.radians(1.0), newton, newton, newton * metre]
    axes = Frame(mirrored=(table.frame or frame) == "NED")
    rows[:, 2:] = axes.wrench_from_file(rows[:, 2:])
    return WindTable.from_rows(
        rows,
        about=None if table.about is None else units.point(table.about),
        speed=None if section.speed is None else units.metres_per_second(section.speed),
        bearing=None if section.bearing is None else units.radians(section.bearing),
    )


def _current(section: CurrentSection, units: Units) -> Current:
    """Return the current in SI units."""
    return Current(
        frontal_area=units.square_metres(section.frontal_area),
        lateral_area=units.square_metres(section.lateral_area),
        speed=units.metres_per_second(section.speed),
        bearing=None if section.bearing is None else units.radians(section.bearing),
        coefficients=CurrentCoefficients(**section.coefficients.model_dump()),
        lateral_centroid=units.metres(section.lateral_centroid),
        density=section.density,
    )


def _waves(section: WavesSection, units: Units) -> Waves:
    """Return the sea in SI units."""
    return Waves(
        height=None if section.height is None else units.metres(section.height),
        period=section.period,
        bearing=None if section.bearing is None else units.radians(section.bearing),
        bow_angle=None if section.bow_angle is None else units.radians(section.bow_angle),
        aft_fullness=section.aft_fullness,
        density=section.density,
    )
