"""What robots certainly exert: known wrenches and uncertain ones, for the check of an answer.

The least of each robot over all its poses, whatever the others do (T14).
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import AnswerInvalid
from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.recompute import Array, crest

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import NewcomerClaim, RobotClaim


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


class Forces(NamedTuple):
    """What a robot exerts that is neither one ray nor two opposite ones: the hull of arcs (T20).

    Attributes
    ----------
    arm : (2,) [m, m]
        Of its contact.
    arcs : (k, 3) [N, rad, rad]
        Radius about the origin, middle direction, and how far to both sides; a point has a width
        of 0.
    """

    arm: Array
    arcs: Array

    def along(self, covectors: Array) -> Array:
        """Return what it exerts at best along covectors (m, 3): (m,) [N]."""
        a = covectors[:, 0] - covectors[:, 2] * self.arm[1]
        b = covectors[:, 1] + covectors[:, 2] * self.arm[0]
        size, angle = np.hypot(a, b)[:, None], np.arctan2(b, a)[:, None]
        radius, middle, half = self.arcs.T
        off = np.abs((angle - middle + math.pi) % math.tau - math.pi)
        return np.asarray((radius * size * np.cos(np.maximum(off - half, 0.0))).max(axis=1))

    def best(self, covectors: Array) -> Array:
        """Return the wrenches (m, 3) [N, N, N m] that are worth so much along covectors (m, 3)."""
        a = covectors[:, 0] - covectors[:, 2] * self.arm[1]
        b = covectors[:, 1] + covectors[:, 2] * self.arm[0]
        radius, middle, half = self.arcs.T
        off = (np.arctan2(b, a)[:, None] - middle + math.pi) % math.tau - math.pi
        nearest = np.clip(off, -half, half)
        chosen = (radius * np.cos(off - nearest)).argmax(axis=1)
        turn = (middle + nearest)[np.arange(len(chosen)), chosen]
        fx, fy = radius[chosen] * np.cos(turn), radius[chosen] * np.sin(turn)
        return np.column_stack([fx, fy, self.arm[0] * fy - self.arm[1] * fx])


@dataclass(frozen=True)
class Team:
    """Robots that exert at least something in each direction.

    Attributes
    ----------
    scale : (3,) [1, 1, 1/m]
        Turns wrenches into the metric's coordinates.
    known : (n, 3) [N]
        Generators of the rays whose wrench is known, in the metric's coordinates; a robot that
        pushes both ways is two.
    spread : tuple of Poses
        The other rays.
    round : tuple of Forces
        The robots that are none.
    machines : (n + spread + round,)
        The machine that each of all these is part of, 0 1 2 ...
    """

    scale: Array
    known: Array
    spread: tuple[Poses, ...]
    round: tuple[Forces, ...]
    machines: NDArray[np.intp]

    def __add__(self, other: "Team") -> "Team":
        """Return both together; no machine has robots of both."""
        known = np.vstack([self.known, other.known])
        parts = zip(self._split(), other._split(), strict=True)
        first = int(self.machines.max(initial=-1)) + 1
        machines = np.concatenate([m for own, more in parts for m in (own, more + first)])
        return Team(
            self.scale, known, self.spread + other.spread, self.round + other.round, machines
        )

    def _split(self) -> list[NDArray[np.intp]]:
        """Return the machines of each kind."""
        known, spread = len(self.known), len(self.spread)
        return np.split(self.machines, [known, known + spread])

    def __len__(self) -> int:
        """Return the number of rays and of robots that are none."""
        return len(self.machines)

    @property
    def size(self) -> float:
        """The sum of the largest |wrench| of each, at most [N]: what rounding is relative to."""
        forces, turn = self.scale[:2].max(), self.scale[2]
        most = [
            s.limit * math.hypot(forces, turn * np.linalg.norm(s.arms, axis=1).max())
            for s in self.spread
        ]
        most += [
            s.arcs[:, 0].max() * math.hypot(forces, turn * np.linalg.norm(s.arm))
            for s in self.round
        ]
        return float(np.linalg.norm(self.known, axis=1).sum()) + sum(most)

    def exerted(self, normals: Array) -> Array:
        """Return what each machine exerts in its worst poses, at normals (m, 3): (m, k) [N]."""
        parts = [np.maximum(normals @ self.known.T, 0.0)]
        if self.spread:
            parts.append(np.maximum(self._least(normals), 0.0))
        parts += [s.along(normals * self.scale)[:, None] for s in self.round]
        return self.by_machine(np.hstack(parts))

    def best(self, normals: Array) -> Array:
        """Return the sum (m, 3) [N] of all wrenches that are best along normals (m, 3).

        In the metric's coordinates, of robots whose poses are known.
        """
        found = np.maximum(np.sign(normals @ self.known.T), 0.0) @ self.known
        for robot in self.round:
            found = found + robot.best(normals * self.scale) * self.scale
        return np.asarray(found)

    def by_machine(self, terms: Array) -> Array:
        """Add up what belongs to one machine: (m, n) -> (m, k)."""
        count = int(self.machines.max(initial=-1)) + 1
        if count == len(self.machines):
            return terms
        found = np.zeros((len(terms), count))
        np.add.at(found.T, self.machines, terms.T)
        return found

    def _least(self, normals: Array) -> Array:
        """Return the least n . b over all poses of each ray whose pose is not known."""
        counts = [len(s.arms) for s in self.spread]
        arms = np.concatenate([s.arms for s in self.spread])
        lo, hi, limit = (
            np.repeat([getattr(s, name) for s in self.spread], counts)
            for name in ("lo", "hi", "limit")
        )
        covectors = (normals * self.scale).T[:, :, None]
        ends = -limit * crest(-covectors, arms, lo, hi)
        return np.asarray(np.minimum.reduceat(ends, np.cumsum([0, *counts[:-1]]), axis=1))

    def worst(self, normal: Array) -> "Team":
        """Return the rays in the worst poses along a normal."""
        found = [s.worst(normal * self.scale) * self.scale for s in self.spread]
        known = np.vstack([self.known, *found])
        return Team(self.scale, known, (), self.round, self.machines)


def team_of(
    robots: "Iterable[RobotClaim]", boundary: Boundary, scale: Array, worst_case: bool
) -> Team:
    """Return robots as they are said to be, or with all the poses that their tolerances allow.

    Raises
    ------
    AnswerInvalid
        If a robot whose pose is uncertain is no ray.
    """
    known: list[tuple[int, Array]] = []
    spread: list[tuple[int, Poses]] = []
    other: list[tuple[int, Forces]] = []
    machines: dict[str, int] = {}
    for k, robot in enumerate(robots):
        machine = machines.setdefault(robot.group or f" {k}", len(machines))
        arm = np.array(robot.contact) - boundary.origin
        tolerance = robot.tolerance if worst_case else None
        limit = robot.limit if tolerance is None else tolerance.certain(robot.limit)
        ways = [(limit, 0.0)] + [(robot.reverse_limit, math.pi)] * (robot.reverse_limit > 0.0)
        is_line = not (robot.steers or robot.friction or robot.least or robot.envelope)
        if limit == 0.0:
            continue
        if tolerance is not None and tolerance.is_spread:
            if not is_line:
                raise AnswerInvalid(
                    f"{robot.name!r} steers, or is no ray, and its pose is uncertain: that is not "
                    "known how to check"
                )
            arms = arm[None]
            if tolerance.contact != (0.0, 0.0):
                points = boundary.around(np.array(robot.contact), *tolerance.contact)
                arms = points - boundary.origin
            lo, hi = (robot.direction + turn for turn in tolerance.direction)
            spread += [(machine, Poses(arms, lo + t, hi + t, size)) for size, t in ways]
        elif is_line:
            known += [
                (machine, size * wrench(arm, robot.direction + t) * scale) for size, t in ways
            ]
        else:
            other.append((machine, Forces(arm, arcs_of(robot, limit))))
    owners = np.array([machine for machine, _ in (*known, *spread, *other)], dtype=np.intp)
    return Team(
        scale,
        np.array([row for _, row in known]).reshape(-1, 3),
        tuple(poses for _, poses in spread),
        tuple(forces for _, forces in other),
        np.unique(owners, return_inverse=True)[1].reshape(-1),
    )


def arcs_of(robot: "RobotClaim", limit: float) -> Array:
    """Return the arcs (k, 3) whose hull a robot of so certain a limit [N] exerts."""
    d, steers, least = robot.direction, robot.steers, robot.least
    if robot.envelope:
        points = np.array(robot.envelope)
        angles = np.arctan2(points[:, 1], points[:, 0]) + d
        return np.column_stack([np.hypot(*points.T), angles, np.zeros(len(points))])
    if robot.friction:
        size, half = math.hypot(1.0, robot.friction), math.atan(robot.friction)
        corners = [(f * size, d + side * half, 0.0) for f in (limit, least) for side in (-1, 1)]
        return np.array(corners)
    arcs = [(limit, d, steers), (least, d - steers, 0.0), (least, d + steers, 0.0)]
    if robot.reverse_limit:
        arcs.append((robot.reverse_limit, d + math.pi, steers))
    return np.array(arcs)


def kept_arcs(newcomer: "NewcomerClaim", limit: float, lo: float, hi: float) -> Array:
    """Return the arcs (k, 3) whose hull a newcomer keeps in a sector [lo, hi] [rad]."""
    middle, half = 0.5 * (lo + hi), 0.5 * (hi - lo)
    if newcomer.friction:
        size, turn = math.hypot(1.0, newcomer.friction), math.atan(newcomer.friction)
        points = [(limit * size, middle + side * turn, 0.0) for side in (-1, 1)]
        return np.array([*points, (0.0, middle, 0.0)])
    astern = (newcomer.reverse_limit, middle + math.pi, half)
    return np.array([(limit, middle, half), astern, (0.0, middle, 0.0)])


def wrench(arm: Array, angle: float) -> Array:
    """Return the wrench (3,) [1, 1, m] of a unit force at a moment arm."""
    fx, fy = math.cos(angle), math.sin(angle)
    return np.array([fx, fy, arm[0] * fy - arm[1] * fx])
