"""Many points against the edges of one polygon: the nearest edge points, and who is inside."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.frozen import read_only

PAIRS_AT_ONCE = 32_768
"""Points times edges that are looked at together: what the processor's cache holds."""

Array = NDArray[np.float64]


class Nearest(NamedTuple):
    """The nearest edges of n points, and the nearest points on them."""

    distances: Array
    """(n,) [m]"""
    edges: NDArray[np.intp]
    """(n,): the first one of those equally near."""
    alongs: Array
    """(n,) [m]: of the nearest points from the starts of their edges."""


class Edges(NamedTuple):
    """The k edges of a polygon, as columns to be set against rows of points.

    Examples
    --------
    >>> triangle = edges_of(np.array([[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]))
    >>> [found.tolist() for found in triangle.nearest(np.array([[1.0, -3.0]]))]
    [[3.0], [0], [1.0]]
    >>> triangle.enclose(np.array([[0.5, 0.5], [1.5, 1.5], [-1.0, 0.5]])).tolist()
    [True, False, False]
    """

    start_x: Array
    """(k, 1) [m], as are the others but the two units."""
    start_y: Array
    end_x: Array
    end_y: Array
    unit_x: Array
    unit_y: Array
    length: Array

    def nearest(self, points: Array) -> Nearest:
        """Find the edges nearest to points, (n, 2) [m, m]."""
        with np.errstate(over="ignore"):  # of points some 1e154 m away
            if len(points) * len(self.length) <= PAIRS_AT_ONCE:
                return self._nearest(points)
            found = [self._nearest(points[part]) for part in self._parts(len(points))]
        return Nearest(*map(np.concatenate, zip(*found, strict=True)))

    def _nearest(self, points: Array) -> Nearest:
        """Do so for a few of the points."""
        x, y = points.T.copy()
        off_x, off_y = x - self.start_x, y - self.start_y  # (k, n)
        along = off_x * self.unit_x
        along += off_y * self.unit_y
        np.maximum(along, 0.0, out=along)
        np.minimum(along, self.length, out=along)
        off_x -= along * self.unit_x
        off_y -= along * self.unit_y
        off_x *= off_x
        off_y *= off_y
        off_x += off_y
        edges = off_x.argmin(axis=0)
        best = edges * len(edges) + np.arange(len(edges))
        return Nearest(np.sqrt(off_x.take(best)), edges, along.take(best))

    def enclose(self, points: Array) -> NDArray[np.bool_]:
        """Tell which points, (n, 2) [m, m], are inside; undecided for those on an edge."""
        inside = np.empty(len(points), dtype=bool)
        level = self.start_y == self.end_y
        rise = np.where(level, 1.0, self.end_y - self.start_y)
        run = self.end_x - self.start_x
        for part in self._parts(len(points)):
            x, y = points[part].T.copy()
            spans = (self.start_y > y) != (self.end_y > y)
            ahead = self.start_x + (y - self.start_y) * run / rise > x
            inside[part] = np.logical_xor.reduce(spans & ahead, axis=0)  # crossed oddly
        return inside

    def _parts(self, points: int) -> Iterator[slice]:
        """Yield the stretches of points to look at together."""
        step = max(1, PAIRS_AT_ONCE // len(self.length))
        for first in range(0, points, step):
            yield slice(first, first + step)


def chords(
    starts: Array, units: Array, points: Array, distance: float, slack: float = 0.0
) -> tuple[NDArray[np.intp], Array, Array]:
    """Find the parts of lines within circles: of one line in many, or of many lines in one.

    Parameters
    ----------
    starts, units : (2,) or (k, 2) [m, m]
        Points of the lines, and unit vectors along them.
    points : (2,) or (k, 2) [m, m]
        The middles of the circles.
    distance : float [m]
        Their radius.
    slack : float [m]
        By how much more than just so a line is to be inside.

    Returns
    -------
    rows : (m,)
        Which ones cross.
    first, last : (m,) [m]
        From where to where along the line.

    Examples
    --------
    >>> rows, first, last = chords(np.zeros(2), np.array([1.0, 0.0]), np.array([[2.0, 3.0]]), 5.0)
    >>> rows.tolist(), first.tolist(), last.tolist()
    ([0], [-2.0], [6.0])
    """
    offsets = points - starts
    units = np.broadcast_to(units, offsets.shape)
    heights = np.abs(offsets[:, 0] * units[:, 1] - offsets[:, 1] * units[:, 0])
    near = heights < distance - slack
    middles = (offsets[near] * units[near]).sum(axis=1)
    halves = np.sqrt(distance**2 - heights[near] ** 2)
    return np.flatnonzero(near), middles - halves, middles + halves


def edges_of(corners: Array) -> Edges:
    """Return the edges of a polygon, (k, 2) [m, m]; each ends where the next one starts."""
    ends = np.roll(corners, -1, axis=0)
    lengths = np.linalg.norm(ends - corners, axis=1)[:, None]
    units = (ends - corners) / lengths
    columns = read_only(np.hstack([corners, ends, units, lengths]).T.copy())
    return Edges(*columns[:, :, None])
