"""What a newcomer knows of the robots that are there, and where it goes by that."""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from swarmgrasp.agents.knowledge.cases import FREE, STEER, Case, Generator
from swarmgrasp.outline import Stretch
from swarmgrasp.placement import place
from swarmgrasp.quality import Criterion
from swarmgrasp.summary import Summary
from swarmgrasp.swarm import Robot, Swarm, Tolerance

GAP = 1e-6
"""Relative gap of a decision to the best by its belief."""
ALL = "everything"
SIGHT = "by sight only"
WORST = "by sight, for the worst"
NOTHING = "nothing"
EVEN = "their number, as if evenly spread"
RANDOM = "a place at random"
BINS = (1024, 128, 12)
LOST = (10, 30, 50, 70, 90)
"""In percent."""
NEAREST = (8, 4, 2)

Belief = Swarm | Summary | None
Known = Callable[[Case, Swarm, Generator], Belief]
"""Gives what a newcomer believes of the robots that are there; None if it does not ask."""


def summary_of(bins: int) -> str:
    """Name what a summary tells."""
    return f"a summary of {bins} bins"


def lost(percent: int) -> str:
    """Name what is left when records get lost."""
    return f"each record lost with {percent} %"


def nearest(count: int) -> str:
    """Name what those nearest tell."""
    return f"the {count} nearest robots"


def _everything(_: Case, swarm: Swarm, __: Generator) -> Swarm:
    return swarm


def _nothing(_: Case, swarm: Swarm, __: Generator) -> Swarm:
    return swarm.without_rows(range(len(swarm)))


def _at_random(_: Case, __: Swarm, ___: Generator) -> None:
    return None


def _summary_of(bins: int) -> Known:
    return lambda _, swarm, __: Summary.of(swarm, bins)


def _lost(percent: int) -> Known:
    def known(_: Case, swarm: Swarm, draws: Generator) -> Swarm:
        """Leave each robot out with a probability."""
        is_lost = draws.random(len(swarm)) < 0.01 * percent
        return swarm.without_rows(np.flatnonzero(is_lost).tolist())

    return known


def _nearest(count: int) -> Known:
    def known(_: Case, swarm: Swarm, draws: Generator) -> Swarm:
        """Keep the robots nearest, around the object, to where the newcomer has come to it."""
        outline = swarm.outline
        apart = np.abs(outline.nearest(swarm.contacts)[1] - draws.random() * outline.perimeter)
        order = np.argsort(np.minimum(apart, outline.perimeter - apart), kind="stable")
        return swarm.without_rows(order[count:].tolist())

    return known


def _sight(case: Case, swarm: Swarm, _: Generator) -> Swarm:
    """Take all robots for such as push along the normals, or about them if they steer."""
    outline = swarm.outline
    contacts = [outline.at_arc_length(float(arc)) for arc in outline.nearest(swarm.contacts)[1]]
    half = case.newcomer.half_angle
    steers = half if case.newcomer.steers and half is not None else 0.0
    robots = [
        Robot(tuple(p), c.inward, steers=steers)
        for p, c in zip(swarm.contacts.tolist(), contacts, strict=True)
    ]
    return Swarm(outline, robots)


def _for_the_worst(case: Case, swarm: Swarm, draws: Generator) -> Swarm:
    """Take each robot to push in any direction that it may."""
    half = case.newcomer.half_angle or math.pi
    return _sight(case, swarm, draws).with_tolerance(Tolerance(direction=half))


def _evenly(case: Case, swarm: Swarm, _: Generator) -> Swarm:
    """Take as many robots to push along the normals, at equal distances."""
    outline, count = swarm.outline, len(swarm)
    contacts = [outline.at_arc_length(outline.perimeter * (k + 0.5) / count) for k in range(count)]
    there = Swarm(outline, [Robot(c.point, c.inward) for c in contacts])
    return _sight(case, there, _)


KNOWN: Mapping[str, Known] = MappingProxyType(
    {
        ALL: _everything,
        **{summary_of(bins): _summary_of(bins) for bins in BINS},
        **{lost(percent): _lost(percent) for percent in LOST},
        **{nearest(count): _nearest(count) for count in NEAREST},
        SIGHT: _sight,
        WORST: _for_the_worst,
        NOTHING: _nothing,
        EVEN: _evenly,
        RANDOM: _at_random,
    }
)
"""All that a newcomer may know, by name, from most to least."""


def known_in(case: Case) -> tuple[str, ...]:
    """Return what is asked of a case.

    Beside a summary places are known how to find of newcomers that push along one ray. Who steers
    has no direction to be seen or not, and of who pushes in any direction nothing is left in the
    worst.
    """
    left_out = {STEER: {*map(summary_of, BINS), WORST}, FREE: {WORST}}.get(case.kind, set())
    return tuple(name for name in KNOWN if name not in left_out)


def decide(
    case: Case, name: str, swarm: Swarm, taken: tuple[Stretch, ...], draws: Generator
) -> tuple[Robot, Belief]:
    """Return where a newcomer goes by what it knows of a swarm, and what it believes.

    What is taken is seen, whatever it knows. The belief is None where it does not decide by the
    support function of one.
    """
    belief = KNOWN[name](case, swarm, draws)
    if belief is None:
        return case.at_random(swarm, taken, draws), None
    if isinstance(belief, Summary):
        return belief.place(swarm.outline, case.newcomer, no_go=taken).robot, belief
    question = case.question(belief, taken)
    if name == WORST:
        return place(replace(question, criterion=Criterion(worst_case=True)), gap=GAP).robot, None
    return place(question, gap=GAP).robot, belief
