"""What searches for a newcomer beside robots with force sets share (T22, T23)."""

from collections.abc import Callable, Sequence
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import core
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.search import WORK
from swarmgrasp.quality.aim import Aim, Work
from swarmgrasp.quality.robot_sets import RobotSets
from swarmgrasp.quality.weakest import Weakest

Array = NDArray[np.float64]
Kernel = TypeVar("Kernel", core.Boxes, core.Spans)


class SetSearch(Generic[Kernel]):
    """The place of a newcomer, by the criterion of a problem.

    Parameters
    ----------
    problem : Problem
    rows : (k, 10)
        The pieces; see `Pieces`.
    make : callable
        Returns the kernel's search beside sets.

    Attributes
    ----------
    aim : Aim
    base : Weakest
        The base swarm's quality and weakest normal.
    opposite : float [N]
        Its support function at the opposite normal.
    floor, zero : float [N]
        A difference not worth closing, and a quality that counts as 0.
    work : Work
        What exact qualities by the aim may take besides: as much as the search.
    """

    def __init__(self, problem: Problem, rows: Array, make: Callable[[core.Sets], Kernel]) -> None:
        self.aim = Aim(problem.swarm, problem.criterion, as_sets=True)
        self._unit, self._rows = self.aim.unit, rows
        sets = self.aim.robots
        assert isinstance(sets, RobotSets)
        self._core: Kernel = make(sets.core)
        self.work = Work(WORK)
        value, normal = self._core.base
        self.base = Weakest(value / self._unit, normal)
        self.opposite = float(self.aim.values(-np.array(normal))[0])
        size: float = self._core.size / self._unit
        self.floor, self.zero = core.FLOOR * size, core.MARGINAL * size

    @property
    def left(self) -> float:
        """Units of work; below 0 when it was not enough."""
        return self._core.left

    def _wanted(self, chosen: Sequence[int] | None) -> NDArray[np.bool_]:
        """Tell which pieces (k,) are chosen: all, if none are named."""
        wanted = np.zeros(len(self._rows), dtype=bool)
        wanted[slice(None) if chosen is None else list(chosen)] = True
        return wanted

    def _bounded(self, found: bytes, width: int, bound: int) -> tuple[Array, Array]:
        """Return the kernel's parts (m, width), and what bounds each piece (k,) [N].

        The parts begin with their pieces, and `bound` is the column of what bounds them: never
        below 0, as no quality is.
        """
        parts = np.frombuffer(found).reshape(-1, width).copy()
        parts[:, bound] = np.maximum(parts[:, bound] / self._unit, 0.0)
        bounds = np.zeros(len(self._rows))
        np.maximum.at(bounds, parts[:, 0].astype(int), parts[:, bound])
        return parts, bounds
