"""The place of a newcomer of one fixed direction beside robots with force sets (T23).

One-way or two-way: by branch and bound over boxes of contacts and directions.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import core
from swarmgrasp.placement.areas import Areas
from swarmgrasp.placement.certificate import BoxProof, Certificate
from swarmgrasp.placement.pieces import Pieces
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.search import WORK, Best, Optimum
from swarmgrasp.placement.set_search import SetSearch
from swarmgrasp.placement.ties import Spot, Tie
from swarmgrasp.swarm.sectors import SAME_ANGLE

Array = NDArray[np.float64]
PIECE, FROM, TO, LO, HI, BOUND, TERMS = range(7)
"""Columns of the kernel's boxes."""
KINDS: tuple[Literal["met"], Literal["demanded"], Literal["travelling"], Literal["flat"]] = (
    "met",
    "demanded",
    "travelling",
    "flat",
)
"""What the terms are, by the kernel's numbers,"""
WITHOUT = (KINDS.index("travelling"), KINDS.index("flat"))
"""and of those that go without some robots."""


@dataclass(frozen=True, eq=False)
class BoxOptimum(Optimum[Best]):
    """The best robot of fixed direction over some pieces, and the boxes that bound them.

    Attributes
    ----------
    boxes : (m, BOX)
        See `core.Boxes`.
    """

    boxes: Array
    _rows: Array
    _origin: Array
    _machines: Mapping[int, tuple[str, ...]]

    @cached_property
    def certificate(self) -> Certificate:
        """The proofs of all bounds."""
        return Certificate((), tuple(self._proofs()), (), (), self.upper_bound)

    def _proofs(self) -> Iterator[BoxProof]:
        """Yield the proof of each box."""
        for row in self.boxes:
            terms = row[TERMS:].reshape(-1, core.TERM)
            terms = terms[terms[:, 4] > 0.0]
            arms = self._rows[int(row[PIECE])]
            ends = row[FROM : TO + 1, None] * (arms[2:4] - arms[:2]) + arms[:2] + self._origin
            (x, y), (to_x, to_y) = ends.tolist()
            yield BoxProof(
                (x, y),
                (to_x, to_y),
                float(row[LO]),
                float(row[HI]),
                tuple(KINDS[int(kind)] for kind in terms[:, 0]),
                terms[:, 1:4],
                terms[:, 4],
                tuple(self._robots_of(term) for term in terms.tolist()),
            )

    def _robots_of(self, term: list[float]) -> tuple[str, ...]:
        """Return the robots that a term goes without."""
        if int(term[0]) not in WITHOUT:
            return ()
        return tuple(name for m in term[5:] if m >= 0.0 for name in self._machines[int(m)])


class BoxSearch(SetSearch[core.Boxes]):
    """The place of a newcomer of fixed direction, by the criterion of a problem.

    Parameters
    ----------
    problem : Problem
    pieces : Pieces or Areas
    """

    def __init__(self, problem: Problem, pieces: Pieces | Areas) -> None:
        limits = problem.certain_limit, problem.newcomer.reverse_limit
        super().__init__(
            problem, pieces.rows, lambda sets: core.Boxes(sets, pieces.rows, *limits, WORK)
        )
        self._limits, self._origin = limits, problem.swarm.outline.origin
        self._machines: dict[int, tuple[str, ...]] = {}
        if problem.criterion.losing:
            swarm = problem.swarm
            for i, machine in enumerate(swarm.machines.tolist()):
                self._machines[machine] = (*self._machines.get(machine, ()), swarm.names[i])

    def solve(
        self, gap: float, chosen: Sequence[int] | None = None, asks: int = core.ASKS
    ) -> BoxOptimum:
        """Find the best robot over all pieces, or over the chosen ones.

        Parameters
        ----------
        gap : float
            Largest difference between bound and best, relative to the best.
        chosen : sequence of int, optional
        asks : int
            Exact qualities after which it stops with the bound it has.
        """
        wanted = self._wanted(chosen)
        for one, other in self._twins():
            if wanted[one]:
                wanted[other] = False
        solved, (value, piece, share, angle), found = self._core.solve(gap, wanted.tobytes(), asks)
        boxes, bounds = self._bounded(found, core.BOX, BOUND)
        for one, other in self._twins():
            if wanted[one]:
                bounds[other] = bounds[one]
        self._boxes, self._spot = boxes, Spot(piece, share, angle)
        best = Best(self.base.quality, 0.0, 0.0, 0.0, -1)
        if piece >= 0:
            best = Best(value / self._unit, *self._wrench(self._spot), piece)
        return BoxOptimum(
            solved,
            best,
            float(bounds.max()),
            bounds,
            self._normals(),
            boxes,
            self._rows,
            self._origin,
            self._machines,
        )

    def _twins(self) -> list[tuple[int, int]]:
        """Return pieces of the same robots: pushing one way is pulling the other."""
        if self._limits[0] != self._limits[1]:
            return []
        seen: dict[tuple[float, ...], list[int]] = {}
        twins = []
        for k, row in enumerate(self._rows.tolist()):
            x, y, to_x, to_y, lo, hi = row[:6]
            others = seen.get((to_x, to_y, x, y), ())
            twins += [(j, k) for j in others if self._is_half_turn(j, lo, hi)][:1]
            seen.setdefault((x, y, to_x, to_y), []).append(k)
        return twins

    def _is_half_turn(self, piece: int, lo: float, hi: float) -> bool:
        """Tell whether a sector [rad] is that of a piece, turned around."""
        turns = np.array([lo, hi]) - self._rows[piece, 4:6] - math.pi
        return bool((np.abs(np.remainder(turns + 1.0, math.tau) - 1.0) <= SAME_ANGLE).all())

    def _wrench(self, spot: Spot) -> tuple[float, float, float]:
        """Return the unit wrench [1, 1, m] of a robot."""
        row, share = self._rows[spot.piece], spot.share
        x, y = (row[:2] * (1.0 - share) + row[2:4] * share).tolist()
        c, s = math.cos(spot.direction), math.sin(spot.direction)
        return c, s, x * s - y * c

    def break_tie(self, best: Best, target: float) -> Best:
        """Of the robots of at least the target quality [N], take the one that lifts the rest most.

        After `solve`, which found the best.
        """
        rivals = self._boxes[self._boxes[:, BOUND] >= target]
        tie = Tie(self.aim, self._limits, self._rows, self._normals(), target)
        start = self._spot if best.piece >= 0 else None
        spot = tie.best(rivals[:, PIECE : HI + 1], start, self.qualities_at)
        if spot is None:  # nothing helps, and nothing was found that does no harm: anywhere
            lo, hi = self._rows[0, 4:6].tolist()
            spot = Spot(0, 0.5, 0.5 * (lo + hi))
        if spot is start:
            return best
        (value,) = self.qualities_at(tie.robots(np.array([spot]))).tolist()
        return Best(value, *self._wrench(spot), spot.piece)

    def _normals(self) -> Array:
        """Return the unit normals met so far (n, 3)."""
        return np.frombuffer(self._core.normals()).reshape(-1, 3)

    def qualities_at(self, robots: Array) -> Array:
        """Return the quality (c,) [N] with each of robots (c, 3): moment arms and directions."""
        found = np.frombuffer(self._core.qualities_at(np.ascontiguousarray(robots)))
        return found.reshape(-1, 4)[:, 0] / self._unit
