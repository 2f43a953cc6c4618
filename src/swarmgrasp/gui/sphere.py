"""Directions all round, and triangles between them: what a body of many faces is drawn by."""

from functools import cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

TIMES: Final = 3
"""Times that each triangle of an icosahedron is cut in four: 642 directions, 1 280 triangles."""


@cache
def sphere() -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Return unit directions (642, 3), and triangles (1280, 3) of them, seen from outside.

    Examples
    --------
    >>> directions, triangles = sphere()
    >>> directions.shape, triangles.shape
    ((642, 3), (1280, 3))
    """
    golden = 0.5 * (1.0 + 5.0**0.5)
    ring = [(a, b) for b in (golden, -golden) for a in (1.0, -1.0)]
    corners = np.array([c for a, b in ring for c in ((0.0, a, b), (a, b, 0.0), (b, 0.0, a))])
    near = np.linalg.norm(corners[:, None] - corners, axis=2) < 2.1
    found = [
        (i, j, k)
        for i in range(12)
        for j in range(i)
        for k in range(j)
        if near[i, j] and near[j, k] and near[i, k]
    ]
    triangles = np.array([
        (i, j, k) if np.linalg.det(corners[[i, j, k]]) > 0.0 else (i, k, j) for i, j, k in found
    ])  # fmt: skip
    for _ in range(TIMES):
        corners, triangles = _cut(corners, triangles)
    return corners / np.linalg.norm(corners, axis=1)[:, None], triangles


def _cut(
    corners: NDArray[np.float64], triangles: NDArray[np.int64]
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Cut each triangle in four, between the middles of its sides on the sphere."""
    corners = corners / np.linalg.norm(corners, axis=1)[:, None]
    sides = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    pairs, index = np.unique(sides, axis=0, return_inverse=True)
    middles = corners[pairs].mean(axis=1)
    ab, bc, ca = index.reshape(-1, 3).T + len(corners)
    a, b, c = triangles.T
    parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.vstack([corners, middles]), np.concatenate([np.column_stack(p) for p in parts])
