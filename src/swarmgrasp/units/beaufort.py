"""The Beaufort scale, both ways."""

from bisect import bisect_right

from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.ranges import number, shown

_LEAST = (0.3, 1.6, 3.4, 5.5, 8.0, 10.8, 13.9, 17.2, 20.8, 24.5, 28.5, 32.7)
"""Least wind speeds [m/s] of Beaufort 1 to 12, as the World Meteorological Organization
lists them."""


def beaufort(speed: float) -> int:
    """Return the Beaufort number of a wind, from 0 to 12.

    Parameters
    ----------
    speed : float [m/s]
        The mean over ten minutes, 10 m above the sea; rounded to 0.1 m/s, as the scale is.

    Examples
    --------
    A fresh breeze, a storm, a hurricane:

    >>> beaufort(9.0), beaufort(25.7), beaufort(40.0)
    (5, 10, 12)
    """
    return bisect_right(_LEAST, round(speed, 1))


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
    >>> beaufort_speed(4), beaufort(7.9), beaufort(8.0)
    (7.9, 4, 5)

    The steps of DNV-ST-0111 have the same winds, but for 3.4 m/s in step 2:

    >>> beaufort_speed(2), beaufort(3.4)
    (3.3, 3)
    """
    value = number(force)
    if value not in range(len(_LEAST)):
        raise QuantityInvalid(
            f"Beaufort {shown(force)} is no step of the scale that has a strongest wind; give a "
            "whole number from 0 to 11, or a speed in kn or m/s"
        )
    return round(_LEAST[int(value)] - 0.1, 1)
