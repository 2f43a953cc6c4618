"""A swarm and a criterion in the kernels' terms."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import core
from swarmgrasp.quality.criterion import Criterion
from swarmgrasp.quality.heights import ON_FACET
from swarmgrasp.quality.poses import Poses, poses_of
from swarmgrasp.quality.task import Polytope
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm import Robot, Swarm

Array = NDArray[np.float64]
EXACT, CERTIFIED = 1e-12, 1e-7
"""Relative gap between a value and its bound, with known poses and with uncertain ones."""
NO_TASK, NO_SPREAD = np.zeros((0, 3)), np.zeros((0, 12))


class Aim:
    """What a criterion asks of a swarm.

    Inside, values are forces [N]: the task is brought to the size of the unit ball. `unit` is
    what divides them for the user: 1 without a task.

    Parameters
    ----------
    swarm : Swarm
    criterion : Criterion
    more : sequence of Poses
        Further robots of uncertain pose.

    Attributes
    ----------
    known : (n, 3) [N]
        Generators of the robots whose pose is known, in the metric's coordinates.
    gap : float
        No direction is weaker than a value found by more than this share.
    size : float [N]
        The sum of |b_i|: what rounding is relative to.
    unit : float [N]
    """

    def __init__(self, swarm: Swarm, criterion: Criterion, more: Sequence[Poses] = ()) -> None:
        self.swarm, self.criterion, self._more = swarm, criterion, tuple(more)
        self.spreads = poses_of(swarm) if criterion.worst_case else {}
        certain, known = np.ones(len(swarm), dtype=bool), np.array(swarm.scaled_generators)
        spread: list[Poses] = []
        for i, found in self.spreads.items():
            certain[i] = found is not None and not swarm.tolerances[i].is_spread
            if found is not None and certain[i]:
                known[i] *= found.limit / swarm.limits[i]
            elif found is not None:
                spread.append(found)
        origin = swarm.outline.origin
        rows = [row for u, s in enumerate([*spread, *more]) for row in s.rows(u, origin)]
        self.known = np.ascontiguousarray(known[certain])
        self.gap = CERTIFIED if rows else EXACT
        task = NO_TASK if criterion.task is None else criterion.task.generators * swarm.scale
        self.unit = 1.0 if criterion.task is None else float(np.linalg.norm(task, axis=1).max())
        self._task = np.ascontiguousarray(task / self.unit)
        self.core = self._core_of(self.known, np.array(rows, dtype=float).reshape(-1, 12))
        limits = sum(s.limit for s in [*spread, *more])
        self.size = float(np.linalg.norm(self.known, axis=1).sum()) + limits

    def _core_of(self, known: Array, rows: Array) -> core.Criterion:
        """Return the criterion of these generators and rows."""
        x, y, z = self.swarm.scale.tolist()
        is_polytope = isinstance(self.criterion.task, Polytope)
        losing = self.criterion.losing
        return core.Criterion(known, (x, y, z), rows, losing, self.load, self._task, is_polytope)

    @property
    def load(self) -> tuple[float, float, float]:
        """The load [N] in the metric's coordinates."""
        x, y, z = (np.array(self.criterion.load) * self.swarm.scale).tolist()
        return x, y, z

    def weakest(self, work: float = core.WORK) -> tuple[Weakest, float]:
        """Find the least H / D, a unit normal that attains it, and what no direction falls below.

        With uncertain poses the value comes down, pose by pose, to one that a swarm in its worst
        poses has exactly; the bound is that of the search on all poses.
        """
        value, normal, is_done = self.core.least(self.gap, np.inf, work)
        value /= self.unit
        bound = 0.0 if not is_done else value if self.is_exact else value * (1.0 - self.gap)
        return Weakest(value, normal), bound

    def values(self, normals: Array) -> Array:
        """Return H / D (m,) at normals (m, 3), in the user's unit; inf where D is 0."""
        height, _, extent = self.levels(normals).T
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(extent > 0.0, height / extent, np.inf)

    def levels(self, normals: Array) -> Array:
        """Return what a newcomer finds at normals (m, 3).

        Returns
        -------
        (m, 3)
            H [N], what no newcomer lifts it beyond [N], and D: the first by the last is a quality
            in the user's unit.
        """
        rows = np.ascontiguousarray(normals, dtype=float).reshape(-1, 3)
        found = np.array(np.frombuffer(self.core.heights(rows)).reshape(-1, 3))
        found[:, 2] *= self.unit
        return found

    def lost_at(self, normal: Sequence[float]) -> tuple[int, ...]:
        """Return the robots whose loss hurts most along a normal, the worst first."""
        generators = self.worst_generators(normal)
        terms, sizes = generators @ np.asarray(normal), np.linalg.norm(generators, axis=1)
        order = np.argsort(-terms, kind="stable")[: self.criterion.losing]
        return tuple(int(i) for i in order if terms[i] > ON_FACET * sizes[i])

    def worst_generators(self, normal: Sequence[float]) -> Array:
        """Return the generators (n, 3) of the robots in their worst poses along a normal.

        In the metric's coordinates; 0 for those that may be absent. Further robots come last.
        """
        found = np.concatenate([self.swarm.scaled_generators, np.zeros((len(self._more), 3))])
        covector, origin = np.asarray(normal) * self.swarm.scale, self.swarm.outline.origin
        spreads = {**self.spreads, **dict(enumerate(self._more, start=len(self.swarm)))}
        for i, spread in spreads.items():
            found[i] = 0.0
            if spread is not None:
                (x, y), direction = spread.worst(origin, covector)
                c, s = np.cos(direction), np.sin(direction)
                torque = (x - origin[0]) * s - (y - origin[1]) * c
                found[i] = spread.limit * np.array([c, s, torque]) * self.swarm.scale
        return found

    def worst_poses(self, normal: Sequence[float]) -> dict[int, Robot | None]:
        """Return the robots that have a tolerance in their worst poses; None if absent."""
        covector = np.asarray(normal) * self.swarm.scale
        found: dict[int, Robot | None] = {}
        for i, spread in self.spreads.items():
            found[i] = None
            if spread is not None:
                contact, direction = spread.worst(self.swarm.outline.origin, covector)
                label = self.swarm.names[i]
                mounted = bool(self.swarm.mounted[i])
                found[i] = Robot(contact, direction, spread.limit, label, mounted)
        return found

    @property
    def is_exact(self) -> bool:
        """Whether values are exact but for rounding."""
        return self.gap == EXACT

    def worst_swarm(self, normal: Sequence[float]) -> Swarm:
        """Return the swarm as it is in the worst case along a normal, without those lost."""
        poses, gone = self.worst_poses(normal), set(self.lost_at(normal))
        gone |= {i for i, robot in poses.items() if robot is None}
        if not poses:
            return self.swarm.without_rows(gone)
        robots = [
            poses.get(i) or robot for i, robot in enumerate(self.swarm.robots) if i not in gone
        ]
        swarm = self.swarm
        return Swarm(swarm.outline, robots, swarm.characteristic_length, swarm.force_weights)
