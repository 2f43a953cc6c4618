"""Longitude and latitude, told from coordinates in metres."""

import numpy as np
from numpy.typing import NDArray

_WIDEST = 0.1
"""Extent of an object [deg], about 11 km of latitude."""
_FAR = 20.0
"""How many times its extent an object is from where no ship is: longitude and latitude 0."""
_DECIMALS = 4
"""Of a degree, about 11 m."""


def is_geographic(corners: NDArray[np.float64]) -> bool:
    """Tell whether coordinates (k, 2) look like degrees of longitude and latitude.

    They do if they are within the globe's, close together, far from zero, and with decimals that a
    drawing in metres of something that small would not have.

    Examples
    --------
    >>> is_geographic(np.array([(-80.17857, 25.78198), (-80.175, 25.78044), (-80.17804, 25.78297)]))
    True
    >>> is_geographic(np.array([(0.0, 0.0), (0.05, 0.0), (0.05, 0.02)]))
    False
    """
    within = np.abs(corners) <= (180.0, 90.0)
    extent = float(np.ptp(corners, axis=0).max())
    is_far = float(np.linalg.norm(corners.mean(axis=0))) > _FAR * extent
    is_fine = np.abs(corners - corners.round(_DECIMALS - 1)) > 10.0 ** -(_DECIMALS + 6)
    return bool(within.all() and extent < _WIDEST and is_far and is_fine.mean() > 0.5)
