"""Certified bounds on the quality of every swarm with a given summary."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Told
from swarmgrasp.quality.weakest import weakest_of
from swarmgrasp.summary.beside_sets import least_beside_sets
from swarmgrasp.summary.cells import Array
from swarmgrasp.summary.support_bounds import SupportBounds

AROUND = 8
"""Directions looked at around the best one so far."""
HALVINGS = 8
"""How often they come nearer."""
MOST_MOVES = 40
"""Steps of the search for the least upper bound, at most."""


@dataclass(frozen=True, eq=False)
class Bounds(Frozen, Told):
    """What is certain about the quality of a swarm of which only a summary is known.

    Attributes
    ----------
    lower, upper : float [N]
        lower <= quality <= upper, for every swarm with this summary.
    direction : (3,)
        Unit normal, in the metric's coordinates, at which the upper bound is attained: near
        it the swarm is weakest.
    metric : str
        The metric in words.
    """

    lower: float
    upper: float
    direction: Array
    metric: str

    @property
    def is_force_closure(self) -> bool:
        """Whether force closure is certain."""
        return self.lower > 0.0

    @property
    def width(self) -> float:
        """Upper bound less lower bound [N]."""
        return self.upper - self.lower


def quality_bounds(support: SupportBounds) -> tuple[float, float, Array]:
    """Bound the quality: returns lower and upper [N], and the direction of the latter (3,)."""
    if support.has_sets:
        least, weakest = least_beside_sets(support, np.zeros(3))
    else:
        least, normal = weakest_of(support.sums, support.load)
        weakest = np.array(normal)
    lower = max(least - support.margin, 0.0)
    upper, direction = least_near(support.upper, weakest, turn_of(support.side))
    return lower, max(upper, lower), direction


def turn_of(side: int) -> float:
    """Return the angle [rad] a cell spans, at most."""
    return 0.5 * math.pi / side


def least_near(heights: Callable[[Array], Array], start: Array, step: float) -> tuple[float, Array]:
    """Walk downhill over the directions.

    Parameters
    ----------
    heights : callable
        Of unit normals (k, 3), to (k,).
    start : (3,)
        A unit normal.
    step : float [rad]
        Length of the first steps.

    Returns
    -------
    least : float
    direction : (3,)
        Where it was found, a unit normal.

    Examples
    --------
    >>> least, direction = least_near(lambda n: n[:, 0], np.array([-0.6, 0.8, 0.0]), 0.5)
    >>> round(least, 2)
    -1.0
    """
    best, least = np.array(start), float(heights(start[None])[0])
    shortest = step * 0.5**HALVINGS
    turns = 2.0 * math.pi * np.arange(AROUND) / AROUND
    circle = np.column_stack([np.cos(turns), np.sin(turns)])
    for _ in range(MOST_MOVES):
        aside = np.cross(best, np.eye(3)[np.abs(best).argmin()])
        aside /= np.linalg.norm(aside)
        tried = best + step * circle @ np.array([aside, np.cross(best, aside)])
        tried /= np.linalg.norm(tried, axis=1)[:, None]
        found = heights(tried)
        k = int(found.argmin())
        if found[k] < least:
            least, best = float(found[k]), tried[k]
            continue
        step *= 0.5
        if step < shortest:
            break
    return least, best
