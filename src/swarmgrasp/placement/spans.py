"""The place of a newcomer that keeps all it can exert: only its contact is chosen (T22)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import core
from swarmgrasp.placement.certificate import Certificate, SpanProof
from swarmgrasp.placement.kept import CHECKED, TRIED, kept_robot
from swarmgrasp.placement.pieces import Pieces, halves_of
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.search import WORK, Optimum
from swarmgrasp.placement.set_search import SetSearch
from swarmgrasp.placement.ties import SoftMinimum
from swarmgrasp.swarm import Robot
from swarmgrasp.swarm.columns import Columns
from swarmgrasp.swarm.force_set import force_sets_of

Array = NDArray[np.float64]
PIECE, FROM, TO, BOUND, KIND, TERMS = range(6)
"""Columns of the kernel's spans."""
KINDS: tuple[Literal["chords"], Literal["travelling"]] = ("chords", "travelling")
"""What bounds a span, by the kernel's numbers."""
NEAR = 1e-3
"""Share of a piece within which two stands are one."""


class Stand(NamedTuple):
    """Where a newcomer stands, and the quality [N] with it; -1 for no piece: it betters nothing."""

    quality: float
    piece: int
    share: float


@dataclass(frozen=True, eq=False)
class SpanOptimum(Optimum[Stand]):
    """The best robot that keeps its force set over some pieces, and the spans that bound them.

    Attributes
    ----------
    spans : (m, SPAN)
        See `core.Spans`.
    """

    spans: Array
    _pieces: Pieces

    @cached_property
    def certificate(self) -> Certificate:
        """The proofs of all bounds."""
        return Certificate((), (), tuple(self._proofs()), (), self.upper_bound)

    def _proofs(self) -> Iterator[SpanProof]:
        """Yield the proof of each span."""
        for row in self.spans:
            index = int(row[PIECE])
            piece = self._pieces.each[index]
            start, end = (self._pieces.point_at(index, float(s)) for s in row[FROM : TO + 1])
            terms = row[TERMS:].reshape(2, 4)
            terms = terms[terms[:, 3] > 0.0]
            kind = KINDS[int(row[KIND])]
            yield SpanProof(start, end, piece.lo, piece.hi, kind, terms[:, :3], terms[:, 3])


class SpanSearch(SetSearch[core.Spans]):
    """The place of a newcomer that keeps its force set, by the criterion of a problem.

    Parameters
    ----------
    problem : Problem
    pieces : Pieces
    """

    def __init__(self, problem: Problem, pieces: Pieces) -> None:
        elements, counts = force_sets_of(_columns_on(problem, pieces), {}, {})
        ends = np.ascontiguousarray(pieces.rows[:, :4])
        super().__init__(
            problem,
            pieces.rows,
            lambda sets: core.Spans(sets, ends, elements, counts.astype(float), WORK),
        )
        self._pieces, self._limit = pieces, problem.certain_limit

    def solve(self, gap: float, chosen: Sequence[int] | None = None) -> SpanOptimum:
        """Find the best robot over all pieces, or over the chosen ones.

        Parameters
        ----------
        gap : float
            Largest difference between bound and best, relative to the best.
        chosen : sequence of int, optional
        """
        wanted = self._wanted(chosen)
        solved, (value, piece, share), found = self._core.solve(gap, wanted.tobytes())
        self._spans, bounds = self._bounded(found, core.SPAN, BOUND)
        best = Stand(value / self._unit, piece, share)
        top = float(bounds.max())
        terms = self._spans[:, TERMS:].reshape(-1, 4)
        normals = np.unique(terms[terms[:, 3] > 0.0, :3], axis=0)
        return SpanOptimum(solved, best, top, bounds, normals, self._spans, self._pieces)

    def quality_at(self, piece: int, share: float, enough: float = 0.0) -> float:
        """Return the quality [N] with the newcomer at a share of the way along a row.

        Below `enough` [N] any upper bound will do.
        """
        value, _ = self._core.quality_at(piece, share, enough * self._unit)
        return value / self._unit

    def break_tie(self, best: Stand, target: float) -> Stand:
        """Of the robots of at least the target quality [N], take the one that lifts the rest most.

        After `solve`, which found the best. It lifts most that makes the soft minimum of H over
        directions greatest (T17).
        """
        rivals = self._spans[self._spans[:, BOUND] >= target]
        is_far = np.abs(rivals[:, [FROM, TO]] - best.share).max(axis=1) > NEAR
        rivals = rivals[is_far | (rivals[:, PIECE] != best.piece)]
        steps = max(1, TRIED // max(1, len(rivals)))
        shares = (np.arange(steps) + 0.5) / steps
        along = rivals[:, FROM, None] + (rivals[:, TO] - rivals[:, FROM])[:, None] * shares
        stands = np.column_stack([np.repeat(rivals[:, PIECE], steps), along.ravel()])
        is_found = best.piece >= 0
        if is_found:
            stands = np.vstack([[best.piece, best.share], stands])
        if is_found and len(stands) == 1:
            return best
        for k in np.argsort(self._scores(stands), kind="stable")[: CHECKED + 1].tolist():
            if is_found and k == 0:
                return best
            piece, share = int(stands[k, 0]), float(stands[k, 1])
            value = self.quality_at(piece, share, target)
            if value >= target:
                return Stand(value, piece, share)
        return best if is_found else Stand(best.quality, 0, 0.5)

    def _scores(self, stands: Array) -> Array:
        """Return what the soft minimum makes of stands (c, 2): pieces and shares of the way."""
        least = SoftMinimum(self.aim, self._limit)
        gains = np.frombuffer(self._core.gains(stands, least.normals))
        return least.scores(gains.reshape(len(stands), -1))


def _columns_on(problem: Problem, pieces: Pieces) -> Columns:
    """Return newcomers that keep their force sets, one in the middle of each piece."""
    newcomer, sectors = problem.newcomer, problem.certain_sectors(pieces.rows[:, 4:6])
    count, friction = len(sectors), newcomer.friction or 0.0
    return Columns(
        0.5 * (pieces.rows[:, :2] + pieces.rows[:, 2:4]) + problem.swarm.outline.origin,
        sectors.mean(axis=1),
        np.full(count, problem.certain_limit),
        np.zeros(count, dtype=bool),
        np.full(count, newcomer.reverse_limit),
        halves_of(sectors) * (friction == 0.0),
        np.full(count, friction),
        np.zeros(count),
    )


def robot_on(problem: Problem, pieces: Pieces, index: int, share: float, name: str = "") -> Robot:
    """Return a newcomer that keeps its force set, at a share of the way along a piece."""
    piece = pieces.each[index]
    return kept_robot(problem.newcomer, pieces.point_at(index, share), piece.lo, piece.hi, name)
