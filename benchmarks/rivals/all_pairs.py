"""Quality by the paper's formula (IV.1) in NumPy: all cross products, and h at each of them."""

import numpy as np

NAME = "all pairs in NumPy"
CHUNK = 4_000_000
"""Numbers held at once [-]: 32 MB."""
PARALLEL = 1e-12
"""Sine of the angle below which a pair defines no facet."""


def normals_of(generators):
    """Return the unit normals b_j x b_k of all pairs j < k, (m, 3), one sign each."""
    units = generators / np.linalg.norm(generators, axis=1)[:, None]
    j, k = np.triu_indices(len(units), 1)
    cross = np.cross(units[j], units[k])
    sizes = np.linalg.norm(cross, axis=1)
    kept = sizes > PARALLEL
    return cross[kept] / sizes[kept, None]


def facets(generators):
    """Return all unit normals of both signs, (m, 3), and h at them, (m,) [N]."""
    normals = normals_of(generators)
    shares = normals @ generators.T
    heights = np.maximum(shares, 0.0).sum(axis=1), np.maximum(-shares, 0.0).sum(axis=1)
    return np.vstack([normals, -normals]), np.concatenate(heights)


def quality(generators):
    """Compute the least h over all normals, in chunks; `generators` (n, 3) [N]."""
    normals, total = normals_of(generators), generators.sum(axis=0)
    step = max(1, CHUNK // len(generators))
    least = np.inf
    for first in range(0, len(normals), step):
        part = normals[first : first + step]
        heights = np.maximum(part @ generators.T, 0.0).sum(axis=1)
        # h(-n) = h(n) - n . (sum of all)
        least = min(least, heights.min(), (heights - part @ total).min())
    return float(least)


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
