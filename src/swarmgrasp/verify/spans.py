"""What spans of contacts prove, and whether they cover what is allowed (T22).

A newcomer that keeps its force set adds sigma(p_n(c)) along a normal n at the contact c, a convex
function of c on a straight span. If it reaches the quality t there, then t D(n) <= H(n) +
sigma(p_n(c)) for every n, so that any mixture of such bounds is greatest at an end of the span.

A normal that turns on the way says more. Take unit normals a and b whose torques have one sign,
scaled to one torque: on the way from start to end n = (1 - l) a + l b has that torque too, and
p_n(c) is linear in l. With h and sigma convex, t |n| is at most the same mixture of what a leaves
at the start and b at the end, and |n| is at least its part along the bisector of a and b. So t is
at most the greater of the two for unit normals, divided by the cosine of half the angle between.
"""

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from swarmgrasp.verify.allowed import Piece
from swarmgrasp.verify.judge import Judge
from swarmgrasp.verify.recompute import ANGLE, Array, units_of
from swarmgrasp.verify.team import Forces, Team, kept_arcs

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import NewcomerClaim, SpanClaim


class Spans:
    """The spans of an answer.

    Parameters
    ----------
    judge : Judge
    team : Team
        The robots already there.
    claims : iterable of SpanClaim
    newcomer : NewcomerClaim
    limit : float [N]
        Of the newcomer, for certain.
    origin : (2,) [m, m]
        Of moments.
    rounding : float [N]
        By which H may be off.
    """

    def __init__(
        self, judge: Judge, team: Team, claims: "Iterable[SpanClaim]", newcomer: "NewcomerClaim",
        limit: float, origin: Array, rounding: float,
    ) -> None:  # fmt: skip
        self._judge, self._team, self._newcomer = judge, team, newcomer
        self._limit, self._origin, self._rounding = limit, origin, rounding
        claims = tuple(claims)
        self.ends = np.array([(span.start, span.end) for span in claims]).reshape(-1, 2, 2)
        self.sectors = np.array([(span.lo, span.hi) for span in claims]).reshape(-1, 2)
        units = [units_of(span.normals) for span in claims]
        known = [rows for rows in units if rows is not None]
        rows = np.concatenate(known) if known else np.zeros((0, 3))
        levels = np.column_stack(judge.held(team, rows)) if len(rows) else np.zeros((0, 3))
        bounds, first = [], 0
        for span, own in zip(claims, units, strict=True):
            if own is None:
                bounds.append((math.inf, math.inf))
                continue
            bounds.append(self._bound(span, own, levels[first : first + len(own)]))
            first += len(own)
        self.surely, self.bound = np.array(bounds).reshape(-1, 2).T

    def _bound(self, span: "SpanClaim", normals: Array, levels: Array) -> tuple[float, float]:
        """Bound the quality with the newcomer on a span, from below and from above."""
        weights, (height, cap, extent) = np.array(span.weights), levels.T
        if len(weights) != len(normals) or not (weights > 0.0).all() or span.hi < span.lo:
            return math.inf, math.inf
        arcs = kept_arcs(self._newcomer, self._limit, span.lo, span.hi)
        gains = np.array(
            [
                Forces(np.array(end) - self._origin, arcs).along(normals * self._judge.scale)
                for end in (span.start, span.end)
            ]
        )
        least = float(extent.min())
        if least == 0.0:  # it bounds nothing, unless a load is not held
            unheld = (height + gains).max(axis=0) < -self._rounding
            found = 0.0 if bool((unheld & (extent == 0.0)).any()) else math.inf
            return found, found
        values = (height + gains) / extent
        if span.kind == "travelling":
            found = self._travelling(normals, values)
        else:
            found = float((values @ (weights / weights.sum())).max())
        found = min(max(found, 0.0), max(float((cap / extent).min()), 0.0))
        hidden = self._rounding / least
        return found - hidden, found + hidden

    def _travelling(self, normals: Array, values: Array) -> float:
        """Bound it by a normal that turns from the first to the second on the way."""
        judge = self._judge
        if len(normals) != 2 or not judge.is_ball or not judge.is_convex(self._team):
            return math.inf
        a, b = normals
        cosine = math.sqrt(max(0.5 * (1.0 + float(a @ b)), 0.0))
        if not a[2] * b[2] > 0.0 or cosine == 0.0:
            return math.inf
        return max(float(values[0, 0]), float(values[1, 1]), 0.0) / cosine

    def cover(self, piece: Piece, sliver: float) -> bool:
        """Tell whether spans of its sector cover a piece, but for what is no more than rounding.

        Parameters
        ----------
        piece : Piece
        sliver : float [m]
        """
        step = piece.q - piece.p
        length = float(np.linalg.norm(step))
        away = self.ends - piece.p
        if length > 0.0:
            across = np.abs(away[..., 0] * step[1] - away[..., 1] * step[0]) / length
            shares, near = np.sort((away @ step) / length**2, axis=1), sliver / length
        else:
            across, near = np.linalg.norm(away, axis=2), 0.0
            shares = np.tile([0.0, 1.0], (len(away), 1))
        off = self.sectors - [piece.lo, piece.hi]
        turn = math.tau * np.round(off[:, :1] / math.tau)
        is_here = (across <= sliver).all(axis=1) & (np.abs(off - turn) <= ANGLE).all(axis=1)
        reached = 0.0
        for first, last in shares[is_here][np.argsort(shares[is_here][:, 0])]:
            if first > reached + near:
                break
            reached = max(reached, last)
        return bool(reached >= 1.0 - near)
