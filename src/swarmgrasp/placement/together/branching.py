"""How many newcomers stand in which region: branch and bound over all distributions (T17)."""

import heapq
import itertools
import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement.together.regions import CONTACT, DIRECTION, Cut, Region
from swarmgrasp.placement.together.relaxation import Relaxation, Relaxed, Rows, Share
from swarmgrasp.products import weighted

Array = NDArray[np.float64]
EVEN = 0.03
"""What a cut counts for that parts a relaxed solution into whole newcomers."""
WIDE = 1e-3
"""What the width of a region counts for beside."""
FINE = 0.05
"""Arc of directions [rad] for the bound of the whole."""


class Branches:
    """Shares of newcomers that are still to be looked at, the highest bound first.

    Parameters
    ----------
    relaxation : Relaxation
    region : Region
        Of all places.

    Attributes
    ----------
    seen : int
        Shares looked at.
    """

    def __init__(self, relaxation: Relaxation, region: Region) -> None:
        self.relaxation, self.seen = relaxation, 0
        self._ground = region.ground
        self._order = itertools.count()
        self._open: list[tuple[float, int, Share]] = []
        self._shut, self._roof = -math.inf, math.inf
        if region.room >= relaxation.count:
            self._put(relaxation.first(region))

    @property
    def bound(self) -> float:
        """What no newcomers reach, wherever they stand."""
        highest = -self._open[0][0] if self._open else -math.inf
        return min(max(highest, self._shut), self._roof)

    @property
    def is_done(self) -> bool:
        """Whether nothing is left to be looked at."""
        return not self._open

    def step(self, target: float) -> tuple[Share, Relaxed] | None:
        """Look at the share with the highest bound, and part it; None if it misses the target."""
        _, _, share = heapq.heappop(self._open)
        self.seen += 1
        if share.bound <= target:
            self._shut = max(self._shut, share.bound)
            return None
        relaxed = self.relaxation.solve(share, target)
        if relaxed is None:
            self._shut = max(self._shut, share.bound)
            return None
        if self.seen == 1:
            self._roof = self._fine_bound(share)
        found = self._best_cut(share, relaxed)
        if found is None:
            self._shut = max(self._shut, share.bound)
        else:
            for part in self._parts(share, *found):
                part.bound = min(share.bound, self.relaxation.quick_bound(part, relaxed))
                if part.bound <= target:
                    self._shut = max(self._shut, part.bound)
                else:
                    self._put(part)
        return share, relaxed

    def _put(self, share: Share) -> None:
        heapq.heappush(self._open, (-share.bound, next(self._order), share))

    def _fine_bound(self, share: Share) -> float:
        """Return the bound of the whole, with directions as they are but for a little."""
        finer = Region(self._ground, share.regions[0].boxes)
        vars(finer)["hull"] = finer.finer_hull(FINE)
        whole = Share((finer,), share.counts, share.rows, share.bound)
        self.relaxation.solve(whole, -math.inf)
        return whole.bound

    def _best_cut(self, share: Share, relaxed: Relaxed) -> tuple[int, Cut] | None:
        """Choose the region and the cut that the relaxed solution obeys least."""
        best, found = -1.0, None
        for index, region in enumerate(share.regions):
            there = np.flatnonzero((relaxed.which == index) & (relaxed.mass > 0.0))
            for axis in (CONTACT, DIRECTION):
                cut = region.halves(axis)
                if cut is None:
                    continue
                size = self._size(region, axis)
                score = self._split(relaxed, there, axis, cut, size) + WIDE * size
                if score > best:
                    best, found = score, (index, cut)
        return found

    def _size(self, region: Region, axis: int) -> float:
        """Return how far apart wrenches in a region may be that way, relative to the longest."""
        span = region.span(axis)
        if axis == DIRECTION:
            return 2.0 * math.sin(0.25 * min(span, math.pi))
        scale, radius = self._ground.scale, self._ground.outline.radius
        return min(0.5 * span, radius) * float(scale[2] / scale[:2].max())

    def _split(
        self, relaxed: Relaxed, there: "NDArray[np.intp]", axis: int, cut: Cut, size: float
    ) -> float:
        """Return how much a cut would change.

        That is the part of a newcomer that it divides, times what the two sides differ in.
        """
        places, mass = relaxed.at[there, axis], relaxed.mass[there]
        below = np.where(np.abs(places - cut.where) <= 1e-9, 0.5, places < cut.where)
        low, high = float((below * mass).sum()), float(((1.0 - below) * mass).sum())
        if min(low, high) <= 1e-9:
            return 0.0
        divided = abs(low - round(low))
        terms = relaxed.terms[:, there]
        means = weighted(below * mass / low - (1.0 - below) * mass / high, terms.T)
        return (divided + EVEN) * min(float((relaxed.multipliers * np.abs(means)).sum()), size)

    def _parts(self, share: Share, index: int, cut: Cut) -> "list[Share]":
        """Return the shares of a region's newcomers between its halves."""
        others = [k for k in range(len(share.regions)) if k != index]
        count, found = int(share.counts[index]), []
        for low in range(count + 1):
            halves = [(cut.low, low), (cut.high, count - low)]
            taken = [(region, number) for region, number in halves if number]
            if not self._has_room(taken, [share.regions[k] for k in others]):
                continue
            columns = others + [index] * len(taken)
            kept = share.rows.kept[:, columns]
            rows = Rows(share.rows.normal, share.rows.lost, kept)
            regions = (*(share.regions[k] for k in others), *(region for region, _ in taken))
            counts = np.array([*share.counts[others], *(number for _, number in taken)])
            found.append(Share(regions, counts, rows, share.bound))
        return found

    def _has_room(self, taken: list[tuple[Region, int]], others: list[Region]) -> bool:
        """Tell whether newcomers may keep the spacing in new regions, beside others."""
        if self._ground.spacing == 0.0:
            return True
        if any(region.room < number for region, number in taken):
            return False
        new = [region for region, _ in taken]
        pairs = [*itertools.product(new, others), *itertools.combinations(new, 2)]
        return all(one.is_apart(other) for one, other in pairs)
