"""The place of a newcomer that cannot hit it exactly: the worst of all it may end up in (T14)."""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement.cores import Cells, Cores
from swarmgrasp.placement.kept import kept_robot
from swarmgrasp.placement.pieces import Pieces
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.search import Optimum
from swarmgrasp.placement.spans import Stand
from swarmgrasp.quality.aim import Aim, Work
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm import Robot

Array = NDArray[np.float64]
WORK_PER_CELL = 250.0
"""The kernels' units of work that bounding a cell of places along one normal takes."""
WORK_PER_PLACE = 1e7
"""Units of work that the quality at one place takes at most: some 30 ms."""
BESIDES = 50
"""Work on a cell whatever the number of normals, in normals."""
SMALLEST = 1e-12
"""Width of a cell [rad], or relative to the lap, that only rounding could split."""
BATCH = 96
"""Cells split at a time."""
CHECKS = 8
"""Places whose quality is computed for each batch."""
SAME = 1e-14
"""Distance between unit normals that are one."""


@dataclass(frozen=True, eq=False)
class Found:
    """The best place of a tolerant newcomer.

    Attributes
    ----------
    robot : Robot
        The newcomer that aims at it, without a name.
    piece : int
    after : Weakest
        In the worst case.
    upper_bound : float [N]
        What no place exceeds.
    solved : bool
        Whether the bound is as near as asked for.
    """

    robot: Robot
    piece: int
    after: Weakest
    upper_bound: float = math.inf
    solved: bool = False


class TolerantSearch:
    """Branch and bound over contacts, and directions if it has one that is chosen.

    Wherever in a cell the newcomer aims, it does no more along the normals known than `Cores` say.

    Parameters
    ----------
    problem : Problem
        With a tolerance and the criterion of the worst case.
    pieces : Pieces
    found : Optimum
        The place of a newcomer that would hit it exactly: no tolerant one does better.
    normals : (n, 3)
        Unit normals that its search has met.
    zero : float [N]
        A quality that counts as 0.
    work : Work
        When there is none left, a search stops with the bound it has.
    """

    def __init__(
        self, problem: Problem, pieces: Pieces, found: Optimum[Any], zero: float, work: Work
    ) -> None:
        self.problem, self.pieces, self.found, self.work = problem, pieces, found, work
        self.cores = Cores(problem, pieces)
        self.aim = Aim(problem.swarm, problem.criterion)
        self.zero = zero
        self._normals = np.zeros((0, 3))
        self._levels = np.zeros((0, 3))
        self.know(found.normals_met)

    def know(self, normals: Array) -> None:
        """Add normals (m, 3) to those that bound the cells, but for what is known of them."""
        apart = np.linalg.norm(normals[:, None] - self._normals, axis=2)
        normals = normals[~(apart <= SAME).any(axis=1)]
        levels = self.aim.levels(normals)
        asked = levels[:, 2] > 0.0
        self._normals = np.vstack([self._normals, normals[asked]])
        self._levels = np.vstack([self._levels, levels[asked]])

    def _forget(self, bound: float) -> None:
        """Leave out the normals that say nothing below a bound on all places."""
        height, cap, extent = self._levels.T
        matters = np.minimum(height, cap) < bound * extent
        self._normals, self._levels = self._normals[matters], self._levels[matters]

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
            self._forget(float(bounds.max()))
            is_stuck, known = self._are_points(cells.take(top[:1])).all(), len(self._normals)
            halves, limits = self._halves(cells.take(top), bounds[top])
            below = np.minimum(self.bounds(halves), limits)
            best = self._look(halves, below, best)
            if is_stuck and len(self._normals) == known:
                break  # what only rounding could split is known as well as can be
            cells = Cells(*map(np.concatenate, zip(cells.take(rest), halves, strict=True)))
            bounds = np.concatenate([bounds[rest], below])
            self.work.left -= WORK_PER_CELL * len(below) * (len(self._normals) + BESIDES)
        upper = max(float(bounds.max(initial=0.0)), best.after.quality)
        if chosen is None:
            upper = min(upper, max(self.found.upper_bound, best.after.quality))
        return replace(best, upper_bound=upper, solved=upper <= wanted)

    def _are_points(self, cells: Cells) -> NDArray[np.bool_]:
        """Tell which cells (m,) are as small as rounding."""
        along, across = cells.end - cells.start, cells.hi - cells.lo
        near = SMALLEST * self.problem.swarm.outline.perimeter
        return np.asarray((along <= near) & (across <= SMALLEST))

    def _aiming(
        self, piece: int, contact: tuple[float, float], direction: float, enough: float = 0.0
    ) -> Found:
        """Return the newcomer that aims at a place, and its quality; 0 if it takes too long.

        Below `enough` [N] it is any upper bound.
        """
        newcomer, problem = self.problem.newcomer, self.problem
        if newcomer.keeps:
            lo, hi = self.pieces.rows[piece, 4:6].tolist()
            robot = kept_robot(newcomer, contact, lo, hi)
        else:
            robot = Robot(
                contact, direction, newcomer.limit, tolerance=newcomer.tolerance,
                reverse_limit=newcomer.reverse_limit, body=newcomer.body,
            )  # fmt: skip
        aim = Aim(problem.swarm.with_robot(robot), problem.criterion)
        return Found(robot, piece, self.work.quality(aim, WORK_PER_PLACE, enough))

    def _all(self, chosen: set[int] | None) -> Cells:
        """Return one cell for each piece."""
        arcs, keeps = self.cores.corner_arcs, self.problem.newcomer.keeps
        rows = []
        for k, p in enumerate(self.pieces.each):
            if chosen is None or k in chosen:
                lo, hi = (0.5 * (p.lo + p.hi),) * 2 if keeps else (p.lo, p.hi)
                rows.append((k, arcs[p.edge] + p.start, arcs[p.edge] + p.end, lo, hi))
        return Cells(*np.array(rows).T)

    def _first(self, chosen: set[int] | None) -> Found:
        """Return a first place: where a newcomer without tolerance goes, or any."""
        exact = self.found.best
        if exact.piece >= 0 and (chosen is None or exact.piece in chosen):
            if isinstance(exact, Stand):
                contact, angle = self.pieces.point_at(exact.piece, exact.share), 0.0
            else:
                contact, angle = self.pieces.robot_at(exact.piece, exact.c, exact.s, exact.torque)
            return self._aiming(exact.piece, contact, angle)
        piece = 0 if chosen is None else min(chosen)
        p = self.pieces.each[piece]
        return self._aiming(piece, self.pieces.point_at(piece, 0.5), 0.5 * (p.lo + p.hi))

    def _look(self, cells: Cells, bounds: Array, best: Found) -> Found:
        """Try the middles of the most promising cells; learn the normals at which they fail."""
        s, a = 0.5 * (cells.start + cells.end), 0.5 * (cells.lo + cells.hi)
        middles, known = Cells(cells.piece, s, s, a, a), 0
        hopes = bounds.copy()
        for _ in range(CHECKS):
            hopes = np.minimum(hopes, self.bounds(middles, known))
            known, k = len(self._normals), int(np.argmax(hopes))
            if hopes[k] <= best.after.quality:
                break
            x, y = (self.cores.point(s[k : k + 1])[0] + self.problem.swarm.outline.origin).tolist()
            piece, enough = int(cells.piece[k]), best.after.quality
            found = self._aiming(piece, (x, y), float(a[k]), enough)
            self.know(np.array([found.after.normal]))
            best = found if found.after.quality > best.after.quality else best
            hopes[k] = min(hopes[k], found.after.quality)
        return best

    def _halves(self, cells: Cells, bounds: Array) -> tuple[Cells, Array]:
        """Halve cells across their longer side, in terms of the wrench; but for points."""
        length = self.problem.swarm.characteristic_length
        across = (cells.end - cells.start) / length > cells.hi - cells.lo
        s, a = 0.5 * (cells.start + cells.end), 0.5 * (cells.lo + cells.hi)
        one = cells._replace(end=np.where(across, s, cells.end), hi=np.where(across, cells.hi, a))
        two = cells._replace(
            start=np.where(across, s, cells.start), lo=np.where(across, cells.lo, a)
        ).take(np.flatnonzero(~self._are_points(cells)))
        halves = Cells(*map(np.concatenate, zip(one, two, strict=True)))
        return halves, np.concatenate([bounds, bounds[~self._are_points(cells)]])

    def bounds(self, cells: Cells, since: int = 0) -> Array:
        """Return what no place in each cell exceeds (m,), by the normals known since so many."""
        height, cap, extent = self._levels[since:, :, None].transpose(1, 0, 2)
        gains = self.cores.gains(cells, self._normals[since:]).T
        reached = np.minimum(height + gains, cap) / extent
        return np.asarray(np.maximum(reached.min(axis=0, initial=np.inf), 0.0))
