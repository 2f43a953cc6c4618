"""The quality of very many one-robot additions at once."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.swarm import Swarm, wrenches

ZERO: Final = 1e-12
"""Quality that counts as none, relative to the swarm's total force."""

CHUNK: Final = 4_000_000
"""Largest number of products held at a time."""


def quality_grid(
    swarm: Swarm,
    contacts: NDArray[np.float64],
    directions: NDArray[np.float64],
    limit: float,
) -> NDArray[np.float64]:
    """Compute the quality with one more robot, for every contact and direction.

    By (T2) the quality is attained at a facet normal of the base swarm, where the
    newcomer b adds max(0, n . b), or at one that b spans with a base generator, where it
    adds nothing: Q(b) = min( min_n h(n) + max(0, n . b), min_j h(+-(b x b_j)) ).

    Parameters
    ----------
    swarm : Swarm
        The robots already there.
    contacts : (m, 2) [m, m]
    directions : (k,) [rad]
    limit : float [N]

    Returns
    -------
    (m, k) [N]
    """
    count, turns = len(contacts), len(directions)
    arms = np.repeat(np.asarray(contacts) - swarm.outline.origin, turns, axis=0)
    angles = np.tile(directions, count)
    b = wrenches(arms, angles, np.full(len(angles), limit)) * swarm.scale
    G = swarm.scaled_generators
    best = np.minimum(_at_base_facets(G, b), _at_new_facets(G, b))
    total = float(np.linalg.norm(G, axis=1).sum()) + limit
    return np.where(np.isfinite(best) & (best > ZERO * total), best, 0.0).reshape(count, turns)


def _at_base_facets(G: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return min over the base facets of h(n) + max(0, n . b), (m,) [N]."""
    best = np.full(len(b), np.inf)
    first, second = np.triu_indices(len(G), 1)
    normals = _units(np.cross(G[first], G[second]), G[first], G[second])
    normals = np.concatenate([normals, -normals])
    heights = np.maximum(normals @ G.T, 0.0).sum(axis=1)
    reach = heights.min(initial=np.inf) + np.linalg.norm(b, axis=1).max(initial=0.0)
    normals, heights = normals[heights <= reach], heights[heights <= reach]
    step = max(1, CHUNK // max(len(b), 1))
    for start in range(0, len(normals), step):
        part = slice(start, start + step)
        added = np.maximum(b @ normals[part].T, 0.0) + heights[part]
        best = np.minimum(best, added.min(axis=1))
    return best


def _at_new_facets(G: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return min over the facets that b spans with a base generator, (m,) [N]."""
    best = np.full(len(b), np.inf)
    step = max(1, CHUNK // max(len(G), 1))
    for start in range(0, len(b), step):
        part = b[start : start + step]
        for g in G:
            normals = _units(np.cross(part, g), part, g, keep=True)
            along = normals @ G.T
            height = np.maximum(along, 0.0).sum(axis=1)
            other = height - along.sum(axis=1)  # h(-n) = h(n) - n . (the sum of all)
            lower = np.where(np.isnan(height), np.inf, np.minimum(height, other))
            best[start : start + step] = np.minimum(best[start : start + step], lower)
    return best


def _units(
    crosses: NDArray[np.float64],
    left: NDArray[np.float64],
    right: NDArray[np.float64],
    keep: bool = False,
) -> NDArray[np.float64]:
    """Normalise cross products; parallel pairs span no facet: dropped, or kept as nan."""
    lengths = np.linalg.norm(crosses, axis=-1)
    sizes = np.linalg.norm(left, axis=-1) * np.linalg.norm(right, axis=-1)
    spans = lengths > 1e-14 * sizes
    if not keep:
        crosses, lengths, spans = crosses[spans], lengths[spans], spans[spans]
    normals: NDArray[np.float64] = crosses / np.where(spans, lengths, np.nan)[:, None]
    return normals
