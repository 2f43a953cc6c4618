"""Capability: the largest wind a swarm can hold the object against, at every bearing."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.capability.asked import (
    HELD,
    AllRound,
    Array,
    asked_of,
    counted,
    is_held,
    times_held,
)
from swarmgrasp.environment import STEPS, STRONGEST_SEA, Environment
from swarmgrasp.plain import picked
from swarmgrasp.quality import Criterion, Polytope, Quality, quality
from swarmgrasp.ranges import call_faults
from swarmgrasp.swarm import Swarm

LOOKED_AT = 2
"""Winds tried from one step of the sea to the next, for the first that is not held."""
NEAR = 1e-10
"""Between a wind that is held and one that is not, relative to it, where the search ends."""
MOST_TRIED = 200
"""Winds tried on the way there."""


@dataclass(frozen=True, eq=False)
class Capability(AllRound):
    """The largest winds that a swarm holds, intact and after its worst loss.

    What was asked, and the worst losses, are as for `AllRound`.

    Attributes
    ----------
    intact, after_loss : (m,) [m/s]
        Largest wind speeds that all robots, and those left after the worst failure and loss, hold
        beside current and waves; 0 where they hold none, or not even what comes without wind.
    holds_calm, holds_calm_after_loss : (m,) of bool
        Whether they hold what comes without wind: the current, and waves that are no wind's.
    directions : (m, 3)
        For each bearing, the unit wrench in the metric's coordinates along which all robots
        together can give no more: what the largest wind needs.
    """

    holds_calm: NDArray[np.bool_]
    holds_calm_after_loss: NDArray[np.bool_]
    directions: Array

    kind = "capability"

    def to_data(self) -> dict[str, Any]:
        """Return question and answer as plain data; losses by the names of robots and groups."""
        more = picked(self, "holds_calm", "holds_calm_after_loss", "directions")
        return {**super().to_data(), **more}

    @property
    def most_told(self) -> float:
        """The wind [m/s] up to which winds were tried: the strongest whose sea is known.

        Infinite where loads grow with the square of the wind, and nothing had to be tried.
        """
        return math.inf if self.environment.grows_with_square else STRONGEST_SEA


def capability(
    swarm: Swarm,
    environment: Environment,
    bearings: ArrayLike | None = None,
    losing: int = 1,
    worst_case: bool = False,
    failures: Sequence[Sequence[str]] = (),
    progress: Callable[[int], object] | None = None,
) -> Capability:
    """Find the largest wind a swarm can hold the object against, at every bearing.

    A wind of speed V from a bearing exerts w_c + V^2 w_w with the current, and with waves that are
    the same in every wind; the robots hold it when the opposite wrench is in their wrench set. The
    largest V^2 is their exact quality for the task of the one wrench -w_w beside the load w_c
    (T16), and after the worst loss of k robots (T15), and of named failures (T25).

    Where the sea goes with the wind, or a table has winds of several speeds, the largest wind is
    the end of those that are held from a calm on: those of the sea's steps and halfway between are
    tried, and the wind at which holding ends before the first that is not held is found to the last
    digits.

    Parameters
    ----------
    swarm : Swarm
    environment : Environment
        The wind's own speed and bearing play no part.
    bearings : (m,) [rad], optional
        Where the wind comes from, clockwise from the bow; every 5 degrees when left out.
    losing : int
        How many robots, or groups of robots, are lost, the worst ones at each bearing.
    worst_case : bool
        In the worst poses that the robots' tolerances allow (T14).
    failures : sequence of sequence of str
        The worst of them happens before any loss: each takes robots and groups, by name.
    progress : callable, optional
        Called with the number of winds found, after each: one for each bearing, and another after
        losses.

    Returns
    -------
    Capability

    Raises
    ------
    EnvironmentInvalid
        If the environment is none, or a bearing is no finite number.
    CriterionInvalid
        If the number of robots lost is negative, or a failure takes nobody.
    SwarmInvalid
        If the swarm is no `Swarm`.

    Examples
    --------
    Four robots of 60 kN push a barge ahead, astern and to either side; a wind abeam is held as
    long as it is weaker than one of them:

    >>> from swarmgrasp import Outline, Robot, Wind, WindCoefficients
    >>> barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    >>> ways = {(-40, 0): 0.0, (40, 0): math.pi, (0, -10): math.pi / 2, (0, 10): -math.pi / 2}
    >>> swarm = Swarm(barge, [Robot(contact, way, 60e3) for contact, way in ways.items()])
    >>> box = WindCoefficients(transverse=0.9, bow=0.7, stern=0.7)
    >>> found = capability(swarm, Environment(Wind(150.0, 500.0, box)), [0.0, math.pi / 2])
    >>> found.intact.round(2).tolist(), found.after_loss.tolist()
    ([30.53, 14.75], [0.0, 0.0])
    """
    asked = asked_of(
        swarm, environment, bearings, losing, worst_case, failures, call_faults(progress)
    )
    held, left = (
        list(counted(_held_from(swarm, environment, asked.bearings, one), progress, before))
        for one, before in ((asked.whole, 0), (asked.less, len(asked.bearings)))
    )
    return Capability(
        swarm=swarm,
        environment=environment,
        bearings=asked.bearings,
        losing=asked.less.losing,
        worst_case=asked.less.worst_case,
        failures=asked.less.failures,
        intact=np.array([at.speed for at in held]),
        after_loss=np.array([at.speed for at in left]),
        holds_calm=np.array([at.holds_calm for at in held]) > 0.0,
        holds_calm_after_loss=np.array([at.holds_calm for at in left]) > 0.0,
        worst_losses=tuple(at.lost for at in left),
        directions=np.array([at.direction for at in held]),
    )


def least_wind(
    swarm: Swarm, environment: Environment, bearings: Array, asked: Criterion
) -> tuple[float, float]:
    """Return the least of the largest winds [m/s] held, and the bearing [rad] it comes from.

    Parameters
    ----------
    swarm : Swarm
    environment : Environment
    bearings : (m,) [rad]
    asked : Criterion
        After what losses and failures, and in which poses; without load and task.
    """
    if environment.grows_with_square:
        held = np.array([at.speed for at in _held_from(swarm, environment, bearings, asked)])
        return float(held.min()), float(bearings[held.argmin()])
    least = _largest_in_its_sea(swarm, environment, bearings, asked).speed
    found = [
        times_held(swarm, load, asked)
        for load in environment.load_in(swarm.outline, bearings, least)
    ]
    times = np.array([math.inf if each is None else each.value for each in found])
    return least, float(bearings[times.argmin()])


# -- parts --------------------------------------------------------------------------------


class _Held(NamedTuple):
    """The largest wind held at one bearing [m/s], and what is known of it."""

    speed: float
    holds_calm: bool
    direction: Array
    lost: tuple[str, ...]


def _held_from(
    swarm: Swarm, environment: Environment, bearings: Array, asked: Criterion
) -> Iterator[_Held]:
    """Yield the largest winds held from bearings (m,)."""
    if environment.grows_with_square:
        calm = environment.load_in(swarm.outline, bearings, 0.0)
        winds = environment.wind_load(swarm.outline, bearings, 1.0)
        yield from _largest(swarm, calm, winds, asked)
        return
    for bearing in bearings[:, None]:
        yield _largest_in_its_sea(swarm, environment, bearing, asked)


def _largest(swarm: Swarm, calm: Array, winds: Array, asked: Criterion) -> Iterator[_Held]:
    """Yield the largest winds held beside loads (m, 3), given the loads (m, 3) of 1 m/s."""
    for load, wind in zip(calm, winds, strict=True):
        x, y, turn = load.tolist()
        keywords = replace(asked, load=(x, y, turn), task=Polytope([-wind])).keywords
        found = quality(swarm, **keywords)
        speed = math.sqrt(max(0.0, found.value))
        holds = speed > 0.0 or is_held(times_held(swarm, load, asked))
        yield _Held(speed, holds, found.direction, (*found.failure, *found.lost))


def _largest_in_its_sea(
    swarm: Swarm, environment: Environment, bearings: Array, asked: Criterion
) -> _Held:
    """Find the largest wind held from all of some bearings (m,) with the sea that goes with it."""

    def tried(speed: float) -> Quality | None:
        """Find by how many times everything could grow in a wind [m/s]."""
        return times_held(swarm, environment.load_in(swarm.outline, bearings, speed), asked)

    known = [step.wind for step in STEPS]
    rungs = np.arange(LOOKED_AT * (len(known) - 1) + 1) / LOOKED_AT
    ladder = np.interp(rungs, range(len(known)), known)
    low = 0.0
    ladders = environment.load_in(swarm.outline, bearings, ladder[:, None])
    for high, loads in zip(ladder, ladders, strict=True):
        found = times_held(swarm, loads, asked)
        if not is_held(found):
            if high > 0.0:
                low, found = _end_of_holding(tried, low, float(high))
            break
        low = float(high)
    assert found is not None  # a wind has a load, and so has a current that is not held
    holds_calm = low > 0.0 or is_held(tried(0.0))
    return _Held(low, holds_calm, found.direction, (*found.failure, *found.lost))


def _end_of_holding(
    tried: Callable[[float], Quality | None], low: float, high: float
) -> tuple[float, Quality | None]:
    """Return the last wind held between one that is held and one that is not, and what is beyond.

    Along the chord of the excess over what is needed; an end that stays twice counts half
    (the Illinois method), so that both ends come near.
    """
    beyond = tried(high)
    inside, outside = _excess(tried(low)), _excess(beyond)
    side = 0
    for _ in range(MOST_TRIED):
        if high - low <= NEAR * high:
            break
        middle = low + (high - low) * inside / (inside - outside)
        middle = min(max(middle, low + 0.3 * NEAR * high), high - 0.3 * NEAR * high)
        found = tried(middle)
        excess = _excess(found)
        if excess >= 0.0:
            low, inside = middle, excess
            outside *= 0.5 if side == 1 else 1.0
            side = 1
        else:
            high, beyond, outside = middle, found, excess
            inside *= 0.5 if side == -1 else 1.0
            side = -1
    return low, beyond


def _excess(found: Quality | None) -> float:
    """Return by how much a load could grow before it is not held; what is less than 0 is short."""
    return 1.0 if found is None else min(found.value, 2.0) - (1.0 - HELD)
