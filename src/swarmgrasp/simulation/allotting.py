"""Who does what: wanted wrenches shared out over the robots, and what they are believed to make."""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.forces import rows_in_step
from swarmgrasp.forces.rows import Rows
from swarmgrasp.ranges import WEAKEST
from swarmgrasp.simulation.plant import Plant

Array = NDArray[np.float64]


class Allotment:
    """The forces that the robots of a plant are asked for, and a model of how they follow.

    Each force goes to the one asked for with the robot's lag, and by no more than its slew lets it.

    Parameters
    ----------
    plant : Plant
        Of the robots that are believed to be there.
    vectors : (runs, n, 2) [N, N]
        What they are believed to exert now.
    period : float [s]
    """

    def __init__(self, plant: Plant, vectors: Array, period: float) -> None:
        self.plant = plant
        each, limits = plant.each_actuator, plant.swarm.limits
        gains = [1.0 - math.exp(-period / one.lag) if one.lag else 1.0 for one in each]
        slews = [period / one.slew if one.slew else math.inf for one in each]
        self._gains, self._most = np.array(gains)[:, None], (np.array(slews) * limits)[:, None]
        self._efficiencies = np.array([one.efficiency for one in each])[:, None]
        self._arms = (plant.swarm.contacts - plant.swarm.outline.origin).T[..., None]
        self._forces = np.array(vectors.transpose(2, 1, 0), order="C")  # quicker run by run
        self._starts = np.zeros((len(vectors), 3))

    @property
    def vectors(self) -> Array:
        """(runs, n, 2) [N, N]: what the robots are believed to exert."""
        return np.ascontiguousarray(self._forces.transpose(2, 1, 0))

    def share_out(self, wanted: Array) -> Rows:
        """Return the forces for wanted wrenches (runs, 3) [N, N, N m], or the nearest there are."""
        found = rows_in_step(self.plant.swarm, wanted, self._starts)
        self._starts = np.ascontiguousarray(found.normals[:, 0])
        return found

    def follow(self, vectors: Array) -> None:
        """Let a period pass in which forces (runs, n, 2) [N, N] are asked for."""
        change = self._gains * (vectors.transpose(2, 1, 0) - self._forces)
        sizes = np.maximum(np.sqrt(change[0] ** 2 + change[1] ** 2), WEAKEST)
        self._forces += np.minimum(1.0, self._most / sizes) * change

    @property
    def made(self) -> Array:
        """(runs, 3) [N, N, N m]: the wrenches that the robots are believed to exert."""
        x, y = self._efficiencies * self._forces
        ahead, abeam = self._arms
        turns = ahead * y - abeam * x
        sums = np.zeros((3, x.shape[1]))
        for i in range(len(x)):  # one by one, whatever the number of runs
            for total, part in zip(sums, (x, y, turns), strict=True):
                total += part[i]
        return np.ascontiguousarray(sums.T)
