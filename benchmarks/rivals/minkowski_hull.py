"""Quality from the convex hull of the wrench set's vertices, built one robot at a time."""

import numpy as np
from scipy.spatial import ConvexHull

NAME = "SciPy ConvexHull of the Minkowski sum"


def quality(generators):
    """Compute the least distance of a hull facet from the origin.

    The hull of V and V + b is the sum with one segment more; its vertices go on. The first
    three segments span a parallelepiped, so that every hull has three dimensions.

    Parameters
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates; the three that span most go first.
    """
    first = _spanning(generators)
    bits = (np.arange(8)[:, None] >> np.arange(3)) & 1
    points = bits @ generators[first]
    for b in np.delete(generators, first, axis=0):
        points = np.vstack([points, points + b])
        hull = ConvexHull(points)
        points = points[hull.vertices]
    return float(np.min(-ConvexHull(points).equations[:, 3]))


def _spanning(generators):
    """Choose three generators, each the farthest from the span of those before it."""
    rest, chosen = generators.copy(), []
    for _ in range(3):
        chosen.append(int(np.argmax(np.linalg.norm(rest, axis=1))))
        axis = rest[chosen[-1]] / np.linalg.norm(rest[chosen[-1]])
        rest = rest - np.outer(rest @ axis, axis)
    return chosen
