"""Placement from a summary: a robot, and what it and any other can reach (T8-T10, T13)."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from swarmgrasp.frozen import Frozen
from swarmgrasp.outline import Stretch
from swarmgrasp.placement.problem import Problem, check_ray_problem
from swarmgrasp.placement.search import Search
from swarmgrasp.plain import Told
from swarmgrasp.summary.beside_sets import least_beside_sets
from swarmgrasp.summary.bounds import least_near, turn_of
from swarmgrasp.summary.ceiling import best_possible
from swarmgrasp.summary.cells import Array
from swarmgrasp.summary.on_lattice import best_on_lattice
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
    check_ray_problem(problem, "placement beside a summary")
    pieces = problem.pieces()
    weights = bare.scale * newcomer.limit
    reach = max(1.0, float(np.abs(pieces.rows[:, :4]).max()))
    spare = EVALUATION * float(weights.sum()) * reach
    chosen = (_beside_sets if support.has_sets else _beside_rays)(support, pieces.rows, weights)
    contact, angle = pieces.robot_at(*chosen.spot)
    name = newcomer.name or "newcomer"
    robot = Robot(contact, angle, newcomer.limit, name, body=newcomer.body)
    wrench = weights * chosen.spot[1:]

    def with_robot(normals: Array) -> Array:
        """Bound h from above with the robot in place."""
        return np.asarray(support.upper(normals) + np.maximum(normals @ wrench, 0.0))

    lower = max(chosen.least - support.margin - spare, 0.0)
    upper, direction = least_near(with_robot, chosen.normal, turn_of(support.side))
    upper = max(upper + spare, lower)
    most = chosen.best_possible(direction) + spare
    place = pieces.each[chosen.spot[0]].place
    return PlacementBounds(robot, place, lower, upper, max(most, lower), direction)


class _Chosen(NamedTuple):
    """A place that a search has found.

    Attributes
    ----------
    spot : tuple
        The piece, and the unit wrench (cos, sin, torque) [1, 1, m].
    least : float [N]
        What the bound from below is at least with it, before rounding.
    normal : (3,)
        Where.
    best_possible : callable
        What no allowed robot exceeds [N], given a direction in which the swarm with it is weak.
    """

    spot: tuple[int, float, float, float]
    least: float
    normal: Array
    best_possible: Callable[[Array], float]


def _beside_rays(support: SupportBounds, rows: Array, weights: Array) -> _Chosen:
    """Find the best place beside the bins' sums and their load."""
    search = Search(support.sums, weights, rows, support.load)
    found = search.solve(GAP)
    best = search.break_tie(found.best, found.best.quality / (1.0 + GAP) - search.floor)
    together = search.quality_with(best.c, best.s, best.torque)
    proofs = found.certificate.proofs
    return _Chosen(
        (best.piece, best.c, best.s, best.torque),
        together.quality,
        np.array(together.normal),
        lambda direction: best_possible(support, rows, weights, proofs, direction),
    )


def _beside_sets(support: SupportBounds, rows: Array, weights: Array) -> _Chosen:
    """Find a good place by the upper bounds along the lattice, which some robots are known on."""
    spot, most = best_on_lattice(support, rows, weights)
    least, normal = least_beside_sets(support, weights * spot[1:])
    return _Chosen(spot, least, normal, lambda _: most)
