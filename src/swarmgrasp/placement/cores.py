"""What a newcomer that misses its place does for certain, wherever it aims in a cell (T14, T26)."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import core
from swarmgrasp.placement.kept import support
from swarmgrasp.placement.pieces import Pieces, halves_of
from swarmgrasp.placement.problem import Problem
from swarmgrasp.quality.aim import NO_TASK
from swarmgrasp.quality.poses import TOUCH
from swarmgrasp.swarm import Tolerance
from swarmgrasp.swarm.columns import Columns
from swarmgrasp.swarm.force_set import force_sets_of

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


class Cells(NamedTuple):
    """Rectangles of contacts and directions, one per row.

    A newcomer that keeps its force set has one direction on each piece: the middle of its sector.
    """

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


class Way(NamedTuple):
    """A force set that a newcomer has, about its direction turned by so much."""

    limit: float
    """[N]"""
    reverse_limit: float
    """[N]"""
    turn: float
    """[rad]"""


class Cores:
    """What newcomers do at most in cells of places that they may miss.

    Wherever in a cell the newcomer aims, it may end up in those poses that all its places have in
    common: so it does no more than a newcomer somewhere among these, as bad as it can be. Where
    they have none in common it does no more than the best that hits its place.

    Parameters
    ----------
    problem : Problem
    pieces : Pieces
    """

    def __init__(self, problem: Problem, pieces: Pieces) -> None:
        newcomer, outline = problem.newcomer, problem.swarm.outline
        tolerance = newcomer.tolerance or Tolerance()
        self._offsets, self._turns = tolerance.offsets, tolerance.turns
        self._scale, self._origin = problem.swarm.scale, outline.origin
        self._friction, self._keeps = newcomer.friction or 0.0, newcomer.keeps
        ahead, back = problem.certain_limit, newcomer.reverse_limit
        self._ways = [Way(ahead, back, 0.0)]
        if not self._keeps and back > 0.0:  # it does not turn around once its pose is drawn
            self._ways = [Way(ahead, 0.0, 0.0), Way(back, 0.0, math.pi)]
        self._halves = halves_of(pieces.rows[:, 4:6]) * (self._friction == 0.0)
        self._lap = outline.perimeter
        self.corner_arcs = np.append(outline.corner_arc_lengths[: len(outline)], self._lap)
        arms = outline.vertices - self._origin
        self._corners = np.vstack([arms, arms[:1]])
        arcs = self.corner_arcs[:-1]
        self._laps = np.concatenate([arcs - self._lap, arcs, arcs + self._lap])

    def gains(self, cells: Cells, normals: Array) -> Array:
        """Return what no newcomer that aims in a cell adds along normals (k, 3): (m, k) [N]."""
        points, is_common = self._contacts(cells)
        lo, hi, is_drawn = self._directions(cells)
        found = np.zeros((len(lo), len(normals)))
        for way in self._ways:
            for rows, worth in (
                (is_drawn, self._drawn),
                (~is_drawn & is_common & self._keeps, self._adrift),
                (~is_drawn & ~(is_common & self._keeps), self._steered),
            ):
                if rows.any():
                    part = worth(way, points[rows], is_common[rows], lo[rows], hi[rows], normals)
                    found[rows] = np.maximum(found[rows], part)
        return found

    def point(self, arcs: Array) -> Array:
        """Return the moment arms (..., 2) at arc lengths, on any lap."""
        wanted = arcs % self._lap
        edge = np.clip(np.searchsorted(self.corner_arcs, wanted, "right") - 1, 0, None)
        edge = np.minimum(edge, len(self.corner_arcs) - 2)
        low, high = self.corner_arcs[edge], self.corner_arcs[edge + 1]
        share = ((wanted - low) / (high - low))[..., None]
        return np.asarray(self._corners[edge] * (1.0 - share) + self._corners[edge + 1] * share)

    # -- what the places of a cell have in common

    def _directions(self, cells: Cells) -> tuple[Array, Array, Mask]:
        """Return the directions [rad] between which a newcomer's is drawn, and whether it is.

        Otherwise it has, or may choose, all those between.
        """
        first, last = self._turns
        if self._keeps:  # what its sector has in each direction that may be drawn, or what it lacks
            half = self._halves[cells.piece.astype(int)]
            one, other = cells.lo + first + half, cells.lo + last - half
            is_drawn = (half < math.pi) & (half < 0.5 * (last - first))
            whole = half >= math.pi
            lo = np.where(whole, cells.lo - half, np.where(is_drawn, one, other))
            return lo, np.where(whole, cells.lo + half, np.where(is_drawn, other, one)), is_drawn
        lo, hi = cells.hi + first, cells.lo + last
        is_drawn = lo <= hi
        return np.where(is_drawn, lo, cells.lo), np.where(is_drawn, hi, cells.hi), is_drawn

    def _contacts(self, cells: Cells) -> tuple[Array, Mask]:
        """Return the moment arms (m, c, 2), in order, of the boundary that all places share.

        Of the cell's ends if they share none; and which of the two.
        """
        first, last = cells.end + self._offsets[0], cells.start + self._offsets[1]
        is_common = last - first > TOUCH * self._lap
        first, last = np.where(is_common, first, cells.start), np.where(is_common, last, cells.end)
        start, stop = np.searchsorted(self._laps, [first, last])
        most = int((stop - start).max(initial=0))
        between = np.minimum(start[:, None] + np.arange(most), len(self._laps) - 1)
        arcs = np.minimum(self._laps[between], last[:, None])
        return self.point(np.column_stack([first, arcs, last])), is_common

    # -- what is worth how much

    def _drawn(
        self, way: Way, points: Array, is_common: Mask, lo: Array, hi: Array, normals: Array
    ) -> Array:
        """Return what a ray is worth whose direction is drawn.

        Of up to half a turn of directions, one of the ends is the worst or one is worth nothing; of
        more, one is worth nothing anyway.
        """
        px, py = self._levers(points, normals)
        worst = np.where(hi - lo > math.pi, 0.0, math.inf)[:, None]
        for angle in (lo + way.turn, hi + way.turn):
            c, s = np.cos(angle)[:, None, None], np.sin(angle)[:, None, None]
            worst = np.minimum(worst, _over_contacts(px * c + py * s, is_common))
        return way.limit * worst

    def _steered(
        self, way: Way, points: Array, is_common: Mask, lo: Array, hi: Array, normals: Array
    ) -> Array:
        """Return what a sector is worth, or a finger, that is on one of the contacts."""
        middle, half = (0.5 * (lo + hi) + way.turn)[:, None, None], 0.5 * (hi - lo)[:, None, None]
        worths = support(*self._levers(points, normals), middle, half, way[:2], self._friction)
        return _over_contacts(worths, is_common)

    def _adrift(
        self, way: Way, points: Array, is_common: Mask, lo: Array, hi: Array, normals: Array
    ) -> Array:
        """Return what it is worth on the worst of all contacts: it steers once it knows it."""
        del is_common
        count = len(lo)
        zero = np.zeros(count)
        limit, back = np.full(count, way.limit), np.full(count, way.reverse_limit)
        columns = Columns(
            points[:, 0], 0.5 * (lo + hi), limit, zero > 0.0, back, 0.5 * (hi - lo),
            zero + self._friction, zero,
        )  # fmt: skip
        elements, counts = force_sets_of(columns, {}, {})
        robots = np.repeat(np.arange(count), points.shape[1] - 1)[:, None]
        ends = [points[:, :-1].reshape(-1, 2), points[:, 1:].reshape(-1, 2)]
        parts = np.hstack([robots, *ends])[np.abs(ends[1] - ends[0]).max(axis=1) > 0.0]
        x, y, turn = self._scale.tolist()
        sets = core.Sets(
            np.ascontiguousarray(points[:, 0]), elements, counts.astype(float),
            np.arange(count, dtype=float), (x, y, turn), 0, (0.0, 0.0, 0.0), NO_TASK, False,
            np.ascontiguousarray(parts), np.zeros((0, 12)), np.zeros((0, count)),
        )  # fmt: skip
        worths = [np.frombuffer(sets.forces((u, v, w)))[::5] for u, v, w in normals.tolist()]
        return np.array(worths, dtype=float).reshape(len(normals), count).T

    def _levers(self, points: Array, normals: Array) -> tuple[Array, Array]:
        """Return the two parts of p(n) (m, c, k) at moment arms (m, c, 2) (T20)."""
        u, v, turn = (normals * self._scale).T
        return u - turn * points[..., 1, None], v + turn * points[..., 0, None]


def _over_contacts(worths: Array, is_common: Mask) -> Array:
    """Return the least (m, k) of worths (m, c, k) over contacts that are shared, or the greatest.

    Linear or convex in the contact, they are greatest at an end.
    """
    return np.asarray(np.where(is_common[:, None], worths.min(axis=1), worths.max(axis=1)))
