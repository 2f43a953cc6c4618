"""Polygons of several numbers of corners, as matplotlib draws them in space."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike


def masked(polygons: Sequence[ArrayLike]) -> "np.ma.MaskedArray[Any, Any]":
    """Return polygons (k, 3) as one array, zeros masked where some have fewer corners than others.

    Of polygons in a list, matplotlib leaves there what memory holds, which may overflow as it is
    projected.

    Examples
    --------
    >>> found = masked([np.ones((3, 3)), np.ones((4, 3))])
    >>> found.shape, found.mask[..., 0].tolist()[0], found.data[0, 3].tolist()
    ((2, 4, 3), [False, False, False, True], [0.0, 0.0, 0.0])
    """
    rows = [np.asarray(polygon, float) for polygon in polygons]
    corners = np.zeros((len(rows), max(map(len, rows)), 3))
    is_none = np.ones(corners.shape, dtype=bool)
    for k, row in enumerate(rows):
        corners[k, : len(row)], is_none[k, : len(row)] = row, False
    return np.ma.MaskedArray(corners, is_none)
