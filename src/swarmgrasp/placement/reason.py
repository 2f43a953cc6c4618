"""Why an answer is what it is, in words."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.explain import (
    FIGURES,
    crew_words,
    limit_sentences,
    loss_sentences,
)
from swarmgrasp.quality.max_transfer import Quality, quality
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm.sectors import sector_words
from swarmgrasp.telling import Telling
from swarmgrasp.terms import SI, Terms
from swarmgrasp.words import Unit, degrees, list_words, percent

if TYPE_CHECKING:
    from swarmgrasp.placement.answer import Placement
    from swarmgrasp.swarm import Robot, Swarm

EQUAL = 1e-6
"""Relative difference of two opposite sides that are equally weak."""
PROVEN = 1e-12
"""Relative gap below which bound and answer count as equal."""
SAME = 1e-3
"""Relative difference of two qualities that is not worth telling."""
ALL_OF_IT = 0.9995
"""Share from which on a runner-up gives as much."""


def reason_of(answer: "Placement", terms: Terms = SI) -> str:
    """Say what limits the swarm with its new robot, or why no newcomer improves it."""
    robot, swarm, criterion = terms.robot, answer.problem.swarm, answer.problem.criterion
    if answer.improves:
        return f"what remains weakest is {_weakest(answer, answer.after)}"
    if len(swarm) + 1 < answer.problem.fewest:
        return too_few_words(
            answer.problem.fewest, criterion.losing, len(swarm) + 1, "this one", terms
        )
    weakest = _weakest(answer, answer.before)
    before = answer.before.quality
    if before * (1.0 + EQUAL) < answer.upper_bound <= before + answer.noise:
        return (
            f"no allowed {robot} raises what is weakest, {weakest}, by more than rounding in the "
            f"outline's coordinates may make of none, {_noise(answer, terms)}"
        )
    is_one_way = answer.problem.newcomer.reverse_limit == 0.0
    if is_one_way and before > 0.0 and answer.opposite <= before * (1.0 + EQUAL):
        opposite = "the opposite way"
        if criterion.task is not None:
            opposite = f"at {criterion.weakest_words(swarm, -np.array(answer.before.normal))}"
        return (
            f"the swarm is equally weak at {weakest} and {opposite}, and one "
            f"{robot} can push only one way: place two, or one that reverses"
        )
    if answer.is_open:
        return (
            f"no allowed {robot} was found that raises what is weakest, {weakest}; whether there "
            "is one is not settled: ask for a smaller gap, or place several"
        )
    if criterion.has_load and answer.quality == 0.0:
        return f"no allowed {robot} gives the swarm force closure beside the load"
    return (
        f"no allowed {robot} raises what is weakest, {weakest}, without another direction "
        "staying as weak: allow more places or directions, or place several"
    )


def too_few_words(fewest: int, lost: int, robots: int, last: str, terms: Terms = SI) -> str:
    """Say that so many robots, the last ones included, are too few for any quality.

    Parameters
    ----------
    fewest, lost : int
        Robots that it takes, and those of them that may be lost.
    robots : int
    last : str
    terms : Terms

    Examples
    --------
    >>> too_few_words(4, 0, 3, "this one")
    'force closure takes at least 4 robots, wherever they are; with this one there are 3'
    >>> too_few_words(4, 1, 1, "this one")
    'holding a load takes at least 3 robots beside the 1 lost; with this one there is 1'
    """
    left = fewest - lost
    takes = f"{_TAKES[left]} takes at least {terms.robots(left)}"
    where = f" beside the {lost} lost" if lost else ", wherever they are"
    return f"{takes}{where}; with {last} there {'are' if robots > 1 else 'is'} {robots}"


_TAKES = {4: "force closure", 3: "holding a load", 2: "force closure", 1: "a task"}
"""What takes so many robots."""


def explain_placement(answer: "Placement") -> str:
    """Say what limited the swarm, what the newcomer adds, and what limits it now.

    Also what the runner-up would give, and how near the answer is to its bound.

    Parameters
    ----------
    answer : Placement

    Returns
    -------
    str
        A sentence per line.
    """
    if answer._held is not None and answer.choice is not None:
        kept = [f"{name} in {sector_words(s)}" for name, s in answer.choice.sectors.items()]
        most = _value(answer.upper_bound, answer)
        return "\n".join([
            f"As long as robots keep to sectors, {list_words(kept)}, the following holds.",
            explain_placement(answer._held),
            f"If they change between sectors, no allowed place gives more than {most}: that is "
            "proven with the gaps filled.",
        ])  # fmt: skip
    after = _quality_of(answer.swarm_after, answer.after, answer)
    said = [_before(answer), *_gain(answer)]
    if answer.improves:
        said += limit_sentences(after, answer.swarm_after, _unit(answer), now=" now")
        said += loss_sentences(after)
    return "\n".join([*said, _runner_up(answer), _bound(answer)])


def _quality_of(swarm: "Swarm", found: Weakest, answer: "Placement") -> Quality:
    """Return a quality that the search found."""
    value = found.quality
    return Quality(
        value, value, value, np.array(found.normal), answer.problem.criterion, None, swarm, swarm,
        None,
    )  # fmt: skip


def _weakest(answer: "Placement", found: Weakest) -> str:
    """Say which wrench is reached least."""
    return answer.problem.criterion.weakest_words(answer.problem.swarm, found.normal)


def _value(value: float, answer: "Placement") -> str:
    """Say a quality, in the one unit of all of them."""
    return _unit(answer).text(value)


def _noise(answer: "Placement", terms: Terms) -> str:
    """Say in some terms what rounding in the outline's coordinates may change of a quality."""
    if answer.problem.criterion.task is not None:
        return _value(answer.noise, answer)
    limits = answer.swarm_after.limits.tolist()
    return Telling.of(terms, answer.problem.swarm.outline.extent, limits).force.text(answer.noise)


def _unit(answer: "Placement") -> Unit:
    """Return the unit of the qualities of an answer."""
    return answer.problem.criterion.unit(answer.upper_bound or answer.noise, figures=FIGURES)


def _before(answer: "Placement") -> str:
    """Say how the swarm was, and who set that."""
    swarm, criterion = answer.problem.swarm, answer.problem.criterion
    if not len(swarm):
        return "There are no robots yet."
    words = criterion.words(swarm)
    without = f"Without {_name(answer)}{f', {words},' if words else ''} the quality is"
    way = _weakest(answer, answer.before)
    if answer.quality_before == 0.0:
        margin = quality(swarm, **replace(criterion, task=None).keywords).margin
        if margin < 0.0:
            short = Unit.for_size(margin, figures=FIGURES).text(-margin)
            return f"{without} 0: the swarm is {short} short of holding the load."
        return f"{without} 0: at {way} the swarm exerts nothing."
    setters = _quality_of(swarm, answer.before, answer).facet_robots
    by = f", set by {crew_words(setters)}" if len(setters) > 1 else ""
    value = _value(answer.quality_before, answer)
    return f"{without} {value}: the swarm is weakest at {way}{by}."


def _gain(answer: "Placement") -> list[str]:
    """Say what the newcomer adds, or why it adds nothing."""
    name, turn = _name(answer), degrees(answer.robot.direction)
    robot = f"{_start(name)}{_at(answer.place, answer.robot)}, its force towards {turn} deg,"
    if not answer.improves:
        return [
            f"No allowed place for {name} raises that: {answer.reason}.",
            f"{robot} prepares best for the next robot.",
        ]
    before, after = answer.quality_before, answer.quality
    there, criterion = math.inf, answer.problem.criterion
    if criterion.task is None:  # of a task the same wrench may limit it at another normal
        aim = Aim(answer.swarm_after, criterion)
        there = float(aim.values(np.array([answer.before.normal]))[0])
    more = f" (+{percent(after / before - 1.0)})" if before > 0.0 else ""
    found = f"{_value(after, answer)}{more}"
    if math.isfinite(there) and there > after * (1.0 + SAME):
        return [f"{robot} raises that to {_value(there, answer)}, and the quality to {found}."]
    return [f"{robot} raises that to {found}."]


def _runner_up(answer: "Placement") -> str:
    """Say what the best other place would give."""
    if answer.runners_up:
        runner = answer.runners_up[0]
        share = runner.quality / answer.quality if answer.quality else 1.0
        said = f"The runner-up{_at(runner.place, runner.robot)}, would give"
        value = _value(runner.quality, answer)
        if share >= ALL_OF_IT:
            return f"{said} as much, {value}."
        return f"{said} {value}, {percent(share)} of it."
    if len(set(answer.problem.places().places)) == 1:
        return f"There is no other place for {_name(answer)}."
    return "There is no runner-up: none was asked for, or none comes near enough."


def _at(place: str, robot: "Robot") -> str:
    """Say where a robot is."""
    x, y = robot.contact
    return f" at {place}, ({x:.4g}, {y:.4g}) m"


def _bound(answer: "Placement") -> str:
    """Say how near the answer is to what is proven."""
    early = " The search stopped before it came as near as asked." if answer.stopped_early else ""
    if answer.quality == 0.0 and not answer.stopped_early:
        return "No allowed place gives any: that is proven."
    if answer.gap <= PROVEN:
        return f"No allowed place is better: that is proven.{early}"
    above = f", {percent(answer.gap)} above" if answer.quality else ""
    most = f"{_value(answer.upper_bound, answer)}{above}"
    return f"No allowed place gives more than {most}: that is proven.{early}"


def _name(answer: "Placement") -> str:
    """Return what the newcomer is called inside a sentence."""
    return answer.robot.name if answer.problem.newcomer.name else f"the {answer.robot.name}"


def _start(name: str) -> str:
    """Return a name at the start of a sentence."""
    return name[0].upper() + name[1:] if name.startswith("the ") else name
