"""Lines that pull on an object: where they run free of it, and where they meet it.

A line that has left the convex hull of the outline never comes back. So only the bight that a
contact lies in, the boundary between two corners of the hull that lies inside it, can be in the way
of a line from there. What lies to port of the contact and what lies to starboard each take away a
sector of directions that begins at the edge, and the one window between them is free, or none is.
"""

import math
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.outline.outline import Outline

if TYPE_CHECKING:
    from shapely import LineString

Array = NDArray[np.float64]

FINEST = 0.0173
"""Change of a window along a cell [rad] below which the cell is not halved: almost 1 degree."""
MOST_HALVINGS = 10
"""Of an edge into cells."""
CLOSED_HALVINGS = 6
"""Of an edge into parts from both of whose ends no line runs free: one between may."""
GRAZES = 1e-9
"""Of the extent: how far a line may run inside the object and only touch it."""
REMEMBERED = 32
"""Outlines whose cells are kept for the next question."""


class Cell(NamedTuple):
    """A part of an edge, and the directions in which a line from anywhere on it runs free.

    Attributes
    ----------
    start, end : float [m]
        Distances along the edge.
    lo, hi : float [rad]
        Counter-clockwise from the edge's outward normal.
    """

    start: float
    end: float
    lo: float
    hi: float


class Meeting(NamedTuple):
    """Where a line meets the object again.

    Attributes
    ----------
    point : tuple of float [m, m]
    edge : int
    distance : float [m]
        From its contact.
    """

    point: tuple[float, float]
    edge: int
    distance: float


def meeting(outline: Outline, contact: tuple[float, float], direction: float) -> Meeting | None:
    """Return where a line from a contact runs into the object, None if it runs free.

    Parameters
    ----------
    outline : Outline
    contact : tuple of float [m, m]
        On the boundary.
    direction : float [rad]
        In which the line pulls.

    Examples
    --------
    From inside a U that is open to +x, a line aft meets its bottom, and one ahead runs free.

    >>> corners = [(0, 0), (6, 0), (6, 1), (1, 1), (1, 4), (6, 4), (6, 5), (0, 5)]
    >>> dock = Outline(corners)
    >>> met = meeting(dock, (4.0, 1.0), math.radians(150.0))
    >>> met.edge, round(met.distance, 6)
    (3, 3.464102)
    >>> meeting(dock, (4.0, 1.0), math.radians(45.0)) is None
    True
    """
    from shapely import LineString, Polygon

    x, y = contact
    c, s = math.cos(direction), math.sin(direction)
    reach, near = 2.0 * outline.extent, GRAZES * outline.extent
    line = LineString([(x, y), (x + reach * c, y + reach * s)])
    found = Polygon(outline.vertices).intersection(line)
    runs = [part for part in getattr(found, "geoms", [found]) if part.length > near]
    runs = [run for run in runs if _is_inside(run, outline)]
    if not runs:
        return None
    distance, point = min((math.dist(contact, p), p) for run in runs for p in run.coords)
    edge = outline.at_point(point).edge
    return Meeting((point[0], point[1]), edge, distance)


def _is_inside(run: "LineString", outline: Outline) -> bool:
    """Tell whether a part of a line is inside, and not along an edge: at its middle."""
    middle = run.interpolate(0.5, normalized=True)
    (distance,), _ = outline.nearest([(middle.x, middle.y)])
    return bool(distance > GRAZES * outline.extent)


@lru_cache(maxsize=REMEMBERED)
def free_cells(outline: Outline) -> tuple[tuple[Cell, ...] | None, ...]:
    """Cut every edge where the window of free directions changes.

    Returns
    -------
    tuple of (tuple of Cell) or None
        One for each edge; None for an edge from all of which all lines outward run free, and no
        cell where none does. What is free from less than a 64th of an edge only may be missed. The
        window of a single contact is wider than its cell's by less than `FINEST` at each end, but
        for cells of the last halving.
    """
    cells: list[tuple[Cell, ...] | None] = [None] * len(outline)
    for corners in _bights(outline):
        for k, edge in enumerate(corners[:-1]):
            cells[edge] = tuple(_cells(outline, corners, k))
    return tuple(cells)


def _bights(outline: Outline) -> list[list[int]]:
    """Return the corners of each bight in order, the two on the hull first and last."""
    from shapely import MultiPoint, distance, points

    hull = MultiPoint(outline.vertices).convex_hull.exterior
    heights = distance(points(outline.vertices), hull)
    on_hull = np.flatnonzero(heights <= GRAZES * outline.extent).tolist()
    count = len(outline)
    return [
        [k % count for k in range(first, last + 1)]
        for first, last in zip(on_hull, [*on_hull[1:], on_hull[0] + count], strict=True)
        if last - first > 1
    ]


def _cells(outline: Outline, corners: list[int], k: int) -> list[Cell]:
    """Cut the edge between the corners k and k + 1 of a bight into cells."""
    points = outline.vertices[corners]
    p, q = points[k], points[k + 1]
    length = float(outline.lengths[corners[k]])

    def window(share: float) -> tuple[float, float]:
        """Return the free directions at a share of the way."""
        return _window(p + share * (q - p), points, k)

    cells: list[Cell] = []
    waiting = [(0.0, 1.0, window(0.0), window(1.0), 0)]
    while waiting:
        a, b, at_a, at_b, halvings = waiting.pop()
        if halvings == MOST_HALVINGS or not _differ(at_a, at_b, halvings):
            # the direction of a corner turns one way only along an edge: a window between is no
            # narrower than at both ends
            lo, hi = max(at_a[0], at_b[0]), min(at_a[1], at_b[1])
            if lo <= hi:
                cells.append(Cell(a * length, b * length, lo, hi))
        else:
            middle = 0.5 * (a + b)
            between = window(middle)
            waiting.append((middle, b, between, at_b, halvings + 1))
            waiting.append((a, middle, at_a, between, halvings + 1))
    return cells


def _differ(one: tuple[float, float], other: tuple[float, float], halvings: int) -> bool:
    """Tell whether two windows differ: one of them is none, or their ends do.

    Where both are none there may be one between, unless what is hidden from either side at one end
    reaches past what is hidden from the other side at the other: along an edge all that is in front
    turns one way.
    """
    is_closed, is_other_closed = one[0] > one[1], other[0] > other[1]
    if is_closed and is_other_closed:
        may_open = min(one[0], other[0]) <= max(one[1], other[1])
        return may_open and halvings < CLOSED_HALVINGS
    if is_closed or is_other_closed:
        return True
    return max(abs(one[0] - other[0]), abs(one[1] - other[1])) > FINEST


def _window(p: Array, points: Array, k: int) -> tuple[float, float]:
    """Return the free directions [rad] at a point of the edge from k to k + 1 of a bight.

    Along the boundary to either side the direction of what is there, counted on through every turn,
    begins at the edge's own. The farthest that it comes over is where free directions end.
    """
    along = points[k + 1] - points[k]  # a quarter turn counter-clockwise of the outward normal
    hi = 0.5 * math.pi + min(0.0, float(_turns(along, points[k + 2 :] - p).min(initial=0.0)))
    lo = -0.5 * math.pi + max(0.0, float(_turns(-along, points[:k][::-1] - p).max(initial=0.0)))
    return lo, hi


def _turns(start: Array, steps: Array) -> Array:
    """Return how far vectors (k, 2) have turned from a first one, each counted on [rad]."""
    ways = np.vstack([start, steps])
    x, y = ways.T
    sine, cosine = x[:-1] * y[1:] - y[:-1] * x[1:], (ways[:-1] * ways[1:]).sum(axis=1)
    turns: Array = np.cumsum(np.arctan2(sine, cosine))
    return turns
