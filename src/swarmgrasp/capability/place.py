"""The place of a newcomer that is best for the least wind held over all bearings."""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.capability.asked import Array, asked_of
from swarmgrasp.capability.winds import least_wind
from swarmgrasp.environment import Environment
from swarmgrasp.errors import ProblemInvalid, refuse
from swarmgrasp.frozen import Frozen
from swarmgrasp.placement import Placement, Placements, Problem, place
from swarmgrasp.placement.problem import problem_faults
from swarmgrasp.plain import Answer
from swarmgrasp.quality import Polytope
from swarmgrasp.swarm import Swarm

FIRST = 1.0
"""The wind [m/s] tried first where the robots hold none without the newcomer."""
MOST_ROUNDS = 30
"""Winds for which a place is sought."""
SAME = 1e-7
"""Relative difference of two winds that is none."""


@dataclass(frozen=True, eq=False)
class CapabilityPlacement(Frozen, Answer):
    """Where a newcomer goes for the least wind held to be largest.

    As plain data it is its `placement`, which `verify` checks like any other.

    Attributes
    ----------
    placement : Placement
        Its criterion's task holds the loads of `tried` from all bearings, so that its quality is by
        how many times they could grow: 1 or more is held, and no allowed place has more than its
        upper bound. Beside a load that is the same from all bearings the task is of the winds
        alone, and quality is the square of a wind over that of `tried`.
    environment : Environment
    bearings : (m,) [rad]
        Where the wind comes from, clockwise from the bow.
    tried : float [m/s]
        The wind whose loads the task holds.
    before, after : float [m/s]
        The least of the largest winds held from these bearings, without and with the newcomer.
    bearing_before, bearing_after : float [rad]
        Where these come from.
    bound : float [m/s], optional
        The least wind held with the newcomer in no allowed place exceeds it. Where loads change
        with the bearing that are not the wind's, such as those of a current that comes with it,
        the placement's bound alone is known: no place holds the loads of `tried` from all bearings
        when they are that many times as large.
    """

    placement: Placement
    environment: Environment
    bearings: Array
    tried: float
    before: float
    after: float
    bearing_before: float
    bearing_after: float
    bound: float | None

    kind = "placements"

    def to_data(self) -> dict[str, object]:
        """Return question and answer as plain data: those of the placement."""
        return Placements((self.placement,)).to_data()


def place_for_capability(
    problem: Problem,
    environment: Environment,
    bearings: ArrayLike | None = None,
    gap: float = 1e-6,
    runners_up: float | None = None,
) -> CapabilityPlacement:
    """Find where a newcomer raises the least wind held over all bearings most.

    A wind is held from all bearings when the wrenches opposite to its loads are in the wrench set:
    when the quality for the task of all of them is 1 or more (T16), by the criterion after losses
    or failures. If nothing but the wind acts, or what does is the same from every bearing, that
    quality is the square of the least wind held, and one certified placement answers. Otherwise the
    loads of a wind are the task: the best place for it holds a larger least wind, for which a place
    is sought again, until no place has anything in hand at the wind that the last one holds.

    Parameters
    ----------
    problem : Problem
        Its criterion says what is lost or fails, and the poses; load and task of its own play no
        part.
    environment : Environment
        The wind's own speed and bearing play no part.
    bearings : (m,) [rad], optional
        Where the wind comes from, clockwise from the bow; every 5 degrees when left out.
    gap : float
        Relative, of the placement's quality.
    runners_up : float, optional
        As for `place`.

    Returns
    -------
    CapabilityPlacement

    Raises
    ------
    ProblemInvalid
        If it is no `Problem`.
    EnvironmentInvalid
        If the environment is none, or a bearing is no finite number.
    SwarmGraspError
        As `place`.

    Examples
    --------
    Four robots push a barge, and a fifth may push where it likes:

    >>> from swarmgrasp import Newcomer, Outline, Robot, Swarm, Wind, WindCoefficients
    >>> barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    >>> ways = {(-40, 0): 0.0, (40, 0): math.pi, (-9, -10): 1.57, (-9, 10): -1.57, (9, 10): -1.57}
    >>> swarm = Swarm(barge, [Robot(contact, way, 60e3) for contact, way in ways.items()])
    >>> box = WindCoefficients(transverse=0.9, bow=0.7, stern=0.7)
    >>> asked = Problem(swarm, Newcomer(60e3, attachment="push"))
    >>> found = place_for_capability(asked, Environment(Wind(150.0, 500.0, box)))
    >>> x, y = found.placement.robot.contact
    >>> round(x, 2), y, found.before, round(found.after, 2)
    (10.77, -10.0, 0.0, 16.37)
    """
    refuse((ProblemInvalid, problem_faults(problem)))
    wanted = asked_of(problem.swarm, environment, bearings, 0, False, ()).bearings
    criterion = replace(problem.criterion, load=(0.0, 0.0, 0.0), task=None)
    asked = _Asked(replace(problem, criterion=criterion), environment, wanted, gap, runners_up)
    before, from_before = asked.least(problem.swarm)
    calm = None if asked.sea_grows else asked.calm
    if calm is not None and np.ptp(calm, axis=0).max() <= SAME * np.abs(calm).max(initial=0.0):
        tried, placement = asked.beside(calm[0], before)
        bound: float | None = tried * math.sqrt(max(0.0, placement.upper_bound))
    else:
        tried, placement = asked.in_winds(before)
        bound = tried if placement.upper_bound < 1.0 - SAME else None
    after, from_after = asked.least(placement.swarm_after)
    return CapabilityPlacement(
        placement, environment, wanted, tried, before, after, from_before, from_after, bound
    )


class _Asked:
    """A question about the least wind over all bearings, and the placements tried for it."""

    def __init__(
        self, problem: Problem, environment: Environment, bearings: Array, gap: float,
        runners_up: float | None,
    ) -> None:  # fmt: skip
        self.problem, self.environment, self.bearings = problem, environment, bearings
        self._gap, self._runners_up = gap, runners_up
        self.sea_grows = not environment.grows_with_square

    @property
    def calm(self) -> Array:
        """The loads (m, 3) [N, N, N m] without wind."""
        return self.environment.load_in(self.problem.swarm.outline, self.bearings, 0.0)

    def least(self, swarm: Swarm) -> tuple[float, float]:
        """Return the least wind [m/s] that a swarm holds, and the bearing [rad] it comes from."""
        return least_wind(swarm, self.environment, self.bearings, self.problem.criterion)

    def beside(self, load: Array, before: float) -> tuple[float, Placement]:
        """Place the newcomer for winds beside one load (3,); return the wind of the task, too."""
        speed = before or FIRST
        winds = self.environment.wind_load(self.problem.swarm.outline, self.bearings, speed)
        return speed, self._placed(load, winds)

    def in_winds(self, before: float) -> tuple[float, Placement]:
        """Place the newcomer for winds and what comes with them; return its task's wind, too."""
        speed = before or FIRST
        best: tuple[float, float, Placement] | None = None
        for _ in range(MOST_ROUNDS):
            loads = self.environment.load_in(self.problem.swarm.outline, self.bearings, speed)
            placement = self._placed(np.zeros(3), loads)
            held, _ = self.least(placement.swarm_after)
            if best is None or held > best[0]:
                best = held, speed, placement
            if held == 0.0 or abs(held - speed) <= SAME * speed:
                break
            speed = held
        assert best is not None  # there is a round
        return best[1:]

    def _placed(self, load: Array, loads: Array) -> Placement:
        """Place the newcomer for a task of loads (m, 3) beside a load (3,)."""
        surge, sway, yaw = load.tolist()
        criterion = replace(self.problem.criterion, load=(surge, sway, yaw), task=Polytope(-loads))
        asked = replace(self.problem, criterion=criterion)
        return place(asked, gap=self._gap, runners_up=self._runners_up)
