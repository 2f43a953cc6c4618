"""How far robots push on average over all directions: no quality exceeds it (T3)."""

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.swarm import Swarm

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(32)


def mean_reach(swarm: Swarm) -> float:
    """Return the mean over all directions of how far the robots push together [N], in the metric.

    Of a ray of limit u it is u / pi, of a disc u. The quality is at most how far they push in any
    direction, wherever they are; so it is at most the mean.

    Examples
    --------
    >>> from swarmgrasp import Outline, Robot
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> round(mean_reach(Swarm(square, [Robot((1, 0), 3.0, 2.0, steers=np.pi)])), 9)
    2.0
    """
    scale = swarm.scale[:2]
    if swarm.has_rays_only:
        return float(np.hypot(*swarm.scaled_generators[:, :2].T).sum() / np.pi)
    radius, x, y, *cone = swarm.force_sets.elements.T
    start, end = (_in_metric(turn, scale) for turn in cone)
    along = scale[0] * x * (np.sin(end) - np.sin(start))
    across = scale[1] * y * (np.cos(start) - np.cos(end))
    half = 0.5 * (end - start)
    turns = 0.5 * (start + end) + half * _NODES[:, None]
    stretch = np.hypot(scale[0] * np.cos(turns), scale[1] * np.sin(turns))
    arcs = radius * half * (_WEIGHTS @ stretch)
    return float((along + across + arcs).sum() / (2.0 * np.pi))


def _in_metric(turns: NDArray[np.float64], scale: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the directions of normals [rad] in the metric's coordinates, by those outside it."""
    there = np.arctan2(np.sin(turns) / scale[1], np.cos(turns) / scale[0])
    off = there - turns
    return np.asarray(there - 2.0 * np.pi * np.round(off / (2.0 * np.pi)))
