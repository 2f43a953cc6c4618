"""The paper's Algorithm 1, corrected: bisection on the level, SLSQP for each query."""

from swarmgrasp.paper import algorithm_1

NAME = "Algorithm 1 with SLSQP"


def place(problem):
    """Return the unit wrench (cos, sin, torque) of the robot, and the quality promised [N]."""
    found = algorithm_1(problem)
    return found.attach().wrench, found.promised
