"""Why an answer is what it is, in words."""

from typing import TYPE_CHECKING

from swarmgrasp.quality.words import wrench_words

if TYPE_CHECKING:
    from swarmgrasp.placement.answer import Placement

ROUNDING = 2e-13
"""Of the quality before: a difference that is none."""


def reason_of(answer: "Placement") -> str:
    """Say what limits the swarm with its new robot, or why no newcomer improves it."""
    if answer.improves:
        return f"what remains weakest is {wrench_words(answer.after.normal)}"
    present = len(answer.problem.swarm)
    weakest = wrench_words(answer.before.normal)
    if present < 3:
        return (
            "force closure takes at least 4 robots, wherever they are; with this one there "
            f"{'are' if present else 'is'} {present + 1}"
        )
    before = answer.before.quality
    if before > 0.0 and answer.opposite <= before * (1.0 + answer.tolerance + ROUNDING):
        return (
            f"the swarm is equally weak in {weakest} and in the opposite direction, and one "
            "robot can push only one way: place two"
        )
    return (
        f"no allowed robot raises what is weakest, {weakest}, without another direction "
        "staying as weak: allow more places or directions, or place several"
    )
