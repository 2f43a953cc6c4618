"""How uneven the difference of two support functions is over all directions (T30).

What a newcomer does not know is e = h - h^, a difference of support functions. On a triangle of
directions, n = sum m_j v_j with m >= 0, the convex h is at most sum m_j h(v_j), and h^ at least
n . c for any c of its set. So e is at most the largest of the three h(v_j) - v_j . c, times the
sum of the m_j, which is at most 1 / (distance of the flat triangle from the origin). Triangles
whose bound leaves no room for doubt are dropped, all others are cut in four.
"""

import math
from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.summary import Summary
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.force_set import best_forces

Array = NDArray[np.float64]
Farthest = Callable[[Array], Array]
"""Gives a convex set's farthest point (k, 3) along each normal (k, 3)."""

CLOSE = 0.05
"""Share of the difference between the two extremes that they may be off by."""
LEAST = 1e-2
"""What they may be off by in any case, as a share of the largest wrench."""
CUTS = 12
MOST_TRIANGLES = 40_000
"""After so many cuts, or above so many triangles, bounds are taken as they are."""
DIGITS = 9
"""Of a robot's pose and limit that tell it from another."""
SAME = 1e9
"""Parts of the largest wrench by which rows are told apart."""


def unevenness(true: Swarm, believed: Swarm | Summary) -> float:
    """Bound max e - min e from above, e = h - h^ over all unit normals [N].

    Parameters
    ----------
    true : Swarm
    believed : Swarm or Summary
        In the same metric. Of a summary, h^ is what it decides by: its lower bound.
    """
    if isinstance(believed, Summary):
        plus, minus, size = _of_summary(true, believed)
    else:
        plus, minus, size = _of_swarm(true, believed)
    if size == 0.0:
        return 0.0
    normals = _mesh().reshape(-1, 3)
    seen = _heights(plus, normals) - _heights(minus, normals)
    slack = max(CLOSE * float(np.ptp(seen)), LEAST * size)
    return greatest(plus, minus, slack) + greatest(minus, plus, slack)


def largest_support(swarm: Swarm) -> float:
    """Bound the support function of robots from above over all unit normals, R of T29 [N]."""
    if not len(swarm):
        return 0.0
    sizes = np.linalg.norm(swarm.scaled_generators, axis=1)
    slack = CLOSE * float(sizes.max())
    return greatest(_swarm_farthest(swarm), np.zeros_like, slack)


def greatest(plus: Farthest, minus: Farthest, slack: float) -> float:
    """Bound from above the difference of two support functions over all unit normals [N].

    Parameters
    ----------
    plus, minus : Farthest
    slack : float [N]
        How far above the largest difference the bound may be.
    """
    triangles, best, dropped = _mesh(), -math.inf, -math.inf
    for cut in range(CUTS + 1):
        corners = triangles.reshape(-1, 3)
        high = _heights(plus, corners)
        best = max(best, float((high - _heights(minus, corners)).max()))
        inner = minus(_unit(triangles.sum(axis=1)))
        tops = (high.reshape(-1, 3) - np.einsum("tjk,tk->tj", triangles, inner)).max(axis=1)
        bounds = np.where(tops > 0.0, tops / _distances(triangles), tops)
        is_open = bounds > best + slack
        if cut == CUTS or 4 * int(is_open.sum()) > MOST_TRIANGLES:
            is_open[:] = False
        dropped = max(dropped, float(bounds[~is_open].max(initial=-math.inf)))
        if not is_open.any():
            break
        triangles = _cut(triangles[is_open])
    return max(best, dropped)


def _of_swarm(true: Swarm, believed: Swarm) -> tuple[Farthest, Farthest, float]:
    """Return what is true and not believed, the other way round, and the largest wrench [N]."""
    known, held = (_as_rows(swarm) for swarm in (true, believed))
    unknown, invented = (_unmatched(a, b) for a, b in ((known, held), (held, known)))
    first, second = (
        swarm.without_rows(np.flatnonzero(~left).tolist())
        for swarm, left in ((true, unknown), (believed, invented))
    )
    sizes = [np.linalg.norm(s.scaled_generators, axis=1).max(initial=0.0) for s in (first, second)]
    return _swarm_farthest(first), _swarm_farthest(second), float(max(sizes))


def _of_summary(true: Swarm, summary: Summary) -> tuple[Farthest, Farthest, float]:
    """Return the same, with all wrenches turned to one side as a summary turns them.

    max(0, n . b) = max(0, n . b') + min(0, +-n . b), linear: it goes into a steady wrench.
    """
    rows, support = true.scaled_generators, summary.support
    turned, steady = _turned(rows)
    sums, offset = _turned(support.sums)
    size = float(np.abs(rows).max(initial=0.0))
    unit = max(size, np.finfo(float).tiny) / SAME
    first, second = np.rint(turned / unit), np.rint(sums / unit)
    more = turned[_unmatched(first, second)]
    less = sums[_unmatched(second, first)]
    wrench = steady - offset - np.array(support.load)
    if not len(more) and not len(less) and np.abs(wrench).max() <= unit * SAME * LEAST:
        size = 0.0
    return _ray_farthest(more, wrench), _ray_farthest(less, np.zeros(3)), size


def _turned(rows: Array) -> tuple[Array, Array]:
    """Turn rows so that the largest component is positive; return also the sum of those turned."""
    largest = np.take_along_axis(rows, np.abs(rows).argmax(axis=1)[:, None], axis=1)[:, 0]
    is_turned = largest < 0.0
    return np.where(is_turned[:, None], -rows, rows), rows[is_turned].sum(axis=0)


def _as_rows(swarm: Swarm) -> Array:
    """Return what tells robots apart, a row each, but for rounding."""
    columns = [swarm.contacts, swarm.directions, swarm.steers, swarm.limits]
    return np.asarray(np.column_stack(columns).round(DIGITS), dtype=float)


def _unmatched(rows: Array, others: Array) -> NDArray[np.bool_]:
    """Tell which rows have no equal among others; each of those is the equal of one only."""
    left: dict[bytes, int] = {}
    for row in others + 0.0:
        left[row.tobytes()] = left.get(row.tobytes(), 0) + 1
    found = np.ones(len(rows), dtype=bool)
    for k, row in enumerate(rows + 0.0):
        if left.get(row.tobytes(), 0):
            left[row.tobytes()] -= 1
            found[k] = False
    return found


def _ray_farthest(rows: Array, steady: Array) -> Farthest:
    """Return the farthest point of rays beside a steady wrench."""
    return lambda normals: steady + (normals @ rows.T > 0.0) @ rows


def _swarm_farthest(swarm: Swarm) -> Farthest:
    """Return the farthest point of robots of any kind."""
    (x, y), scale = (swarm.contacts - swarm.outline.origin).T, swarm.scale
    sets = swarm.force_sets

    def farthest(normals: Array) -> Array:
        """Let each robot push as far along each normal as it can."""
        ahead, aside, turn = (normals * scale).T[:, :, None]
        ways = np.stack([ahead - turn * y, aside + turn * x], axis=-1)
        fx, fy = np.moveaxis(best_forces(sets, ways), -1, 0)
        parts = (fx, fy, x * fy - y * fx)
        return np.asarray(scale * np.column_stack([part.sum(axis=1) for part in parts]))

    return farthest


def _heights(farthest: Farthest, normals: Array) -> Array:
    """Compute a support function at normals (k, 3): (k,) [N]."""
    return np.asarray(np.einsum("ij,ij->i", normals, farthest(normals)))


@lru_cache(maxsize=1)
def _mesh() -> Array:
    """Return the faces of an octahedron, each cut in 16, blown up to the sphere: (128, 3, 3)."""
    signs = np.array([(a, b, c) for a in (1.0, -1.0) for b in (1.0, -1.0) for c in (1.0, -1.0)])
    return _cut(_cut(signs[:, :, None] * np.eye(3)))


def _cut(triangles: Array) -> Array:
    """Cut triangles (t, 3, 3) in four each, at the middles of their sides."""
    a, b, c = np.moveaxis(triangles, 1, 0)
    ab, bc, ca = (_unit(p + q) for p, q in ((a, b), (b, c), (c, a)))
    parts = ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
    return np.concatenate([np.stack(part, axis=1) for part in parts])


def _distances(triangles: Array) -> Array:
    """Return the distances of flat triangles (t, 3, 3) from the origin: (t,)."""
    a, b, c = np.moveaxis(triangles, 1, 0)
    across = _unit(np.cross(b - a, c - a))
    return np.asarray(np.abs(np.einsum("ij,ij->i", across, a)))


def _unit(rows: Array) -> Array:
    """Scale rows to length 1."""
    return np.asarray(rows / np.linalg.norm(rows, axis=1, keepdims=True))
