"""What spans of contacts prove, and whether they cover what is allowed (T22).

A newcomer that keeps its force set adds sigma(p_n(c)) along a normal n at the contact c, a convex
function of c on a straight span. If it reaches the quality t there, then t D(n) <= H(n) +
sigma(p_n(c)) for every n, so that any mixture of such bounds is greatest at an end of the span.

A normal that turns on the way says more. Take unit normals a and b whose torques have one sign,
scaled to one torque: on the way from start to end n = (1 - l) a + l b has that torque too, and
p_n(c) is linear in l. With h and sigma convex, t D(n) is at most the same mixture of what a leaves
at the start and b at the end, and D(n) is at least d . n for any wrench d of the task. So t is at
most the greater of the two for unit normals, each divided by its d . n, if these are positive; of
the unit ball d is the bisector, and both are the cosine of half the angle between.

What a span is said to be is rounded: it is looked at on the edge and for the sector that the check
has found itself.
"""

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from swarmgrasp.verify.allowed import Piece
from swarmgrasp.verify.judge import UNASKED, Judge
from swarmgrasp.verify.recompute import ANGLE, Array, units_of
from swarmgrasp.verify.team import Forces, Team, kept_arcs

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import NewcomerClaim, PatchClaim, SpanClaim


class Kept:
    """What directions prove of a newcomer that keeps its force set.

    Parameters
    ----------
    judge : Judge
    team : Team
        The robots already there.
    newcomer : NewcomerClaim
    limit : float [N]
        Of the newcomer, for certain.
    drawn : tuple of float [rad, rad]
        Offsets between which its direction is drawn.
    rounding : float [N]
        By which H may be off.
    """

    def __init__(
        self, judge: Judge, team: Team, newcomer: "NewcomerClaim", limit: float,
        drawn: tuple[float, float], rounding: float,
    ) -> None:  # fmt: skip
        self._judge, self._team, self._newcomer = judge, team, newcomer
        self._limit, self._drawn, self._rounding = limit, drawn, rounding

    def bound(
        self, claim: "SpanClaim | PatchClaim", arms: Array, lo: float, hi: float
    ) -> tuple[float, float]:
        """Bound the quality with the newcomer in the hull of moment arms (k, 2) [m].

        Less and more what rounding hides.
        """
        normals, weights = units_of(claim.normals), np.array(claim.weights)
        if normals is None or len(weights) != len(normals) or not (weights > 0.0).all():
            return math.inf, math.inf
        height, cap, extent = self._judge.held(self._team, normals)
        arcs = kept_arcs(self._newcomer, self._limit, *_certain_sector(lo, hi, self._drawn))
        gains = np.array(
            [Forces(arm[None], arcs).along(normals * self._judge.scale) for arm in arms]
        )
        least = float(extent.min())
        if least == 0.0:  # it bounds nothing, unless a load is not held
            unheld = (height + gains).max(axis=0) < -self._rounding
            found = 0.0 if bool((unheld & (extent == 0.0)).any()) else math.inf
            return found, found
        values = (height + gains) / extent
        if claim.kind == "travelling":
            least, found = self._travelling(normals, values * extent)
        else:
            weights = weights / weights.max()
            found = float((values @ (weights / weights.sum())).max())
        found = min(max(found, 0.0), max(float((cap / extent).min()), 0.0))
        hidden = self._rounding / least
        return found - hidden, found + hidden

    def _travelling(self, normals: Array, sides: Array) -> tuple[float, float]:
        """Bound it by a normal that turns on the way from each corner to the others.

        The right sides (k, k) are those at the corners, a row each. Returns the least of what
        divides them, and the bound.
        """
        judge = self._judge
        if len(normals) != len(sides) or not judge.is_convex(self._team):
            return 1.0, math.inf
        along = normals @ judge.farthest(normals.sum(axis=0)[None])[0]
        turns = normals[:, 2]
        if not ((turns > 0.0).all() or (turns < 0.0).all()) or not along.min() > UNASKED:
            return 1.0, math.inf
        along = along * judge.unit
        return float(along.min()), float((np.maximum(np.diag(sides), 0.0) / along).max())


class Spans:
    """The spans of an answer.

    Parameters
    ----------
    kept : Kept
    claims : iterable of SpanClaim
    origin : (2,) [m, m]
        Of moments.
    """

    def __init__(self, kept: Kept, claims: "Iterable[SpanClaim]", origin: Array) -> None:
        self._kept, self._origin, self._claims = kept, origin, tuple(claims)
        self.ends = np.array([(span.start, span.end) for span in self._claims]).reshape(-1, 2, 2)
        self.sectors = np.array([(span.lo, span.hi) for span in self._claims]).reshape(-1, 2)

    def bounds(self, pieces: Iterable[Piece], sliver: float) -> tuple[float, float]:
        """Bound the quality with the newcomer on pieces, less and more what rounding hides.

        Without end if the spans leave more of a piece than rounding.

        Parameters
        ----------
        pieces : iterable of Piece
        sliver : float [m]
        """
        surely = bound = 0.0
        for piece in pieces:
            shares = self._shares(piece, sliver)
            if not _is_covered([ends for _, ends in shares], sliver / max(_length(piece), sliver)):
                return math.inf, math.inf
            for k, ends in shares:
                arms = piece.p + ends[:, None] * (piece.q - piece.p) - self._origin
                low, high = self._kept.bound(self._claims[k], arms, piece.lo, piece.hi)
                surely, bound = max(surely, low), max(bound, high)
        return surely, bound

    def _shares(self, piece: Piece, sliver: float) -> list[tuple[int, Array]]:
        """Return the spans beside a piece for its sector, and the shares of it at their ends."""
        step, length = piece.q - piece.p, _length(piece)
        away = self.ends - piece.p
        if length > 0.0:
            across = np.abs(away[..., 0] * step[1] - away[..., 1] * step[0]) / length
            shares = (away @ step) / length**2
        else:
            across = np.linalg.norm(away, axis=2)
            shares = np.tile([0.0, 1.0], (len(away), 1))
        off = self.sectors - [piece.lo, piece.hi]
        turn = math.tau * np.round(off[:, :1] / math.tau)
        is_here = (across <= sliver).all(axis=1) & (np.abs(off - turn) <= ANGLE).all(axis=1)
        return [(int(k), shares[k]) for k in np.flatnonzero(is_here)]


def _certain_sector(lo: float, hi: float, drawn: tuple[float, float]) -> tuple[float, float]:
    """Return what all sectors [lo, hi] share that are turned by as much as is drawn [rad].

    Their middle if they share nothing: a ray of uncertain direction has no more than that has.
    """
    first, last = drawn
    if hi - lo >= math.tau - ANGLE:
        return lo, hi
    lo, hi = lo + last, hi + first
    return (lo, hi) if lo <= hi else (0.5 * (lo + hi),) * 2


def _length(piece: Piece) -> float:
    """Return the length [m] of a piece."""
    return float(np.linalg.norm(piece.q - piece.p))


def _is_covered(shares: list[Array], near: float) -> bool:
    """Tell whether intervals cover [0, 1], but for what is no more than rounding."""
    reached = 0.0
    for first, last in sorted(sorted(ends.tolist()) for ends in shares):
        if first > reached + near:
            break
        reached = max(reached, last)
    return reached >= 1.0 - near
