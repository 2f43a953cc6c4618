"""The facets of a swarm's wrench set, as the qualities and placements use them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

MARGINAL = 1e-12
"""Quality relative to sum |b_i| at and below which it counts as zero."""
ALL_AT_ONCE = 256
"""Number of robots up to which all facets are listed first and sorted out afterwards."""


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


def facets_of(generators: NDArray[np.float64], margin: float = np.inf) -> Facets:
    """Find the weakest facet, and list those with h(n) < quality + margin.

    A flat set that spans no plane has one normal, with its negative, and h = 0.

    Parameters
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates.
    margin : float [N]
        0 lists none, infinity all: n (n - 1) of them.

    Examples
    --------
    Robots along the axes, a cube from the origin.

    >>> cube = facets_of(np.eye(3))
    >>> len(cube.normals), cube.quality
    (6, 0.0)
    """
    # Numba takes 0.3 s to import: not before it is needed
    from swarmgrasp.kernels.facets import list_facets

    vectors = np.array(generators, dtype=float)  # a writable copy: one compiled signature
    n = len(vectors)
    all_at_once = margin > 0.0 and n <= ALL_AT_ONCE
    passes = [np.inf] if all_at_once else [-np.inf, margin] if margin > 0.0 else [-np.inf]
    room, quality = n * (n - 1) if all_at_once else 0, 0.0
    for reach in passes:
        normals, heights = np.empty((room, 3)), np.empty(room)
        cutoff = quality + reach
        count, quality, weakest = list_facets(vectors, cutoff, normals, heights)
        room = 16 * n
    if count > len(heights):
        normals, heights = np.empty((count, 3)), np.empty(count)
        list_facets(vectors, cutoff, normals, heights)
    if quality == np.inf:
        weakest = np.linalg.svd(np.vstack([vectors, np.zeros((1, 3))]))[2][2]
        return Facets(np.array([weakest, -weakest]), np.zeros(2), weakest, 0.0)
    low = np.flatnonzero(heights[:count] < quality + margin)
    zero = MARGINAL * float(np.linalg.norm(vectors, axis=1).sum())
    return Facets(normals[low], heights[low], weakest, quality if quality > zero else 0.0)
