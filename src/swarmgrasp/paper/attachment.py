"""The paper's last step, "determine attachment": the nearest wrench a robot can really make."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement import Problem
from swarmgrasp.swarm import Robot

Array = NDArray[np.float64]

STEPS = 181
"""Directions looked at on each piece at a time."""
ROUNDS = 4
"""Each looks between the two neighbours of the best direction so far."""


@dataclass(frozen=True, eq=False)
class Attachment:
    """A robot in contact, in place of a wrench that was asked for.

    Attributes
    ----------
    robot : Robot
        At its full limit, which never hurts (T6).
    wrench : (3,) [1, 1, m]
        What it exerts per newton of its limit.
    distance : float [N]
        How far that is from the wrench asked for, in the metric.
    """

    robot: Robot
    wrench: Array
    distance: float


def nearest_attachment(problem: Problem, wanted: Array) -> Attachment:
    """Find the robot whose wrench is nearest to a wanted one, among all the problem allows.

    On one piece, and for one direction, the torque is free between those at its two ends (T8),
    so that only the direction is searched, ever finer around the best.

    Parameters
    ----------
    problem : Problem
    wanted : (3,) [1, 1, m]
        Per newton of the newcomer's limit.

    Raises
    ------
    NowhereToAttach
        If the problem leaves no boundary point to the newcomer.
    """
    pieces = problem.pieces()
    weights = problem.swarm.scale * problem.newcomer.limit
    low, high = pieces.rows[:, 4:5], pieces.rows[:, 5:6]
    shares = np.linspace(-1.0, 1.0, STEPS)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    for _ in range(ROUNDS):
        angles = np.clip(middle + half * shares, low, high)
        robots = _nearest_torques(pieces.rows, angles, float(wanted[2]))
        apart = np.linalg.norm((robots - wanted) * weights, axis=2)
        best = apart.argmin(axis=1)
        middle = np.take_along_axis(angles, best[:, None], axis=1)
        half = half * (2.0 / (STEPS - 1))
    rows = np.arange(len(best))
    k = int(apart[rows, best].argmin())
    c, s, torque = robots[k, best[k]].tolist()
    contact, direction = pieces.robot_at(k, c, s, torque)
    robot = Robot(contact, direction, problem.newcomer.limit, problem.newcomer.name or "newcomer")
    return Attachment(robot, np.array([c, s, torque]), float(apart[k, best[k]]))


def _nearest_torques(rows: Array, angles: Array, torque: float) -> Array:
    """Return the unit wrenches (k, a, 3) of pieces, at angles (k, a), nearest to a torque [m]."""
    c, s = np.cos(angles), np.sin(angles)
    first = rows[:, 0:1] * s - rows[:, 1:2] * c
    last = rows[:, 2:3] * s - rows[:, 3:4] * c
    return np.stack([c, s, np.clip(torque, first, np.maximum(first, last))], axis=2)
