"""Robots as sets of forces, in the kernels' terms: what they can certainly do (T20, T26)."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import CriterionInvalid, RobotInvalid
from swarmgrasp.kernels import core
from swarmgrasp.quality.heights import ON_FACET, largest
from swarmgrasp.quality.poses import Poses, poses_of
from swarmgrasp.ranges import shown
from swarmgrasp.swarm import Robot, Swarm, Tolerance
from swarmgrasp.swarm.force_set import force_sets_of

Array = NDArray[np.float64]
Normal = tuple[float, float, float]
CERTIFIED, UNSURE = 1e-9, 1e-7
"""Relative gap between a value and its bound, with known poses and with uncertain ones; the kernel
makes it wider where it takes long."""

ASIDE = 1e-7
"""How far beside a normal robots are looked at whose best force may change there,"""
JUMPED = 1e-3
"""and by how much of its size it then does at least."""


class Certain(NamedTuple):
    """What robots can certainly do, as the arrays of `core.Sets`."""

    arms: Array
    elements: Array
    counts: Array
    machines: Array
    parts: Array
    poses: Array
    astern: tuple[int, ...]
    """The robots that the last rows are the other ways of."""


def certain_sets(swarm: Swarm, spreads: Mapping[int, Poses | None]) -> Certain:
    """Return what the robots of a swarm can certainly do.

    A robot steers once its pose is drawn: what a sector has of whatever direction it is drawn in is
    left of it. If nothing is, it is a ray of uncertain direction (T14). One that reverses is two
    such rays, the second of them after all others.

    Raises
    ------
    RobotInvalid
        If a robot has a tolerance that does not go with what it can exert; all faults at once.
    """
    _check(swarm, spreads)
    n, origin = len(swarm), swarm.outline.origin
    rays: dict[int, Poses] = {}
    astern: dict[int, Poses] = {}
    parts: list[tuple[float, ...]] = []
    directions, steers, limits = (
        np.array(column) for column in (swarm.directions, swarm.steers, swarm.limits)
    )
    is_plain = np.ones(n, dtype=bool)
    for i, poses in spreads.items():
        if poses is None:
            is_plain[i] = False
            continue
        limits[i] = poses.limit
        half, spare = float(steers[i]), 0.5 * (poses.hi - poses.lo)
        if swarm.is_ray[i] or half < min(spare, math.pi):
            is_plain[i] = False
            rays[i] = poses._replace(lo=poses.lo + half, hi=poses.hi - half)
            if swarm.reverse_limits[i] > 0.0:
                back = poses._replace(lo=poses.lo + math.pi, hi=poses.hi + math.pi)
                astern[i] = back._replace(limit=float(swarm.reverse_limits[i]))
            continue
        if half < math.pi:
            directions[i], steers[i] = 0.5 * (poses.lo + poses.hi), half - spare
        if swarm.tolerances[i].is_adrift:
            ends = (np.array(part) - origin for part in poses.parts)
            parts += [(i, *part.ravel().tolist()) for part in ends]
    found = swarm.force_sets
    if spreads:
        changed = swarm.columns._replace(directions=directions, steers=steers, limits=limits)
        found = force_sets_of(changed, swarm.rare.envelopes, swarm.rare.hulls)
    rays.update(enumerate(astern.values(), start=n))
    others = np.zeros(len(astern))
    counts = found.counts * is_plain
    rows = [row for i, poses in sorted(rays.items()) for row in poses.rows(i, origin)]
    return Certain(
        np.concatenate([swarm.contacts - origin, np.zeros((len(others), 2))]),
        np.ascontiguousarray(found.elements[np.repeat(is_plain, found.counts)]),
        np.concatenate([counts, others]),
        np.concatenate([swarm.machines, swarm.machines[list(astern)]]).astype(float),
        np.array(parts, dtype=float).reshape(-1, 5),
        np.array(rows, dtype=float).reshape(-1, 12),
        tuple(astern),
    )


def failing_rows(
    swarm: Swarm, failures: Sequence[Sequence[str]], count: int, astern: Sequence[int]
) -> NDArray[np.bool_]:
    """Return which rows of a swarm's arrays (f, count) each failure takes.

    Raises
    ------
    CriterionInvalid
        If a name is none of a robot or a group; all such names are told.
    """
    found, faults = np.zeros((len(failures), count), dtype=bool), []
    members = {g: [swarm.index(name) for name in names] for g, names in swarm.groups.items()}
    for row, names in zip(found, failures, strict=True):
        for name in names:
            if name in members:
                row[members[name]] = True
            elif name in swarm:
                row[swarm.index(name)] = True
            else:
                faults.append(f"a failure takes {shown(name)}, which is no robot and no group")
    if faults:
        raise CriterionInvalid(faults)
    if astern:
        found[:, -len(astern) :] = found[:, list(astern)]
    return found


def _check(swarm: Swarm, spreads: Mapping[int, Poses | None]) -> None:
    """Raise `RobotInvalid` for tolerances that do not go with what robots can exert."""
    faults = []
    for i in spreads:
        tolerance, name = swarm.tolerances[i], swarm.names[i]
        is_envelope = i in swarm.rare.envelopes
        kinds = {
            "friction": swarm.frictions[i] > 0.0,
            "an envelope": is_envelope,
            "sectors with gaps between": i in swarm.rare.hulls,
            "a least force": swarm.leasts[i] > 0.0,
            "steering both ways": swarm.reverse_limits[i] > 0.0 and swarm.steers[i] > 0.0,
        }
        faults += turn_faults(name, tolerance, kinds)
        if is_envelope and tolerance.least_limit is not None:
            faults.append(f"{name}: an envelope says what it can exert; leave out its least limit")
        if swarm.leasts[i] > (tolerance.least_limit or math.inf):
            faults.append(
                f"{name}: its least force {swarm.leasts[i]:.9g} is more than its least limit, "
                f"{tolerance.least_limit} [N]"
            )
    if faults:
        raise RobotInvalid(faults)


def turn_faults(name: str, tolerance: Tolerance, kinds: Mapping[str, bool]) -> list[str]:
    """Return what is wrong with the tolerance of a robot's direction, of the kinds that it is."""
    if tolerance.turns == (0.0, 0.0):
        return []
    return [
        f"{name}: the worst direction of what has {kind} is not known how to find; leave out the "
        "tolerance of its direction, or ask without the worst case"
        for kind, is_so in kinds.items()
        if is_so
    ]


class RobotSets:
    """The force sets of a swarm's robots, as they are or in all their poses.

    Parameters
    ----------
    swarm, worst_case, losing, load, task, is_polytope
        As for `Rays`, but that `losing` counts machines.
    failures : sequence of sequence of str
        The worst of them happens, before any loss: each takes robots and groups, by name.

    Attributes
    ----------
    core : core.Sets
    gap : float
    size : float [N]
        As for `Rays`.
    """

    def __init__(
        self, swarm: Swarm, worst_case: bool, losing: int, load: Normal, task: Array,
        is_polytope: bool, failures: Sequence[Sequence[str]] = (),
    ) -> None:  # fmt: skip
        self._swarm, self._losing, self._count = swarm, losing, len(swarm)
        self.spreads = poses_of(swarm) if worst_case else {}
        arms, elements, counts, machines, parts, poses, astern = certain_sets(swarm, self.spreads)
        self.gap = UNSURE if len(parts) or len(poses) else CERTIFIED
        self._machines = machines.astype(int)
        self.failing = failing_rows(swarm, failures, len(machines), astern)
        x, y, z = swarm.scale.tolist()
        self.core = core.Sets(
            arms, elements, counts, machines, (x, y, z), losing, load, task, is_polytope, parts,
            poses, self.failing.astype(float),
        )  # fmt: skip
        self.size = self.core.weight

    def least(self, units: float | None, enough: float = 0.0) -> tuple[float, Normal, float, float]:
        """Find the least H / D, a unit normal that attains it, and what no normal falls below.

        Within so many units of work; the last number is how many are left. Less than `enough` will
        do: the bound is then 0.
        """
        budget = () if units is None else (units, enough)
        return self.core.least(self.gap, np.inf, *budget)

    def heights(self, normals: Array) -> bytes:
        """Return H, the H before the last loss, and D, (m, 3), at normals (m, 3) [N]."""
        return self.core.heights(normals)

    def _best(self, normal: Normal) -> Array:
        """Return worths, forces and moment arms (n, 5) along a normal."""
        return np.frombuffer(self.core.forces(normal)).reshape(-1, 5)

    def _sums(self, worths: Array, failing: NDArray[np.bool_] | None) -> Array:
        """Return what machines exert, of what their robots do, after a failure."""
        left = worths if failing is None else np.where(failing, 0.0, worths)
        return np.asarray(np.bincount(self._machines, left), dtype=float)

    def failure_at(self, normal: Normal) -> int | None:
        """Return which failure is the worst along a normal; None if none is named."""
        worths, heights = self._best(normal)[:, 0], []
        for failing in self.failing:
            sums = self._sums(worths, failing)
            heights.append(sums.sum() - largest(sums[None], self._losing)[0])
        return int(np.argmin(heights)) if heights else None

    def lost_at(self, normal: Normal) -> tuple[int, ...]:
        """Return the robots of the machines whose loss hurts most along a normal, worst first."""
        worths, failure = self._best(normal)[:, 0], self.failure_at(normal)
        sums = self._sums(worths, None if failure is None else self.failing[failure])
        order = np.argsort(-sums, kind="stable")[: self._losing]
        own = self._machines[: len(self._swarm)]
        return tuple(
            i
            for machine in order
            if sums[machine] > ON_FACET * self.size / len(worths)
            for i in np.flatnonzero(own == machine).tolist()
        )

    def failing_at(self, normal: Normal) -> tuple[int, ...]:
        """Return the robots that the failure takes that is the worst along a normal."""
        failure = self.failure_at(normal)
        if failure is None:
            return ()
        return tuple(np.flatnonzero(self.failing[failure][: len(self._swarm)]).tolist())

    def worst_wrenches(self, normal: Normal) -> Array:
        """Return the wrenches (n, 3) that are best along a normal, in the robots' worst poses.

        In the metric's coordinates; 0 for those that may be absent.
        """
        _, fx, fy, x, y = self._best(normal)[: self._count].T
        return np.column_stack([fx, fy, x * fy - y * fx]) * self._swarm.scale

    def setters(self, normal: Normal) -> tuple[int, ...]:
        """Return the robots whose best force is not the same on all sides of a normal."""
        before = self._best(normal)[: len(self._swarm), 1:3]
        sizes, moved = np.linalg.norm(before, axis=1), np.zeros(len(before))
        for step in ASIDE * np.vstack([np.eye(3), -np.eye(3)]):
            x, y, z = (np.asarray(normal) + step).tolist()
            now = self._best((x, y, z))[: len(self._swarm), 1:3]
            sizes = np.maximum(sizes, np.linalg.norm(now, axis=1))
            moved = np.maximum(moved, np.linalg.norm(now - before, axis=1))
        return tuple(np.flatnonzero(moved > JUMPED * sizes).tolist())

    def worst_poses(self, normal: Normal) -> dict[int, Robot | None]:
        """Return the robots that have a tolerance in their worst poses; None if absent."""
        best = self._best(normal)
        scaled = np.asarray(normal) * self._swarm.scale
        found: dict[int, Robot | None] = {}
        for i, poses in self.spreads.items():
            found[i] = None
            if poses is None:
                continue
            robot = self._swarm.robots[i]
            x, y = best[i, 3:].tolist()
            contact, direction = (
                (x + self._swarm.outline.origin[0], y + self._swarm.outline.origin[1]),
                robot.direction,
            )
            if poses.lo < poses.hi:
                direction = _worst_turn(poses, scaled, x, y)
            if not self._swarm.tolerances[i].is_adrift:
                contact = robot.contact
            if robot.lever:
                contact, direction = robot.contact, robot.direction
            limit = poses.limit * float(self._swarm.nearness[i])
            found[i] = replace(
                robot, contact=contact, direction=direction, limit=limit, tolerance=None
            )
        return found


def _worst_turn(poses: Poses, covector: Array, x: float, y: float) -> float:
    """Return the direction, of those a robot at a moment arm may have, farthest from the best."""
    u, v, turn = covector.tolist()
    wanted = math.atan2(v + turn * x, u - turn * y)
    middle = 0.5 * (poses.lo + poses.hi)
    off = math.remainder(wanted - middle, math.tau)
    reach = min(0.5 * (poses.hi - poses.lo), math.pi - abs(off))
    return middle - math.copysign(reach, off)
