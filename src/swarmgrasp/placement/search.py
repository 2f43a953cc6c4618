"""One placement in the kernels' terms: a swarm, the pieces, and the optimum over them."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.frozen import Frozen
from swarmgrasp.kernels import core
from swarmgrasp.placement.certificate import Certificate, Proof
from swarmgrasp.placement.problem import Problem
from swarmgrasp.quality.aim import Aim, Work
from swarmgrasp.quality.weakest import MARGINAL, Weakest

Array = NDArray[np.float64]
WORK = core.WORK
"""Units of work after which a search stops with the bound it has: a second or two."""


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


Found = TypeVar("Found")


@dataclass(frozen=True, eq=False)
class Optimum(Frozen, ABC, Generic[Found]):
    """The best robot over some pieces, and what bounds them.

    Attributes
    ----------
    solved : bool
        Whether the search came as near as asked; the bounds hold in any case.
    best
        Where it is, with its quality.
    upper_bound : float [N]
        What no robot exceeds.
    bounds : (k,) [N]
        What no robot on each piece exceeds, of those looked at.
    normals_met : (n, 3)
        Unit normals that the search has met, or of them those that bound the pieces.
    """

    solved: bool
    best: Found
    upper_bound: float
    bounds: Array
    normals_met: Array

    @property
    @abstractmethod
    def certificate(self) -> Certificate:
        """The proofs of all bounds."""


@dataclass(frozen=True, eq=False)
class RayOptimum(Optimum[Best]):
    """The best ray beside rays."""

    _rows: bytes
    _shares: bytes

    @cached_property
    def certificate(self) -> Certificate:
        """The proofs of all bounds, each distinct one once."""
        normals = self.normals_met
        rows = np.frombuffer(self._rows, dtype=np.intc).reshape(-1, 4)
        shares = np.frombuffer(self._shares).reshape(-1, 4)
        proofs = {}
        for row, share in zip(rows, shares, strict=True):
            used = share > 0.0
            key = (tuple(row[used]), tuple(share[used]))
            if key not in proofs:
                proofs[key] = Proof(normals[row[used]], share[used])
        return Certificate(tuple(proofs.values()), (), (), (), self.upper_bound)


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
    aim : Aim, optional
        What is asked of the base swarm, other than its nominal quality; it knows the load.
        Qualities are then in its unit, and no robot can join.

    Attributes
    ----------
    aim : Aim or None
        What is asked other than the nominal quality.
    base : Weakest
        The base swarm's quality and weakest normal.
    opposite : float [N]
        Its support function at the opposite normal.
    floor, zero : float [N]
        A difference not worth closing, and a quality that counts as 0.
    work : Work
        What exact qualities by the aim may take besides: as much as the search.
    """

    def __init__(
        self,
        generators: Array,
        weights: Array,
        rows: Array,
        load: tuple[float, float, float] = (0.0, 0.0, 0.0),
        aim: Aim | None = None,
    ) -> None:
        x, y, turn = weights.tolist()
        self.aim, self._unit = aim, 1.0 if aim is None else aim.unit
        criterion = None if aim is None else aim.core
        self._core = core.Search(generators, (x, y, turn), rows, load, criterion, WORK)
        self.work = Work(WORK)
        self._note(rows)

    def _note(self, rows: Array) -> None:
        """Read what is known before any search."""
        size = self._core.size / self._unit
        self.base = Weakest(self._core.quality / self._unit, self._core.weakest)
        opposite = -np.array(self.base.normal)
        self.opposite = self._core.height(*opposite.tolist())
        if self.aim is not None:
            self.opposite = float(self.aim.values(opposite)[0])
        self.floor, self.zero = core.FLOOR * size, MARGINAL * size
        self._many = len(rows)

    @property
    def left(self) -> float:
        """Units of work; below 0 when it was not enough."""
        return self._core.left

    def solve(self, gap: float, chosen: Sequence[int] | None = None) -> RayOptimum:
        """Find the best robot over all pieces, or over the chosen ones.

        Parameters
        ----------
        gap : float
            Largest difference between bound and best, relative to the best.
        chosen : sequence of int, optional
        """
        mask = None
        if chosen is not None:
            wanted = np.zeros(self._many, dtype=bool)
            wanted[list(chosen)] = True
            mask = wanted.tobytes()
        solved, best, bound, bounds, rows, shares = self._core.solve(gap, mask)
        normals = np.frombuffer(self._core.normals()).reshape(-1, 3)  # they change as robots join
        unit = self._unit
        found = Best(best[0] / unit, *best[1:])
        each = np.frombuffer(bounds) / unit
        return RayOptimum(solved, found, bound / unit, each, normals, rows, shares)

    def break_tie(self, best: Best, target: float) -> Best:
        """Of the robots of at least the target quality [N], take the one that lifts the rest most.

        After `solve`, which found the best.

        When the weakest facet cannot be raised, or the contact does not matter to it, a whole
        set of robots shares the best quality. Of these the one is taken that makes the soft
        minimum of h over directions greatest, so that the robots to come are not stuck where
        this one could not help (T17).
        """
        unit = self._unit
        tied = self._core.break_tie((best[0] * unit, *best[1:]), target * unit)
        return Best(tied[0] / unit, *tied[1:])

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
        value /= self._unit
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
        found = self._core.qualities_with(np.ascontiguousarray(robots))
        values = np.frombuffer(found) / self._unit
        return np.where(values > self.zero, values, 0.0).reshape(robots.shape[:-1])


def search_for(problem: Problem, rows: Array) -> Search:
    """Return the search of a problem's newcomer over these pieces, where all push along rays."""
    swarm, aim = problem.swarm, None
    if not problem.criterion.is_nominal:
        aim = Aim(swarm, problem.criterion)
    known = swarm.scaled_generators if aim is None else aim.known
    return Search(known, swarm.scale * problem.certain_limit, rows, aim=aim)
