"""The normal that limits a wrench, by a linear program."""

import numpy as np

from swarmgrasp.forces.answer import Array
from swarmgrasp.linear import Program

Normal = tuple[float, float, float]


def start_for(generators: Array, wrench: Array) -> Normal:
    """Find the normal of the face by which the ray along a wrench leaves the wrench set.

    It is what the wrench costs in the program for how far along the ray the robots reach (T18).
    The search for the nearest to a wrench out of reach starts from there, too.

    Parameters
    ----------
    generators : (n, 3) [N]
    wrench : (3,) [N]
        In the metric's coordinates, not 0.

    Returns
    -------
    tuple of float
        A unit vector; the wrench's own direction if the program has no answer.

    Examples
    --------
    >>> start_for(np.array([[2.0, 0.0, 0.0], [0.0, 1.0, 0.0]]), np.array([1.0, 0.0, 0.0]))
    (1.0, 0.0, 0.0)
    """
    n, w = len(generators), wrench / np.abs(wrench).max()
    B = generators.T / np.abs(generators).max(initial=np.finfo(float).tiny)
    cost, most = np.zeros(n + 1), np.ones(n + 1)
    cost[n], most[n] = -1.0, np.inf
    solution = Program(cost, np.column_stack([B, -w]), (0.0, 0.0), (0.0, most)).solve()
    return _unit(solution.prices if solution is not None and solution.prices.any() else w)


def _unit(vector: Array) -> Normal:
    """Return a vector scaled to unit length."""
    x, y, z = (vector / np.linalg.norm(vector) + 0.0).tolist()
    return x, y, z
