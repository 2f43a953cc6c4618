"""Who does what: wanted wrenches shared out over the robots, and what they are believed to make."""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.forces import ForcesAlong, forces_in_step
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
        self.vectors = vectors
        lags = [one.lag for one in plant.each_actuator]
        self._gains = np.array([1.0 - math.exp(-period / lag) if lag else 1.0 for lag in lags])
        slews = np.array([period / one.slew if one.slew else np.inf for one in plant.each_actuator])
        self._most = slews * plant.swarm.limits
        self._efficiencies = np.array([one.efficiency for one in plant.each_actuator])
        self._arms = plant.swarm.contacts - plant.swarm.outline.origin
        self._last: ForcesAlong | None = None

    def share_out(self, wanted: Array) -> ForcesAlong:
        """Return the forces for wanted wrenches (runs, 3) [N, N, N m], or the nearest there are."""
        self._last = forces_in_step(self.plant.swarm, wanted, self._last)
        return self._last

    def follow(self, vectors: Array) -> None:
        """Let a period pass in which forces (runs, n, 2) [N, N] are asked for."""
        change = self._gains[:, None] * (vectors - self.vectors)
        sizes = np.maximum(np.hypot(change[..., 0], change[..., 1]), WEAKEST)
        change *= np.minimum(1.0, self._most / sizes)[..., None]
        self.vectors = self.vectors + change

    @property
    def made(self) -> Array:
        """(runs, 3) [N, N, N m]: the wrenches that the robots are believed to exert."""
        x, y = self._efficiencies * self.vectors[..., 0], self._efficiencies * self.vectors[..., 1]
        turns = self._arms[:, 0] * y - self._arms[:, 1] * x
        return np.stack([part.sum(axis=1) for part in (x, y, turns)], axis=1)
