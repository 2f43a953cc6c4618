"""The place of a newcomer beside robots whose sectors have gaps between (T28).

What a swarm reaches then is a union over choices of sectors. Placed beside the robots with their
gaps filled, no place is better than the bound found, whatever they choose: it proves the answer.
The answer itself keeps one choice: the place that is best beside it, and the choice that is best
with that place, in turn until neither changes.
"""

from collections.abc import Callable
from dataclasses import replace

from swarmgrasp.placement.answer import Placement
from swarmgrasp.placement.problem import Problem
from swarmgrasp.quality.max_transfer import best_choice, quality
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm.choices import Choice

TURNS = 8
"""Times that place and choice are found in turn, at most."""
RISE = 1e-9
"""Relative gain that is none."""


def beside_gaps(problem: Problem, place_on: Callable[[Problem], Placement]) -> Placement:
    """Find a good place of the newcomer, and a bound for all of them.

    Parameters
    ----------
    problem : Problem
        Of a swarm in which robots have gaps between their sectors.
    place_on : callable
        Places the newcomer where none has.
    """
    swarm, keywords = problem.swarm, problem.criterion.keywords

    def beside(choice: Choice) -> Placement:
        """Place the newcomer beside robots that keep their sectors."""
        kept = {swarm.index(name): sector for name, sector in choice.sectors.items()}
        return place_on(problem.with_swarm(swarm.choosing(kept)))

    held, choice, _ = best_choice(swarm, problem.criterion)
    now = quality(held, **keywords)
    filled = place_on(problem.with_swarm(swarm.filled))
    choice_before = choice
    best = beside(choice)
    robots = [best.robot, filled.robot]
    for _ in range(TURNS):
        if not robots:
            break
        _, other, _ = best_choice(swarm.with_robot(robots.pop(0)), problem.criterion)
        if other.sectors == choice.sectors:
            continue
        found = beside(other)
        if found.quality > best.quality * (1.0 + RISE):
            best, choice, robots = found, other, [found.robot, *robots]
    x, y, z = now.direction.tolist()
    gain = best.quality - now.value * (1.0 + RISE)
    upper_bound = max(filled.upper_bound, best.quality)
    return replace(
        best,
        problem=problem,
        before=Weakest(now.value, (x, y, z)),
        upper_bound=upper_bound,
        stopped_early=filled.stopped_early or upper_bound > best.quality * (1.0 + best.asked_gap),
        improves=best.improves and gain > best.noise,
        choice_before=choice_before,
        choice=choice,
        _found=filled._found,
        _held=best,
    )
