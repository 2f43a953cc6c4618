"""The Beaufort scale, both ways.

A number always stands for its strongest wind, so that who holds in it holds in all of it.
"""

from bisect import bisect_right

from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.ranges import number, shown

_LEAST = (0.3, 1.6, 3.4, 5.5, 8.0, 10.8, 13.9, 17.2, 20.8, 24.5, 28.5, 32.7)
"""Least wind speeds [m/s] of Beaufort 1 to 12, as the World Meteorological Organization
lists them."""
_MOST = tuple(round(least - 0.1, 1) for least in _LEAST)
"""The strongest winds [m/s] of Beaufort 0 to 11."""


def beaufort_number(speed: float) -> int:
    """Return the largest Beaufort number, 0 to 12, none of whose winds exceeds a wind.

    Parameters
    ----------
    speed : float [m/s]
        The mean over ten minutes, 10 m above the sea; rounded to 0.1 m/s, as the scale is. From
        32.7 m/s on the number is 12, which has no strongest wind.

    Examples
    --------
    Beaufort 5 ends at 10.7 m/s:

    >>> beaufort_number(10.6), beaufort_number(10.7), beaufort_number(32.6), beaufort_number(40.0)
    (4, 5, 11, 12)
    """
    wind = round(speed, 1)
    return len(_MOST) if wind > _MOST[-1] else max(0, bisect_right(_MOST, wind) - 1)


def beaufort_speed(force: float) -> float:
    """Return the strongest wind [m/s] of a Beaufort number: who holds in it holds in all of them.

    Parameters
    ----------
    force : float
        A whole number from 0 to 11; 12 has no strongest wind.

    Raises
    ------
    QuantityInvalid
        If it is none of these.

    Examples
    --------
    >>> beaufort_speed(4), beaufort_number(7.9)
    (7.9, 4)

    The steps of DNV-ST-0111 have the same winds, but for 3.4 m/s in step 2:

    >>> beaufort_speed(2)
    3.3
    """
    value = number(force)
    if value not in range(len(_MOST)):
        raise QuantityInvalid(
            f"Beaufort {shown(force)} is no step of the scale that has a strongest wind; give a "
            "whole number from 0 to 11, or a speed in kn or m/s"
        )
    return _MOST[int(value)]
