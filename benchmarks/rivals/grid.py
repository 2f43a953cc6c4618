"""Placement by looking at every point of a grid of contacts and directions, in NumPy."""

import numpy as np

from rivals.all_pairs import facets, qualities_with
from rivals.choices import Choices

SIDE = 180
NAME = f"grid of {SIDE} x {SIDE} in NumPy"


def place(problem):
    """Return the unit wrench (cos, sin, torque) of the robot, and its quality [N]."""
    choices, base = Choices(problem), problem.swarm.scaled_generators
    shares = np.linspace(0.0, 1.0, SIDE)
    robots = choices.wrenches(*(v.ravel() for v in np.meshgrid(shares, shares)))
    values = qualities_with(base, facets(base), robots * choices.weights)
    k = int(values.argmax())
    return robots[k], float(values[k])
