"""Whether a load is held, with how much to spare, and after whose loss it is not."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.cli.show.change import unit_of
from swarmgrasp.environment import Environment, Waves
from swarmgrasp.errors import ForcesNotProven
from swarmgrasp.forces import Forces, forces
from swarmgrasp.outline import Outline
from swarmgrasp.quality import Loss, Quality
from swarmgrasp.scenario import Scenario
from swarmgrasp.swarm import Swarm
from swarmgrasp.telling import Telling
from swarmgrasp.words import either_words, list_words, wrench_words

SAME = 1e-9
"""Relative difference of two loads that is none, and share of a load by which it may be missed."""
MOST_NAMED = 6
"""Robots whose loss is told by name."""


@dataclass(frozen=True)
class Held:
    """Whether a swarm holds a load.

    Attributes
    ----------
    found : Quality
        Of the swarm by a criterion with a load.
    answer : Forces or None
        What the robots that are there in the worst case do against the load; None where the
        quality says that they hold it.
    unheld : tuple of str
        The robots and groups after whose loss, alone, it is not held.
    tried : int
        How many have been left out, one at a time, to find those; 0 if that was not asked.
    """

    found: Quality
    answer: Forces | None
    unheld: tuple[str, ...]
    tried: int

    @property
    def is_missed(self) -> bool:
        """Whether the load is out of reach."""
        return self.answer is not None and misses(self.answer)


def misses(answer: Forces) -> bool:
    """Tell whether forces miss the load that they are to hold."""
    return answer.shortfall > SAME * float(np.linalg.norm(answer.load * answer.swarm.scale))


def held_of(found: Quality, lost: Sequence[Loss] | None) -> Held | None:
    """Tell whether a load is held; None if rounding hides that.

    Parameters
    ----------
    found : Quality
        By a criterion with a load.
    lost : sequence of Loss or None
        What each loss leaves beside the load; None if that was not asked.
    """
    load = found.criterion.load
    try:
        answer = None if found.value > 0.0 else _against(found.worst_swarm, load)
        unheld = [
            loss.name
            for loss in lost or ()
            if loss.quality == 0.0 and misses(_against(loss.after.worst_swarm, load))
        ]
    except ForcesNotProven:
        return None
    return Held(found, answer, tuple(unheld), len(lost or ()))


def _against(swarm: Swarm, load: tuple[float, float, float]) -> Forces:
    """Return what robots do against a load."""
    return forces(swarm, (0.0, 0.0, 0.0), load=load)


# -- words --------------------------------------------------------------------------------


def headline(scenario: Scenario, held: Held, tell: Telling) -> str:
    """Say in a line whether the load is held, and after whose loss it is not."""
    found, criterion, robots = held.found, held.found.criterion, tell.terms.several
    said = f"held {weather_words(scenario, criterion.load, tell)}"
    if words := replace(criterion, load=(0.0, 0.0, 0.0)).words(scenario.swarm, tell.terms.robot):
        said += f" {words}"
    if held.answer is not None and held.is_missed:
        short = tell.force.text(held.answer.shortfall)
        return f"not {said}: out of reach by {short}, {drift_words(held.answer)}"
    if found.value > 0.0:
        said += f", {unit_of(criterion, tell).text(found.value)} to spare"
    elif criterion.is_of_worst:  # of several losses as bad, another may be the one that misses
        return f"nothing to spare when {said}, weakest {found.weakest_words}"
    else:
        said += f", with nothing to spare {found.weakest_words}"
    one = f"any one {tell.machines(1, bool(scenario.swarm.rare.groups))}"
    if held.unheld:
        few = len(held.unheld) <= MOST_NAMED
        who = either_words(held.unheld) if few else f"any of {len(held.unheld)} {robots}"
        who = one if len(held.unheld) == held.tried > 1 else who
        return f"{said}. Not held after losing {who}."
    return f"{said}. Held after losing {one}." if held.tried else said


def drift_words(answer: Forces) -> str:
    """Say where what is missing drives the object."""
    return f"which leaves the object {wrench_words(-answer.missing * answer.swarm.scale)}"


def weather_words(scenario: Scenario, load: ArrayLike, tell: Telling) -> str:
    """Say in which weather a load acts: the file's wind and current, if the load is theirs."""
    environment = scenario.environment
    if environment is None or not _is_of(load, environment, scenario.swarm.outline):
        return "against the load"
    wind, current = environment.wind, environment.current
    speed, bearing = wind.speed or 0.0, wind.bearing or 0.0
    said = [f"{tell.speed(speed)} {tell.from_words(bearing)}"] if speed else []
    if current is not None and current.speed:
        from_ = bearing if current.bearing is None else current.bearing
        said.append(f"a current of {tell.speed(current.speed)} {tell.from_words(from_)}")
    if environment.waves is not None:
        said.append(_sea_words(environment.waves, bearing, tell))
    more = f", loads times {environment.dynamic_factor:g}" * (environment.dynamic_factor != 1.0)
    return f"in {list_words(said)}{more}" if said else "against the load"


def _sea_words(waves: Waves, wind_bearing: float, tell: Telling) -> str:
    """Say which sea it is."""
    way = tell.from_words(wind_bearing if waves.bearing is None else waves.bearing)
    if waves.height is None or waves.period is None:
        return f"the sea of that wind {way}"
    return f"a sea of {tell.length.short(waves.height)} and {waves.period:.3g} s {way}"


def _is_of(load: ArrayLike, environment: Environment, outline: Outline) -> bool:
    """Tell whether a load is that of an environment."""
    if not environment.is_steady:
        return False
    return bool(np.allclose(environment.load(outline), load, rtol=SAME, atol=0.0))
