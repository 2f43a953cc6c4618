"""What a swarm is worth with several newcomers, by the criterion of its problem (T14, T15, T16)."""

from dataclasses import replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import core
from swarmgrasp.placement.together.stands import Ground, Stands
from swarmgrasp.products import dots
from swarmgrasp.quality.aim import NO_TASK, Aim
from swarmgrasp.quality.task import Polytope
from swarmgrasp.quality.weakest import UNASKED, Weakest, weakest_of
from swarmgrasp.swarm import Swarm

Array = NDArray[np.float64]
MOST_PAIRED = 40
"""Generators of the swarm whose planes with each other and with the newcomers' are listed."""
PARALLEL = 1e-9
"""Sine of the angle between generators that have no plane in common."""


class Levels(NamedTuple):
    """What a swarm has along normals without its newcomers.

    Attributes
    ----------
    normals : (m, 3)
    heights : (m, losing + 1) [N]
        H after the worst loss of 0, 1, ... of its robots.
    extents : (m,)
        D: H / D is a quality, in newtons or in the task's unit.
    """

    normals: Array
    heights: Array
    extents: Array

    def take(self, rows: "NDArray[np.intp] | NDArray[np.bool_] | slice") -> "Levels":
        """Return some of them."""
        return Levels(self.normals[rows], self.heights[rows], self.extents[rows])

    def joined(self, others: "Levels") -> "Levels":
        """Return these and others."""
        pairs = zip(self, others, strict=True)
        return Levels(*(np.concatenate(pair) for pair in pairs))

    def with_newcomers(self, terms: Array) -> Array:
        """Return H / D (m,) with newcomers that add so much, (m, k) [N], the worst ones lost."""
        losing = self.heights.shape[1] - 1
        if losing == 0:
            return np.asarray((self.heights[:, 0] + terms.sum(axis=1)) / self.extents)
        order = -np.sort(-terms, axis=1)
        lost = np.zeros((len(terms), losing + 1))
        known = min(losing, terms.shape[1])
        lost[:, 1 : known + 1] = np.cumsum(order[:, :known], axis=1)
        lost[:, known + 1 :] = lost[:, known : known + 1]
        left = self.heights - lost[:, ::-1]  # j of the swarm's robots lost, and losing - j others
        return np.asarray((left.min(axis=1) + terms.sum(axis=1)) / self.extents)


class Gauge:
    """Qualities of a problem's swarm with several newcomers.

    Parameters
    ----------
    ground : Ground

    Attributes
    ----------
    before : Weakest
        Quality and weakest normal of the swarm alone.
    known : (n, 3) [N]
        Its generators whose wrench is known, in the metric's coordinates.
    losing : int
    unit : float
        What divides forces [N] for a quality: 1 without a task.
    """

    def __init__(self, ground: Ground) -> None:
        self.ground, problem = ground, ground.problem
        self.swarm, self.criterion = problem.swarm, problem.criterion
        self.losing = self.criterion.losing
        self.is_plain = self.criterion.is_nominal
        self.load = np.array(self.criterion.load) * self.swarm.scale
        if self.is_plain:
            self.known, self.unit = self.swarm.scaled_generators, 1.0
            self.before = weakest_of(self.known)
            return
        self._aims = [
            Aim(self.swarm, replace(self.criterion, losing=k)) for k in range(self.losing + 1)
        ]
        aim = self._aims[-1]
        self.known, self.unit = aim.known, aim.unit
        self.before, _ = aim.weakest()

    @property
    def size_known(self) -> float:
        """The size of the swarm's wrenches [N]: what rounding is relative to."""
        return float(np.linalg.norm(self.known, axis=1).sum())

    @property
    def size(self) -> float:
        """What one newcomer may add to a quality, at most."""
        return self.reach / self.unit

    @cached_property
    def reach(self) -> float:
        """The length of a newcomer's longest wrench [N]."""
        ground = self.ground
        arms = ground.outline.vertices - ground.outline.origin
        arm = float(np.linalg.norm(arms, axis=1).max())
        return float(np.hypot(ground.scale[:2].max(), ground.scale[2] * arm))

    def levels(self, normals: Array) -> Levels:
        """Return what the swarm has along unit normals (m, 3) in which anything is asked."""
        rows = np.ascontiguousarray(normals, dtype=float).reshape(-1, 3)
        if self.is_plain:
            heights = np.maximum(dots(rows, self.known), 0.0).sum(axis=1, keepdims=True)
            return Levels(rows, heights, np.ones(len(rows)))
        found = [aim.levels(rows) for aim in self._aims]
        heights = np.column_stack([each[:, 0] for each in found]) + UNASKED * self._aims[-1].size
        levels = Levels(rows, heights, found[0][:, 2])
        return levels.take(levels.extents > UNASKED * self.unit)

    def exact(self, stands: Stands) -> Weakest:
        """Compute the quality with newcomers, and the normal that attains it."""
        if self.criterion.worst_case:
            return Aim(self.swarm_with(stands), self.criterion).weakest()[0]
        return self.weakest(self.ground.wrenches(stands))

    def weakest(self, points: Array) -> Weakest:
        """Compute the same with further generators (k, 3) [N], of known pose."""
        both = np.vstack([self.known, points])
        if self.is_plain:
            return weakest_of(both)
        task, rays = self.criterion.task, self._aims[-1].rays
        rows = NO_TASK if task is None else task.generators * self.swarm.scale / self.unit
        x, y, z = self.swarm.scale.tolist()
        fx, fy, turn = self.load.tolist()
        judge = core.Criterion(
            both, (x, y, z), rays.poses, self.losing, (fx, fy, turn),
            np.ascontiguousarray(rows), isinstance(task, Polytope),
        )  # fmt: skip
        value, normal, *_ = judge.least(rays.gap, np.inf)
        return Weakest(value / self.unit, normal)

    def touched(self, normals: Array, values: Array) -> Array:
        """Return the points (m, 3) [N] of the robots' set that a task grown to values touches."""
        task, scale = self.criterion.task, self.swarm.scale
        if task is None:
            return np.asarray(values[:, None] * normals - self.load)
        farthest = [task.farthest(normal) for normal in normals * scale]
        return np.asarray(values[:, None] * np.array(farthest) * scale - self.load)

    def swarm_with(self, stands: Stands) -> Swarm:
        """Return the swarm with the newcomers."""
        swarm = self.swarm
        for robot in self.ground.robots(stands, [""] * len(stands.piece)):
            swarm = swarm.with_robot(robot)
        return swarm

    def adds(self, normals: Array, points: Array) -> Array:
        """Return what one newcomer at each of the points (k, 3) [N] adds along normals: (m, k)."""
        return np.asarray(np.maximum(dots(normals, points), 0.0))

    def exerted(self, pulls: Array) -> Array:
        """Return the shares of their generators that newcomers exert which are pulled so."""
        return np.asarray(pulls > 0.0, dtype=float)

    def weak_with(self, points: Array, mass: Array) -> Array:
        """List unit normals (m, 3) that may be weakest with so many newcomers at each point."""
        return self.weak_normals(points * mass[:, None])

    def weak_normals(self, points: Array) -> Array:
        """List unit normals (m, 3) that may be weakest with further generators (k, 3) [N].

        With few robots all normals of facets (T2); with many, those near the weakest.
        """
        found = self.weakest(points)
        normal = np.array(found.normal)
        base = self.known
        if len(base) > MOST_PAIRED:
            sizes = np.linalg.norm(base, axis=1)
            near = np.abs(dots(base, normal[None])[:, 0]) / np.where(sizes > 0.0, sizes, 1.0)
            base = base[np.argsort(near, kind="stable")[:MOST_PAIRED]]
        return np.vstack([normal, facet_normals(np.vstack([base, points]))])


def facet_normals(generators: Array) -> Array:
    """Return +-(b_j x b_k)/|b_j x b_k| for all pairs of generators (n, 3) not parallel, (m, 3).

    Examples
    --------
    >>> facet_normals(np.eye(3)[:2]).tolist()
    [[0.0, 0.0, 1.0], [-0.0, -0.0, -1.0]]
    """
    first, second = np.triu_indices(len(generators), 1)
    sizes = np.linalg.norm(generators, axis=1)
    crosses = np.cross(generators[first], generators[second])
    lengths = np.linalg.norm(crosses, axis=1)
    kept = lengths > PARALLEL * sizes[first] * sizes[second]
    normals = crosses[kept] / lengths[kept, None]
    return np.concatenate([normals, -normals])
