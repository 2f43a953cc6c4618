"""Whether patches cover an area, as the check of an answer finds out."""

import math

import numpy as np
import pytest
from shapely import Polygon, constrained_delaunay_triangles, get_coordinates

from swarmgrasp.verify.cover import is_covered

AREAS = {
    "notched": [(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)],
    "star": [(math.cos(t) * r, math.sin(t) * r)
             for t, r in zip(np.linspace(0, 6, 17).tolist(), [1.0, 0.4] * 9, strict=False)],
    "thin": [(0, 0), (1, 1e-7), (2, 0), (1, -1e-7)],
    "line": [(0.3, 0.3), (0.3, 1.7)],
    "sliver": [(0.2, 0.2), (0.9, 0.2), (0.5, 0.2 + 1e-13)],
}  # fmt: skip


def cut(area, rng, cuts):
    """Return patches of an area, halved at random so often across their longest sides."""
    parts = [area]
    if len(area) > 3:
        found = constrained_delaunay_triangles(Polygon(area))
        parts = [get_coordinates(part)[:3] for part in found.geoms]
    for _ in range(cuts):
        part = parts.pop(int(rng.integers(len(parts))))
        i, j = max(
            ((i, j) for i in range(len(part)) for j in range(i)),
            key=lambda ends: float(np.linalg.norm(part[ends[0]] - part[ends[1]])),
        )
        for k in (i, j):
            half = part.copy()
            half[k] = 0.5 * (part[i] + part[j])
            parts.append(half)
    return parts


@pytest.mark.parametrize("kind", AREAS)
@pytest.mark.parametrize("size", [1e-3, 1.0, 1e4])
def test_patches_cover_what_was_cut(kind, size):
    """In any place and turned any way; and without one of them, or with none, they do not."""
    rng = np.random.default_rng(4)
    for turn in (0.0, math.pi / 2, float(rng.uniform(0.0, 6.0))):
        c, s = math.cos(turn), math.sin(turn)
        area = (np.array(AREAS[kind]) @ np.array([[c, s], [-s, c]]) + rng.uniform(-3, 3, 2)) * size
        patches, sliver = cut(area, rng, int(rng.integers(0, 60))), 3e-9 * size
        assert is_covered(area, patches, sliver)
        assert not is_covered(area, [], sliver)
        if kind in {"notched", "star"}:
            largest = max(range(len(patches)), key=lambda k: Polygon(patches[k]).area)
            assert not is_covered(area, patches[:largest] + patches[largest + 1 :], sliver)
        if kind == "line":
            assert not is_covered(area, patches[1:], sliver)


def test_many_narrow_patches_hide_no_hole():
    """However near each other their corners are."""
    square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    halves = [square[[0, 1, 2]], square[[2, 3, 0]]]
    near = [np.array([(x, 0.0), (x, 0.1), (x + 1e-4, 0.0)]) for x in np.arange(0.0, 1.0, 1e-3)]
    assert is_covered(square, halves + near, 2e-3)
    assert not is_covered(square, halves[1:] + near, 2e-3)
