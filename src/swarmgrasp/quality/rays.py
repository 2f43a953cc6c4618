"""Robots that push along one ray each, in the kernels' terms."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import core
from swarmgrasp.quality.heights import ON_FACET
from swarmgrasp.quality.poses import Poses, poses_of
from swarmgrasp.swarm import Robot, Swarm

Array = NDArray[np.float64]
Normal = tuple[float, float, float]
EXACT, CERTIFIED = 1e-12, 1e-7
"""Relative gap between a value and its bound, with known poses and with uncertain ones."""


class Rays:
    """The rays of a swarm's robots, as they are or in all their poses.

    Parameters
    ----------
    swarm : Swarm
        Of rays only.
    worst_case : bool
    losing : int
        Robots that may be lost.
    load : tuple of float [N]
        In the metric's coordinates.
    task : (m, 3)
        In the metric's coordinates, the longest row about 1; no rows: the unit ball.
    is_polytope : bool

    Attributes
    ----------
    known : (n, 3) [N]
        Generators of the robots whose pose is known, in the metric's coordinates.
    poses : (r, 12)
        The kernel's rows of the others.
    core : core.Criterion
    gap : float
        No direction is weaker than a value found by more than this share.
    size : float [N]
        The sum of |b_i|: what rounding is relative to.
    """

    def __init__(
        self, swarm: Swarm, worst_case: bool, losing: int, load: Normal, task: Array,
        is_polytope: bool,
    ) -> None:  # fmt: skip
        self._swarm, self._losing = swarm, losing
        self.spreads = poses_of(swarm) if worst_case else {}
        certain, known = np.ones(len(swarm), dtype=bool), np.array(swarm.scaled_generators)
        spread: list[Poses] = []
        for i, found in self.spreads.items():
            certain[i] = found is not None and not swarm.tolerances[i].is_spread
            if found is not None and certain[i]:
                known[i] *= found.limit / swarm.limits[i]
            elif found is not None:
                spread.append(found)
        origin = swarm.outline.origin
        rows = [row for u, s in enumerate(spread) for row in s.rows(u, origin)]
        self.known = np.ascontiguousarray(known[certain])
        self.gap = CERTIFIED if rows else EXACT
        x, y, z = swarm.scale.tolist()
        self.poses = np.array(rows, dtype=float).reshape(-1, 12)
        self.core = core.Criterion(
            self.known, (x, y, z), self.poses, losing, load, task, is_polytope
        )
        limits = sum(s.limit for s in spread)
        self.size = float(np.linalg.norm(self.known, axis=1).sum()) + limits

    def least(self, units: float | None) -> tuple[float, Normal, float, float]:
        """Find the least H / D, a unit normal that attains it, and what no direction falls below.

        Within so many units of work; the last number is how many are left. With uncertain poses
        the value comes down, pose by pose, to one that a swarm in its worst poses has exactly; the
        bound is that of the search on all poses.
        """
        value, normal, is_done, left = self.core.least(
            self.gap, np.inf, core.WORK if units is None else units
        )
        if not is_done:
            return value, normal, 0.0, left
        return value, normal, value if self.gap == EXACT else value * (1.0 - self.gap), left

    def heights(self, normals: Array) -> bytes:
        """Return H, the H before the last loss, and D, (m, 3), at normals (m, 3) [N]."""
        return self.core.heights(normals)

    def lost_at(self, normal: Normal) -> tuple[int, ...]:
        """Return the robots whose loss hurts most along a normal, the worst first."""
        generators = self.worst_wrenches(normal)
        terms, sizes = generators @ np.asarray(normal), np.linalg.norm(generators, axis=1)
        order = np.argsort(-terms, kind="stable")[: self._losing]
        return tuple(int(i) for i in order if terms[i] > ON_FACET * sizes[i])

    def worst_wrenches(self, normal: Normal) -> Array:
        """Return the generators (n, 3) of the robots in their worst poses along a normal.

        In the metric's coordinates; 0 for those that may be absent.
        """
        found = np.array(self._swarm.scaled_generators)
        covector, origin = np.asarray(normal) * self._swarm.scale, self._swarm.outline.origin
        for i, spread in self.spreads.items():
            found[i] = 0.0
            if spread is not None:
                (x, y), direction = spread.worst(origin, covector)
                c, s = np.cos(direction), np.sin(direction)
                torque = (x - origin[0]) * s - (y - origin[1]) * c
                found[i] = spread.limit * np.array([c, s, torque]) * self._swarm.scale
        return found

    def worst_poses(self, normal: Normal) -> dict[int, Robot | None]:
        """Return the robots that have a tolerance in their worst poses; None if absent."""
        covector = np.asarray(normal) * self._swarm.scale
        found: dict[int, Robot | None] = {}
        for i, spread in self.spreads.items():
            found[i] = None
            if spread is not None and i in self._swarm.rare.couples:
                limit = spread.limit * float(self._swarm.nearness[i])
                found[i] = replace(self._swarm.robots[i], limit=limit, tolerance=None)
            elif spread is not None:
                contact, direction = spread.worst(self._swarm.outline.origin, covector)
                label, mounted = self._swarm.names[i], bool(self._swarm.mounted[i])
                group = self._swarm.rare.groups.get(i, "")
                found[i] = Robot(contact, direction, spread.limit, label, mounted, group=group)
        return found
