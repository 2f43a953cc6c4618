"""One placement in the kernels' terms: a swarm, the pieces, and the optimum over them."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import core
from swarmgrasp.placement.certificate import Certificate, Proof
from swarmgrasp.quality.weakest import MARGINAL, Weakest

MOST_NORMALS = 200_000
"""Normals met on the way after which a search stops with the bound it has; some 10 are usual."""

Array = NDArray[np.float64]


class Best(NamedTuple):
    """A robot in a search.

    Attributes
    ----------
    quality : float [N]
        Of the swarm with it.
    c, s, torque : float [1, 1, m]
        Its unit wrench.
    piece : int
        Where it is; -1 when none betters the swarm as it is.
    """

    quality: float
    c: float
    s: float
    torque: float
    piece: int


@dataclass(frozen=True, eq=False)
class Optimum:
    """The best robot over some pieces, and what bounds them.

    Attributes
    ----------
    solved : bool
        Whether the search came as near as asked; the bounds hold in any case.
    best : Best
    upper_bound : float [N]
        What no robot exceeds.
    """

    solved: bool
    best: Best
    upper_bound: float
    _bounds: bytes
    _rows: bytes
    _shares: bytes
    _normals: bytes

    @property
    def bounds(self) -> Array:
        """(k,) [N]: what no robot on each piece exceeds."""
        return np.frombuffer(self._bounds)

    @cached_property
    def certificate(self) -> Certificate:
        """The proofs of all bounds, each distinct one once."""
        normals = np.frombuffer(self._normals).reshape(-1, 3)
        rows = np.frombuffer(self._rows, dtype=np.intc).reshape(-1, 4)
        shares = np.frombuffer(self._shares).reshape(-1, 4)
        proofs = {}
        for row, share in zip(rows, shares, strict=True):
            used = share > 0.0
            key = (tuple(row[used]), tuple(share[used]))
            if key not in proofs:
                proofs[key] = Proof(normals[row[used]], share[used])
        return Certificate(tuple(proofs.values()), self.upper_bound)


class Search:
    """The place of a newcomer, over plain arrays.

    Parameters
    ----------
    generators : (n, 3) [N]
        Of the base swarm, in the metric's coordinates.
    weights : (3,) [N, N, N/m]
        Turn a unit wrench [1, 1, m] of the newcomer into the metric's coordinates.
    rows : (k, 10)
        The pieces; see `Pieces`.
    load : (3,) [N]
        A wrench that is always there, in the metric's coordinates.

    Attributes
    ----------
    base : Weakest
        The base swarm's quality and weakest normal.
    opposite : float [N]
        Its support function at the opposite normal.
    floor, zero : float [N]
        A difference not worth closing, and a quality that counts as 0.
    """

    def __init__(
        self,
        generators: Array,
        weights: Array,
        rows: Array,
        load: tuple[float, float, float] = (0.0, 0.0, 0.0),
    ) -> None:
        x, y, turn = weights.tolist()
        self._core = core.Search(generators, (x, y, turn), rows, load)
        self._note(rows)

    def _note(self, rows: Array) -> None:
        """Read what is known before any search."""
        self.base = Weakest(self._core.quality, self._core.weakest)
        self.opposite = self._core.height(*(-n for n in self.base.normal))
        self.floor, self.zero = core.FLOOR * self._core.size, MARGINAL * self._core.size
        self._many = len(rows)

    def solve(self, gap: float, chosen: Sequence[int] | None = None) -> Optimum:
        """Find the best robot over all pieces, or over the chosen ones.

        Parameters
        ----------
        gap : float
            Largest difference between bound and best, relative to the best.
        chosen : sequence of int, optional
        """
        mask = None
        if chosen is not None:
            wanted = set(chosen)
            mask = bytes(k in wanted for k in range(self._many))
        solved, best, bound, bounds, rows, shares = self._core.solve(gap, mask, MOST_NORMALS)
        normals = self._core.normals()  # kept: joining robots change them
        return Optimum(solved, Best(*best), bound, bounds, rows, shares, normals)

    def break_tie(self, found: Optimum, target: float) -> Best:
        """Of the robots of at least the target quality [N], take the one that lifts the rest most.

        When the weakest facet cannot be raised, or the contact does not matter to it, a whole
        set of robots shares the best quality. Of these the one is taken that makes the soft
        minimum of h over directions greatest, so that the robots to come are not stuck where
        this one could not help (T17).
        """
        return Best(*self._core.break_tie(found.best, target))

    def join(self, c: float, s: float, torque: float, rows: Array) -> None:
        """Let a robot join the base swarm, a unit wrench, and go on with these pieces.

        What is known is kept: the facets of a small swarm are lifted and those across the new
        robot added; the tree of a large one stays, and the directions worth looking at.
        """
        self._core.join(c, s, torque, rows)
        self._note(rows)

    def quality_with(self, c: float, s: float, torque: float) -> Weakest:
        """Compute the exact quality with one robot more, a unit wrench [1, 1, m]."""
        value, normal = self._core.quality_with(c, s, torque)
        return Weakest(value if value > self.zero else 0.0, normal)

    def qualities_with(self, robots: Array) -> Array:
        """Compute the exact quality with each of many new robots, one at a time.

        Parameters
        ----------
        robots : (..., 3) [1, 1, m]
            Unit wrenches (cos, sin, torque) that the pieces allow, or shorter ones.

        Returns
        -------
        (...) [N]
        """
        values = np.frombuffer(self._core.qualities_with(np.ascontiguousarray(robots)))
        return np.where(values > self.zero, values, 0.0).reshape(robots.shape[:-1])
