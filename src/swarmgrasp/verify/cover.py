"""Whether patches of contacts cover an area, but for what is no more than rounding.

Between two neighbouring abscissas of all corners every edge is straight, and an area is made of
trapezoids. One of them is covered if patches follow each other from its lower edge to its upper
one, each reaching the next at both ends: then they do between, too.
"""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.verify.recompute import Array


def is_covered(area: Array, patches: list[Array], sliver: float) -> bool:
    """Tell whether patches cover an area.

    Parameters
    ----------
    area : (k, 2) [m, m]
        Corners in order: of a spot, a line or a polygon.
    patches : list of (k, 2) [m, m]
        Corners, one to three each.
    sliver : float [m]
        A width that counts as none.

    Examples
    --------
    >>> square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    >>> halves = [square[[0, 1, 2]], square[[2, 3, 0]]]
    >>> is_covered(square, halves, 1e-9), is_covered(square, halves[1:], 1e-9)
    (True, False)
    """
    wide = np.ptp(area, axis=0)
    if len(area) == 2:  # turned so that it is level
        step = (area[1] - area[0]) / max(float(np.linalg.norm(wide)), np.finfo(float).tiny)
        turn = np.array([[step[0], -step[1]], [step[1], step[0]]])
        area, patches = area @ turn, [patch @ turn for patch in patches]
    elif wide[1] > wide[0]:
        area, patches = area[:, ::-1], [patch[:, ::-1] for patch in patches]
    if float(np.ptp(area, axis=0).max()) <= sliver:
        return any((np.abs(patch - area[0]) <= sliver).all(axis=1).any() for patch in patches)
    near = 0.5 * sliver
    cuts = _apart(np.concatenate([area[:, 0], *(patch[:, 0] for patch in patches)]), near)
    first, last = float(area[:, 0].min()), float(area[:, 0].max())
    inside = [c for c in cuts if first - near <= c <= last + near]
    corners = np.array([(*patch, patch[-1], patch[-1])[:3] for patch in patches]).reshape(-1, 3, 2)
    order = np.argsort(corners[:, :, 0], axis=1, kind="stable")
    corners = np.take_along_axis(corners, order[:, :, None], axis=1)  # from left to right
    for ends in np.array(list(pairwise(inside))):
        here = (corners[:, 0, 0] <= ends[0] + near) & (corners[:, 2, 0] >= ends[1] - near)
        edges = _edges(corners[here], ends)
        if not all(_is_filled(part, *edges, sliver, ends) for part in _parts(area, ends)):
            return False
    return len(inside) > 1


def _apart(values: Array, near: float) -> list[float]:
    """Return values in order, without those that are near the one before."""
    found: list[float] = []
    for value in np.unique(values).tolist():
        if not found or value > found[-1] + near:
            found.append(value)
    return found


def _at(p: Array, q: Array, ends: Array) -> Array:
    """Return the ordinates (m, 2) of edges at two abscissas, or at their own ends between.

    The edges run from p to q, (m, 2) each; of one with a single abscissa it is the middle.
    """
    wide = q[:, :1] - p[:, :1]
    shares = (ends - p[:, :1]) / np.where(wide == 0.0, 1.0, wide)
    shares = np.where(wide == 0.0, 0.5, np.clip(shares, 0.0, 1.0))
    return np.asarray(p[:, 1:] + shares * (q[:, 1:] - p[:, 1:]))


def _edges(corners: Array, ends: Array) -> tuple[Array, Array]:
    """Return the lower and the upper edges (m, 2) of patches (m, 3, 2) between two abscissas."""
    first, middle, last = corners.transpose(1, 0, 2)
    is_before = (middle[:, :1] > ends.mean()) | (middle[:, :1] == last[:, :1])
    bent = _at(np.where(is_before, first, middle), np.where(is_before, middle, last), ends)
    straight = _at(first, last, ends)
    is_low = (bent.sum(axis=1) < straight.sum(axis=1))[:, None]
    return np.where(is_low, bent, straight), np.where(is_low, straight, bent)


def _parts(area: Array, ends: Array) -> Array:
    """Return the trapezoids (m, 2, 2) of an area between two abscissas: their two edges."""
    middle, after = float(ends.mean()), np.roll(area, -1, axis=0)
    spans = (area[:, 0] > middle) != (after[:, 0] > middle)
    rows = _at(area[spans], after[spans], ends)
    return rows[np.argsort(rows.sum(axis=1), kind="stable")].reshape(-1, 2, 2)


def _is_filled(part: Array, low: Array, high: Array, sliver: float, ends: Array) -> bool:
    """Tell whether patches follow each other from the lower to the upper edge of a trapezoid.

    Their edges are low and high, (m, 2).
    """
    wide = float(ends[1] - ends[0])
    tops = _is_below(part[1:], high, sliver, wide)
    left, reached = np.ones(len(low), dtype=bool), [part[0]]
    while reached:
        following = np.flatnonzero(left & _is_below(low, reached.pop()[None], sliver, wide))
        if tops[following].any():
            return True
        left[following] = False
        reached += list(high[following])
    return False


def _is_below(edges: Array, others: Array, sliver: float, wide: float) -> NDArray[np.bool_]:
    """Tell which edges lie below others, (m, 2) or (1, 2) each.

    But for a strip that is no wider than a sliver.
    """
    steep = np.minimum(*(np.abs(side[:, 1] - side[:, 0]) for side in (edges, others))) / wide
    return np.asarray((edges <= others + sliver * np.hypot(1.0, steep)[:, None]).all(axis=1))
