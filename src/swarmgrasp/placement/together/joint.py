"""The search for the best places of several newcomers at once: answers and a bound (T17)."""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.together.branching import Branches
from swarmgrasp.placement.together.effort import Budget
from swarmgrasp.placement.together.gathering import Gathering
from swarmgrasp.placement.together.gauge import Gauge
from swarmgrasp.placement.together.polish import Climb, Polish
from swarmgrasp.placement.together.regions import whole
from swarmgrasp.placement.together.relaxation import Relaxation, Relaxed, Share
from swarmgrasp.placement.together.sets import KeptPolish, SetGauge, SetGround, SetPolish
from swarmgrasp.placement.together.stands import Ground, Stands
from swarmgrasp.quality.weakest import MARGINAL

Array = NDArray[np.float64]
SearchProgress = Callable[[float, float], object]
MOST_STARTS = 2
"""Places where newcomers have gathered that are climbed from."""
SEED = 17
"""Of the random numbers: the same search finds the same answer again."""


class JointSearch:
    """Good places of several newcomers, and what no places exceed.

    Parameters
    ----------
    problem : Problem
    count : int
    gap : float
        Difference between bound and quality, relative to the quality, that is small enough.
    enough : float
        A quality that is good enough; whether there is one is then all that is asked.
    budget : Budget
        When it is spent the search stops anyway.

    Attributes
    ----------
    best : Climb
    """

    def __init__(
        self, problem: Problem, count: int, gap: float, budget: Budget, enough: float = math.inf
    ) -> None:
        self.problem, self.count, self.gap, self.enough = problem, count, gap, enough
        self.budget = budget
        self.ground, self.gauge, self.polish, self.gathering = _parts_of(problem, budget)
        self.branches = Branches(Relaxation(self.gauge, count, budget), whole(self.ground))
        self.best = Climb(Stands(np.zeros(0, dtype=np.intp), np.zeros((0, 2))), -1.0)
        self.ceiling = 0.0 if self._is_hopeless else math.inf
        self._random = np.random.default_rng(SEED)
        self._starts: list[Stands] = []
        self._climbs = 0
        self._zero = MARGINAL * (self.gauge.size_known / self.gauge.unit + count * self.gauge.size)

    @property
    def bound(self) -> float:
        """What no newcomers reach, in the quality's unit."""
        bound = max(min(self.branches.bound, self.ceiling), self.best.quality)
        return bound if bound > self._zero else 0.0

    @property
    def has_room(self) -> bool:
        """Whether the spacing may leave room to them all."""
        return self.branches.bound > -math.inf

    @property
    def target(self) -> float:
        """A bound up to this is not worth lowering."""
        quality = max(self.best.quality, 0.0)
        wanted = quality * (1.0 + self.gap) + self._zero
        return wanted if self.enough == math.inf else max(wanted, self.enough * (1.0 - 1e-9))

    @property
    def is_over(self) -> bool:
        """Whether the bound is as near as asked, or the quality good enough."""
        is_enough = self.best.quality >= self.enough
        return is_enough or (self.best.quality >= 0.0 and self.bound <= self.target)

    def offer(self, stands: Stands) -> None:
        """Climb from some places, and keep the best that was reached."""
        if len(stands.piece) < self.count or not self.ground.keeps_spacing(stands):
            return
        found = self.polish.climb(stands, self.best.quality)
        if found.quality > self.best.quality:
            self.best = found

    def run(self, progress: SearchProgress | None = None) -> None:
        """Search until it is over, or the budget is spent: on answers and on the bound in turn.

        Parameters
        ----------
        progress : callable, optional
            Called with the best quality and the bound, now and then; ends the search if it says so.
        """
        relaxed: tuple[Share, Relaxed] | None = None
        climbing, bounding = 0, 0
        while not (self.is_over or self.budget.is_spent):
            if self.branches.is_done and (self.best.quality >= 0.0 or not self.has_room):
                break
            before = self.budget.left
            if not self.branches.is_done and bounding <= climbing:
                relaxed = self.branches.step(self.target) or relaxed
                bounding += before - self.budget.left
            else:
                self._climb(relaxed)
                climbing += before - self.budget.left
            if progress is not None and progress(max(self.best.quality, 0.0), self.bound):
                self.budget.stop()

    @property
    def _is_hopeless(self) -> bool:
        """Whether they are too few for any quality."""
        return len(self.gauge.swarm) + self.count < self.problem.fewest

    def _climb(self, relaxed: tuple[Share, Relaxed] | None) -> None:
        """Climb from the best with some moved away, or else from where newcomers gather."""
        turn, self._climbs = self._climbs, self._climbs + 1
        if turn % 2 and self.best.quality > 0.0 and self.count > 1:
            self.offer(self._shaken())
            return
        if not self._starts:
            self._starts = self._gathered(relaxed)
        self.offer(self._starts.pop())

    def _gathered(self, relaxed: tuple[Share, Relaxed] | None) -> list[Stands]:
        """Return where to climb from, the best last.

        Random newcomers, and such near a relaxed solution, gather where all normals pull them.
        """
        rng = self._random
        if self.gathering is None:
            if relaxed is None:
                return [self.ground.random(rng, self.count)]
            return [self._near(*relaxed)]
        flocks = self.gathering.flocks(self.count)
        near = [] if relaxed is None else [self._near(*relaxed) for _ in range(flocks // 2)]
        anywhere = [self.ground.random(rng, self.count) for _ in range(flocks - len(near))]
        found = self.gathering.gathered(near + anywhere)[:MOST_STARTS]
        return [*near[:1], *(found[::-1] or [self.ground.packed(rng, self.count)])]

    def _shaken(self) -> Stands:
        """Return the best stands with one of them anywhere, or some more."""
        stands, rng = self.best.stands, self._random
        moved = min(int(rng.geometric(0.5)), self.count // 2)
        rows = rng.permutation(self.count)
        return self.ground.random(rng, self.count, stands.take(rows[moved:].tolist()))

    def _near(self, share: Share, relaxed: Relaxed) -> Stands:
        """Return whole newcomers near a relaxed solution: at its quantiles in each region."""
        rows: list[int] = []
        for index, count in enumerate(share.counts.astype(int)):
            there = np.flatnonzero(relaxed.which == index)
            order = there[np.lexsort(relaxed.at[there].T)]
            level = np.cumsum(relaxed.mass[order]) / max(float(relaxed.mass[order].sum()), 1e-9)
            wanted = (np.arange(count) + self._random.uniform(0.0, 1.0)) / count
            nearest = np.minimum(np.searchsorted(level, wanted), len(order) - 1)
            rows += order[nearest].tolist()
        outline = self.ground.outline
        arcs = np.minimum(relaxed.at[rows, 0], outline.perimeter)
        points = [outline.at_arc_length(float(arc)).point for arc in arcs]
        stands = self.ground.stands_at(points, relaxed.at[rows, 1].tolist())
        return self.ground.parted(stands, self._random)


def _parts_of(problem: Problem, budget: Budget) -> tuple[Ground, Gauge, Polish, Gathering | None]:
    """Return what newcomers stand on, what they are worth, how they move, and where they gather."""
    if problem.has_rays_only:
        ground = Ground(problem)
        gauge = Gauge(ground)
        return ground, gauge, Polish(gauge, budget), Gathering(gauge, budget)
    places = SetGround(problem)
    worth = SetGauge(places)
    if problem.newcomer.keeps:
        return places, worth, KeptPolish(worth, budget), None
    return places, worth, SetPolish(worth, budget), Gathering(worth, budget)
