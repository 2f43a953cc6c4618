"""Placement by SciPy's differential evolution, with our exact quality as its objective."""

import numpy as np
from ours import evaluator
from scipy.optimize import differential_evolution

from rivals.choices import Choices

NAME = "the same with our exact quality"


def place(problem):
    """Return the unit wrench (cos, sin, torque) of the robot, and its quality [N].

    A whole generation is evaluated in one call; all settings are SciPy's own.
    """
    qualities, choices = evaluator(problem), Choices(problem)

    def loss(x):
        """Return minus the quality at shares (2,) or (2, m)."""
        values = -qualities(choices.wrenches(*np.reshape(x, (2, -1))))
        return values if np.ndim(x) > 1 else float(values[0])

    found = differential_evolution(
        loss, [(0.0, 1.0), (0.0, 1.0)], vectorized=True, updating="deferred", rng=1
    )
    return choices.wrenches(*found.x[:, None])[0], -float(found.fun)
