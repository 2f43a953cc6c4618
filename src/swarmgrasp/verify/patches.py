"""What patches of contacts prove, and whether they cover the areas that are allowed (T22).

What a newcomer that keeps its force set adds along a normal is convex in its contact, so that a
mixture of such bounds is greatest at a corner of a patch; and a normal that turns on the way from
corner to corner bounds it as along a span.
"""

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from swarmgrasp.verify.allowed import Piece
from swarmgrasp.verify.cover import is_covered
from swarmgrasp.verify.recompute import ANGLE, Array
from swarmgrasp.verify.spans import Kept

if TYPE_CHECKING:
    from swarmgrasp.verify.claims import PatchClaim


class Patches:
    """The patches of an answer.

    Parameters
    ----------
    kept, claims, origin
        As for `Spans`.
    """

    def __init__(self, kept: Kept, claims: "Iterable[PatchClaim]", origin: Array) -> None:
        self._kept, self._origin, self._claims = kept, origin, tuple(claims)

    def bounds(self, pieces: Iterable[Piece], sliver: float) -> tuple[float, float]:
        """Bound the quality with the newcomer on areas, less and more what rounding hides.

        Without end if the patches leave more of an area than rounding.

        Parameters
        ----------
        pieces : iterable of Piece
        sliver : float [m]
        """
        surely = bound = 0.0
        for piece in pieces:
            area, here = np.atleast_2d(piece.p if piece.area is None else piece.area), []
            for claim in self._claims:
                off = np.array([claim.lo - piece.lo, claim.hi - piece.hi])
                turn = math.tau * np.round(off[0] / math.tau)
                if not (np.abs(off - turn) <= ANGLE).all():
                    continue
                here.append(np.array(claim.corners))
                arms = here[-1] - self._origin
                low, high = self._kept.bound(claim, arms, piece.lo, piece.hi)
                surely, bound = max(surely, low), max(bound, high)
            if not is_covered(area, here, sliver):
                return math.inf, math.inf
        return surely, bound
