"""What newcomers in given regions reach at most, by a linear program (T17).

So many newcomers stand in each of some regions. Split up among the points of a region's hull
they exert at least as much in every direction, so that the linear program

    max t,  t D(n) <= H(n) + sum_c x_c max(0, n . c) for the normals n known,
    sum of x_c over a region's points = the number in it,  x_c >= 0

is an upper bound; any multipliers of its rows give one too. Normals are added where x falls short.
When j of the robots lost are the swarm's and the others newcomers, these take away no less than
their average: each region's sum is then multiplied by the share that is kept.
"""

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.linear import Program
from swarmgrasp.placement.together.effort import Budget
from swarmgrasp.placement.together.gauge import Gauge, Levels
from swarmgrasp.placement.together.regions import Region
from swarmgrasp.products import dots, weighted

Array = NDArray[np.float64]
Indices = NDArray[np.intp]
SHORT = 1e-6
"""Share of t by which a row falls short that is added."""
STALLED = 2e-4
"""Gain of three rounds, relative to the bound, below which no more rows are looked for."""
MOST_ROUNDS = 60
"""Programs solved for one bound, at most."""
MOST_KNOWN, MOST_NEW = 8, 6
"""Rows added at a time: of known normals, and of new ones."""
MOST_SIFTED = 400
"""New normals, the worst, among which those are sought."""
NOBODY = 1e-9
"""Newcomers at a point that are none."""
ALIKE = 0.97
"""Cosine of the angle between new normals of which one is enough."""
SLACK = 0.02
"""How far from t a row may be that is handed on, relative to t."""


@dataclass(frozen=True, eq=False)
class Rows:
    """Rows of a program.

    Attributes
    ----------
    normal : (r,)
        Indices of normals.
    lost : (r,)
        How many of the swarm's robots are lost.
    kept : (r, regions)
        Share of each region's newcomers that is not lost.
    """

    normal: Indices
    lost: Indices
    kept: Array

    def take(self, rows: "Indices | NDArray[np.bool_]") -> "Rows":
        """Return some of them."""
        return Rows(self.normal[rows], self.lost[rows], self.kept[rows])

    def joined(self, others: "Rows") -> "Rows":
        """Return these and others."""
        return Rows(
            np.append(self.normal, others.normal),
            np.append(self.lost, others.lost),
            np.vstack([self.kept, others.kept]),
        )


@dataclass(eq=False)
class Share:
    """So many newcomers in each of some regions, and what they reach at most."""

    regions: tuple[Region, ...]
    counts: Array
    rows: Rows
    bound: float


@dataclass(frozen=True, eq=False)
class Relaxed:
    """A solved program.

    Attributes
    ----------
    at : (c, 2) [m, rad]
        All points' arc lengths and directions.
    which : (c,)
        The regions they belong to.
    mass : (c,)
        How many newcomers are at each.
    terms : (r, c)
        What one at each adds to t, by row.
    multipliers : (r,)
        Of the rows; they sum to 1.
    rows : Rows
    """

    at: Array
    which: Indices
    mass: Array
    terms: Array
    multipliers: Array
    rows: Rows


@dataclass(eq=False)
class Relaxation:
    """All normals known, and the programs they make.

    Parameters
    ----------
    gauge : Gauge
    count : int
        The number of newcomers.
    budget : Budget
        When it is spent, bounds are left as they are.
    """

    gauge: Gauge
    count: int
    budget: Budget
    levels: Levels = field(init=False)

    def __post_init__(self) -> None:
        """Begin with the axes and what lies between them."""
        grid = np.stack(np.meshgrid(*[[-1.0, 0.0, 1.0]] * 3), axis=-1).reshape(-1, 3)
        grid = grid[np.abs(grid).sum(axis=1) > 0.0]
        normals = grid / np.linalg.norm(grid, axis=1)[:, None]
        self.levels = self.gauge.levels(np.vstack([normals, self.gauge.before.normal]))
        self.least, self.size = self.gauge.before.quality, self.gauge.size

    def first(self, region: Region) -> Share:
        """Return the share of all newcomers in one region."""
        many = len(self.levels.normals)
        lost = np.full(many, self.gauge.losing)
        rows = Rows(np.arange(many), lost, np.ones((many, 1)))
        bound = self.least + self.size * self._most()
        return Share((region,), np.array([float(self.count)]), rows, bound)

    def _most(self) -> float:
        """Return what t is at most, as if all newcomers exerted all they can along every normal."""
        straight = self.count * self.gauge.unit / self.levels.extents
        return float((self._heights(self.levels)[:, -1] + straight).min())

    def terms(self, rows: Rows, points: Array, which: Indices) -> Array:
        """Return what one newcomer at each point adds to each row, in units of `size`."""
        levels = self.levels.take(rows.normal)
        found = self.gauge.adds(levels.normals, points)
        found /= (levels.extents * self.size)[:, None]
        return np.asarray(found if self.gauge.losing == 0 else found * rows.kept[:, which])

    def sides(self, rows: Rows) -> Array:
        """Return the rows' right-hand sides in units of `size`, above the swarm's own quality."""
        heights = self.levels.heights[rows.normal, rows.lost] / self.levels.extents[rows.normal]
        return np.asarray((heights - self.least) / self.size)

    def bound(self, share: Share, sides: Array, terms: Array, multipliers: Array) -> float:
        """Return the bound that multipliers prove, whatever they are."""
        worth = weighted(multipliers, terms)
        starts = np.cumsum([0, *(len(region.hull.points) for region in share.regions[:-1])])
        most = np.maximum.reduceat(worth, starts)
        above = (multipliers * sides).sum() + (most * share.counts).sum()
        return float(self.least + self.size * above)

    def quick_bound(self, share: Share, proven: Relaxed) -> float:
        """Return the bound that the multipliers of another program prove, its rows handed on."""
        used = proven.multipliers > 0.0
        rows = share.rows.take(np.flatnonzero(used))
        points, which = _points(share.regions)
        terms = self.terms(rows, points, which)
        return self.bound(share, self.sides(rows), terms, proven.multipliers[used])

    def solve(self, share: Share, target: float) -> Relaxed | None:
        """Bound a share, and note the rows that matter.

        None as soon as the bound is at most a target, or if no program could be solved.
        """
        points, which = _points(share.regions)
        at = np.vstack([region.hull.at for region in share.regions])
        rows, sides = share.rows, self.sides(share.rows)
        terms = self.terms(rows, points, which)
        program = self._program(share, which)
        program.add_rows(_with_t(terms), (-np.inf, sides))
        multipliers, mass, last = np.zeros(0), np.zeros(len(points)), math.inf
        for turn in range(MOST_ROUNDS):
            if self.budget.is_spent:
                break
            self.budget.spend()
            solution = program.solve()
            if solution is None:
                break
            t, mass = float(solution.values[0]), np.maximum(solution.values[1:], 0.0)
            prices = np.maximum(-solution.prices[len(share.regions) :], 0.0)
            if prices.sum() > 0.0:
                multipliers = prices / prices.sum()
                share.bound = min(share.bound, self.bound(share, sides, terms, multipliers))
            if share.bound <= target:
                return None
            more = self._short(share, points, which, mass, t)
            is_stalled = turn > 4 and turn % 3 == 0 and last - share.bound < STALLED * share.bound
            if not len(more.normal) or is_stalled:
                break
            last = share.bound if turn % 3 == 0 else last
            fresh, their_sides = self.terms(more, points, which), self.sides(more)
            program.add_rows(_with_t(fresh), (-np.inf, their_sides))
            rows, terms = rows.joined(more), np.vstack([terms, fresh])
            sides = np.append(sides, their_sides)
        if not len(multipliers):
            return None
        multipliers = np.append(multipliers, np.zeros(len(sides) - len(multipliers)))
        slack = sides + weighted(mass, terms.T)
        near = slack - slack.min(initial=0.0) <= SLACK * max(abs(slack.min(initial=0.0)), SHORT)
        kept = np.flatnonzero(near | (multipliers > 0.0))
        share.rows = rows.take(kept)
        return Relaxed(at, which, mass, terms[kept], multipliers[kept], share.rows)

    def _program(self, share: Share, which: Indices) -> Program:
        """Return the program without rows of normals."""
        members = which == np.arange(len(share.counts))[:, None]
        matrix = np.column_stack([np.zeros(len(share.counts)), members])
        cost = np.zeros(matrix.shape[1])
        cost[0] = -1.0
        lower, upper = np.zeros(len(cost)), np.full(len(cost), np.inf)
        lower[0], upper[0] = -np.inf, self._most()
        return Program(cost, matrix, (share.counts, share.counts), (lower, upper))

    def _short(self, share: Share, points: Array, which: Indices, mass: Array, t: float) -> Rows:
        """Return rows in which newcomers split up so fall short of t, of known normals or new."""
        there = np.flatnonzero(mass > NOBODY)
        points, which, mass = points[there], which[there], mass[there]
        wanted = t - SHORT * max(abs(t), 1e-3)
        weights = mass[:, None] * (which[:, None] == np.arange(len(share.counts)))
        worth = self._worth(self.levels, points, weights)
        values = self._values(self.levels, worth, share.counts)
        order = np.argsort(values, kind="stable")[:MOST_KNOWN]
        short = order[values[order] < wanted]
        if len(short):
            return self._rows(short, worth[short], share.counts)
        fresh = self.gauge.levels(self.gauge.weak_with(points, mass))
        worth = self._worth(fresh, points, weights)
        values = self._values(fresh, worth, share.counts)
        order = np.argsort(values, kind="stable")[:MOST_SIFTED]
        short = order[values[order] < wanted]
        short = short[_unlike(fresh.normals[short], MOST_NEW)]
        first = len(self.levels.normals)
        self.levels = self.levels.joined(fresh.take(short))
        return self._rows(first + np.arange(len(short)), worth[short], share.counts)

    def _worth(self, levels: Levels, points: Array, weights: Array) -> Array:
        """Return what the newcomers of each region add along normals: (m, regions)."""
        terms = self.gauge.adds(levels.normals, points)
        return np.asarray(dots(terms, weights.T) / (levels.extents * self.size)[:, None])

    def _heights(self, levels: Levels) -> Array:
        """Return H / D after losing 0, 1, ... of the swarm's robots: (m, losing + 1)."""
        return np.asarray((levels.heights / levels.extents[:, None] - self.least) / self.size)

    def _values(self, levels: Levels, worth: Array, counts: Array) -> Array:
        """Return what newcomers of that worth reach along normals, after the worst loss: (m,)."""
        if self.gauge.losing == 0:
            return np.asarray(self._heights(levels)[:, 0] + worth.sum(axis=1))
        lost = _largest(worth, counts, self.gauge.losing)[:, ::-1]
        return np.asarray((self._heights(levels) - lost).min(axis=1) + worth.sum(axis=1))

    def _rows(self, normal: Indices, worth: Array, counts: Array) -> Rows:
        """Return rows for normals, with the loss that is worst for newcomers of that worth."""
        losing, levels = self.gauge.losing, self.levels.take(normal)
        kept = np.ones(worth.shape)
        if losing == 0:
            return Rows(normal, np.zeros(len(normal), dtype=np.intp), kept)
        left = self._heights(levels) - _largest(worth, counts, losing)[:, ::-1]
        lost = left.argmin(axis=1)
        for row, others in enumerate(losing - lost):
            for region in np.argsort(-worth[row] / counts, kind="stable"):
                gone = min(others, counts[region])
                kept[row, region] = 1.0 - gone / counts[region]
                others -= gone
        return Rows(normal, lost, kept)


def _largest(worth: Array, counts: Array, losing: int) -> Array:
    """Return what the 0, 1, ... `losing` newcomers that add most add: (m, losing + 1).

    The newcomers of a region all add its average.
    """
    each = np.repeat(worth / counts, counts.astype(int), axis=1)
    order = -np.sort(-each, axis=1)[:, :losing]
    found = np.zeros((len(worth), losing + 1))
    found[:, 1 : order.shape[1] + 1] = np.cumsum(order, axis=1)
    found[:, order.shape[1] + 1 :] = found[:, order.shape[1], None]
    return found


def _unlike(normals: Array, most: int) -> Indices:
    """Return a few rows of normals (m, 3), the first ones, that differ from each other."""
    left = np.arange(len(normals))
    found: list[int] = []
    while len(left) and len(found) < most:
        found.append(int(left[0]))
        left = left[dots(normals[left], normals[left[:1]])[:, 0] < ALIKE]
    return np.array(found, dtype=np.intp)


def _points(regions: tuple[Region, ...]) -> tuple[Array, Indices]:
    """Return the points of regions' hulls, and the regions they belong to."""
    points = np.vstack([region.hull.points for region in regions])
    return points, np.repeat(np.arange(len(regions)), [len(r.hull.points) for r in regions])


def _with_t(terms: Array) -> Array:
    """Return the rows of a program: t - sum of terms."""
    return np.column_stack([np.ones(len(terms)), -terms])
