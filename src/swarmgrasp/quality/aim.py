"""A swarm and a criterion in the kernels' terms."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import ProblemInvalid
from swarmgrasp.kernels import core
from swarmgrasp.quality.criterion import Criterion
from swarmgrasp.quality.rays import Normal, Rays
from swarmgrasp.quality.robot_sets import RobotSets
from swarmgrasp.quality.task import Polytope
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm import Robot, Swarm

Array = NDArray[np.float64]
NO_TASK = np.zeros((0, 3))


@dataclass(eq=False)
class Work:
    """What several searches may do together.

    Attributes
    ----------
    left : float
        The kernels' units of work, see `work.h`; below 0 if it was overdrawn by what must be done
        in any case.
    """

    left: float

    def quality(self, aim: "Aim", most: float = math.inf, enough: float = 0.0) -> Weakest:
        """Compute a quality; 0 if that takes more than is left, or more than `most` units.

        Below `enough` any upper bound will do.
        """
        units = min(self.left, most)
        found, bound, left = aim.weakest_within(units, enough)
        self.left -= units - left
        is_known = bound > 0.0 or found.quality < enough
        return found if is_known else found._replace(quality=0.0)


class Aim:
    """What a criterion asks of a swarm.

    Inside, values are forces [N]: the task is brought to the size of the unit ball. `unit` is
    what divides them for the user: 1 without a task.

    Parameters
    ----------
    swarm : Swarm
    criterion : Criterion
    as_sets : bool
        Take rays for sets, too.

    Attributes
    ----------
    robots : Rays or RobotSets
        Rays if that is all there is; groups and failures take sets.
    unit : float [N]
    """

    def __init__(self, swarm: Swarm, criterion: Criterion, as_sets: bool = False) -> None:
        self.swarm, self.criterion = swarm, criterion
        task = NO_TASK if criterion.task is None else criterion.task.generators * swarm.scale
        self.unit = 1.0 if criterion.task is None else float(np.linalg.norm(task, axis=1).max())
        x, y, z = (np.array(criterion.load) * swarm.scale).tolist()
        asked = (
            swarm, criterion.worst_case, criterion.losing, (x, y, z),
            np.ascontiguousarray(task / self.unit), isinstance(criterion.task, Polytope),
        )  # fmt: skip
        has_machines = bool(criterion.failures or (criterion.losing and swarm.rare.groups))
        self.robots: Rays | RobotSets
        if swarm.has_rays_only and not (has_machines or as_sets):
            self.robots = Rays(*asked)
        else:
            self.robots = RobotSets(*asked, criterion.failures)
        self.spreads = self.robots.spreads

    @property
    def rays(self) -> Rays:
        """The robots, if they are rays.

        Raises
        ------
        ProblemInvalid
            If they are not.
        """
        if isinstance(self.robots, Rays):
            return self.robots
        raise ProblemInvalid(
            "this is known for robots that push along one ray each, without groups or failures; "
            "some of these steer, reverse, or have another set of forces"
        )

    @property
    def core(self) -> core.Criterion:
        """The kernel's criterion, of rays."""
        return self.rays.core

    @property
    def known(self) -> Array:
        """(n, 3) [N]: generators of the rays whose pose is known, in the metric's coordinates."""
        return self.rays.known

    @property
    def size(self) -> float:
        """The sum of |b_i| [N]: what rounding is relative to."""
        return self.robots.size

    def weakest(self) -> tuple[Weakest, float]:
        """Find the least H / D, a unit normal that attains it, and what no direction falls below.

        With uncertain poses the value comes down, pose by pose, to one that a swarm in its worst
        poses has exactly; the bound is that of the search on all poses.
        """
        return self.weakest_within(None)[:2]

    def weakest_within(
        self, units: float | None, enough: float = 0.0
    ) -> tuple[Weakest, float, float]:
        """Find the same with so many units of work, and how many are left; the bound may be 0.

        Of robots that are no rays less than `enough` will do, if it is not the least.
        """
        if isinstance(self.robots, RobotSets):
            value, normal, bound, left = self.robots.least(units, enough * self.unit)
        else:
            value, normal, bound, left = self.robots.least(units)
        return Weakest(value / self.unit, normal), bound / self.unit, left

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
        found = np.array(np.frombuffer(self.robots.heights(rows)).reshape(-1, 3))
        found[:, 2] *= self.unit
        return found

    def lost_at(self, normal: Normal) -> tuple[int, ...]:
        """Return the robots whose loss hurts most along a normal, the worst first."""
        return self.robots.lost_at(normal)

    def failure_at(self, normal: Normal) -> int | None:
        """Return which of the criterion's failures is the worst along a normal, if any."""
        return self.robots.failure_at(normal) if isinstance(self.robots, RobotSets) else None

    def gone_at(self, normal: Normal) -> set[int]:
        """Return the robots that are not there in the worst case: lost, failing, or absent."""
        gone = {i for i, poses in self.spreads.items() if poses is None}
        if isinstance(self.robots, RobotSets):
            gone |= set(self.robots.failing_at(normal))
        return gone | set(self.lost_at(normal))

    def worst_wrenches(self, normal: Normal) -> Array:
        """Return the wrenches (n, 3) [N] of the robots at their best in their worst poses.

        In the metric's coordinates; 0 for those that may be absent.
        """
        return self.robots.worst_wrenches(normal)

    def worst_poses(self, normal: Normal) -> dict[int, Robot | None]:
        """Return the robots that have a tolerance in their worst poses; None if absent."""
        return self.robots.worst_poses(normal)

    def worst_swarm(self, normal: Normal) -> Swarm:
        """Return the swarm as it is in the worst case along a normal, without those lost."""
        poses, gone = self.worst_poses(normal), self.gone_at(normal)
        if not poses:
            return self.swarm.without_rows(gone)
        robots = [
            poses.get(i) or robot for i, robot in enumerate(self.swarm.robots) if i not in gone
        ]
        swarm = self.swarm
        return Swarm(swarm.outline, robots, swarm.characteristic_length, swarm.force_weights)
