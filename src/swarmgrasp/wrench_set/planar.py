"""Sums of flat convex sets of wrenches: what robots can exert that push along more than a line."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.frozen import Frozen
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.force_set import ForceSets, best_forces

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Planar(Frozen):
    """Force sets, each at a contact.

    Attributes
    ----------
    elements, counts
        As of `ForceSets`, of n robots.
    planes : (n, 2, 3) [1, 1, m]
        The wrenches of a unit force along x and along y at each contact.
    """

    elements: Array
    counts: NDArray[np.intp]
    planes: Array

    def __len__(self) -> int:
        """Return the number of sets."""
        return len(self.counts)

    @property
    def is_round(self) -> bool:
        """Whether a set has an arc."""
        return bool((self.elements[:, 0] > 0.0).any())

    @property
    def sizes(self) -> Array:
        """(n,) [N]: the largest force of each."""
        largest = np.hypot(self.elements[:, 1], self.elements[:, 2]) + self.elements[:, 0]
        firsts = np.cumsum(self.counts) - self.counts
        return np.maximum.reduceat(largest, firsts) if len(self) else np.zeros(0)

    def farthest(self, normals: Array) -> Array:
        """Return the sum of the wrenches (m, 3) of each set that are farthest along normals (m, 3).

        Normals are in physical coordinates, of any length.
        """
        ways = np.einsum("ndk,mk->mnd", self.planes, normals)
        forces = best_forces(ForceSets(self.elements, self.counts), ways)
        return np.asarray(np.einsum("mnd,ndk->mk", forces, self.planes))


NO_PLANES = Planar(np.zeros((0, 5)), np.zeros(0, dtype=np.intp), np.zeros((0, 2, 3)))


def planar_of(swarm: Swarm) -> tuple[Planar, Array, Array]:
    """Return what robots can exert that push along more than a line, and along lines.

    Returns
    -------
    planar : Planar
    lines : (n, 3) [N, N, N m]
        From one end to the other of the wrenches of each robot that pushes along a line.
    starts : (n, 3) [N, N, N m]
        The first ends.
    """
    is_line, shares = swarm.is_line, (swarm.lows / swarm.limits)[:, None]
    starts, lines = swarm.generators * shares, swarm.generators * (1.0 - shares)
    sets = swarm.force_sets
    arms = (swarm.contacts - swarm.outline.origin)[~is_line]
    planes = np.zeros((len(arms), 2, 3))
    planes[:, 0, 0] = planes[:, 1, 1] = 1.0
    planes[:, 0, 2], planes[:, 1, 2] = -arms[:, 1], arms[:, 0]
    kept = np.repeat(~is_line, sets.counts)
    planar = Planar(sets.elements[kept], sets.counts[~is_line], planes)
    return planar, lines[is_line], starts[is_line]
