"""Rows of vectors turned between frames, and matrices times them: each row as if it were alone.

Products are written out, because those of a linear algebra library differ in the last bit with the
number of rows.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def turned(rows: Array, headings: Array, back: bool = False) -> Array:
    """Return vectors (runs, 3) of the object's frame in the earth's; the other way with `back`.

    Parameters
    ----------
    rows : (runs, 3)
        x, y, and a turn, which stays.
    headings : (runs,) [rad]
    back : bool

    Examples
    --------
    >>> turned(np.array([[1.0, 0.0, 5.0]]), np.array([0.5 * np.pi])).round(12).tolist()
    [[0.0, 1.0, 5.0]]
    """
    flat = np.ascontiguousarray(headings)
    cos, sin = np.cos(flat), np.sin(flat)
    if back:
        sin = -sin
    found = np.empty_like(rows)
    found[:, 0] = cos * rows[:, 0] - sin * rows[:, 1]
    found[:, 1] = sin * rows[:, 0] + cos * rows[:, 1]
    found[:, 2] = rows[:, 2]
    return found


def times(matrix: Array, rows: Array) -> Array:
    """Return a matrix (3, 3) times each of some vectors (runs, 3)."""
    found = np.empty_like(rows)
    for i, (a, b, c) in enumerate(matrix.tolist()):
        found[:, i] = a * rows[:, 0] + b * rows[:, 1] + c * rows[:, 2]
    return found


def nearest_turns(rows: Array) -> Array:
    """Return vectors (..., 3) whose turns [rad] go the shorter way, within [-pi, pi]."""
    found = np.array(rows)
    found[..., 2] -= 2.0 * np.pi * np.round(found[..., 2] / (2.0 * np.pi))
    return found
