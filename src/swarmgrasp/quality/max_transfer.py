"""Max-Transfer quality: the largest ball of wrenches a swarm can make (T1, T2)."""

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.linear import minimise
from swarmgrasp.quality.weakest import MARGINAL, weakest_of
from swarmgrasp.swarm import Swarm

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
    weakest_wrench : (3,) [N, N, N m]
        The smallest wrench on the boundary: where the ball touches the facet.
    facet_robots : tuple of int
        Indices of the robots whose generators span that facet.
    force_closure : ForceClosure
    ceiling : float [N]
        Sum of the limits / pi, weighted by the metric: no robots with these limits and
        directions exceed it, wherever they are (T3).
    metric : str
        The metric in words.
    """

    value: float
    direction: NDArray[np.float64]
    weakest_wrench: NDArray[np.float64]
    facet_robots: tuple[int, ...]
    force_closure: ForceClosure
    ceiling: float
    metric: str

    @property
    def is_force_closure(self) -> bool:
        """Whether force closure is certain."""
        return self.force_closure is ForceClosure.YES

    @property
    def efficiency(self) -> float:
        """Quality as a share of its ceiling, within [0, 1]."""
        return self.value / self.ceiling if self.ceiling > 0.0 else 0.0


def quality(swarm: Swarm) -> Quality:
    """Compute the Max-Transfer quality of a swarm, exactly.

    The least support function over all facet normals +-(b_j x b_k) (T2): in O(n^2 log n) by
    sweeping for up to 80 robots, then by branch and bound, at the cost of reading them (T12).

    Parameters
    ----------
    swarm : Swarm
        Of any size, degenerate or not; below 4 robots the quality is 0.

    Returns
    -------
    Quality

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
    generators = swarm.scaled_generators
    sizes = np.linalg.norm(generators, axis=1)
    value, weakest = weakest_of(generators)
    normal = np.array(weakest)
    normal.setflags(write=False)
    wrench = value * normal / swarm.scale
    wrench.setflags(write=False)
    facet = np.flatnonzero((sizes > 0.0) & (np.abs(generators @ normal) <= ON_FACET * sizes))
    return Quality(
        value=value,
        direction=normal,
        weakest_wrench=wrench,
        facet_robots=tuple(int(i) for i in facet),
        force_closure=ForceClosure.YES if value > 0.0 else _without_closure(generators, sizes),
        ceiling=float(np.linalg.norm(generators[:, :2], axis=1).sum() / np.pi),
        metric=swarm.metric_sentence,
    )


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
