"""The least of a lower bound on the support function, where robots have force sets (T12, T13).

A spherical triangle with corners v_j is bounded by any wrench w of the inner wrench set: if all
w . v_j >= m >= 0, then h(n) >= w . n >= m for every unit n in it. Triangles are halved both ways
until their bounds are near the least value met.
"""

import numpy as np

from swarmgrasp.summary.cells import Array
from swarmgrasp.summary.lattice import OCTANTS
from swarmgrasp.summary.support_bounds import EVALUATION, SupportBounds

GAP = 1e-4
"""Of the least value, far below what a summary leaves open."""
ROUNDS, MOST_TRIANGLES = 24, 20_000
"""Halvings, and triangles at once, after which the bound is what it is."""
AT_ONCE = 1 << 21
"""Products of directions and bins that are held at once."""


def least_beside_sets(support: SupportBounds, extra: Array) -> tuple[float, Array]:
    """Bound the quality from below, of a swarm and one robot.

    Parameters
    ----------
    support : SupportBounds
    extra : (3,) [N]
        The robot's generator; zero for none.

    Returns
    -------
    bound : float [N]
        At least 0.
    direction : (3,)
        The weakest unit normal met.
    """
    corners = OCTANTS[:, :, None] * np.eye(3)
    floor = EVALUATION * (support.size + float(np.linalg.norm(extra)))
    best, bound, direction = np.inf, np.inf, np.array([1.0, 0.0, 0.0])
    for _ in range(ROUNDS):
        middles = corners.sum(axis=1)
        middles /= np.linalg.norm(middles, axis=1)[:, None]
        wrenches = _inner_wrenches(support, extra, middles)
        values = np.einsum("ij,ij->i", wrenches, middles)
        if values.min() < best:
            best, direction = float(values.min()), middles[values.argmin()]
        bounds = np.einsum("ij,ikj->ik", wrenches, corners).min(axis=1)
        is_open = bounds < best - max(GAP * best, floor)
        bound = min(bound, float(bounds[~is_open].min(initial=np.inf)))
        if best <= floor:
            return 0.0, direction
        if not is_open.any():
            return max(bound, 0.0), direction
        if 4 * int(is_open.sum()) > MOST_TRIANGLES:
            break
        corners = _quartered(corners[is_open])
    return max(min(bound, float(bounds[is_open].min())), 0.0), direction


def _inner_wrenches(support: SupportBounds, extra: Array, normals: Array) -> Array:
    """Return a wrench (m, 3) [N] of the inner set that is far along each unit normal (m, 3)."""
    step = AT_ONCE // max(len(support.sums), 1) + 1
    found = support.farthest(normals) + np.where(normals @ extra > 0.0, 1.0, 0.0)[:, None] * extra
    for first in range(0, len(normals), step):
        some = normals[first : first + step]
        found[first : first + step] += (some @ support.sums.T > 0.0) @ support.sums
    return np.asarray(found + np.array(support.load))


def _quartered(corners: Array) -> Array:
    """Return the four parts (4 m, 3, 3) of spherical triangles (m, 3, 3)."""
    a, b, c = np.moveaxis(corners, 1, 0)
    middles = [b + c, c + a, a + b]
    d, e, f = (side / np.linalg.norm(side, axis=1)[:, None] for side in middles)
    parts = [(a, f, e), (f, b, d), (e, d, c), (d, e, f)]
    return np.concatenate([np.stack(part, axis=1) for part in parts])
