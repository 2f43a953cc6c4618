"""Several newcomers of any kind beside robots of any kind (T17, T20).

What a newcomer adds along a normal is convex in the wrench of its one direction, or in its contact
if it keeps its force set. So it adds no more than newcomers split up between the ends of an
interval of contacts, and there between the corners of a polygon around the arc of directions: the
linear programs that bound rays beside rays bound these, too. Of those present they ask H only.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import NowhereToAttach
from swarmgrasp.placement.boxes import BoxSearch
from swarmgrasp.placement.pieces import halves_of
from swarmgrasp.placement.place import place
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.together.gathering import spread_normals
from swarmgrasp.placement.together.gauge import Gauge
from swarmgrasp.placement.together.polish import GAIN, MOST_NORMALS, ROUNDS, Climb, Polish
from swarmgrasp.placement.together.stands import Ground, Stands
from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm import Robot

Array = NDArray[np.float64]
KEPT, FIXED = 1e-5, 1e-3
"""Relative gap to which one newcomer is placed beside the others: one that keeps its force set, and
one of a fixed direction,"""
ASKED, STEPS = 40, 5
"""for which no more exact qualities are asked, and the steps that it takes."""
AROUND = 300
"""Normals spread evenly that are looked at beside the weakest."""
REMEMBERED = 400
"""Weakest normals that are kept for the next look."""
ASIDE = 1e-6
"""Of a tenth of the outline's radius and of a radian: from how far slopes are taken."""


class SetGround(Ground):
    """The places of newcomers of any kind.

    Those that keep their force set have one direction on each piece, the middle of their sector.

    Attributes
    ----------
    halves : (p,) [rad]
        How far either side they steer on each piece.
    """

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem)
        self.halves = np.zeros(len(self.low))
        if problem.newcomer.steers:
            self.halves = halves_of(np.column_stack([self.low[:, 1], self.high[:, 1]]))
            middles = 0.5 * (self.low[:, 1] + self.high[:, 1])
            self.low[:, 1] = self.high[:, 1] = middles

    def points_at(self, piece: int, arc: float, radii: Array, angles: Array) -> Array:
        """Return moment arm, direction as a vector, half of the sector, and limits: (c, 6)."""
        along = arc - self.outline.corner_arc_lengths[self.edges[piece]]
        stands = Stands(
            np.full(len(angles), piece), np.column_stack([np.full(len(angles), along), angles])
        )
        return self.points_of(stands, radii)

    def points_of(self, stands: Stands, sizes: Array | float = 1.0) -> Array:
        """Return the same of stands, (k, 6), and of so many limits each."""
        arms, turns = self.contacts(stands) - self.outline.origin, stands.at[:, 1]
        sizes = np.broadcast_to(sizes, turns.shape)
        return np.column_stack(
            [arms, np.cos(turns), np.sin(turns), self.halves[stands.piece], sizes]
        )

    def robots(self, stands: Stands, names: Sequence[str]) -> tuple[Robot, ...]:
        """Return the newcomers in contact."""
        newcomer = self.problem.newcomer
        return tuple(
            replace(self.robot(point, newcomer.limit, name), tolerance=newcomer.tolerance)
            for point, name in zip(self.points_of(stands), names, strict=True)
        )

    def robot(self, point: Array, limit: float, name: str = "") -> Robot:
        """Return a newcomer at a point (6,), so strong ahead [N], that is sure to be there."""
        x, y, c, s, half, size = point.tolist()
        newcomer = self.problem.newcomer
        contact = tuple((np.array([x, y]) + self.outline.origin).tolist())
        return Robot(
            contact, math.atan2(s, c), size * limit, name, False, None,
            size * newcomer.reverse_limit, half, newcomer.friction,
        )  # fmt: skip


class SetGauge(Gauge):
    """Qualities of a problem's swarm with several newcomers of any kind.

    Attributes
    ----------
    back : float
        The newcomer's reverse limit, relative to what it exerts ahead for certain.
    met : (m, 3)
        Unit normals, spread evenly and lately found to be weakest.
    """

    ground: SetGround

    def __init__(self, ground: SetGround) -> None:
        self.ground, problem = ground, ground.problem
        self.swarm, self.criterion = problem.swarm, problem.criterion
        self.losing, self.is_plain = self.criterion.losing, False
        self._aims = [
            Aim(self.swarm, replace(self.criterion, losing=k)) for k in range(self.losing + 1)
        ]
        self.unit = self._aims[-1].unit
        self.before, _ = self._aims[-1].weakest()
        self.back = problem.newcomer.reverse_limit / problem.certain_limit
        self.met = spread_normals(AROUND)

    @property
    def size_known(self) -> float:
        """The size of the swarm's wrenches [N]: what rounding is relative to."""
        return self._aims[-1].size

    @cached_property
    def reach(self) -> float:
        """The length of a newcomer's longest wrench [N]."""
        friction = self.ground.problem.newcomer.friction or 0.0
        ground, radius = self.ground, self.ground.outline.radius
        arm = math.hypot(float(ground.scale[:2].max()), float(ground.scale[2]) * radius)
        return max(1.0, self.back, math.hypot(1.0, friction)) * arm

    def adds(self, normals: Array, points: Array) -> Array:
        """Return what one newcomer at each of the points (k, 6) adds along normals: (m, k) [N]."""
        x, y, c, s, half, most = points.T
        u, v, turn = (normals * self.ground.scale).T[:, :, None]
        px, py = u - turn * y, v + turn * x
        ahead, side = px * c + py * s, np.abs(px * s - py * c)
        friction = self.ground.problem.newcomer.friction
        if friction:
            return np.asarray(most * np.maximum(ahead + friction * side, 0.0))
        size, c, s = np.hypot(px, py), np.cos(half), np.sin(half)
        worths = [
            share * np.where(way >= size * c, size, np.maximum(way * c + side * s, 0.0))
            for share, way in ((1.0, ahead), (self.back, -ahead))
        ]
        return np.asarray(most * np.maximum(*worths))

    def exerted(self, pulls: Array) -> Array:
        """Return the shares of their generators that newcomers exert which are pulled so."""
        return np.where(pulls > 0.0, 1.0, -self.back)

    def weak_with(self, points: Array, mass: Array) -> Array:
        """List unit normals (m, 3) that may be weakest with so many newcomers at each point."""
        swarm, limit = self.swarm, self.ground.problem.certain_limit
        for point, count in zip(points, mass, strict=True):
            more = np.append(point[:5], point[5] * count)
            swarm = swarm.with_robot(self.ground.robot(more, limit))
        self._note(Aim(swarm, self.criterion).weakest()[0])
        return self.met

    def exact(self, stands: Stands) -> Weakest:
        """Compute the quality with newcomers, and the normal that attains it."""
        found = Aim(self.swarm_with(stands), self.criterion).weakest()[0]
        self._note(found)
        return found

    def _note(self, found: Weakest) -> None:
        """Keep a weakest normal: the last comes first, those spread evenly last."""
        normal, lately = np.array(found.normal), self.met[:-AROUND][:REMEMBERED]
        is_new = np.abs(lately - normal).max(axis=1) > ASIDE
        self.met = np.vstack([normal, lately[is_new], self.met[-AROUND:]])


class SetPolish(Polish):
    """Newcomers of a fixed direction that move to raise the quality, beside robots of any kind."""

    gauge: SetGauge

    def _placed(self, others: Stands) -> tuple[int, Array] | None:
        """Return a good stand beside others; None if none helps."""
        ground = self.ground
        self.budget.spend(STEPS)
        try:
            pieces = ground.pieces_beside(others)
        except NowhereToAttach:
            return None
        asked = ground.problem.with_swarm(self.gauge.swarm_with(others))
        best = BoxSearch(asked, pieces).solve(FIXED, asks=ASKED).best
        if best.piece < 0:
            return None
        return ground.stand_at(*pieces.robot_at(best.piece, best.c, best.s, best.torque))

    def _facets(self, stands: Stands, quality: float, step: float) -> tuple[Array, Array]:
        """Return how the weakest levels change with the stands, (m, 2 k), and the levels (m,)."""
        gauge, ground = self.gauge, self.gauge.ground
        levels = gauge.levels(gauge.met)
        terms = gauge.adds(levels.normals, ground.points_of(stands))
        values = levels.with_newcomers(terms)
        order = np.argsort(values, kind="stable")[:MOST_NORMALS]
        values = values - max(float(values[order[0]]) - quality, 0.0)  # a place may be missed
        order = order[values[order] <= quality + step * gauge.size]
        levels, terms = levels.take(order), terms[order]
        shares = np.ones(terms.shape)
        self._lose(levels, shares, terms)
        slopes = []
        for near in np.diag(ASIDE * self._reach):
            ends = [Stands(stands.piece, stands.at + way * near) for way in (1.0, -1.0)]
            more, less = (gauge.adds(levels.normals, ground.points_of(end)) for end in ends)
            slopes.append((more - less) * shares / (2.0 * near.sum() * levels.extents[:, None]))
        return np.stack(slopes, axis=2).reshape(len(order), -1), values[order]


class KeptPolish(SetPolish):
    """The same for newcomers that keep their force set: only their contacts are to be found."""

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
            answer = place(ground.problem.with_swarm(swarm), gap=KEPT)
        except NowhereToAttach:
            return None
        return ground.stand_at(answer.robot.contact, answer.robot.direction)
