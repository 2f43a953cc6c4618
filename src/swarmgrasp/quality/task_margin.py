"""By how much a whole task is held or missed (T34).

The task, once, is held by as much as the wrench of it that is held the least. How far a wrench lies
within what can be made is a concave function of it: of a polytope a vertex decides, and on a part
of an ellipsoid it is no less than at the corners of a triangle that the part lies within.
"""

import heapq
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.quality.changing import OCTAHEDRON, quarters
from swarmgrasp.quality.margin import Margin
from swarmgrasp.quality.task import Polytope, Task

Array = NDArray[np.float64]
NEAR = 1e-6
"""Share of an ellipsoid's size that its margin is known to,"""
MOST_ASKED = 4000
"""unless that takes more wrenches than these."""


def around_task(task: Task, scale: Array, at: Callable[[Array], Margin]) -> Margin:
    """Return how far the wrenches that can be made reach beyond a whole task, or fall short.

    Parameters
    ----------
    task : Polytope or Ellipsoid
    scale : (3,) [1, 1, 1/m]
    at : callable
        Tells the margin of a wrench (3,) [N] of the task, in the metric's coordinates.
    """
    rows = task.generators * scale
    least = at(np.zeros(3))
    if isinstance(task, Polytope):
        return min([least, *map(at, rows)], key=_value)
    _, sizes, ways = np.linalg.svd(rows, full_matrices=False)
    axes = np.zeros((3, 3))
    axes[:, : len(sizes)] = ways.T * sizes
    queue: list[tuple[float, int, Array]] = []
    cells = OCTAHEDRON
    asked, close = 0, NEAR * float(sizes[0])
    while True:
        for corners in cells:
            foot = _foot(corners)
            outer = min(at(axes @ corner / foot).value for corner in corners)
            centre = corners.sum(axis=0)
            least = min(least, at(axes @ (centre / np.linalg.norm(centre))), key=_value)
            asked += 4
            heapq.heappush(queue, (outer, asked, corners))
        bound, _, corners = heapq.heappop(queue)
        if bound >= least.value - close or asked >= MOST_ASKED:
            return least
        cells = quarters(corners[None])


def _value(margin: Margin) -> float:
    """Return the value of a margin."""
    return margin.value


def _foot(corners: Array) -> float:
    """Return how far from the origin the plane of three unit vectors (3, 3) is."""
    across = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    return float(abs(corners[0] @ across) / np.linalg.norm(across))
