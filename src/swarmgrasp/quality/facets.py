"""The facets of a swarm's wrench set, as the qualities and placements use them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

MARGINAL = 1e-12
"""Quality relative to sum |b_i| at and below which it counts as zero."""
ALL_AT_ONCE = 256
"""Number of robots up to which room is made for all facets without counting them first."""


@dataclass(frozen=True, eq=False)
class Facets:
    """Facet normals with their support, and the exact quality (T2).

    Attributes
    ----------
    normals : (m, 3)
        Unit vectors in the metric's coordinates, both signs.
    heights : (m,) [N]
        The support function h at them.
    weakest : (3,)
        The normal with the least h.
    quality : float [N]
        That least h; 0 up to rounding is exactly 0.
    """

    normals: NDArray[np.float64]
    heights: NDArray[np.float64]
    weakest: NDArray[np.float64]
    quality: float


def facets_of(generators: NDArray[np.float64], cutoff: float = np.inf) -> Facets:
    """List the facet normals n with h(n) < cutoff, and find the weakest of all.

    A flat set that spans no plane has one normal, with its negative, and h = 0.

    Parameters
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates.
    cutoff : float [N]
    """
    # Numba takes 0.3 s to import: not before it is needed
    from swarmgrasp.kernels.facets import list_facets

    vectors = np.array(generators, dtype=float)  # a writable copy: one compiled signature
    room = len(vectors) * (len(vectors) - 1) if len(vectors) <= ALL_AT_ONCE else 0
    while True:
        normals, heights = np.empty((room, 3)), np.empty(room)
        count, quality, weakest = list_facets(vectors, float(cutoff), normals, heights)
        if count <= room:
            break
        room = count
    if quality == np.inf:
        weakest = np.linalg.svd(np.vstack([vectors, np.zeros((1, 3))]))[2][2]
        return Facets(np.array([weakest, -weakest]), np.zeros(2), weakest, 0.0)
    zero = MARGINAL * float(np.linalg.norm(vectors, axis=1).sum())
    return Facets(normals[:count], heights[:count], weakest, quality if quality > zero else 0.0)
