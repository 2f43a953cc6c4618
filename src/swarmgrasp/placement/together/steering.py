"""Several newcomers that steer: only their contacts are chosen (T17, T22).

A newcomer that keeps its whole sector adds its support function along every normal, a convex
function of its contact on an edge. So it adds no more than newcomers split up between the two ends
of an interval, and the same linear programs bound it as bound rays, with one point at each end.
"""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import NowhereToAttach
from swarmgrasp.placement.place import place
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.together.gathering import spread_normals
from swarmgrasp.placement.together.gauge import Gauge
from swarmgrasp.placement.together.polish import GAIN, ROUNDS, Climb, Polish
from swarmgrasp.placement.together.stands import Ground, Stands
from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm import Robot

Array = NDArray[np.float64]
ROUGH = 1e-5
"""Relative gap to which one newcomer is placed beside the others."""
AROUND = 300
"""Normals spread evenly that are looked at beside the weakest."""


class SteeringGround(Ground):
    """The places of newcomers that steer; their directions are the middles of their sectors.

    Attributes
    ----------
    halves : (p,) [rad]
        How far either side they steer on each piece.
    """

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem)
        self.halves = 0.5 * (self.high[:, 1] - self.low[:, 1])
        middles = 0.5 * (self.low[:, 1] + self.high[:, 1])
        self.low[:, 1] = self.high[:, 1] = middles

    def points_at(self, piece: int, arc: float, radii: Array, angles: Array) -> Array:  # noqa: ARG002
        """Return moment arm, middle of the sector as a vector, and half of it: (c, 5)."""
        edge = self.edges[piece]
        along = float(arc - self.outline.corner_arc_lengths[edge])
        x, y = self._corners[piece] + self._steps[piece] * along - self.outline.origin
        rows = [(x, y, math.cos(a), math.sin(a), self.halves[piece]) for a in angles.tolist()]
        return np.array(rows)

    def robots(self, stands: Stands, names: Sequence[str]) -> tuple[Robot, ...]:
        """Return the newcomers in contact."""
        newcomer, halves = self.problem.newcomer, self.halves[stands.piece].tolist()
        directions = np.remainder(stands.at[:, 1] + math.pi, math.tau) - math.pi
        rows = zip(self.contacts(stands).tolist(), directions.tolist(), halves, names, strict=True)
        return tuple(
            Robot((x, y), direction, newcomer.limit, name, steers=min(half, math.pi))
            for (x, y), direction, half, name in rows
        )


class SteeringGauge(Gauge):
    """Qualities of a problem's swarm with several newcomers that steer."""

    ground: SteeringGround

    def __init__(self, ground: SteeringGround) -> None:
        self.ground, problem = ground, ground.problem
        self.swarm, self.criterion = problem.swarm, problem.criterion
        self.losing, self.is_plain = self.criterion.losing, False
        self._aims = [
            Aim(self.swarm, replace(self.criterion, losing=k)) for k in range(self.losing + 1)
        ]
        self.unit = self._aims[-1].unit
        self.before, _ = self._aims[-1].weakest()

    @property
    def size_known(self) -> float:
        """The size of the swarm's wrenches [N]: what rounding is relative to."""
        return self._aims[-1].size

    def adds(self, normals: Array, points: Array) -> Array:
        """Return what one newcomer at each of the points (k, 5) adds along normals: (m, k) [N]."""
        x, y, c, s, half = points.T
        u, v, turn = (normals * self.ground.scale).T[:, :, None]
        px, py = u - turn * y, v + turn * x
        size, ahead = np.hypot(px, py), px * c + py * s
        off = np.arctan2(np.abs(px * s - py * c), ahead) - half
        return np.asarray(size * np.where(off <= 0.0, 1.0, np.maximum(np.cos(off), 0.0)))

    def weak_with(self, points: Array, mass: Array) -> Array:
        """List unit normals (m, 3) that may be weakest with so many newcomers at each point."""
        swarm, limit = self.swarm, self.ground.problem.newcomer.limit
        for (x, y, c, s, half), count in zip(points.tolist(), mass.tolist(), strict=True):
            contact = tuple((np.array([x, y]) + swarm.outline.origin).tolist())
            robot = Robot(contact, math.atan2(s, c), limit * count, steers=min(half, math.pi))
            swarm = swarm.with_robot(robot)
        found = Aim(swarm, self.criterion).weakest()[0]
        return np.vstack([np.array(found.normal), spread_normals(AROUND)])

    def exact(self, stands: Stands) -> Weakest:
        """Compute the quality with newcomers, and the normal that attains it."""
        return Aim(self.swarm_with(stands), self.criterion).weakest()[0]


class SteeringPolish(Polish):
    """Newcomers that steer and move one at a time, each to its best place beside the others."""

    def climb(self, stands: Stands, best: float = 0.0) -> Climb:  # noqa: ARG002
        """Move newcomers until no move of one helps."""
        found = Climb(stands, self.gauge.exact(stands).quality)
        for _ in range(ROUNDS):
            before = found.quality
            found = self.one_by_one(found)
            if found.quality <= before * (1.0 + 10.0 * GAIN) or self.budget.is_spent:
                break
        return found

    def _placed(self, others: Stands) -> tuple[int, Array] | None:
        """Return the best stand beside others; None if none helps."""
        ground, swarm = self.ground, self.gauge.swarm_with(others)
        self.budget.spend()
        try:
            answer = place(ground.problem.with_swarm(swarm), gap=ROUGH)
        except NowhereToAttach:
            return None
        return ground.stand_at(answer.robot.contact, answer.robot.direction)
