"""Capability: the largest wind a swarm can hold the object against, at every bearing."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment import Environment
from swarmgrasp.environment.limits import BEARING
from swarmgrasp.errors import EnvironmentInvalid, SwarmInvalid, refuse
from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Answer, picked
from swarmgrasp.quality import Criterion, Polytope, quality
from swarmgrasp.ranges import WEAKEST, array_of, kind_faults, shown
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.swarm import swarm_faults
from swarmgrasp.words import machine_words

HELD = 1e-9
"""Share of a current by which it may fail to be held, for rounding."""

STEP = math.radians(5.0)
"""Between the bearings looked at by default [rad]: half of what DNV-ST-0111 asks for."""


@dataclass(frozen=True, eq=False)
class Capability(Frozen, Answer):
    """The largest winds that a swarm holds, intact and after its worst loss.

    Attributes
    ----------
    swarm : Swarm
    environment : Environment
    bearings : (m,) [rad]
        Where the wind comes from, clockwise from the bow.
    losing : int
        How many robots, or groups, are lost.
    worst_case : bool
        Whether the robots are in the worst poses that their tolerances allow.
    failures : tuple of tuple of str
        The worst of them happens before any loss, as in a `Criterion`.
    intact, after_loss : (m,) [m/s]
        Largest wind speeds that all robots, and those left after the worst failure and loss, hold
        beside the current; 0 where they hold none, or not even the current.
    holds_current, holds_current_after_loss : (m,) of bool
        Whether they hold the current alone.
    worst_losses : tuple of tuple of str
        For each bearing, names of the robots and groups whose failure and loss leave the least.
    directions : (m, 3)
        For each bearing, the unit wrench in the metric's coordinates along which all robots
        together can give no more: what the largest wind needs.
    """

    swarm: Swarm
    environment: Environment
    bearings: NDArray[np.float64]
    losing: int
    worst_case: bool
    failures: tuple[tuple[str, ...], ...]
    intact: NDArray[np.float64]
    after_loss: NDArray[np.float64]
    holds_current: NDArray[np.bool_]
    holds_current_after_loss: NDArray[np.bool_]
    worst_losses: tuple[tuple[str, ...], ...]
    directions: NDArray[np.float64]

    kind = "capability"

    def to_data(self) -> dict[str, Any]:
        """Return question and answer as plain data; losses by the names of robots and groups."""
        told = picked(
            self, "swarm", "environment", "losing", "worst_case", "failures", "bearings", "intact",
            "after_loss", "holds_current", "holds_current_after_loss", "directions",
        )  # fmt: skip
        return {**told, "worst_losses": list(map(list, self.worst_losses))}

    @property
    def loss_words(self) -> str:
        """What is lost, such as "one robot"; a group counts as one."""
        kind = machine_words(self.losing, bool(self.swarm.rare.groups))
        return f"{'one' if self.losing == 1 else self.losing} {kind}"

    @property
    def less_by(self) -> str:
        """By what the robots are fewer: "failure", which robots may be lost beside, or "loss"."""
        return "failure" if self.failures else "loss"

    def lost_words(self, index: int, most: int = 2) -> str:
        """Return the names of robots and groups that are gone at worst at a bearing, in a sentence.

        Parameters
        ----------
        index : int
            Of the bearing.
        most : int
            Names told, at least 1; the others are counted.
        """
        names = list(self.worst_losses[index])
        if len(names) > most:
            names[most:] = [f"{len(names) - most} more"]
        return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)

    @property
    def worst(self) -> int:
        """Index of the bearing at which the least wind is held, intact."""
        return _first_least(self.intact)

    @property
    def worst_after_loss(self) -> int:
        """Index of the bearing at which the least wind is held, after the worst loss there."""
        return _first_least(self.after_loss)


def _first_least(speeds: NDArray[np.float64]) -> int:
    """Return the first index of the least value, whatever rounding says of its equals."""
    return int(np.argmax(speeds <= speeds.min() * (1.0 + 1e-9)))


def capability(
    swarm: Swarm,
    environment: Environment,
    bearings: ArrayLike | None = None,
    losing: int = 1,
    worst_case: bool = False,
    failures: Sequence[Sequence[str]] = (),
) -> Capability:
    """Find the largest wind a swarm can hold the object against, at every bearing.

    A wind of speed V from a bearing exerts w_c + V^2 w_w with the current; the robots hold it
    when the opposite wrench is in their wrench set. The largest V^2 is their exact quality for
    the task of the one wrench -w_w beside the load w_c (T16), and after the worst loss of k
    robots (T15), and of named failures (T25).

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
    found = array_of(np.arange(0.0, 2.0 * math.pi - 1e-9, STEP) if bearings is None else bearings)
    wanted = np.zeros(0) if found is None else found
    faults = kind_faults(environment, Environment, "Environment(wind)")
    if wanted.ndim != 1 or not len(wanted):
        faults.append(f"the bearings are {shown(bearings)}; they should be numbers (m,) [rad]")
    else:
        faults += [fault for b in wanted.tolist() for fault in BEARING.faults("bearing", b)]
    refuse((SwarmInvalid, swarm_faults(swarm)), (EnvironmentInvalid, faults))
    whole = Criterion(worst_case=worst_case)
    less = Criterion(losing=losing, worst_case=worst_case, failures=failures)  # type: ignore[arg-type]
    currents = environment.current_load(swarm.outline, wanted)
    winds = environment.wind_load(swarm.outline, wanted, 1.0)
    held = _largest(swarm, currents, winds, whole)
    left = _largest(swarm, currents, winds, less)
    return Capability(
        swarm=swarm,
        environment=environment,
        bearings=wanted,
        losing=less.losing,
        worst_case=less.worst_case,
        failures=less.failures,
        intact=np.array([at.speed for at in held]),
        after_loss=np.array([at.speed for at in left]),
        holds_current=np.array([at.holds_current for at in held]) > 0.0,
        holds_current_after_loss=np.array([at.holds_current for at in left]) > 0.0,
        worst_losses=tuple(at.lost for at in left),
        directions=np.array([at.direction for at in held]),
    )


# -- parts --------------------------------------------------------------------------------


class _Held(NamedTuple):
    """The largest wind held at one bearing [m/s], and what is known of it."""

    speed: float
    holds_current: bool
    direction: NDArray[np.float64]
    lost: tuple[str, ...]


def _largest(
    swarm: Swarm,
    currents: NDArray[np.float64],
    winds: NDArray[np.float64],
    asked: Criterion,
) -> list[_Held]:
    """Find the largest winds held beside currents (m, 3), given the loads (m, 3) of 1 m/s."""
    held = []
    for current, wind in zip(currents, winds, strict=True):
        x, y, turn = current.tolist()
        terms = replace(asked, load=(x, y, turn), task=Polytope([-wind])).terms
        found = quality(swarm, **terms)
        speed = math.sqrt(max(0.0, found.value))
        holds = speed > 0.0 or _holds(swarm, current, asked)
        held.append(_Held(speed, holds, found.direction, (*found.failure, *found.lost)))
    return held


def _holds(swarm: Swarm, current: NDArray[np.float64], asked: Criterion) -> bool:
    """Tell whether a current (3,) alone is held."""
    if np.abs(current).max() <= WEAKEST:
        return True
    found = quality(swarm, **replace(asked, task=Polytope([-current])).terms)
    return found.value >= 1.0 - HELD
