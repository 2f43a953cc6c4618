"""Bearings as seamen tell them: relative to the bow, true, or as a point of the compass."""

import math
import re
from typing import Final

from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.ranges import shown
from swarmgrasp.units.quantity import in_unit
from swarmgrasp.units.spellings import ANGLES

_QUARTERS: Final = (("N", "E"), ("E", "S"), ("S", "W"), ("W", "N"))
COMPASS: Final[dict[str, float]] = {}
"""The true bearing [rad] of each of 16 points, clockwise from north."""
for _turn, (_first, _last) in enumerate(_QUARTERS):
    _between = _first + _last if _first in "NS" else _last + _first
    for _step, _point in enumerate((_first, _first + _between, _between, _last + _between)):
        COMPASS[_point] = math.radians(90.0 * _turn + 22.5 * _step)


_NO_LETTER = re.compile(r"[\s-]+")
_TRUE = re.compile(r"(.*[0-9\s\u00b0])\s*(?:true|T)\s*", re.S)


def compass_point(text: str) -> float | None:
    """Return the true bearing [rad] of a point of the compass; None if text is none.

    Examples
    --------
    >>> [round(math.degrees(compass_point(each)), 1) for each in ("N", "nne", "SW", "WNW")]
    [0.0, 22.5, 225.0, 292.5]
    >>> compass_point("north-east") == compass_point("NE"), compass_point("port") is None
    (True, True)
    """
    letters = _NO_LETTER.sub("", text.upper())
    for word in ("NORTH", "EAST", "SOUTH", "WEST"):
        letters = letters.replace(word, word[0])
    return COMPASS.get(letters)


def bearing(value: str | float, unit: str, heading: float | None = None) -> float:
    """Return a bearing, clockwise from the bow, in some unit.

    Parameters
    ----------
    value : str or float
        A number, or text: an angle clockwise from the bow, "30 deg"; one clockwise from north,
        "225 true" or "225 deg T"; or a point of the compass, "NE".
    unit : str
        Of a number that has none, and of what is returned: rad or deg.
    heading : float, optional [rad]
        The true bearing of the bow, which the last two need.

    Raises
    ------
    QuantityInvalid
        If it is no bearing, or a true one and there is no heading.

    Examples
    --------
    >>> bearing("30", "deg"), bearing("NE", "deg", math.pi / 2), bearing("225 true", "deg", 0.0)
    (30.0, -45.0, 225.0)
    """
    size = ANGLES[unit]
    point = compass_point(value) if isinstance(value, str) else None
    told = _TRUE.fullmatch(value) if isinstance(value, str) else None
    if point is None and isinstance(value, str) and value.strip()[:1].isalpha():
        said = f"{shown(value)} is no bearing; write an angle clockwise from the bow, such as "
        raise QuantityInvalid(f"{said}30 deg, or a point of the compass, such as NE")
    if point is None and told is None:
        return in_unit(value, "angle", unit)
    if heading is None:
        said = f"{shown(value)} is a true bearing, which needs the heading of the object"
        raise QuantityInvalid(f"{said}; give heading, the true bearing of its bow")
    if told is not None:
        return in_unit(told[1].strip(), "angle", unit) - heading / size
    return ((point or 0.0) - heading) / size
