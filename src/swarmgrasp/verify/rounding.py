"""What rounded coordinates of an outline leave open, for the check of an answer (T4)."""

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.recompute import Array, turns_into

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import RobotClaim

ALONG = 1e-12
"""Angle [rad] between a direction and a normal that were computed from the same edge."""


def noise_of(robots: "Iterable[RobotClaim]", boundary: Boundary, scale: Array) -> float:
    """Bound what rounding may change of a quality [N]: the sum over robots along a normal."""
    if boundary.precision == 0.0:
        return 0.0
    return sum(_error(robot, boundary, scale) for robot in robots if not robot.mounted)


def _error(robot: "RobotClaim", boundary: Boundary, scale: Array) -> float:
    """Return by how much a robot's wrench may be off [N]: 0 if it has it from no edge."""
    point, turn = np.array(robot.contact), 0.0
    for k in boundary.at(point):
        p, q = boundary.edge(k)
        dx, dy = (float(step) for step in q - p)
        open_by = 2.0 * boundary.precision * (abs(dx) + abs(dy)) / (dx * dx + dy * dy)
        normal, near = math.atan2(dx, -dy), open_by + ALONG
        is_along = any(
            turns_into(robot.direction, normal + side - near, normal + side + near)
            for side in (0.0, math.pi)
        )
        if is_along and dx != 0.0 and dy != 0.0:
            turn = max(turn, open_by)
    if turn == 0.0:
        return 0.0
    c, s = math.cos(robot.direction), math.sin(robot.direction)
    turned = np.array([-s, c, (point - boundary.origin) @ [c, s]]) * scale
    moved = math.sqrt(8.0) * boundary.precision * float(scale[2])
    return robot.limit * (turn * float(np.linalg.norm(turned)) + moved)
