"""Speeds as seamen tell them: knots and the Beaufort scale."""

from bisect import bisect_right

from swarmgrasp.terms import KNOT

_LEAST = (0.3, 1.6, 3.4, 5.5, 8.0, 10.8, 13.9, 17.2, 20.8, 24.5, 28.5, 32.7)
"""Least wind speeds [m/s] of Beaufort 1 to 12, as the World Meteorological Organization
lists them."""

__all__ = ["KNOT", "beaufort"]


def beaufort(speed: float) -> int:
    """Return the Beaufort number of a wind, from 0 to 12.

    Parameters
    ----------
    speed : float [m/s]
        The mean over ten minutes, 10 m above the sea; rounded to 0.1 m/s, as the scale is.

    Examples
    --------
    A fresh breeze, a storm, a hurricane:

    >>> beaufort(9.0), beaufort(50 * KNOT), beaufort(40.0)
    (5, 10, 12)
    """
    return bisect_right(_LEAST, round(speed, 1))
