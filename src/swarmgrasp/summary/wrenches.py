"""What robots that are no rays can do together along each direction of a lattice."""

import numpy as np

from swarmgrasp.kernels import core
from swarmgrasp.summary.cells import Array
from swarmgrasp.summary.lattice import OVERREACH, lattice
from swarmgrasp.summary.moments import rounding_of
from swarmgrasp.summary.support_bounds import EVALUATION
from swarmgrasp.swarm import Swarm

NO_WRENCHES = np.zeros((0, 3))
"""Of rays only."""
AT_ONCE = 256
"""Robots whose elements stay in a processor's nearest memory while all directions are asked."""


def farthest_wrenches(swarm: Swarm, side: int) -> tuple[Array, float]:
    """Add up the wrenches that are the farthest along each direction, of robots that are no rays.

    Returns
    -------
    wrenches : (4 side^2 + 2, 3) [N]
        In the metric's coordinates.
    rounding : float [N]
        By how much rounding may have moved them.
    """
    normals = lattice(side)
    x, y, turn = swarm.scale.tolist()
    arms, (elements, counts) = swarm.contacts - swarm.outline.origin, swarm.force_sets
    firsts = np.cumsum(counts) - counts
    others = np.flatnonzero(~swarm.is_ray)
    wrenches, size = np.zeros((len(normals), 3)), 0.0
    for first in range(0, len(others), AT_ONCE):
        some = others[first : first + AT_ONCE]
        own = np.concatenate([np.arange(firsts[i], firsts[i] + counts[i]) for i in some])
        sets = core.Sets(
            arms[some], elements[own], counts[some].astype(float), np.zeros(len(some)),
            (x, y, turn), 0, (0.0, 0.0, 0.0), NO_WRENCHES, False,
            np.zeros((0, 5)), np.zeros((0, 12)), np.zeros(0),
        )  # fmt: skip
        wrenches += np.frombuffer(sets.wrenches(normals)).reshape(-1, 3)
        size += sets.weight
    return wrenches, OVERREACH * (rounding_of(len(others), size) + EVALUATION * size)
