"""Capability numbers: the largest step of wind, sea and current held, at every bearing."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.capability.asked import AllRound, Array, asked_of, counted, is_held, times_held
from swarmgrasp.environment import STEPS, Environment, Waves
from swarmgrasp.quality import Criterion
from swarmgrasp.ranges import call_faults
from swarmgrasp.swarm import Swarm

ALLOWANCE = 1.25
"""The dynamic factor with which DNV-ST-0111 computes its numbers."""


@dataclass(frozen=True, eq=False)
class CapabilityNumbers(AllRound):
    """The largest steps of weather that a swarm holds, intact and after its worst loss.

    What was asked, and the worst losses, are as for `AllRound`; speeds and bearings of the
    environment play no part, its sea neither.

    Attributes
    ----------
    intact, after_loss : (m,) of int
        Numbers of the largest of `STEPS`, all those before it held too, that all robots, and those
        left after the worst failure and loss, hold: wind, waves and current from one bearing.
    """

    intact: NDArray[np.int64]
    after_loss: NDArray[np.int64]

    kind = "capability numbers"


def capability_numbers(
    swarm: Swarm,
    environment: Environment,
    bearings: ArrayLike | None = None,
    losing: int = 1,
    worst_case: bool = False,
    failures: Sequence[Sequence[str]] = (),
    progress: Callable[[int], object] | None = None,
) -> CapabilityNumbers:
    """Find the largest step of weather a swarm can hold the object in, at every bearing.

    The steps are those by which DNV-ST-0111 numbers the capability of vessels: the winds of the
    Beaufort scale, the sea and the current that go with each, all from one bearing. Whether one is
    held is exact. It is no assessment by that standard: thrusters are as the swarm has them,
    without its losses and its power balance, loads are steady, and the wind's coefficients are the
    environment's.

    Parameters
    ----------
    swarm : Swarm
    environment : Environment
        What the object shows to wind and current; waves meet the outline, unless it says more.
    bearings, losing, worst_case, failures, progress
        As for `capability`.

    Returns
    -------
    CapabilityNumbers

    Raises
    ------
    EnvironmentInvalid
        If the environment is none or has no current, or a bearing is no finite number.
    CriterionInvalid, SwarmInvalid
        As for `capability`.

    Examples
    --------
    A barge held by four robots of 60 kN, ahead and abeam; any loss lets it go in the least wind:

    >>> import math
    >>> from swarmgrasp import Current, Outline, Robot, Wind, WindCoefficients
    >>> barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    >>> ways = {(-40, 0): 0.0, (40, 0): math.pi, (0, -10): math.pi / 2, (0, 10): -math.pi / 2}
    >>> swarm = Swarm(barge, [Robot(contact, way, 60e3) for contact, way in ways.items()])
    >>> box = WindCoefficients(transverse=0.9, bow=0.7, stern=0.7)
    >>> around = Environment(Wind(150.0, 500.0, box), Current(60.0, 240.0))
    >>> found = capability_numbers(swarm, around, [0.0])
    >>> found.intact.tolist(), found.after_loss.tolist(), found.worst_losses
    ([5], [0], (('R1',),))
    """
    lacking = isinstance(environment, Environment) and environment.current is None
    faults = [
        "the environment has no current, and every step has one: give it Current(frontal_area, "
        "lateral_area)"
    ] * lacking + call_faults(progress)
    asked = asked_of(swarm, environment, bearings, losing, worst_case, failures, faults)
    loads = step_loads(swarm, environment, asked.bearings)
    found = (
        (_largest(swarm, each, one) for each in loads.swapaxes(0, 1))
        for one in (asked.whole, asked.less)
    )
    held, left = (
        list(counted(each, progress, k * len(asked.bearings))) for k, each in enumerate(found)
    )
    return CapabilityNumbers(
        swarm=swarm,
        environment=environment,
        bearings=asked.bearings,
        losing=asked.less.losing,
        worst_case=asked.less.worst_case,
        failures=asked.less.failures,
        intact=np.array([at.number for at in held]),
        after_loss=np.array([at.number for at in left]),
        worst_losses=tuple(at.lost for at in left),
    )


def step_loads(swarm: Swarm, environment: Environment, bearings: Array) -> Array:
    """Return the loads (12, m, 3) [N, N, N m] of the steps from bearings (m,)."""
    current, sea = environment.current, environment.waves or Waves()
    assert current is not None
    loads = []
    for step in STEPS:
        around = replace(
            environment,
            wind=replace(environment.wind, speed=None, bearing=None),
            current=replace(current, speed=step.current, bearing=None),
            waves=replace(sea, height=step.height, period=step.period, bearing=None),
        )
        loads.append(around.load_in(swarm.outline, bearings, step.wind))
    return np.array(loads)


class _Largest(NamedTuple):
    """The largest step held at one bearing, and who is gone when the next is not."""

    number: int
    lost: tuple[str, ...]


def _largest(swarm: Swarm, loads: Array, asked: Criterion) -> _Largest:
    """Find the largest step held of loads (12, 3), all before it held too."""
    held = -1
    found = None
    for load in loads:
        found = times_held(swarm, load, asked)
        if not is_held(found):
            break
        held += 1
    lost = () if found is None else (*found.failure, *found.lost)
    return _Largest(held, lost)
