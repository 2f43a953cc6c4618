"""How far some direction opposes all robots: what keeps a swarm without force closure so."""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.linear import minimise
from swarmgrasp.quality.weakest import MARGINAL

Array = NDArray[np.float64]


def opposition(generators: Array, shares: Array) -> float:
    """Find by how much some direction opposes all robots.

    The largest s for which some n with |n| <= sqrt 3 has n . b_i <= -s share_i |b_i| for all
    robots. If every b_i may change by less than s / sqrt 3 of share_i |b_i|, no force closure
    comes of it.

    Parameters
    ----------
    generators : (n, 3) [N]
        None of them 0, in the metric's coordinates.
    shares : (n,)
        Not negative, and 1 at most.

    Returns
    -------
    float
        0 where the robots only just leave a direction out, or leave none; infinite for fewer than
        4 robots, and for generators in a plane.

    Examples
    --------
    >>> ahead = np.array([(1.0, y, y) for y in (-0.5, 0.0, 0.5)] + [(1.0, 0.5, -0.5)])
    >>> round(opposition(ahead, np.ones(4)), 3), opposition(ahead[:3], np.ones(3))
    (0.816, inf)
    """
    units = generators / np.linalg.norm(generators, axis=1)[:, None]
    if len(units) < 4 or np.linalg.svd(units, compute_uv=False)[2] <= MARGINAL * len(units):
        return math.inf
    cost, matrix = np.array([0.0, 0.0, 0.0, -1.0]), np.column_stack([units, shares])
    found = minimise(cost, matrix, rows=(-np.inf, 0.0), columns=(-1.0, [1.0, 1.0, 1.0, np.inf]))
    return float(found[3])
