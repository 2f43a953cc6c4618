"""Directions in which a line that pulls runs free of the object, found anew for the check.

Every other edge hides the directions between its two ends. What no edge hides is free. An edge is
cut in two as long as its free directions differ by more at its ends, and a part allows what is free
at both.
"""

import math
from collections.abc import Iterator

import numpy as np

from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.recompute import Array

FINEST = 0.0173
"""Difference [rad] at which a part of an edge is not cut any more."""
MOST_HALVINGS, CLOSED_HALVINGS = 10, 6
"""Of an edge, and of one whose parts have no free directions at both ends."""

NOTHING = 1e-12
"""Width [rad] of free directions that is none: between two edges that meet."""
RIGHT_ANGLE = 0.5 * math.pi
NONE = (RIGHT_ANGLE, -RIGHT_ANGLE)

Free = tuple[float, float] | None
Part = tuple[float, float, float, float]


def free_parts(boundary: Boundary, edge: int, start: float, end: float) -> Iterator[Part]:
    """Yield the parts of a stretch of an edge in which lines run free alike.

    Parameters
    ----------
    boundary : Boundary
    edge : int
    start, end : float [m]
        Distances along the edge.

    Yields
    ------
    start, end : float [m]
    lo, hi : float [rad]
        The free directions, from the outward normal; in (-pi / 2, pi / 2) where nothing is in the
        way.
    """
    p, q = boundary.edge(edge)
    length = float(boundary.lengths[edge])
    if float(((boundary.corners - p) @ _outward(p, q)).max()) <= boundary.sliver:
        yield start, end, -RIGHT_ANGLE, RIGHT_ANGLE
        return
    parts = [(0.0, 1.0, 0)]
    while parts:
        a, b, halvings = parts.pop()
        if b * length < start or a * length > end:
            continue
        ends = [_free(boundary, edge, share) for share in (a, b)]
        most = CLOSED_HALVINGS if ends == [None, None] else MOST_HALVINGS
        if _differ(*ends) and halvings < most:
            middle = 0.5 * (a + b)
            parts += [(a, middle, halvings + 1), (middle, b, halvings + 1)]
            continue
        (lo_a, hi_a), (lo_b, hi_b) = (found or NONE for found in ends)
        lo, hi = max(lo_a, lo_b), min(hi_a, hi_b)
        first, last = max(start, a * length), min(end, b * length)
        if lo <= hi and (last - first > boundary.sliver or start == end):
            yield first, last, lo, hi


def _differ(one: Free, other: Free) -> bool:
    """Tell whether two contacts have other free directions, or contacts between them may."""
    if one is None or other is None:
        return True
    return max(abs(one[0] - other[0]), abs(one[1] - other[1])) > FINEST


def _outward(p: Array, q: Array) -> Array:
    """Return the outward normal (2,) of an edge."""
    x, y = q - p
    return np.array([y, -x]) / math.hypot(x, y)


def _free(boundary: Boundary, edge: int, share: float) -> Free:
    """Return the free directions [rad] at a share of the way along an edge, None without any."""
    p, q = boundary.edge(edge)
    normal, along, point = _outward(p, q), (q - p) / boundary.lengths[edge], p + share * (q - p)

    def seen(corners: Array) -> Array:
        """Return the directions in which corners are seen, those at the point along the edge."""
        x, y = (corners - point) @ along, (corners - point) @ normal
        at = np.arctan2(x, y)
        here = np.hypot(x, y) <= boundary.sliver
        return np.asarray(np.where(here, RIGHT_ANGLE if share > 0.5 else -RIGHT_ANGLE, at))

    others = np.arange(len(boundary.lengths)) != edge
    first = seen(boundary.corners)[others]
    last = seen(np.roll(boundary.corners, -1, axis=0))[others]
    low, high = np.minimum(first, last), np.maximum(first, last)
    around = high - low > math.pi  # seen across the inward normal
    half = np.full(int(around.sum()), math.pi)
    hidden = np.vstack([
        np.column_stack([low, high])[~around],
        np.column_stack([-half, low[around]]),
        np.column_stack([high[around], half]),
    ])  # fmt: skip
    reached = -RIGHT_ANGLE
    for start, end in [*sorted(hidden.tolist()), [RIGHT_ANGLE, math.pi]]:
        until = min(start, RIGHT_ANGLE)
        if until - reached > NOTHING:
            return reached, until
        reached = max(reached, end)
    return None
