"""What robots certainly exert: known wrenches and uncertain ones, for the check of an answer.

The least of each robot over all its poses, whatever the others do (T14).
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.recompute import Array, crest

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import RobotClaim


class Poses(NamedTuple):
    """All the poses of a robot whose pose is uncertain.

    Attributes
    ----------
    arms : (r, 2) [m, m]
        Moment arms between which its contact lies, along straight parts of the boundary.
    lo, hi : float [rad]
        Between which its direction lies.
    limit : float [N]
        What it exerts for certain.
    """

    arms: Array
    lo: float
    hi: float
    limit: float

    def worst(self, covector: Array) -> Array:
        """Return the wrench (3,) [N, N, N m] with the least product with a covector.

        At a given contact the product is a sinusoid in the direction, and it is linear in the
        contact: only the parts' ends, and there the sector's ends and the trough, matter.
        """
        rows = np.array(
            [wrench(arm, angle) for arm in self.arms for angle in self.turns(arm, covector)]
        )
        return np.asarray(self.limit * rows[np.argmin(rows @ covector)])

    def turns(self, arm: Array, covector: Array) -> tuple[float, float, float]:
        """Return the directions [rad] at a contact of which one has the least product."""
        a, b = covector[:2] + covector[2] * np.array([-arm[1], arm[0]])
        trough = math.atan2(b, a) + math.pi
        trough += math.tau * math.ceil((self.lo - trough) / math.tau)
        return self.lo, self.hi, min(trough, self.hi)


@dataclass(frozen=True)
class Team:
    """Robots that exert at least something in each direction.

    Attributes
    ----------
    scale : (3,) [1, 1, 1/m]
        Turns wrenches into the metric's coordinates.
    known : (n, 3) [N]
        Generators of the robots whose wrench is known, in the metric's coordinates.
    spread : tuple of Poses
        The others.
    """

    scale: Array
    known: Array
    spread: tuple[Poses, ...]

    def __add__(self, other: "Team") -> "Team":
        """Return both together."""
        known = np.vstack([self.known, other.known])
        return Team(self.scale, known, self.spread + other.spread)

    def __len__(self) -> int:
        """Return the number of robots."""
        return len(self.known) + len(self.spread)

    @property
    def size(self) -> float:
        """The sum of |b_i|, at most [N]: what rounding is relative to."""
        forces, turn = self.scale[:2].max(), self.scale[2]
        most = (
            s.limit * math.hypot(forces, turn * np.linalg.norm(s.arms, axis=1).max())
            for s in self.spread
        )
        return float(np.linalg.norm(self.known, axis=1).sum()) + sum(most)

    def least(self, normals: Array) -> Array:
        """Return the least n . b_i over all poses of each robot, at normals (m, 3): (m, n) [N]."""
        known = normals @ self.known.T
        if not self.spread:
            return np.asarray(known)
        counts = [len(s.arms) for s in self.spread]
        arms = np.concatenate([s.arms for s in self.spread])
        lo, hi, limit = (
            np.repeat([getattr(s, name) for s in self.spread], counts)
            for name in ("lo", "hi", "limit")
        )
        covectors = (normals * self.scale).T[:, :, None]
        ends = -limit * crest(-covectors, arms, lo, hi)
        starts = np.cumsum([0, *counts[:-1]])
        return np.hstack([known, np.minimum.reduceat(ends, starts, axis=1)])

    def worst(self, normal: Array) -> Array:
        """Return the generators (n, 3) [N] in the worst poses along a normal."""
        found = [s.worst(normal * self.scale) * self.scale for s in self.spread]
        return np.vstack([self.known, *found])


def team_of(
    robots: "Iterable[RobotClaim]", boundary: Boundary, scale: Array, worst_case: bool
) -> Team:
    """Return robots as they are said to be, or with all the poses that their tolerances allow."""
    known, spread = [], []
    for robot in robots:
        arm = np.array(robot.contact) - boundary.origin
        tolerance = robot.tolerance if worst_case else None
        limit = robot.limit if tolerance is None else tolerance.certain(robot.limit)
        if tolerance is not None and limit > 0.0 and tolerance.is_spread:
            arms = arm[None]
            if tolerance.contact != (0.0, 0.0):
                points = boundary.around(np.array(robot.contact), *tolerance.contact)
                arms = points - boundary.origin
            lo, hi = (robot.direction + turn for turn in tolerance.direction)
            spread.append(Poses(arms, lo, hi, limit))
        elif limit > 0.0:
            known.append(limit * wrench(arm, robot.direction) * scale)
    return Team(scale, np.array(known).reshape(-1, 3), tuple(spread))


def wrench(arm: Array, angle: float) -> Array:
    """Return the wrench (3,) [1, 1, m] of a unit force at a moment arm."""
    fx, fy = math.cos(angle), math.sin(angle)
    return np.array([fx, fy, arm[0] * fy - arm[1] * fx])
