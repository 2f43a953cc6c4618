"""A task is drawn as the set it is."""

import itertools

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from swarmgrasp import Criterion, Ellipsoid, Polytope
from swarmgrasp.plot.tasks import hull, solid

SCALE = np.array([1.0, 2.0, 0.5])


def volume(found):
    """Return the volume of what patches enclose: the sum of cones about the origin."""
    fans = [
        (patch[0] @ np.cross(patch[1:-1], patch[2:]).T).sum() * sign(patch, normal)
        for patch, normal in zip(found.patches, found.normals, strict=True)
    ]
    return sum(fans) / 6.0


def sign(patch, normal):
    """Tell whether a polygon runs counter-clockwise, seen from outside."""
    return np.sign(np.cross(patch[1] - patch[0], patch[2] - patch[0]) @ normal)


def test_a_cube_has_six_faces_of_four_corners():
    """Corners inside, in a face or on an edge do not count."""
    points = np.array(list(itertools.product([-1.0, 0.0, 1.0], repeat=3)))
    found = hull(points)
    assert [len(patch) for patch in found.patches] == [4] * 6
    assert volume(found) == pytest.approx(8.0, rel=1e-12)


@pytest.mark.parametrize("count", [4, 9, 30])
def test_any_hull_is_that_of_qhull(count):
    """The same volume, and no point outside a face."""
    points = np.random.default_rng(count).normal(size=(count, 3))
    found = hull(points)
    assert volume(found) == pytest.approx(ConvexHull(points).volume, rel=1e-9)
    for patch, normal in zip(found.patches, found.normals, strict=True):
        assert (points @ normal).max() <= patch[0] @ normal + 1e-9


def test_a_task_of_many_corners_is_drawn_with_the_outermost():
    """Nearly all of a ball's volume, in time."""
    points = np.random.default_rng(1).normal(size=(500, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    assert 0.7 * 4.19 < volume(hull(points)) < 4.19


def test_flat_and_straight_tasks_are_a_polygon_and_a_segment():
    """One wrench is a line from no wrench; two span a triangle, seen from both sides."""
    line = solid(Criterion(task=Polytope([(4, 0, 0)])), SCALE).times(2.0)
    assert line.patches == ()
    assert sorted(line.segment.tolist()) == [[0, 0, 0], [8, 0, 0]]
    triangle = solid(Criterion(task=Polytope([(4, 0, 0), (0, 1, 0)])), SCALE)
    assert [len(patch) for patch in triangle.patches] == [3, 3]
    disc = solid(Criterion(task=Ellipsoid([(4, 0, 0), (0, 1, 0)])), SCALE)
    assert [len(patch) for patch in disc.patches] == [32, 32]
    stick = solid(Criterion(task=Ellipsoid([(4, 0, 0)])), SCALE)
    assert np.ptp(stick.segment, axis=0).tolist() == [8, 0, 0]


@pytest.mark.parametrize(
    "task",
    [
        Polytope([(3, 0, 0), (1, 0, 4), (1, 0, -4), (0, 1, 0)]),
        Ellipsoid([(3, 1, 0), (0, 2, 0), (0, 0, 5)]),
        Ellipsoid([(3, 1, 0), (0, 2, 0), (0, 0, 5), (1, 1, 1)]),
    ],
)
def test_a_solid_task_has_its_own_support_function(task):
    """The corners of its patches reach as far as the task, along any normal."""
    found = solid(Criterion(task=task), SCALE)
    corners = np.concatenate(found.patches)
    ways = np.random.default_rng(2).normal(size=(50, 3))
    drawn = (ways @ corners.T).max(axis=1)
    np.testing.assert_allclose(drawn, task.support(ways * SCALE), rtol=0.03)
    assert volume(found) > 0.0
