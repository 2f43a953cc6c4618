"""Random robots of one kind: each anywhere it may be, in any direction it may take there."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement import Problem
from swarmgrasp.placement.problem import check_ray_problem
from swarmgrasp.ranges import is_whole, kind_faults, shown
from swarmgrasp.swarm import Swarm, wrenches
from swarmgrasp.telling import Telling
from swarmgrasp.terms import SI, Terms

Array = NDArray[np.float64]
MOST_ROBOTS = 1000


class Crowd(NamedTuple):
    """Robots, as arrays of any shape.

    Attributes
    ----------
    arms : (..., 2) [m, m]
        Contacts from the outline's origin.
    directions : (...) [rad]
    """

    arms: Array
    directions: Array


class Crowds:
    """Draws robots that are all like the newcomer of a problem.

    Each is anywhere in its zones, as likely here as there along the boundary; bollards, which have
    no length, are chosen if there is nothing else. It may be in the way of others: no spacing is
    kept. The robots of the problem itself are left out.

    Parameters
    ----------
    problem : Problem

    Raises
    ------
    ForceSetUnsupported
        If the newcomer does not push along one ray from a place on the boundary.
    NowhereToAttach
        If there is nowhere to attach.
    """

    def __init__(self, problem: Problem) -> None:
        check_ray_problem(problem, "a study of random robots")
        self.problem, rows = problem, problem.pieces().rows
        self._first, self._along = rows[:, 0:2], rows[:, 2:4] - rows[:, 0:2]
        self._low, self._turn = rows[:, 4], rows[:, 5] - rows[:, 4]
        lengths = np.hypot(*self._along.T)
        self._ends = np.cumsum(lengths if lengths.any() else np.ones(len(rows)))

    def draw(self, draws: np.random.Generator, shape: tuple[int, ...]) -> Crowd:
        """Draw robots."""
        at, share, turn = draws.random((3, *shape))
        piece = np.searchsorted(self._ends, at * self._ends[-1], side="right")
        arms = self._first[piece] + self._along[piece] * share[..., None]
        return Crowd(arms, self._low[piece] + self._turn[piece] * turn)

    def generators(self, crowd: Crowd) -> Array:
        """Return the robots' generators (..., 3) [N] in the metric's coordinates."""
        limit = self.problem.newcomer.limit
        return wrenches(crowd.arms, crowd.directions, limit) * self.problem.swarm.scale

    def swarm(self, draws: np.random.Generator, count: int) -> Swarm:
        """Draw a swarm of so many robots."""
        crowd, like = self.draw(draws, (count,)), self.problem.swarm
        return Swarm.from_arrays(
            like.outline, crowd.arms + like.outline.origin, crowd.directions,
            self.problem.newcomer.limit, characteristic_length=like.characteristic_length,
            force_weights=like.force_weights,
        )  # fmt: skip


@lru_cache(maxsize=4)
def crowds_of(problem: Problem) -> Crowds:
    """Return what draws robots like the newcomer of a problem, made once."""
    return Crowds(problem)


def question_of(problem: Problem) -> Problem:
    """Return a problem without its robots: what studies of random robots are of."""
    swarm = problem.swarm
    empty = Swarm(swarm.outline, [], swarm.characteristic_length, swarm.force_weights)
    return problem.with_swarm(empty)


def crowd_faults(problem: object, fewest: object, most: object) -> list[str]:
    """Return what is wrong with the problem of random robots, and with how many there are."""
    faults = kind_faults(problem, Problem, "Problem(swarm, newcomer)")
    if not (is_whole(fewest) and is_whole(most) and 1 <= fewest <= most <= MOST_ROBOTS):
        faults.append(
            f"the robots are from {shown(fewest)} to {shown(most)}; they should be whole numbers, "
            f"1 <= fewest <= most <= {MOST_ROBOTS}"
        )
    return faults


def like_words(problem: Problem, terms: Terms = SI) -> str:
    """Return what random robots are like, as the rest of a sentence that begins with their number.

    Examples
    --------
    >>> from swarmgrasp import Newcomer, Outline
    >>> square = Swarm(Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)]), [])
    >>> like_words(Problem(square, Newcomer(2000.0, name="Ajax")))
    'random robots like Ajax of 2.0000 kN, anywhere along the outline'
    """
    newcomer, zones = problem.newcomer, problem.zones
    like = f" like {newcomer.name}" if newcomer.name else ""
    where = "along the outline" if zones is None else f"in {len(zones)} zones"
    tell = Telling.of(terms, problem.swarm.outline.extent, [newcomer.limit])
    limit = tell.force.text(newcomer.limit)
    return f"random {terms.several}{like} of {limit}, anywhere {where}"
