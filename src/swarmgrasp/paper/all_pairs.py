"""The paper's formula (IV.1) as it stands: the normals of all pairs, and h at each of them (T2)."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

CHUNK = 4_000_000
"""Numbers held at once: 32 MB."""
PARALLEL = 1e-12
"""Sine of the angle below which a pair defines no facet."""


def normals_of(generators: Array) -> Array:
    """Return the unit normals b_j x b_k of all pairs j < k, (m, 3), one sign each.

    Parameters
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates; none is zero.
    """
    units = generators / np.linalg.norm(generators, axis=1)[:, None]
    j, k = np.triu_indices(len(units), 1)
    cross = np.cross(units[j], units[k])
    sizes = np.linalg.norm(cross, axis=1)
    kept = sizes > PARALLEL
    return np.asarray(cross[kept] / sizes[kept, None])


def facets(generators: Array) -> tuple[Array, Array]:
    """List all facets of a wrench set by the formula.

    Parameters
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates; none is zero.

    Returns
    -------
    normals : (m, 3)
        Unit normals of both signs.
    heights : (m,) [N]
        h at each, the distance of that facet from the origin.

    Examples
    --------
    >>> normals, heights = facets(np.array([(1.0, 0, 0), (-1, 0, 0), (0, 1, 0), (0, 0, 1)]))
    >>> len(normals), sorted(set(heights.tolist()))
    (10, [0.0, 1.0])
    """
    normals = normals_of(generators)
    shares = normals @ generators.T
    heights = np.maximum(shares, 0.0).sum(axis=1), np.maximum(-shares, 0.0).sum(axis=1)
    return np.vstack([normals, -normals]), np.concatenate(heights)


def quality(generators: Array) -> float:
    """Compute the least h over all normals [N], in chunks.

    Parameters
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates; none is zero, and they span all three dimensions.

    Examples
    --------
    Four robots to the corners of a tetrahedron: sqrt(6)/3 for unit ones.

    >>> corners = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], dtype=float)
    >>> round(quality(corners / 3**0.5), 6)
    0.816497
    """
    normals, total = normals_of(generators), generators.sum(axis=0)
    step = max(1, CHUNK // len(generators))
    least = np.inf
    for first in range(0, len(normals), step):
        part = normals[first : first + step]
        heights = np.maximum(part @ generators.T, 0.0).sum(axis=1)
        # h(-n) = h(n) - n . (sum of all)
        least = min(least, heights.min(), (heights - part @ total).min())
    return float(least)
