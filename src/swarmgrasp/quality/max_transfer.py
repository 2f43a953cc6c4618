"""Max-Transfer quality: the largest ball of wrenches a swarm can make (T1, T2)."""

from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.linear import minimise
from swarmgrasp.quality.weakest import MARGINAL, weakest_of
from swarmgrasp.swarm import Swarm, check_swarm

SEPARATED = 1e-9
"""Cosine by which a direction opposes all robots where force closure is clearly lacking."""
ON_FACET = 1e-9
"""Sine of the angle to a facet within which a generator counts as lying in it."""


class ForceClosure(StrEnum):
    """Whether the swarm can resist a disturbance in every direction."""

    YES = "yes"
    NO = "no"
    MARGINAL = "marginal"
    """On the border: the slightest change of a pose decides."""


@dataclass(frozen=True, eq=False)
class Quality:
    """The exact quality of a swarm, and what limits it.

    Attributes
    ----------
    value : float [N]
        Radius of the largest ball in the wrench set, in the metric.
    direction : (3,)
        Unit normal of the weakest facet, in the metric's coordinates.
    """

    value: float
    direction: NDArray[np.float64]
    _swarm: Swarm = field(repr=False)

    @property
    def weakest_wrench(self) -> NDArray[np.float64]:
        """(3,) [N, N, N m]: the smallest wrench on the boundary, where the ball touches it."""
        return self.value * self.direction / self._swarm.scale

    @cached_property
    def facet_robots(self) -> tuple[int, ...]:
        """Indices of the robots whose generators span that facet."""
        generators, sizes = self._swarm.scaled_generators, self._sizes
        facet = (sizes > 0.0) & (np.abs(generators @ self.direction) <= ON_FACET * sizes)
        return tuple(np.flatnonzero(facet).tolist())

    @cached_property
    def force_closure(self) -> ForceClosure:
        """Whether the swarm can resist a disturbance in every direction."""
        if self.value > 0.0:
            return ForceClosure.YES
        return _without_closure(self._swarm.scaled_generators, self._sizes)

    @property
    def is_force_closure(self) -> bool:
        """Whether force closure is certain."""
        return self.force_closure is ForceClosure.YES

    @cached_property
    def ceiling(self) -> float:
        """Sum of the limits / pi [N], weighted by the metric.

        No robots with these limits and directions exceed it, wherever they are (T3).
        """
        forces = self._swarm.scaled_generators[:, :2]
        return float(np.hypot(forces[:, 0], forces[:, 1]).sum() / np.pi)

    @property
    def efficiency(self) -> float:
        """Quality as a share of its ceiling, within [0, 1]."""
        return self.value / self.ceiling if self.ceiling > 0.0 else 0.0

    @property
    def metric(self) -> str:
        """The metric in words."""
        return self._swarm.metric_sentence

    @property
    def _sizes(self) -> NDArray[np.float64]:
        """(n,) [N]: |b_i|."""
        generators = self._swarm.scaled_generators
        return np.asarray(np.sqrt(np.einsum("ij,ij->i", generators, generators)))


def quality(swarm: Swarm) -> Quality:
    """Compute the Max-Transfer quality of a swarm, exactly.

    The least support function over all facet normals +-(b_j x b_k) (T2): by sweeping all
    planes across a robot for up to 48 robots (T11), then by branch and bound on the sphere of
    directions, at about the cost of sorting the robots by direction (T12).

    Parameters
    ----------
    swarm : Swarm
        Of any size, degenerate or not; below 4 robots the quality is 0.

    Returns
    -------
    Quality

    Raises
    ------
    RobotInvalid
        If it is no `Swarm`.

    Examples
    --------
    Four unit robots pull a square with lever arm 0.4: 2 t / sqrt(1 + 2 t^2).

    >>> from math import pi
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pulls = [((1, -0.4), 0), ((-1, 0.4), pi), ((-0.4, 1), pi / 2), ((0.4, -1), -pi / 2)]
    >>> grasp = Swarm(square, [Robot(c, a) for c, a in pulls], characteristic_length=1.0)
    >>> answer = quality(grasp)
    >>> round(answer.value, 6), str(answer.force_closure), round(answer.efficiency, 3)
    (0.696311, 'yes', 0.547)
    >>> quality(Swarm(square, grasp.robots[:3])).value
    0.0
    """
    check_swarm(swarm)
    value, weakest = weakest_of(swarm.scaled_generators)
    normal = np.array(weakest)
    normal.setflags(write=False)
    return Quality(value, normal, swarm)


def _without_closure(generators: NDArray[np.float64], sizes: NDArray[np.float64]) -> ForceClosure:
    """Tell a clear lack of force closure from a marginal one.

    It is clear with fewer than 4 robots, with generators that do not span the wrench space,
    and where the origin keeps a distance from the convex hull of their directions.
    """
    units = generators[sizes > 0.0] / sizes[sizes > 0.0, None]
    if len(units) < 4 or np.linalg.svd(units, compute_uv=False)[2] <= MARGINAL * len(units):
        return ForceClosure.NO
    # largest s with n . unit_i <= -s for some n in the unit cube
    cost = np.array([0.0, 0.0, 0.0, -1.0])
    matrix = np.column_stack([units, np.ones(len(units))])
    margin = minimise(cost, matrix, rows=(-np.inf, 0.0), columns=(-1.0, 1.0))[3]
    return ForceClosure.NO if margin > SEPARATED else ForceClosure.MARGINAL
