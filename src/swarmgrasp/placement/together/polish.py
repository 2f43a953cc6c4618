"""Newcomers moved on the boundary until no move helps: one at a time, and all together (T17)."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import NowhereToAttach
from swarmgrasp.linear import Program
from swarmgrasp.placement.search import Search, search_for
from swarmgrasp.placement.together.effort import Budget
from swarmgrasp.placement.together.gauge import Gauge, Levels
from swarmgrasp.placement.together.stands import Stands
from swarmgrasp.products import dots

Array = NDArray[np.float64]
FIRST_STEP, LAST_STEP, LONGEST_STEP = 1.0, 1e-6, 5.0
"""Steps, of a tenth of the outline's radius and a tenth of a radian each: where a climb begins
and ends, and what it may grow to."""
MOST_STEPS = 60
"""Steps of one climb."""
MOST_NORMALS, MOST_SIFTED = 80, 600
"""Weak normals that a step looks at, and those among which they are found."""
GAIN = 1e-7
"""Relative gain that counts as none."""
ON_PLANE = 1e-9
"""Sine of the angle to a facet within which a generator counts as lying in it."""
RIDGE = 1e-10
"""What keeps equations solvable whose generators span no plane, relative to the longest squared."""
ROUGH = 1e-7
"""Relative gap to which one newcomer is placed beside the others."""
ROUGH_STEP, ROUGH_GAIN, ROUGH_TURNS = 0.1, 5e-3, 4
"""Where a first climb ends: at a step, or at the relative gain of so many steps."""
HOPEFUL = 0.985
"""Share of the best quality that a first climb should reach to go on."""
ROUNDS = 12
"""Times that newcomers are moved together and one at a time, at most."""


class Climb(NamedTuple):
    """Newcomers and the quality with them."""

    stands: Stands
    quality: float


class Polish:
    """Newcomers that move to raise the quality.

    Parameters
    ----------
    gauge : Gauge
    budget : Budget
        When it is spent they stop moving.
    """

    def __init__(self, gauge: Gauge, budget: Budget) -> None:
        self.gauge, self.ground, self.budget = gauge, gauge.ground, budget
        self._reach = 0.1 * np.array([self.ground.outline.radius, 1.0])

    def climb(self, stands: Stands, best: float = 0.0) -> Climb:
        """Move newcomers together and one at a time until neither helps.

        Given up early where it falls short of the best quality known.
        """
        found = Climb(stands, self.gauge.exact(stands).quality)
        found = self.one_by_one(self.together(found, is_rough=True))
        for _ in range(ROUNDS if found.quality >= HOPEFUL * best else 0):
            before = found.quality
            found = self.one_by_one(self.together(found))
            if found.quality <= before * (1.0 + 10.0 * GAIN) or self.budget.is_spent:
                break
        return found

    # -- one at a time

    def one_by_one(self, climb: Climb) -> Climb:
        """Place each newcomer anew beside the others, which is solved exactly (T9)."""
        for row in range(len(climb.stands.piece)):
            if self.budget.is_spent:
                break
            others = [k for k in range(len(climb.stands.piece)) if k != row]
            found = self._placed(climb.stands.take(others))
            if found is None:
                continue
            stands = climb.stands.with_one(row, *found)
            if not self.ground.keeps_spacing(stands):
                continue
            quality = self.gauge.exact(stands).quality
            if quality > climb.quality * (1.0 + GAIN):
                climb = Climb(stands, quality)
        return climb

    def _placed(self, others: Stands) -> tuple[int, Array] | None:
        """Return the best stand beside others; None if none helps."""
        ground, gauge = self.ground, self.gauge
        self.budget.spend()
        try:
            pieces = ground.pieces_beside(others)
        except NowhereToAttach:
            return None
        if gauge.is_plain:
            generators = np.vstack([gauge.known, ground.wrenches(others)])
            search = Search(generators, ground.scale, pieces.rows)
        else:
            search = search_for(ground.problem.with_swarm(gauge.swarm_with(others)), pieces.rows)
        best = search.solve(ROUGH).best
        if best.piece < 0:
            return None
        return ground.stand_at(*pieces.robot_at(best.piece, best.c, best.s, best.torque))

    # -- all together

    def together(self, climb: Climb, is_rough: bool = False) -> Climb:
        """Move all newcomers a little, time and again, by linear programs in their places."""
        step, last = FIRST_STEP, ROUGH_STEP if is_rough else LAST_STEP
        reached = [climb.quality]
        while step >= last and len(reached) <= MOST_STEPS and not self.budget.is_spent:
            earlier = reached[-ROUGH_TURNS] if len(reached) > ROUGH_TURNS else -1.0
            if is_rough and climb.quality < earlier * (1.0 + ROUGH_GAIN):
                break
            found = self._step(climb, step)
            reached.append(climb.quality)
            if found is None:
                step *= 0.25
                continue
            stands, hoped = found
            quality = self.gauge.exact(stands).quality
            gained = quality - climb.quality
            if gained > 0.0 and self.ground.keeps_spacing(stands):
                climb = Climb(stands, quality)
                step = min(1.5 * step, LONGEST_STEP) if gained > 0.1 * hoped else 0.5 * step
            else:
                step *= 0.35
        return climb

    def _step(self, climb: Climb, step: float) -> tuple[Stands, float] | None:
        """Return the best stands near by, to first order, and the gain hoped for."""
        stands, count = climb.stands, len(climb.stands.piece)
        rows, sides = self._facets(stands, climb.quality, step)
        low, high = self.ground.low[stands.piece], self.ground.high[stands.piece]
        lower = np.minimum(np.maximum(low - stands.at, -step * self._reach), 0.0)
        upper = np.maximum(np.minimum(high - stands.at, step * self._reach), 0.0)
        size = self.gauge.size
        cost = np.append(np.zeros(2 * count), -1.0)
        columns = (np.append(lower.ravel(), 0.0), np.append(upper.ravel(), np.inf))
        program = Program(cost, np.column_stack([-rows / size, np.ones(len(rows))]),
                          (-np.inf, (sides - climb.quality) / size), columns)  # fmt: skip
        apart, room = self._spacing_rows(stands)
        if len(apart):
            program.add_rows(np.column_stack([apart, np.zeros(len(apart))]), (room, np.inf))
        self.budget.spend()
        solution = program.solve()
        if solution is None or solution.values[-1] * size <= GAIN * max(climb.quality, GAIN * size):
            return None
        moves = solution.values[:-1].reshape(count, 2)
        moved = self.ground.clipped(Stands(stands.piece, stands.at + moves))
        return moved, float(solution.values[-1]) * size

    def _spacing_rows(self, stands: Stands) -> tuple[Array, Array]:
        """Return rows that keep newcomers apart: distances are convex, so tangents are safe."""
        ground, count = self.ground, len(stands.piece)
        if ground.spacing == 0.0 or count < 2:
            return np.zeros((0, 2 * count)), np.zeros(0)
        points, steps = ground.contacts(stands), ground.steps(stands)
        first, second = np.triu_indices(count, 1)
        offsets = points[first] - points[second]
        apart = np.linalg.norm(offsets, axis=1)
        ways = offsets / np.maximum(apart, ground.near)[:, None]
        rows, pairs = np.zeros((len(first), 2 * count)), np.arange(len(first))
        rows[pairs, 2 * first] = (ways * steps[first]).sum(axis=1)
        rows[pairs, 2 * second] = -(ways * steps[second]).sum(axis=1)
        return rows, np.minimum(ground.spacing - apart, 0.0)

    def _facets(self, stands: Stands, quality: float, step: float) -> tuple[Array, Array]:
        """Return how the weakest facets change with the stands, (m, 2 k), and their levels (m,).

        At a facet's normal n the point of the wrench set that is touched is sum u_i b_i, with u_i
        1 for robots that push along n, 0 for those that do not, and in between for those whose
        generators span the facet; to first order the level rises by sum u_i n . db_i.
        """
        gauge, own = self.gauge, self.ground.wrenches(stands)
        levels = gauge.levels(gauge.weak_normals(own))
        terms = np.maximum(dots(levels.normals, own), 0.0)
        values = levels.with_newcomers(terms)
        order = np.argsort(values, kind="stable")[:MOST_SIFTED]
        # of newcomers that may miss their places only the nominal ones are looked at
        values = values - max(float(values[order[0]]) - quality, 0.0)
        order = order[values[order] <= quality + step * gauge.size]
        rounded = np.round(levels.normals[order], 7)
        order = order[np.sort(np.unique(rounded, axis=0, return_index=True)[1])][:MOST_NORMALS]
        levels = levels.take(order)
        shares = self._shares(levels, own, terms[order], values[order])
        moved, turned = self.ground.slopes(stands)
        normals, extents = levels.normals, levels.extents[:, None]
        slopes = np.stack([dots(normals, moved), dots(normals, turned)], axis=2)
        slopes *= (shares / extents)[:, :, None]
        return slopes.reshape(len(order), -1), values[order]

    def _shares(self, levels: Levels, own: Array, terms: Array, values: Array) -> Array:
        """Return the shares u (m, k) of the newcomers at the points that facets are touched in."""
        gauge, normals = self.gauge, levels.normals
        along, reach = dots(normals, own), ON_PLANE * np.linalg.norm(own, axis=1)
        shares: Array = np.asarray(along > reach, dtype=float)
        self._lose(levels, shares, terms)
        flat = np.abs(along) <= reach
        shares[flat] = 0.5
        rows = np.flatnonzero(flat.any(axis=1))
        if gauge.criterion.worst_case or len(gauge.known) > MOST_NORMALS or not len(rows):
            return shares
        normals, values = normals[rows], values[rows]
        both = np.vstack([gauge.known, own])
        products, reach = dots(normals, both), ON_PLANE * np.linalg.norm(both, axis=1)
        spanning = (np.abs(products) <= reach).astype(float)
        pushing = (products > reach).astype(float)
        lost = np.argsort(-products, axis=1, kind="stable")[:, : gauge.losing]
        np.put_along_axis(pushing, lost, 0.0, axis=1)
        missing = gauge.touched(normals, values) - dots(pushing + 0.5 * spanning, both.T)
        # the least change from halves, for which the facets' generators make up what is missing
        squares = dots(spanning, _squares(both).T)
        squares += (_squares(normals) + RIDGE * np.eye(3).ravel()) * gauge.reach**2
        found = 0.5 + dots(_solved(squares.reshape(-1, 3, 3), missing), own)
        shares[rows] = np.where(flat[rows], np.clip(found, 0.0, 1.0), shares[rows])
        return shares

    def _lose(self, levels: Levels, shares: Array, terms: Array) -> None:
        """Set the shares of those newcomers to 0 that are lost along each normal; in place."""
        losing = self.gauge.losing
        for row, level in enumerate(levels.heights if losing else ()):
            order = np.argsort(-terms[row], kind="stable")
            lost = np.concatenate([[0.0], np.cumsum(terms[row][order][:losing])])
            left = [level[losing - k] - lost[min(k, len(lost) - 1)] for k in range(losing + 1)]
            shares[row, order[: int(np.argmin(left))]] = 0.0


def _squares(vectors: Array) -> Array:
    """Return the products of the components of each vector (m, 3) with each other, (m, 9)."""
    return np.asarray((vectors[:, :, None] * vectors[:, None]).reshape(-1, 9))


def _solved(matrices: Array, sides: Array) -> Array:
    """Solve symmetric equations (m, 3, 3) for sides (m, 3), by cross products of the rows."""
    first, second, third = matrices.transpose(1, 0, 2)
    adjugate = np.stack(
        [np.cross(second, third), np.cross(third, first), np.cross(first, second)], axis=1
    )
    determinant = (first * adjugate[:, 0]).sum(axis=1)
    return np.asarray((adjugate * sides[:, :, None]).sum(axis=1) / determinant[:, None])
