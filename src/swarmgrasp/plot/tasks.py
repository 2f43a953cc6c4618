"""What quality scales, the ball or a task, as polygons in the metric's coordinates."""

import itertools
import math
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.quality import Criterion, Polytope

Vectors = NDArray[np.float64]

BALL_STEPS: Final = (16, 32)
"""Parts of the ball from pole to pole and around."""

MOST_CORNERS: Final = 40
"""A task of more corners is drawn with so many of them, some of the outermost."""

FLAT: Final = 1e-9
"""Extent across a plane or a line that is none, relative to the extent along it."""


@dataclass(frozen=True, eq=False)
class Solid:
    """A convex set about no wrench.

    Attributes
    ----------
    patches : tuple of (k, 3) [N, N, N]
        Polygons of its surface, none for a segment; with a task, a share of the task.
    normals : (p, 3)
        Their unit outward normals. A flat set has each polygon twice, seen from both sides.
    segment : (2, 3) [N, N, N] or None
        The ends of a set that is no more than a segment.
    is_angular : bool
        Whether the patches have edges worth drawing.
    is_ball : bool
        Whether it is a ball of the metric and no task.
    """

    patches: tuple[Vectors, ...]
    normals: Vectors
    segment: Vectors | None = None
    is_angular: bool = False
    is_ball: bool = False

    def times(self, factor: float) -> "Solid":
        """Return the set so many times as large."""
        segment = None if self.segment is None else factor * self.segment
        patches = tuple(factor * patch for patch in self.patches)
        return replace(self, patches=patches, segment=segment)


def solid(criterion: Criterion, scale: Vectors) -> Solid:
    """Return what a criterion's quality scales: the unit ball of the metric, or the task.

    Parameters
    ----------
    criterion : Criterion
    scale : (3,) [1, 1, 1/m]
        Makes the metric Euclidean.

    Returns
    -------
    Solid
    """
    task = criterion.task
    if task is None:
        return Solid(*unit_ball(), is_ball=True)
    rows = task.generators * scale
    if isinstance(task, Polytope):
        return hull(np.vstack([np.zeros(3), rows]))
    _, sizes, axes = np.linalg.svd(rows, full_matrices=False)
    rank = int(np.count_nonzero(sizes > FLAT * sizes[0]))
    if rank < 3:
        turns = np.linspace(0.0, 2.0 * math.pi, BALL_STEPS[1], endpoint=False)
        circle = np.column_stack([np.cos(turns), np.sin(turns)])
        shares = circle if rank == 2 else np.array([[1.0], [-1.0]])
        return hull(shares @ (sizes[:rank, None] * axes[:rank]))
    patches, normals = unit_ball()
    outward = normals / sizes @ axes
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    return Solid(tuple(patch * sizes @ axes for patch in patches), outward)


def unit_ball() -> tuple[tuple[Vectors, ...], Vectors]:
    """Return the unit ball as quadrangles.

    Returns
    -------
    patches : tuple of (4, 3)
    normals : (q, 3)
        Unit outward normals.
    """
    rows, columns = BALL_STEPS
    tilt, turn = np.meshgrid(
        np.linspace(0.0, math.pi, rows + 1),
        np.linspace(0.0, 2.0 * math.pi, columns + 1),
        indexing="ij",
    )
    grid = np.stack([np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt)], -1)
    corners = [grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]]
    patches = np.stack(corners, axis=2).reshape(-1, 4, 3)
    normals = patches.mean(axis=1)
    return tuple(patches), normals / np.linalg.norm(normals, axis=1, keepdims=True)


def hull(points: Vectors) -> Solid:
    """Return the convex hull of a few points (m, 3), not all of them the same.

    Examples
    --------
    >>> cube = hull(np.array(list(itertools.product([0.0, 1.0], repeat=3))))
    >>> len(cube.patches), len(hull(np.eye(3)).patches), hull(np.eye(3)[:2]).patches
    (6, 2, ())
    """
    points = _outermost(np.unique(points, axis=0))
    centre = points.mean(axis=0)
    _, sizes, axes = np.linalg.svd(points - centre)
    rank = int(np.count_nonzero(sizes > FLAT * sizes[0]))
    if rank == 1:
        along = points @ axes[0]
        ends = points[[int(along.argmin()), int(along.argmax())]]
        return Solid((), np.zeros((0, 3)), ends)
    if rank == 2:
        polygon = _polygon(points, axes[2])
        return Solid((polygon, polygon[::-1]), np.array([axes[2], -axes[2]]), is_angular=True)
    patches, normals = [], []
    for normal in _facet_normals(points, FLAT * sizes[0]):
        heights = points @ normal
        patches.append(_polygon(points[heights >= heights.max() - FLAT * sizes[0]], normal))
        normals.append(normal)
    return Solid(tuple(patches), np.array(normals), is_angular=True)


def _outermost(points: Vectors) -> Vectors:
    """Return the points (m, 3); if they are many, some of the outermost, well apart."""
    if len(points) <= MOST_CORNERS:
        return points
    _, ways = unit_ball()
    outer = points[np.unique(((points - points.mean(axis=0)) @ ways.T).argmax(axis=0))]
    chosen = [0]
    nearest = np.full(len(outer), np.inf)
    for _ in range(min(MOST_CORNERS, len(outer)) - 1):
        nearest = np.minimum(nearest, np.linalg.norm(outer - outer[chosen[-1]], axis=1))
        chosen.append(int(nearest.argmax()))
    return np.asarray(outer[chosen])


def _facet_normals(points: Vectors, tolerance: float) -> list[Vectors]:
    """Return the unit outward normal of every face of points that span space, each once."""
    i, j, k = np.array(list(itertools.combinations(range(len(points)), 3))).T
    crosses = np.cross(points[j] - points[i], points[k] - points[i])
    sizes = np.linalg.norm(crosses, axis=1)
    wide = sizes > FLAT * sizes.max()
    normals = crosses[wide] / sizes[wide, None]
    normals = np.concatenate([normals, -normals])
    base = (normals * np.tile(points[i[wide]], (2, 1))).sum(axis=1)
    outer = normals[(normals @ points.T).max(axis=1) <= base + tolerance]
    found: list[Vectors] = []
    while len(outer):
        found.append(outer[0])
        outer = outer[np.abs(outer - outer[0]).max(axis=1) > math.sqrt(FLAT)]
    return found


def _polygon(points: Vectors, normal: Vectors) -> Vectors:
    """Return the corners of the hull of points (m, 3) in a plane, counter-clockwise."""
    centred = points - points.mean(axis=0)
    first = centred[int(np.linalg.norm(centred, axis=1).argmax())]
    flat = np.column_stack([centred @ first, centred @ np.cross(normal, first)])
    order = np.lexsort(flat.T[::-1])
    chain: list[int] = []
    for way in (order, order[::-1]):  # lower chain, then upper (Andrew)
        start = len(chain)
        for index in way:
            while len(chain) > start + 1 and _turn(flat[chain[-2:]], flat[index]) <= 0.0:
                chain.pop()
            chain.append(int(index))
        chain.pop()
    return np.asarray(points[chain])


def _turn(pair: Vectors, point: Vectors) -> float:
    """Return twice the area of a triangle, positive if it turns left."""
    (ax, ay), (bx, by) = pair - point
    return float(ax * by - ay * bx)
