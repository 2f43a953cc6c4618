"""Whether a load is held, with how much to spare, and after whose loss it is not."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.cli.show.change import telling_of, unit_of
from swarmgrasp.environment import Waves
from swarmgrasp.quality import Criterion, Loss, Quality, quality
from swarmgrasp.scenario import Scenario
from swarmgrasp.swarm import Swarm
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.words import either_words, list_words, wrench_words

SAME = 1e-9
"""Relative difference of two loads that is none, and share of a load by which it may be missed."""
THE_LOAD = "against the load"
"""What is held where nothing more is known of it."""
MOST_NAMED = 6
"""Robots whose loss is told by name."""


@dataclass(frozen=True)
class Held:
    """Whether a swarm holds a load.

    Attributes
    ----------
    found : Quality
        Of the swarm by a criterion with a load.
    alone : Quality
        The same of the load alone, without a task.
    unheld : tuple of str
        The robots and groups after whose loss, alone, it is not held.
    tried : int
        How many have been left out, one at a time, to find those; 0 if that was not asked.
    """

    found: Quality
    alone: Quality
    unheld: tuple[str, ...]
    tried: int

    @property
    def is_missed(self) -> bool:
        """Whether the load is out of reach."""
        return misses(self.alone)


def misses(found: Quality) -> bool:
    """Tell whether a load is missed, by more than rounding."""
    load = np.array(found.criterion.load) * found.worst_swarm.scale
    return -found.margin > SAME * float(np.linalg.norm(load))


def held_of(swarm: Swarm, found: Quality, lost: Sequence[Loss] | None) -> Held:
    """Tell whether a load is held.

    Parameters
    ----------
    swarm : Swarm
    found : Quality
        Of it, by a criterion with a load.
    lost : sequence of Loss or None
        What each loss leaves beside the load alone; None if that was not asked.
    """
    alone = found
    if found.criterion.task is not None:
        alone = quality(swarm, **replace(found.criterion, task=None).keywords)
    unheld = tuple(loss.name for loss in lost or () if misses(loss.after))
    return Held(found, alone, unheld, len(lost or ()))


# -- words --------------------------------------------------------------------------------


def headline(scenario: Scenario, held: Held, tell: Telling) -> str:
    """Say in a line whether the load is held, and after whose loss it is not."""
    found, criterion, robots = held.found, held.found.criterion, tell.terms.several
    weather = weather_words(scenario, criterion.load, tell)
    said = _held_words(criterion, scenario.swarm, weather, tell)
    if held.is_missed:
        short = tell.force.text(-held.alone.margin)
        drift = drift_words(held.alone.missing, scenario.swarm)
        return f"not {said}: out of reach by {short}, {drift}"
    if found.value > 0.0:
        said += f", {unit_of(criterion, tell).text(found.value)} to spare"
    elif criterion.is_of_worst:
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


def headline_with(found: Quality, who: str, weather: str, tell: Telling) -> str:
    """Say in a line whether a load is held with newcomers.

    Parameters
    ----------
    found : Quality
        With them, by a criterion with a load.
    who : str
        They, and where.
    weather : str
        Against what: "in 25 kn from 60 deg", "against the load".
    tell : Telling
    """
    held = held_of(found.swarm, found, None)
    said = _held_words(found.criterion, found.swarm, weather, tell)
    if held.is_missed:
        short = tell.force.text(-held.alone.margin)
        drift = drift_words(held.alone.missing, found.swarm)
        return f"not {said}, even with {who}: out of reach by {short}, {drift}"
    spare = unit_of(found.criterion, tell).text(found.value) if found.value > 0.0 else "nothing"
    return f"{said}, with {who}: {spare} to spare"


def _held_words(criterion: Criterion, swarm: Swarm, weather: str, tell: Telling) -> str:
    """Say what is held, and after which loss."""
    words = replace(criterion, load=(0.0, 0.0, 0.0)).words(swarm, tell.terms.robot)
    return f"held {weather} {words}".rstrip()


def drift_words(missing: ArrayLike, swarm: Swarm) -> str:
    """Say where what is missing (3,) [N, N, N m] drives the object."""
    return f"which leaves the object {wrench_words(-np.asarray(missing) * swarm.scale)}"


def weather_words(scenario: Scenario, load: ArrayLike, tell: Telling) -> str:
    """Say in which weather a load acts: the file's wind and current, if the load is theirs."""
    environment = scenario.environment
    if environment is None or not environment.exerts(scenario.swarm.outline, load):
        return THE_LOAD
    wind, current = environment.wind, environment.current
    speed, bearing = wind.speed or 0.0, wind.bearing or 0.0
    said = [f"{tell.speed(speed)} {tell.from_words(bearing)}"] if speed else []
    if current is not None and current.speed:
        from_ = bearing if current.bearing is None else current.bearing
        said.append(f"a current of {tell.speed(current.speed)} {tell.from_words(from_)}")
    if environment.waves is not None:
        said.append(_sea_words(environment.waves, bearing, tell))
    more = f", loads times {environment.dynamic_factor:g}" * (environment.dynamic_factor != 1.0)
    return f"in {list_words(said)}{more}" if said else THE_LOAD


def weather_of(scenario: Scenario, terms: Terms) -> str:
    """Say in which weather the load of a scenario acts."""
    return weather_words(scenario, scenario.criterion.load, telling_of(terms, scenario.swarm, []))


def _sea_words(waves: Waves, wind_bearing: float, tell: Telling) -> str:
    """Say which sea it is."""
    way = tell.from_words(wind_bearing if waves.bearing is None else waves.bearing)
    if waves.height is None or waves.period is None:
        return f"the sea of that wind {way}"
    return f"a sea of {tell.length.short(waves.height)} and {waves.period:.3g} s {way}"
