"""Longitude and latitude, told from coordinates in metres."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

WIDEST = 0.05
"""Degrees across, 5.5 km of latitude, up to which coordinates may be an object's."""
_FAR = 20.0
"""How many times its extent an object is from where no ship is: longitude and latitude 0."""
_DECIMALS = 3
"""Of a degree, about 110 m."""


def may_be_geographic(corners: ArrayLike) -> bool:
    """Tell whether coordinates (k, 2) may be degrees of longitude and latitude of an object.

    They may if they are within the globe's, and no farther apart than objects are large.

    Examples
    --------
    >>> may_be_geographic([(10.1, 54.3), (10.101, 54.3), (10.1, 54.301)])
    True
    >>> may_be_geographic([(0, 0), (60, 0), (60, 20)])
    False
    >>> may_be_geographic([(179.99, 10.0), (-179.99, 10.0), (180.0, 10.01)])
    True
    """
    points = np.asarray(corners, float)
    is_on_globe = bool((np.abs(points) <= (180.0, 90.0)).all())
    return is_on_globe and float(_extents(points).max()) <= WIDEST


def is_geographic(corners: NDArray[np.float64]) -> bool:
    """Tell whether coordinates (k, 2) that are said to be lengths are degrees all the same.

    They are if they may be, lie far from zero, and have decimals that a drawing in metres of
    something that small would not have.

    Examples
    --------
    >>> is_geographic(np.array([(-80.17857, 25.78198), (-80.175, 25.78044), (-80.17804, 25.78297)]))
    True
    >>> is_geographic(np.array([(0.0, 0.0), (0.05, 0.0), (0.05, 0.02)]))
    False
    """
    if not may_be_geographic(corners):
        return False
    is_far = float(np.linalg.norm(corners[0])) > _FAR * float(_extents(corners).max())
    is_fine = np.abs(corners - corners.round(_DECIMALS)) > 10.0 ** -(_DECIMALS + 7)
    return is_far and bool(is_fine.mean() > 0.5)


def _extents(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far apart points are [deg], east to west and north to south."""
    east = np.remainder(points[:, 0] - points[0, 0] + 180.0, 360.0)
    return np.asarray(np.ptp(np.column_stack([east, points[:, 1]]), axis=0))
