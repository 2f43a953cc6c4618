"""Placement by SciPy's Nelder-Mead with restarts, with our exact quality as its objective."""

import numpy as np
from ours import evaluator
from scipy.optimize import minimize

from rivals.choices import Choices

RESTARTS = 10
NAME = f"SciPy Nelder-Mead, {RESTARTS} starts"


def place(problem):
    """Return the unit wrench (cos, sin, torque) of the robot, and its quality [N]."""
    qualities, choices = evaluator(problem), Choices(problem)

    def loss(x):
        """Return minus the quality at shares (2,)."""
        return -float(qualities(choices.wrenches(x[:1], x[1:]))[0])

    starts = np.random.default_rng(1).random((RESTARTS, 2))
    runs = [
        minimize(loss, start, method="Nelder-Mead", bounds=[(0.0, 1.0), (0.0, 1.0)])
        for start in starts
    ]
    best = min(runs, key=lambda run: run.fun)
    return choices.wrenches(best.x[:1], best.x[1:])[0], -float(best.fun)
