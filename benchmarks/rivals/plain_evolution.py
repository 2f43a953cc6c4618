"""Placement by SciPy's differential evolution, as one would write it without this package."""

import numpy as np
from scipy.optimize import differential_evolution

from rivals import all_pairs
from rivals.choices import Choices

NAME = "SciPy differential evolution"


def place(problem):
    """Return the unit wrench (cos, sin, torque) of the robot, and its quality [N]."""
    choices, swarm = Choices(problem), problem.swarm
    weights = swarm.scale * problem.newcomer.limit

    def loss(x):
        """Return minus the quality at shares (2,)."""
        (wrench,) = choices.wrenches(x[:1], x[1:])
        return -all_pairs.quality(np.vstack([swarm.scaled_generators, wrench * weights]))

    found = differential_evolution(loss, [(0.0, 1.0), (0.0, 1.0)], rng=1)
    return choices.wrenches(*found.x[:, None])[0], -float(found.fun)
