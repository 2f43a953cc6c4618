"""What every question about weather from all round is: a swarm, its surroundings, bearings."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment import Environment
from swarmgrasp.environment.limits import BEARING
from swarmgrasp.errors import EnvironmentInvalid, SwarmInvalid, refuse
from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Answer, picked
from swarmgrasp.quality import Criterion, Polytope, Quality, quality
from swarmgrasp.ranges import WEAKEST, array_of, kind_faults, shown
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.robot import Envelope
from swarmgrasp.swarm.swarm import swarm_faults
from swarmgrasp.words import machine_words

Array = NDArray[np.float64]
T = TypeVar("T")

HELD = 1e-9
"""Share of a load by which it may fail to be held, for rounding."""

STRAIGHT = 1e-9
"""Angle [rad] by which forces may lie on more than half a turn's other side, for rounding."""

APART = math.radians(5.0)
"""Between the bearings looked at by default [rad]: half of what DNV-ST-0111 asks for."""


@dataclass(frozen=True, eq=False)
class AllRound(Frozen, Answer):
    """What a swarm holds from bearings all round, intact and after its worst loss.

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
    failures : sequence of sequence of str
        The worst of them happens before any loss, as in a `Criterion`.
    intact, after_loss : (m,)
        How much all robots, and those left after the worst failure and loss, hold.
    worst_losses : tuple of tuple of str
        For each bearing, names of the robots and groups whose failure and loss leave the least.
    """

    swarm: Swarm
    environment: Environment
    bearings: Array
    losing: int
    worst_case: bool
    failures: Sequence[Sequence[str]]
    intact: NDArray[Any]
    after_loss: NDArray[Any]
    worst_losses: tuple[tuple[str, ...], ...]

    def to_data(self) -> dict[str, Any]:
        """Return question and answer as plain data; losses by the names of robots and groups."""
        told = picked(
            self, "swarm", "environment", "losing", "worst_case", "failures", "bearings", "intact",
            "after_loss",
        )  # fmt: skip
        return {**told, "worst_losses": list(map(list, self.worst_losses))}

    def loss_words(self, robot: str = "robot") -> str:
        """Return what is lost, such as "one robot"; a group counts as one."""
        kind = machine_words(self.losing, bool(self.swarm.rare.groups), robot)
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
        """Index of the bearing at which the least is held, intact."""
        return _first_least(self.intact)

    @property
    def worst_after_loss(self) -> int:
        """Index of the bearing at which the least is held, after the worst loss there."""
        return _first_least(self.after_loss)


class Asked(NamedTuple):
    """A question, checked: the bearings [rad], and what is held intact and after losses."""

    bearings: Array
    whole: Criterion
    less: Criterion


def asked_of(
    swarm: Swarm,
    environment: Environment,
    bearings: ArrayLike | None,
    losing: int,
    worst_case: bool,
    failures: Sequence[Sequence[str]],
    more_faults: Sequence[str] = (),
) -> Asked:
    """Check a question; every 5 degrees where no bearings are given.

    Raises
    ------
    EnvironmentInvalid
        If the environment is none, a bearing is no finite number, or there are more faults.
    CriterionInvalid
        If the number of robots lost is negative, or a failure takes nobody.
    SwarmInvalid
        If the swarm is no `Swarm`.
    """
    found = array_of(np.arange(0.0, 2.0 * math.pi - 1e-9, APART) if bearings is None else bearings)
    wanted = np.zeros(0) if found is None else found
    faults = kind_faults(environment, Environment, "Environment(wind)")
    if wanted.ndim != 1 or not len(wanted):
        faults.append(f"the bearings are {shown(bearings)}; they should be numbers (m,) [rad]")
    else:
        faults += [fault for b in wanted.tolist() for fault in BEARING.faults("bearing", b)]
    faults += more_faults
    refuse((SwarmInvalid, swarm_faults(swarm)), (EnvironmentInvalid, faults))
    return Asked(
        wanted,
        Criterion(worst_case=worst_case),
        Criterion(losing=losing, worst_case=worst_case, failures=failures),
    )


def counted(
    found: Iterable[T], progress: Callable[[int], object] | None, before: int
) -> Iterator[T]:
    """Yield what is found, and tell how many that are, beside so many found before.

    Examples
    --------
    >>> told = []
    >>> list(counted("ab", told.append, 3)), told
    (['a', 'b'], [4, 5])
    """
    for count, each in enumerate(found, start=before + 1):
        yield each
        if progress is not None:
            progress(count)


def times_held(swarm: Swarm, load: Array, asked: Criterion) -> Quality | None:
    """Find by how many times a load (3,), or each of several (m, 3), could grow and be held.

    None of no load at all, if the robots can stand still; robots that always exert something may
    not be able to, and then hold nothing.
    """
    if np.abs(load).max() <= WEAKEST:
        return _unrest(swarm, asked)
    return quality(swarm, **replace(asked, task=Polytope(-np.atleast_2d(load))).keywords)


def _unrest(swarm: Swarm, asked: Criterion) -> Quality | None:
    """Return the quality, which is 0, of robots whose wrench set is without 0; None of others.

    Where it has 0, it is a ball's around 0, or flat, and then it has some of a robot's wrench too,
    or of its opposite; robots that can only just balance each other are told to hold nothing.
    """
    always = bool((swarm.lows > 0.0).any()) or any(map(_is_off, swarm.rare.envelopes.values()))
    if not always:
        return None
    found = quality(swarm, **asked.keywords)
    rows = np.unique(swarm.generators, axis=0)
    for task in (Polytope([sign * row]) for row in rows if row.any() for sign in (1.0, -1.0)):
        if found.value > 0.0 or quality(swarm, **replace(asked, task=task).keywords).value > 0.0:
            return None
    return found


def _is_off(envelope: Envelope) -> bool:
    """Tell whether no force is none of those between the corners (k, 2) of an envelope."""
    corners = np.array(envelope)
    if not corners.any(axis=1).all():
        return False
    turns = np.sort(np.arctan2(*corners.T[::-1]))
    return bool(np.diff(turns, append=turns[0] + math.tau).max() > math.pi + STRAIGHT)


def is_held(found: Quality | None) -> bool:
    """Tell whether a load is held, of which `times_held` was found."""
    return found is None or found.value >= 1.0 - HELD


def _first_least(held: NDArray[Any]) -> int:
    """Return the first index of the least value, whatever rounding says of its equals."""
    return int(np.argmax(held <= held.min() * (1.0 + 1e-9)))
