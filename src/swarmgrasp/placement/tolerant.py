"""The place of a newcomer that cannot hit it exactly: the worst of all it may end up in (T14)."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement.boxes import BoxOptimum
from swarmgrasp.placement.pieces import Pieces
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.search import RayOptimum
from swarmgrasp.quality.aim import Aim, Work
from swarmgrasp.quality.poses import poses_at
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm import Tolerance

Array = NDArray[np.float64]
WORK_PER_CELL = 250.0
"""The kernels' units of work that bounding a cell of places along one normal takes."""
WORK_PER_PLACE = 1e7
"""The same for the quality at one place, at most: some 30 ms."""
BESIDES = 50
"""Normals that a cell takes as long as, besides those looked at."""
SMALLEST = 1e-12
"""Width of a cell [rad], or relative to the lap, that only rounding could split."""
BATCH = 96
"""Cells split at a time."""
CHECKS = 8
"""Places whose quality is computed for each batch."""


class Cells(NamedTuple):
    """Rectangles of contacts and directions, one per row."""

    piece: Array
    """Its index, a whole number."""
    start: Array
    """Arc length of the first contact [m]."""
    end: Array
    lo: Array
    """The first direction [rad]."""
    hi: Array

    def take(self, rows: NDArray[np.intp]) -> "Cells":
        """Return some of them."""
        return Cells(*(column[rows] for column in self))


class Found(NamedTuple):
    """The best place of a tolerant newcomer.

    Attributes
    ----------
    contact : tuple of float [m, m]
    direction : float [rad]
    piece : int
    after : Weakest
        In the worst case.
    upper_bound : float [N]
        What no place exceeds.
    solved : bool
        Whether the bound is as near as asked for.
    """

    contact: tuple[float, float]
    direction: float
    piece: int
    after: Weakest
    upper_bound: float
    solved: bool


class TolerantSearch:
    """Branch and bound over contacts and directions.

    Wherever in a cell the newcomer aims, it may end up in those poses that all its places have
    in common; so a cell reaches no more than with a robot somewhere among these, which is as bad
    as it can be for each normal known.

    Parameters
    ----------
    problem : Problem
        With a tolerance and the criterion of the worst case.
    pieces : Pieces
    found : RayOptimum or BoxOptimum
        The place of a newcomer that would hit it exactly: no tolerant one does better.
    zero : float [N]
        A quality that counts as 0.
    work : Work
        When there is none left, a search stops with the bound it has.
    """

    def __init__(
        self,
        problem: Problem,
        pieces: Pieces,
        found: RayOptimum | BoxOptimum,
        zero: float,
        work: Work,
    ) -> None:
        self.problem, self.pieces, self.found, self.work = problem, pieces, found, work
        tolerance = problem.newcomer.tolerance or Tolerance()
        self.offsets, self.turns = tolerance.offsets, tolerance.turns
        self.aim = Aim(problem.swarm, problem.criterion)
        self.zero = zero
        self.weights = problem.swarm.scale * problem.certain_limit
        outline = problem.swarm.outline
        lap = outline.perimeter
        self._lap = lap
        self._corner_arcs = np.append(outline.corner_arc_lengths[: len(outline)], lap)
        arms = outline.vertices - outline.origin
        self._corners = np.vstack([arms, arms[:1]])
        arcs = self._corner_arcs[:-1]
        self._laps = np.concatenate([arcs - lap, arcs, arcs + lap])
        self._normals = np.zeros((0, 3))
        self._levels = np.zeros((0, 3))
        self.know(found.normals_met)

    def know(self, normals: Array) -> None:
        """Add normals to those that bound the cells."""
        levels = self.aim.levels(normals)
        asked = levels[:, 2] > 0.0
        self._normals = np.vstack([self._normals, normals[asked]])
        self._levels = np.vstack([self._levels, levels[asked]])

    def solve(self, gap: float, chosen: set[int] | None = None) -> Found:
        """Find the best place, on all pieces or on the chosen ones, to a relative gap."""
        cells = self._all(chosen)
        bounds = np.minimum(self.bounds(cells), self.found.bounds[cells.piece.astype(int)])
        best = self._first(chosen)
        while True:
            wanted = best.after.quality * (1.0 + gap) + self.zero
            open_ = bounds > wanted
            if not open_.any() or self.work.left <= 0.0:
                break
            cells, bounds = cells.take(np.flatnonzero(open_)), bounds[open_]
            order = np.argsort(-bounds)
            top, rest = order[:BATCH], order[BATCH:]
            if self._is_point(cells, top[0]):
                break
            halves, limits = self._halves(cells.take(top), bounds[top])
            below = np.minimum(self.bounds(halves), limits)
            best = self._look(halves, below, best)
            cells = Cells(*map(np.concatenate, zip(cells.take(rest), halves, strict=True)))
            bounds = np.concatenate([bounds[rest], below])
            self.work.left -= WORK_PER_CELL * len(below) * (len(self._normals) + BESIDES)
        upper = max(float(bounds.max(initial=0.0)), best.after.quality)
        if chosen is None:
            upper = min(upper, max(self.found.upper_bound, best.after.quality))
        return best._replace(upper_bound=upper, solved=upper <= wanted)

    def _is_point(self, cells: Cells, row: int) -> bool:
        """Tell whether a cell is as small as rounding."""
        along, across = cells.end - cells.start, cells.hi - cells.lo
        return bool(along[row] <= SMALLEST * self._lap and across[row] <= SMALLEST)

    def quality_at(self, contact: tuple[float, float], direction: float) -> Weakest:
        """Compute the quality with the newcomer aiming at a place; 0 if it takes too long."""
        problem = self.problem
        outline, newcomer = problem.swarm.outline, problem.newcomer
        spread = poses_at(
            outline, contact, direction, newcomer.limit, newcomer.tolerance or Tolerance()
        )
        return self.work.quality(Aim(problem.swarm, problem.criterion, [spread]), WORK_PER_PLACE)

    def _all(self, chosen: set[int] | None) -> Cells:
        """Return one cell for each piece."""
        arcs = self._corner_arcs
        rows = [
            (k, arcs[p.edge] + p.start, arcs[p.edge] + p.end, p.lo, p.hi)
            for k, p in enumerate(self.pieces.each)
            if chosen is None or k in chosen
        ]
        columns = np.array(rows).T
        return Cells(*columns)

    def _first(self, chosen: set[int] | None) -> Found:
        """Return a first place: where a newcomer without tolerance goes, or any."""
        exact = self.found.best
        if exact.piece >= 0 and (chosen is None or exact.piece in chosen):
            contact, angle = self.pieces.robot_at(exact.piece, exact.c, exact.s, exact.torque)
            piece = exact.piece
        else:
            piece = 0 if chosen is None else min(chosen)
            p = self.pieces.each[piece]
            angle, outline = 0.5 * (p.lo + p.hi), self.problem.swarm.outline
            contact = outline.on_edge(p.edge, 0.5 * (p.start + p.end)).point
        return Found(contact, angle, piece, self.quality_at(contact, angle), math.inf, False)

    def _look(self, cells: Cells, bounds: Array, best: Found) -> Found:
        """Try the middles of the most promising cells; learn the normals at which they fail."""
        s, a = 0.5 * (cells.start + cells.end), 0.5 * (cells.lo + cells.hi)
        for _ in range(CHECKS):
            hopes = self.bounds(Cells(cells.piece, s, s, a, a))
            k = int(np.argmax(hopes))
            if hopes[k] <= best.after.quality or bounds[k] <= best.after.quality:
                break
            x, y = (self._point(s[k : k + 1])[0] + self.problem.swarm.outline.origin).tolist()
            after = self.quality_at((x, y), float(a[k]))
            self.know(np.array([after.normal]))
            if after.quality > best.after.quality:
                best = Found((x, y), float(a[k]), int(cells.piece[k]), after, math.inf, False)
        return best

    def _halves(self, cells: Cells, bounds: Array) -> tuple[Cells, Array]:
        """Halve cells across their longer side, in terms of the wrench."""
        length = self.problem.swarm.characteristic_length
        across = (cells.end - cells.start) / length > cells.hi - cells.lo
        s, a = 0.5 * (cells.start + cells.end), 0.5 * (cells.lo + cells.hi)
        one = cells._replace(end=np.where(across, s, cells.end), hi=np.where(across, cells.hi, a))
        two = cells._replace(
            start=np.where(across, s, cells.start), lo=np.where(across, cells.lo, a)
        )
        halves = Cells(*map(np.concatenate, zip(one, two, strict=True)))
        return halves, np.concatenate([bounds, bounds])

    # -- bounds

    def bounds(self, cells: Cells) -> Array:
        """Return what no place in each cell exceeds (m,)."""
        points, is_common = self._contacts(cells)
        v = self._normals * self.weights
        x, y = points[..., 0, None], points[..., 1, None]
        a, b = v[:, 0] - v[:, 2] * y, v[:, 1] + v[:, 2] * x
        gain = self._over_directions(cells, a, b)
        common = is_common[:, None]
        gain = np.where(common, gain.min(axis=1), gain.max(axis=1))
        height, cap, extent = self._levels.T
        reached = np.minimum(height + np.maximum(gain, 0.0), cap) / extent
        return np.asarray(np.maximum(reached.min(axis=1, initial=np.inf), 0.0))

    def _over_directions(self, cells: Cells, a: Array, b: Array) -> Array:
        """Return the least a cos + b sin over the directions that all places of a cell share.

        The greatest over the cell if they share none.
        """
        lo, hi = cells.hi + self.turns[0], cells.lo + self.turns[1]
        is_common = lo <= hi
        lo, hi = np.where(is_common, lo, cells.lo), np.where(is_common, hi, cells.hi)
        sign = np.where(is_common, -1.0, 1.0)[:, None, None]
        lo, hi = lo[:, None, None], hi[:, None, None]
        a, b = sign * a, sign * b
        ends = np.maximum(a * np.cos(lo) + b * np.sin(lo), a * np.cos(hi) + b * np.sin(hi))
        crest = (np.arctan2(b, a) - lo) % math.tau <= hi - lo
        return np.asarray(sign * np.where(crest, np.hypot(a, b), ends))

    def _contacts(self, cells: Cells) -> tuple[Array, NDArray[np.bool_]]:
        """Return the moment arms (m, c, 2) between which n . b is linear in the contact.

        Of the contacts that all places of a cell share, or the cell's ends if they share none;
        and which of the two.
        """
        first, last = cells.end + self.offsets[0], cells.start + self.offsets[1]
        is_common = first <= last
        first, last = np.where(is_common, first, cells.start), np.where(is_common, last, cells.end)
        start, stop = np.searchsorted(self._laps, [first, last])
        most = int((stop - start).max(initial=0))
        between = np.minimum(start[:, None] + np.arange(most), np.maximum(stop - 1, start)[:, None])
        arcs = self._laps[np.minimum(between, len(self._laps) - 1)]
        arcs = np.where((stop > start)[:, None], arcs, first[:, None])
        return self._point(np.column_stack([first, last, arcs])), is_common

    def _point(self, arcs: Array) -> Array:
        """Return the moment arms (..., 2) at arc lengths, on any lap."""
        wanted = arcs % self._lap
        edge = np.clip(np.searchsorted(self._corner_arcs, wanted, "right") - 1, 0, None)
        edge = np.minimum(edge, len(self._corner_arcs) - 2)
        low, high = self._corner_arcs[edge], self._corner_arcs[edge + 1]
        share = ((wanted - low) / (high - low))[..., None]
        return np.asarray(self._corners[edge] * (1.0 - share) + self._corners[edge + 1] * share)
