"""The place inside of a newcomer that keeps all it can exert, by patches of contacts (T22).

Its part of H is convex in the contact, over areas as along edges: on a triangle it is no more than
what goes linearly from corner to corner. So whatever mixture of normals is best against the three
corners bounds the quality there, a matrix game; or normals do that travel from corner to corner.
"""

import heapq
import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import core
from swarmgrasp.placement.areas import Decks
from swarmgrasp.placement.certificate import Certificate, PatchProof
from swarmgrasp.placement.kept import CHECKED, TRIED, Kept, kept_robot
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.search import WORK, Optimum
from swarmgrasp.quality.aim import Aim, Work
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm import Robot

Array = NDArray[np.float64]
Kind = Literal["chords", "travelling"]
ENOUGH, CLOSE = 300, 1e-4
"""Exact qualities after which a bound so near, relatively, is near enough, or one of nothing."""
WORK_PER_PATCH, WORK_PER_NORMAL = 2e5, 150.0
"""The kernels' units of work that bounding a patch takes, and for each normal besides."""
WORK_PER_ASK = 3e5
"""The same for an exact quality, besides what it takes itself."""
SAME = 1e-14
"""Distance between unit normals that are one."""
NOTHING = 1.5
"""Times what counts as 0: what normals leave that were asked where it is 0."""
STRONG = 0.3
"""Of the swarm's size: from this strength on a newcomer's own poles matter."""
STEEP = 0.01
"""Share of D, along each of some normals, below which none travels between them."""
SMALLEST = 1e-12
"""Width of a patch, relative to its distance from the origin, that only rounding could split."""
NARROW = 0.1
"""Share of the outline's radius up to which a patch is asked about at its corners, too."""
NEAR = 1e-3
"""Share of the outline's radius within which two places are one."""
PIVOTS, PRICE = 60, 1e-11
"""Of a game, whose mixture is good at any time; and the price from which a row comes in."""
SMALL = 1e-10
"""Difference between what mixtures are worth, relative to what rows are, that is none."""


class Berth(NamedTuple):
    """Where a newcomer may be inside.

    Attributes
    ----------
    quality : float [N]
        Of the swarm with it.
    piece : int
        The deck; -1 when none betters the swarm as it is.
    arm : tuple of float [m, m]
        Moment arm of its contact.
    sector : tuple of float [rad, rad]
        That it keeps there.
    """

    quality: float
    piece: int
    arm: tuple[float, float]
    sector: tuple[float, float]


class Patch(NamedTuple):
    """A triangle of contacts, or a line or a spot, and what bounds it.

    Attributes
    ----------
    deck : int
    corners : (k, 2) [m, m]
        Moment arms, of one to three.
    bound : float
        The quality that no robot on it exceeds.
    ask : (2,) [m, m]
        The moment arm that looks best.
    known : int
        Normals met when it was bounded.
    kind : str
    rows : list of int
        Of the normals met those that bound it,
    weights : (r,)
        and how they are mixed.
    """

    deck: int
    corners: Array
    bound: float
    ask: Array
    known: int
    kind: Kind
    rows: list[int]
    weights: Array


@dataclass(frozen=True, eq=False)
class PatchOptimum(Optimum[Berth]):
    """The best robot that keeps its force set over some decks, and the patches that bound them.

    Attributes
    ----------
    patches : tuple of Patch
    """

    patches: tuple[Patch, ...]
    _decks: Decks

    @cached_property
    def certificate(self) -> Certificate:
        """The proofs of all bounds."""
        return Certificate((), (), (), tuple(self._proofs()), self.upper_bound)

    def _proofs(self) -> Iterator[PatchProof]:
        """Yield the proof of each patch."""
        for patch in self.patches:
            deck = self._decks.each[patch.deck]
            corners = (patch.corners + self._decks.outline.origin).tolist()
            yield PatchProof(
                tuple((x, y) for x, y in corners), deck.lo, deck.hi, patch.kind,
                self.normals_met[patch.rows], patch.weights,
            )  # fmt: skip


class PatchSearch:
    """The place inside of a newcomer that keeps its force set, by the criterion of a problem.

    Parameters
    ----------
    problem : Problem
    decks : Decks

    Attributes
    ----------
    aim : Aim
    base : Weakest
        The base swarm's quality and weakest normal.
    opposite : float [N]
        Its support function at the opposite normal.
    floor, zero : float [N]
        A difference not worth closing, and a quality that counts as 0.
    work : Work
        What exact qualities by the aim may take besides: as much as the search.
    """

    def __init__(self, problem: Problem, decks: Decks) -> None:
        self.aim = Aim(problem.swarm, problem.criterion, as_sets=True)
        self.work, self._own_work = Work(WORK), Work(WORK)
        self._problem, self._decks = problem, decks
        self._kept = Kept(self.aim, problem)
        self._normals, self._levels = np.zeros((0, 3)), np.zeros((0, 3))
        criterion = problem.criterion
        self._may_travel = not (criterion.losing or criterion.failures or self.aim.spreads)
        self.base, _, self._own_work.left = self.aim.weakest_within(WORK)
        opposite = -np.array(self.base.normal)
        self.opposite = float(self.aim.values(opposite)[0])
        arms = problem.swarm.outline.vertices - problem.swarm.outline.origin
        self._radius = float(np.linalg.norm(arms, axis=1).max())
        x, y, turn = (problem.swarm.scale * problem.certain_limit).tolist()
        strength = float(np.hypot(max(x, y), turn * self._radius))
        size = (self.aim.size + strength) / self.aim.unit
        self.floor, self.zero = core.FLOOR * size, core.MARGINAL * size
        self._has_poles = strength > STRONG * self.aim.size
        self._meet(np.vstack([-opposite, opposite, np.eye(3), -np.eye(3)]))

    @property
    def left(self) -> float:
        """Units of work; below 0 when it was not enough."""
        return self._own_work.left

    def solve(
        self, gap: float, chosen: Sequence[int] | None = None, asks: int = core.ASKS
    ) -> PatchOptimum:
        """Find the best robot on all decks, or on the chosen ones.

        Parameters
        ----------
        gap : float
            Largest difference between bound and best, relative to the best.
        chosen : sequence of int, optional
        asks : int
            Exact qualities after which it stops with the bound it has.
        """
        self._best, asked = Berth(self.base.quality, -1, (0.0, 0.0), (0.0, 0.0)), 0
        self._gap, self._order = gap, itertools.count()
        self._open: list[tuple[float, int, Patch]] = []
        self._closed: list[Patch] = []
        self._asked = set[tuple[int, float, float]]()
        for k in range(len(self._decks.each)) if chosen is None else chosen:
            for corners in self._decks.each[k].parts:
                self._put(self._bounded(k, corners))
        while self._open and -self._open[0][0] > self._enough:
            is_close = -self._open[0][0] <= self._best.quality * (1.0 + CLOSE)
            is_enough = is_close or self._best.quality == 0.0
            if asked >= (ENOUGH if is_enough else asks) or self._own_work.left <= 0.0:
                break
            *_, patch = heapq.heappop(self._open)
            if patch.known < len(self._normals):
                self._put(self._bounded(patch.deck, patch.corners, patch))
                continue
            asked += 1
            corner = self._open_corner(patch)
            if corner is not None:
                self._ask(patch.deck, corner)
                self._put(self._bounded(patch.deck, patch.corners, patch))
                continue
            self._ask(patch.deck, patch.ask)
            halves = _halves(patch.corners, SMALLEST * self._radius)
            if halves is None:  # its own normal bounds it now
                self._closed.append(self._bounded(patch.deck, patch.corners, patch))
            else:  # a travelling normal bounds the whole only
                before = patch if patch.kind == "chords" else None
                for corners in halves:
                    self._put(self._bounded(patch.deck, corners, before))
        patches = (*self._closed, *(patch for *_, patch in self._open))
        bounds = np.zeros(len(self._decks.each))
        for patch in patches:
            bounds[patch.deck] = max(bounds[patch.deck], patch.bound)
        self._patches, top = patches, float(bounds.max())
        return PatchOptimum(
            top <= self._enough, self._best, top, bounds, self._normals, patches, self._decks
        )

    @property
    def _enough(self) -> float:
        """What a bound may be for a patch to be closed."""
        best = self._best.quality
        return max(best + max(self._gap * best, self.floor), NOTHING * self.zero)

    def _put(self, patch: Patch) -> None:
        """Put a patch where it belongs."""
        if patch.bound <= self._enough:
            self._closed.append(patch)
        else:
            heapq.heappush(self._open, (-patch.bound, next(self._order), patch))

    def _open_corner(self, patch: Patch) -> Array | None:
        """Return a corner at which was not asked; None where the patch is wide.

        The weakest normals at corners are those that travel; they alone tell where nothing is held.
        """
        width = float(np.ptp(patch.corners, axis=0).max())
        if self._best.quality > 0.0 and width > NARROW * self._radius:
            return None
        corners = ((patch.deck, *corner) for corner in patch.corners.tolist())
        fresh = (k for k, corner in enumerate(corners) if corner not in self._asked)
        return next((patch.corners[k] for k in fresh), None)

    def _meet(self, normals: Array) -> None:
        """Add unit normals (m, 3) to those known, but for what is known of them."""
        apart = np.linalg.norm(normals[:, None] - self._normals, axis=2)
        normals = normals[~(apart <= SAME).any(axis=1)]
        levels = self.aim.levels(normals)
        levels[levels[:, 2] <= core.UNASKED * self.aim.unit, 2] = 0.0
        self._normals = np.vstack([self._normals, normals])
        self._levels = np.vstack([self._levels, levels])

    def _ask(self, deck: int, arm: Array) -> None:
        """Compute the quality at a moment arm, and meet its weakest normal."""
        self._own_work.left -= WORK_PER_ASK
        self._asked.add((deck, *arm.tolist()))
        found, berth = self._quality_at(deck, arm, self._own_work)
        if berth.quality > self._best.quality:
            self._best = berth
        self._meet(np.array([found.normal]))

    def _meet_poles(self, corners: Array) -> None:
        """Meet the normals along which a newcomer at moment arms (k, 2) exerts nothing."""
        x, y, turn = self._problem.swarm.scale.tolist()
        ones = np.ones(len(corners))
        poles = np.column_stack([turn / x * corners[:, 1], -turn / y * corners[:, 0], ones])
        poles /= np.linalg.norm(poles, axis=1)[:, None]
        self._meet(np.vstack([poles, -poles]))

    def _quality_at(self, deck: int, arm: Array, work: Work) -> tuple[Weakest, Berth]:
        """Compute the quality with the newcomer at a moment arm."""
        berth = self._berth(deck, arm)
        swarm = self._problem.swarm.with_robot(robot_in(self._problem, berth))
        found = work.quality(Aim(swarm, self._problem.criterion))
        return found, berth._replace(quality=found.quality)

    def _berth(self, deck: int, arm: Array) -> Berth:
        """Return a place of no quality yet."""
        (x, y), (_, lo, hi, _) = arm.tolist(), self._decks.each[deck]
        return Berth(0.0, deck, (x, y), (lo, hi))

    def _bounded(self, deck: int, corners: Array, before: Patch | None = None) -> Patch:
        """Bound a patch by all normals met, and no worse than before."""
        if self._has_poles or self._best.quality == 0.0:
            self._meet_poles(corners)
        count, rows = len(self._normals), np.arange(len(self._normals))
        self._own_work.left -= WORK_PER_PATCH + WORK_PER_NORMAL * count
        _, lo, hi, _ = self._decks.each[deck]
        sectors = np.tile([lo, hi], (len(corners), 1))
        height, cap, extent = self._levels.T
        sides = height[:, None] + self._kept.gains(corners, sectors, self._normals).T
        with np.errstate(divide="ignore", invalid="ignore"):
            values, caps = sides / extent[:, None], np.maximum(cap, 0.0) / extent
        unasked = extent == 0.0  # it bounds nothing, unless a load is not held
        values[unasked] = np.where(sides.max(axis=1) < 0.0, 0.0, np.inf)[unasked, None]
        caps[unasked] = np.inf
        known = np.isfinite(values).all(axis=1)
        bound, chosen, weights, shares = mixture_against(values[known])
        patch = Patch(
            deck, corners, max(bound, 0.0), shares @ corners, count, "chords",
            rows[known][chosen].tolist(), weights,
        )  # fmt: skip
        if self._may_travel:
            patch = self._travelled(patch, values, ~unasked)
        if before is not None and before.bound < patch.bound:
            patch = before._replace(corners=corners, ask=patch.ask, known=count)
        if caps.min() < patch.bound:  # no newcomer does better, anywhere
            patch = patch._replace(
                bound=float(caps.min()), kind="chords", rows=[int(caps.argmin())],
                weights=np.ones(1),
            )  # fmt: skip
        return patch

    def _travelled(self, patch: Patch, values: Array, asked: NDArray[np.bool_]) -> Patch:
        """Bound a patch by normals that travel from corner to corner, if that is better."""
        for sign in (1.0, -1.0):
            rows = np.flatnonzero((sign * self._normals[:, 2] > 0.0) & asked)
            if not len(rows):
                continue
            least = rows[values[rows].argmin(axis=0)]
            extents = self._levels[least, 2] / self.aim.unit
            along = self._normals[least] @ self._farthest(self._normals[least].sum(axis=0))
            if not (along > STEEP * extents).all():
                continue
            reached = values[least, range(len(least))] * extents / along
            bound = max(float(reached.max()), 0.0)
            if bound < patch.bound:
                patch = patch._replace(
                    bound=bound, kind="travelling", rows=least.tolist(), weights=np.ones(len(least))
                )
        return patch

    def _farthest(self, way: Array) -> Array:
        """Return the task's wrench (3,) farthest along a way, relative to the task's size."""
        task, scale = self._problem.criterion.task, self._problem.swarm.scale
        if task is None:
            return np.asarray(way / max(float(np.linalg.norm(way)), np.finfo(float).tiny))
        return np.asarray(task.farthest(way * scale) * scale / self.aim.unit)

    def break_tie(self, best: Berth, target: float) -> Berth:
        """Of the robots of at least the target quality [N], take the one that lifts the rest most.

        After `solve`, which found the best. It lifts most that makes the soft minimum of H over
        directions greatest (T17).
        """
        near, is_found = NEAR * self._radius, best.piece >= 0
        rivals = [
            patch
            for patch in self._patches
            if patch.bound >= target
            and not (
                patch.deck == best.piece
                and (np.linalg.norm(patch.corners - best.arm, axis=1) <= near).all()
            )
        ]
        spots = [(best.piece, np.array(best.arm))] if is_found else []
        each = max(1, TRIED // max(1, len(rivals)))
        for patch in rivals[:TRIED]:
            shares = _shares(len(patch.corners), each)
            spots += [(patch.deck, arm) for arm in shares @ patch.corners]
        if is_found and len(spots) == 1:
            return best
        decks, arms = [deck for deck, _ in spots], np.array([arm for _, arm in spots])
        sectors = np.array([self._decks.each[deck][1:3] for deck in decks])
        order = np.argsort(self._kept.scores(arms, sectors), kind="stable") if spots else ()
        for k in order[: CHECKED + 1]:
            if is_found and k == 0:
                return best
            _, berth = self._quality_at(decks[k], arms[k], self.work)
            if berth.quality >= target:
                return berth
        if is_found:
            return best
        middle = self._decks.each[0].parts[0].mean(axis=0)
        return self._berth(0, middle)._replace(quality=best.quality)


def robot_in(problem: Problem, berth: Berth, name: str = "") -> Robot:
    """Return a newcomer that keeps its force set, inside."""
    x, y = (problem.swarm.outline.origin + berth.arm).tolist()
    return kept_robot(problem.newcomer, (x, y), *berth.sector, name)


def mixture_against(values: Array) -> tuple[float, Array, Array, Array]:
    """Play a matrix game: mix rows so that the greatest of the columns' sums is least.

    By the simplex method: greatest sum of q with q values <= 1, q >= 0, once all are above 0.

    Parameters
    ----------
    values : (r, k)

    Returns
    -------
    float, (m,), (m,), (k,)
        That sum, the rows mixed and their weights, and the mixture of columns that does best
        against them. The sum is that of the weights, whatever rounding did to them.

    Examples
    --------
    >>> value, rows, weights, shares = mixture_against(np.array([[3.0, 0.0], [0.0, 1.0]]))
    >>> value, weights.tolist(), shares.tolist()
    (0.75, [0.25, 0.75], [0.25, 0.75])
    """
    tops, width = values.max(axis=1), values.shape[1]
    low, top = float(values.min()), float(tops.min())
    rows = np.flatnonzero(values.min(axis=1) <= top)
    unit = max(top - low, SMALL * float(np.abs(values[rows]).max()), np.finfo(float).tiny)
    # the last rows are slack: they count for nothing
    game = np.vstack([1.0 + (values[rows] - low) / unit, np.eye(width)])
    costs = np.append(np.ones(len(rows)), np.zeros(width))
    basis = len(rows) + np.arange(width)
    for _ in range(PIVOTS):
        inverse = np.linalg.inv(game[basis].T)
        worths = costs - game @ (costs[basis] @ inverse)
        row = int(worths.argmax())
        step = inverse @ game[row]
        if worths[row] <= PRICE or not (step > PRICE).any():
            break
        steps = np.where(step > PRICE, step, 1.0)
        basis[np.where(step > PRICE, inverse.sum(axis=1) / steps, np.inf).argmin()] = row
    inverse = np.linalg.inv(game[basis].T)
    levels, prices = inverse.sum(axis=1), np.maximum(costs[basis] @ inverse, 0.0)
    used = (basis < len(rows)) & (levels > 0.0)
    chosen, weights = rows[basis[used]], levels[used] / levels[used].sum()
    return float((weights @ values[chosen]).max()), chosen, weights, prices / prices.sum()


def _halves(corners: Array, smallest: float) -> tuple[Array, Array] | None:
    """Cut a patch across its longest side; None if that is no longer than the smallest [m]."""
    count = len(corners)
    pairs = list(itertools.combinations(range(count), 2))
    lengths = [float(np.linalg.norm(corners[i] - corners[j])) for i, j in pairs]
    if not pairs or max(lengths) <= smallest:
        return None
    i, j = pairs[int(np.argmax(lengths))]
    one, other = corners.copy(), corners.copy()
    one[i] = other[j] = 0.5 * (corners[i] + corners[j])
    return one, other


def _shares(corners: int, count: int) -> Array:
    """Return at most so many mixtures (c, corners) of corners, spread evenly inside of a patch."""
    if corners == 1:
        return np.ones((1, 1))
    side = count if corners == 2 else max(1, int(math.sqrt(2 * count)) - 1)
    marks = itertools.product(range(side), repeat=corners - 1)
    shares = (np.array([m for m in marks if sum(m) < side]) + 1.0 / corners) / side
    return np.column_stack([shares, 1.0 - shares.sum(axis=1)])
