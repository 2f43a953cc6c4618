"""The points of the compass."""

import math
from typing import Final

_QUARTERS: Final = (("N", "E"), ("E", "S"), ("S", "W"), ("W", "N"))
COMPASS: Final[dict[str, float]] = {}
"""The true bearing [rad] of each of 16 points, clockwise from north."""
for _turn, (_first, _last) in enumerate(_QUARTERS):
    _between = _first + _last if _first in "NS" else _last + _first
    for _step, _point in enumerate((_first, _first + _between, _between, _last + _between)):
        COMPASS[_point] = math.radians(90.0 * _turn + 22.5 * _step)


def compass_point(text: str) -> float | None:
    """Return the true bearing [rad] of a point of the compass; None if text is none.

    Examples
    --------
    >>> [round(math.degrees(compass_point(each)), 1) for each in ("N", "nne", "SW", "WNW")]
    [0.0, 22.5, 225.0, 292.5]
    >>> compass_point("port") is None
    True
    """
    return COMPASS.get(text.strip().upper())
