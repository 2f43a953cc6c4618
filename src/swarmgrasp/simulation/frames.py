"""Rows of vectors turned between frames, and matrices times them: each row as if it were alone.

Products are written out, because those of a linear algebra library differ in the last bit with the
number of rows.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Headings:
    """How the frames of some objects stand in the earth's.

    Vectors are rows (runs, 3): x, y, and a turn, which is the same in both.

    Parameters
    ----------
    angles : (runs,) [rad]

    Examples
    --------
    >>> abeam = Headings(np.array([0.5 * np.pi]))
    >>> abeam.to_earth(np.array([[1.0, 0.0, 5.0]])).round(12).tolist()
    [[0.0, 1.0, 5.0]]
    """

    def __init__(self, angles: Array) -> None:
        flat = np.ascontiguousarray(angles)
        self._cos, self._sin = np.cos(flat), np.sin(flat)

    def to_earth(self, rows: Array) -> Array:
        """Return vectors of the objects' frames in the earth's."""
        return self._turned(rows, self._sin)

    def to_object(self, rows: Array) -> Array:
        """Return vectors of the earth's frame in the objects'."""
        return self._turned(rows, -self._sin)

    def _turned(self, rows: Array, sin: Array) -> Array:
        """Return vectors turned by the angles of these sines."""
        found, (x, y, turn) = np.empty_like(rows), rows.T
        found[:, 0] = self._cos * x - sin * y
        found[:, 1] = sin * x + self._cos * y
        found[:, 2] = turn
        return found


def times(matrix: Array, rows: Array) -> Array:
    """Return a matrix (3, 3) times each of some vectors (runs, 3)."""
    found, (x, y, turn) = np.empty_like(rows), rows.T
    for i, (a, b, c) in enumerate(matrix.tolist()):
        found[:, i] = a * x + b * y + c * turn
    return found


def nearest_turns(rows: Array) -> Array:
    """Return vectors (..., 3) whose turns [rad] go the shorter way, within [-pi, pi]."""
    found = np.array(rows)
    found[..., 2] -= 2.0 * np.pi * np.round(found[..., 2] / (2.0 * np.pi))
    return found
