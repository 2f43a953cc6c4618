"""Placement from a summary: a robot, and what it and any other can reach (T8-T10, T13)."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from swarmgrasp.frozen import Frozen
from swarmgrasp.outline import Stretch
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.search import Search
from swarmgrasp.plain import Told
from swarmgrasp.summary.bounds import least_near, turn_of
from swarmgrasp.summary.ceiling import best_possible
from swarmgrasp.summary.cells import Array
from swarmgrasp.summary.support_bounds import EVALUATION, SupportBounds
from swarmgrasp.swarm import Newcomer, Robot, Swarm, Zone

GAP = 1e-4
"""Gap of the search over the bins' sums beside their load, far below what a summary leaves open."""


@dataclass(frozen=True, eq=False)
class PlacementBounds(Frozen, Told):
    """Where the newcomer goes, and what is certain about it.

    Attributes
    ----------
    robot : Robot
        The newcomer in contact, at its full limit.
    place : str
        The zone's name, or the edge's.
    lower, upper : float [N]
        The quality with this robot lies between them, for every swarm with this summary.
    best_possible : float [N]
        What no allowed robot exceeds.
    direction : (3,)
        Unit normal, in the metric's coordinates, at which `upper` is attained.
    """

    robot: Robot
    place: str
    lower: float
    upper: float
    best_possible: float
    direction: Array

    @property
    def is_force_closure(self) -> bool:
        """Whether force closure with this robot is certain."""
        return self.lower > 0.0

    @property
    def regret(self) -> float:
        """By how much another robot might be better, at most [N]."""
        return self.best_possible - self.lower


def place_from(
    support: SupportBounds,
    side: int,
    bare: Swarm,
    newcomer: Newcomer,
    zones: Iterable[Zone] | None,
    no_go: Iterable[Stretch],
) -> PlacementBounds:
    """Place a newcomer; see `Summary.place`.

    Parameters
    ----------
    bare : Swarm
        The outline and the metric, without robots.
    """
    problem = Problem(bare, newcomer, zones, no_go)  # type: ignore[arg-type]
    pieces = problem.pieces()
    weights = bare.scale * newcomer.limit
    search = Search(support.sums, weights, pieces.rows, support.load)
    found = search.solve(GAP)
    best = search.break_tie(found.best, found.best.quality / (1.0 + GAP) - search.floor)
    contact, angle = pieces.robot_at(best.piece, best.c, best.s, best.torque)
    robot = Robot(contact, angle, newcomer.limit, newcomer.name or "newcomer")
    together = search.quality_with(best.c, best.s, best.torque)
    wrench = weights * (best.c, best.s, best.torque)
    reach = max(1.0, float(np.abs(pieces.rows[:, :4]).max()))
    spare = EVALUATION * float(weights.sum()) * reach

    def with_robot(normals: Array) -> Array:
        """Bound h from above with the robot in place."""
        return np.asarray(support.upper(normals) + np.maximum(normals @ wrench, 0.0))

    lower = max(together.quality - support.margin - spare, 0.0)
    upper, direction = least_near(with_robot, np.array(together.normal), turn_of(side))
    upper = max(upper + spare, lower)
    proofs = found.certificate.proofs
    most = best_possible(support, pieces.rows, weights, proofs, direction) + spare
    place = pieces.each[best.piece].place
    return PlacementBounds(robot, place, lower, upper, max(most, lower), direction)
