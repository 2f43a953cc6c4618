"""Directions all around, and each direction as a mixture of the three around it.

The octahedron |x| + |y| + |z| = 1 has eight faces, one for each choice of signs. Each is cut into
side^2 triangles; their corners, pushed out to the unit sphere, are the lattice: 4 side^2 + 2
directions, the axes among them. No triangle reaches across a plane of two axes.
"""

from functools import lru_cache

import numpy as np

from swarmgrasp.frozen import read_only
from swarmgrasp.summary.cells import Array, Indices

OCTANTS = np.array([(x, y, z) for x in (1, -1) for y in (1, -1) for z in (1, -1)])
"""The signs of the octahedron's faces."""
OVERREACH = 3.0**0.5
"""Weights that mix a unit normal add up to no more."""


def size_of(side: int) -> int:
    """Return how many directions a lattice has."""
    return 4 * side**2 + 2


@lru_cache(maxsize=4)
def _lattice(side: int) -> tuple[Array, Indices]:
    """Return unit normals (k, 3), and which is at each place (octant, i, j)."""
    i, j = (part.ravel() for part in np.mgrid[: side + 1, : side + 1])
    inside = i + j <= side
    places = np.column_stack([i, j, side - i - j])[inside]
    points, back = np.unique(
        (OCTANTS[:, None] * places).reshape(-1, 3), axis=0, return_inverse=True
    )
    numbers = np.zeros((len(OCTANTS), side + 1, side + 1), dtype=np.int64)
    numbers[:, i[inside], j[inside]] = back.reshape(len(OCTANTS), -1)
    normals = points / np.linalg.norm(points, axis=1)[:, None]
    return read_only(normals), read_only(numbers)


def lattice(side: int) -> Array:
    """Return the lattice's unit normals, (4 side^2 + 2, 3)."""
    return _lattice(side)[0]


def mixtures(normals: Array, side: int) -> tuple[Indices, Array]:
    """Write normals as mixtures of the three directions of the lattice around them.

    Parameters
    ----------
    normals : (m, 3)
    side : int

    Returns
    -------
    numbers : (m, 3)
        Of the directions.
    weights : (m, 3)
        Not negative: a normal is the sum of so much of each.

    Examples
    --------
    >>> numbers, weights = mixtures(np.array([[0.25, 0.25, 0.5]]), 2)
    >>> [round(float(weight), 3) for weight in weights[0]]
    [0.0, 0.354, 0.354]
    >>> (weights @ lattice(2)[numbers[0]]).round(12).tolist()
    [[0.25, 0.25, 0.5]]
    """
    directions, table = _lattice(side)
    sizes = np.abs(normals).sum(axis=1)
    x, y = np.abs(normals[:, :2].T) / sizes * side
    i = np.minimum(x.astype(np.int64), side - 1)
    j = np.minimum(y.astype(np.int64), side - 1 - i)
    x, y = x - i, y - j
    # half of a square of the grid, on the face seen along z: beyond its diagonal or not
    is_far = (x + y > 1.0) & (i + j + 2 <= side)
    first = np.where(is_far, x + y - 1.0, np.maximum(1.0 - x - y, 0.0))
    weights = np.column_stack([first, np.where(is_far, 1.0 - y, x), np.where(is_far, 1.0 - x, y)])
    octants = (normals < 0.0) @ (4, 2, 1)
    numbers = np.column_stack(
        [table[octants, i + is_far, j + is_far], table[octants, i + 1, j], table[octants, i, j + 1]]
    )
    # on the octahedron weights mix points, which are directions over the sum of their components
    return numbers, weights * sizes[:, None] / np.abs(directions[numbers]).sum(axis=2)
