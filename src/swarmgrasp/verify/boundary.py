"""The boundary of the object, for the check of an answer."""

from typing import TYPE_CHECKING

import numpy as np

from swarmgrasp.verify.recompute import Array, distance_to, share_along

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import OutlineClaim

NEAR = 1e-6
"""Distance of a contact from the boundary that counts as none, relative to the extent."""
SLIVER = 1e-9
"""Width of contacts, allowed or not, that counts as rounding, relative to the extent."""


class Boundary:
    """A polygon, counter-clockwise.

    Attributes
    ----------
    corners : (n, 2) [m, m]
    origin : (2,) [m, m]
        Of moments.
    names : tuple of str
        Of the edges; edge k runs from corner k to the next.
    lengths : (n,) [m]
        Of the edges.
    arcs : (n + 1,) [m]
        Arc length at each corner, from the first; the last is the perimeter.
    precision : float [m]
        How far each coordinate may be off.
    near, sliver : float [m]
        A distance and a width that count as none.
    """

    def __init__(self, outline: "OutlineClaim") -> None:
        self.corners, self.origin = np.array(outline.vertices), np.array(outline.origin)
        self.names, self.precision = tuple(outline.edge_names), outline.precision
        self._ends = np.roll(self.corners, -1, axis=0)
        self.lengths = np.asarray(np.linalg.norm(self._ends - self.corners, axis=1))
        self.arcs = np.concatenate([[0.0], np.cumsum(self.lengths)])
        extent = float(np.linalg.norm(np.ptp(self.corners, axis=0)))
        self.near, self.sliver = NEAR * extent, SLIVER * extent

    @property
    def perimeter(self) -> float:
        """Length of the boundary [m]."""
        return float(self.arcs[-1])

    @property
    def radius(self) -> float:
        """The largest distance from the origin to the boundary [m]."""
        return float(np.linalg.norm(self.corners - self.origin, axis=1).max())

    def edge(self, k: int) -> tuple[Array, Array]:
        """Return the two ends (2,) [m, m] of an edge."""
        return self.corners[k], self._ends[k]

    def has(self, point: Array) -> bool:
        """Tell whether a point lies on an edge."""
        return bool(self._distances(point).min() <= self.near)

    def at(self, point: Array) -> list[int]:
        """Return the edges that a point lies on: two at a corner."""
        return [int(k) for k in np.flatnonzero(self._distances(point) <= self.near)]

    def surrounds(self, point: Array) -> bool:
        """Tell whether a point is inside."""
        return surrounds(self.corners, point)

    def around(self, point: Array, first: float, last: float) -> Array:
        """Return points between which the boundary near a contact is straight.

        Parameters
        ----------
        point : (2,) [m, m]
            The contact.
        first, last : float [m]
            ``first <= 0 <= last``: how far the stretch reaches from there, along the boundary.

        Returns
        -------
        (m, 2) [m, m]
            The two ends of the stretch, and the corners on it between them, in order.
        """
        k = int(np.argmin(self._distances(point)))
        here = self.arcs[k] + self.lengths[k] * share_along(point, *self.edge(k))
        width = min(last - first, self.perimeter)
        past = (self.arcs[:-1] - here - first) % self.perimeter
        order = np.argsort(past, kind="stable")
        between = self.corners[order[past[order] <= width]]
        return np.vstack([self._at(here + first), between, self._at(here + first + width)])

    def _at(self, arc: float) -> Array:
        """Return the point (2,) [m, m] at an arc length, on any lap."""
        arc = arc % self.perimeter
        k = min(int(np.searchsorted(self.arcs, arc, "right")) - 1, len(self.lengths) - 1)
        (p, q), length = self.edge(k), float(self.lengths[k])
        share = float(arc - self.arcs[k]) / length if length > 0.0 else 0.0
        return np.asarray(p + min(share, 1.0) * (q - p))

    def _distances(self, point: Array) -> Array:
        """Return the distance [m] of a point from each edge."""
        return np.array(
            [distance_to(point, p, q) for p, q in zip(self.corners, self._ends, strict=True)]
        )


def surrounds(corners: Array, point: Array) -> bool:
    """Tell whether a point is inside a polygon: a ray from it crosses an odd number of edges."""
    x, y = point
    a, b = corners, np.roll(corners, -1, axis=0)
    spans = (a[:, 1] > y) != (b[:, 1] > y)
    a, b = a[spans], b[spans]
    meets = a[:, 0] + (y - a[:, 1]) * (b[:, 0] - a[:, 0]) / (b[:, 1] - a[:, 1])
    return bool(np.count_nonzero(meets > x) % 2)
