"""Quality by the paper's formula (IV.1) in NumPy: all cross products, and h at each of them."""

import numpy as np

from swarmgrasp.paper.all_pairs import CHUNK, PARALLEL, facets, quality

__all__ = ["NAME", "facets", "qualities_with", "quality"]

NAME = "all pairs in NumPy"


def qualities_with(base, known, newcomers):
    """Compute the quality with each of many newcomers, vectorised.

    Parameters
    ----------
    base : (n, 3) [N]
        Generators of the robots already there.
    known : tuple
        Their `facets`.
    newcomers : (m, 3) [N]
        Generators, one newcomer at a time.
    """
    normals, heights = known
    values = np.empty(len(newcomers))
    step = max(1, CHUNK // max(len(base) ** 2, len(heights)))
    for first in range(0, len(newcomers), step):
        b = newcomers[first : first + step]
        old = (heights + np.maximum(b @ normals.T, 0.0)).min(axis=1)
        cross = np.cross(b[:, None, :], base)
        sizes = np.linalg.norm(cross, axis=2, keepdims=True)
        shares = (cross / np.where(sizes > 0.0, sizes, 1.0)) @ base.T
        up = np.maximum(shares, 0.0).sum(axis=2)
        both = np.minimum(up, up - shares.sum(axis=2))
        both[sizes[:, :, 0] <= PARALLEL] = np.inf
        values[first : first + step] = np.minimum(old, both.min(axis=1))
    return values
