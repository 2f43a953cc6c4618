"""What robots certainly exert: known wrenches and uncertain ones, for the check of an answer.

The least of each robot over all its poses, whatever the others do (T14, T26).
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import compress
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import AnswerInvalid
from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.pushes import is_part
from swarmgrasp.verify.recompute import Array, crest

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import ChoiceClaim, NewcomerClaim, RobotClaim, ToleranceClaim

HALVINGS = 52
"""Of a straight part on which the worst contact lies: down to rounding."""


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
    arms : (r, 2) [m, m]
        Moment arm of its contact; of one that is not known, those of the ends of the straight parts
        of the boundary on which it lies, in order.
    arcs : (k, 3) [N, rad, rad]
        Radius about the origin, middle direction, and how far to both sides; a point has a width
        of 0.
    """

    arms: Array
    arcs: Array

    def along(self, covectors: Array) -> Array:
        """Return what it exerts at best along covectors (m, 3), at its worst contact: (m,) [N].

        Along a straight part that is convex: it is least at an end, or between where it falls and
        where it rises.
        """
        least = np.min([self.worths(covectors, arm) for arm in self.arms], axis=0)
        for p, step in zip(self.arms, np.diff(self.arms, axis=0), strict=False):
            falls = self._slopes(covectors, p, step) < 0.0
            inside = np.flatnonzero(falls & (self._slopes(covectors, p + step, step) > 0.0))
            rows, first = covectors[inside], np.zeros((len(inside), 1))
            for k in range(HALVINGS if len(inside) else 0):
                middle = first + 0.5 ** (k + 1)
                worths = self.worths(rows, p + middle * step)
                least[inside] = np.minimum(least[inside], worths)
                is_later = self._slopes(rows, p + middle * step, step) < 0.0
                first = np.where(is_later[:, None], middle, first)
        return np.asarray(least)

    def worths(self, covectors: Array, arms: Array) -> Array:
        """Return the same at moment arms (2,) or (m, 2) [m]."""
        wanted = _pulled(covectors, arms)
        return np.asarray((wanted * self.forces(wanted)).sum(axis=1))

    def _slopes(self, covectors: Array, arms: Array, step: Array) -> Array:
        """Return how that rises along a step (2,) [m] of the arm."""
        turned = covectors[:, 2:] * [-step[1], step[0]]
        return np.asarray((turned * self.forces(_pulled(covectors, arms))).sum(axis=1))

    def forces(self, wanted: Array) -> Array:
        """Return the forces (m, 2) [N] that are best along directions (m, 2)."""
        radius, middle, half = self.arcs.T
        angle = np.arctan2(wanted[:, 1], wanted[:, 0])[:, None]
        off = (angle - middle + math.pi) % math.tau - math.pi
        nearest = np.clip(off, -half, half)
        chosen = (radius * np.cos(off - nearest)).argmax(axis=1)
        turn = (middle + nearest)[np.arange(len(chosen)), chosen]
        return np.asarray(radius[chosen, None] * np.column_stack([np.cos(turn), np.sin(turn)]))

    def best(self, covectors: Array) -> Array:
        """Return the wrenches (m, 3) [N, N, N m] that are worth so much, of a known contact."""
        ((x, y),) = self.arms
        fx, fy = self.forces(_pulled(covectors, self.arms[0])).T
        return np.column_stack([fx, fy, x * fy - y * fx])


def _pulled(covectors: Array, arms: Array) -> Array:
    """Return the directions (m, 2) in which forces at moment arms are worth most."""
    return covectors[:, :2] + covectors[:, 2:] * np.stack([-arms[..., 1], arms[..., 0]], axis=-1)


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
    left : (f, n + spread + round)
        Which of them are left after each failure; without failures all of them, in one row.
    """

    scale: Array
    known: Array
    spread: tuple[Poses, ...]
    round: tuple[Forces, ...]
    machines: NDArray[np.intp]
    left: NDArray[np.bool_]

    def __add__(self, other: "Team") -> "Team":
        """Return both together; no machine has robots of both."""
        known = np.vstack([self.known, other.known])
        first = int(self.machines.max(initial=-1)) + 1
        machines, left = (
            np.concatenate(
                [
                    part
                    for both in zip(self._split(own), other._split(more), strict=True)
                    for part in both
                ],
                axis=-1,
            )
            for own, more in ((self.machines, other.machines + first), (self.left, other.left))
        )
        return Team(
            self.scale, known, self.spread + other.spread, self.round + other.round, machines, left
        )

    def _split(self, columns: NDArray[Any]) -> list[NDArray[Any]]:
        """Return the columns of each kind."""
        known, spread = len(self.known), len(self.spread)
        return np.split(columns, [known, known + spread], axis=-1)

    def __len__(self) -> int:
        """Return the number of rays and of robots that are none."""
        return len(self.machines)

    @property
    def is_sure(self) -> bool:
        """Whether all poses are known."""
        return not self.spread and all(len(s.arms) == 1 for s in self.round)

    @property
    def size(self) -> float:
        """The sum of the largest |wrench| of each, at most [N]: what rounding is relative to."""
        most = [s.limit * self._reach(s) for s in self.spread]
        most += [s.arcs[:, 0].max() * self._reach(s) for s in self.round]
        return float(np.linalg.norm(self.known, axis=1).sum()) + sum(most)

    def _reach(self, robot: "Poses | Forces") -> float:
        """Return the size of the wrench of a unit force, at most."""
        arm = np.linalg.norm(robot.arms, axis=1).max()
        return math.hypot(self.scale[:2].max(), self.scale[2] * arm)

    def exerted(self, normals: Array) -> Array:
        """Return what each exerts in its worst pose, at normals (m, 3): (m, n) [N]."""
        parts = [np.maximum(normals @ self.known.T, 0.0)]
        if self.spread:
            parts.append(np.maximum(self._least(normals), 0.0))
        parts += [s.along(normals * self.scale)[:, None] for s in self.round]
        return np.hstack(parts)

    def best(self, normals: Array, left: NDArray[np.bool_]) -> Array:
        """Return the sum (m, 3) [N] of the wrenches of those left that are best along normals.

        In the metric's coordinates, of robots whose poses are known.
        """
        of_rays, _, of_others = self._split(left)
        found = (np.maximum(np.sign(normals @ self.known.T), 0.0) * of_rays) @ self.known
        for robot in compress(self.round, of_others):
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
        return Team(self.scale, known, (), self.round, self.machines, self.left)


def team_of(
    robots: "Iterable[RobotClaim]", boundary: Boundary, scale: Array, worst_case: bool,
    failures: Sequence[frozenset[str]] = (),
) -> Team:  # fmt: skip
    """Return robots as they are said to be, or with all the poses that their tolerances allow.

    Parameters
    ----------
    robots : iterable of RobotClaim
    boundary : Boundary
    scale : (3,) [1, 1, 1/m]
    worst_case : bool
    failures : sequence of frozenset of str
        The robots that each takes, by name.

    Raises
    ------
    AnswerInvalid
        If a robot has a tolerance that does not go with what it exerts.
    """
    known: list[tuple[int, str, Array]] = []
    spread: list[tuple[int, str, Poses]] = []
    other: list[tuple[int, str, Forces]] = []
    machines: dict[str | int, int] = {}
    for k, robot in enumerate(robots):
        machine, name = machines.setdefault(robot.group or k, len(machines)), robot.name
        arms = np.array(robot.contact)[None] - boundary.origin
        tolerance = robot.tolerance if worst_case else None
        limit = robot.limit if tolerance is None else tolerance.certain(robot.limit)
        if limit == 0.0:
            continue
        if robot.lever:
            torque = np.array([0.0, 0.0, robot.lever]) * scale
            ways = (limit * torque, -robot.reverse_limit * torque)
            known += [(machine, name, way) for way in ways if way.any()]
            continue
        first = last = 0.0
        if tolerance is not None:
            _check(robot, tolerance)
            first, last = tolerance.direction
            if tolerance.contact != (0.0, 0.0):
                points = boundary.around(np.array(robot.contact), *tolerance.contact)
                arms = points - boundary.origin
        if not robot.is_line:
            half, spare = robot.steers, 0.5 * (last - first)
            if half >= min(spare, math.pi):  # of whatever direction it has, it keeps the middle
                middle, half = (first + last, half - spare) if half < math.pi else (0.0, half)
                other.append((machine, name, Forces(arms, arcs_of(robot, limit, middle / 2, half))))
                continue
            first, last = first + half, last - half
        for size, turn in ((limit, 0.0), (robot.reverse_limit, math.pi)):
            way = robot.direction + turn
            if size > 0.0 and (len(arms) > 1 or first < last):
                spread.append((machine, name, Poses(arms, way + first, way + last, size)))
            elif size > 0.0:
                known.append((machine, name, size * wrench(arms[0], way + first) * scale))
    owners = np.array([machine for machine, *_ in (*known, *spread, *other)], dtype=np.intp)
    names = [name for _, name, _ in (*known, *spread, *other)]
    left = [[name not in failure for name in names] for failure in failures or (frozenset(),)]
    return Team(
        scale,
        np.array([row for *_, row in known]).reshape(-1, 3),
        tuple(poses for *_, poses in spread),
        tuple(forces for *_, forces in other),
        np.unique(owners, return_inverse=True)[1].reshape(-1),
        np.array(left, dtype=bool),
    )


def _check(robot: "RobotClaim", tolerance: "ToleranceClaim") -> None:
    """Raise `AnswerInvalid` for a tolerance that does not go with what a robot exerts."""
    is_turned = tolerance.direction != (0.0, 0.0)
    is_fixed = robot.friction or robot.least or robot.envelope or robot.sectors
    if is_turned and (is_fixed or (robot.steers and robot.reverse_limit)):
        raise AnswerInvalid(
            f"{robot.name!r} has friction, an envelope, sectors or a least force, or steers both "
            "ways, and its direction is uncertain: that is not known how to check"
        )
    least = tolerance.least_limit
    if least is not None and (robot.envelope or robot.least > least):
        raise AnswerInvalid(
            f"{robot.name!r} has a least limit beside an envelope, or below its least force: that "
            "says nothing certain"
        )


def arcs_of(robot: "RobotClaim", limit: float, turn: float, steers: float) -> Array:
    """Return the arcs (k, 3) whose hull a robot of so certain a limit [N] exerts.

    Its direction is turned by so much, and it steers so far to both sides [rad].
    """
    d, least = robot.direction + turn, robot.least
    if robot.sectors is not None:
        arcs = [(limit, 0.5 * (start + end), 0.5 * (end - start)) for start, end in robot.sectors]
        return np.array([*arcs, (0.0, 0.0, 0.0)])
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


def keeping(
    robots: "Sequence[RobotClaim]", choice: "ChoiceClaim | None"
) -> "list[RobotClaim] | None":
    """Return robots of which those with gaps keep to one sector each (T28).

    None if some keep none, or something that is no part of their sectors of half a turn or less.
    """
    kept = {} if choice is None else choice.sectors
    if set(kept) != {robot.name for robot in robots if robot.sectors is not None}:
        return None
    found = []
    for robot in robots:
        if robot.sectors is not None:
            start, end = kept[robot.name]
            if not is_part((start, end), robot.sectors):
                return None
            steers, way = 0.5 * (end - start), math.remainder(0.5 * (start + end), math.tau)
            robot = robot.model_copy(update={"steers": steers, "direction": way, "sectors": None})
        found.append(robot)
    return found


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
