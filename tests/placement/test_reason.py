"""What an answer says of itself is true."""

import numpy as np
import pytest

import reference
from swarmgrasp import Newcomer, Outline, Robot, Swarm, Zone, place
from swarmgrasp.quality.words import force_words
from swarmgrasp.scenario import load_example


@pytest.fixture(scope="module")
def answer():
    """Return the answer for the deck barge's sixth tug, with runners-up."""
    barge = load_example("deck-barge")
    swarm, newcomer = barge.swarm, barge.newcomer
    return place(
        swarm, newcomer, barge.zones, no_go=barge.no_go, spacing=barge.spacing, runners_up=0.5
    )


def test_what_the_newcomer_adds(answer):
    """Before and after, and what the old weakest direction has with it."""
    before, gain, now, setters, *_ = answer.explanation.splitlines()
    assert f"the quality is {force_words(answer.quality_before)}" in before
    assert "weakest at turning to port while moving to starboard, set by Castor and Dione" in before
    swarm = answer.swarm_after
    there = reference.support(swarm.scaled_generators, np.array(answer.before.normal))[0]
    assert gain.startswith("Fortuna at port aft pads, (-12.19, 10.97) m, its force towards -112.9")
    assert f"raises that to {force_words(there)}, and the quality to " in gain
    assert f"{force_words(answer.quality)} (+108 %)" in gain
    assert "now weakest at turning to starboard while moving to starboard" in now
    assert setters.startswith("Castor and Fortuna set this limit")


def test_the_runner_up_and_the_bound(answer):
    """Where the best other place is, what it would give, and what nothing exceeds."""
    *_, runner, bound = answer.explanation.splitlines()
    best = answer.runners_up[0]
    assert runner.startswith(f"The runner-up at {best.place}, ")
    assert f"would give {force_words(best.quality)}, 97.5 % of it." in runner
    assert f"No allowed place gives more than {force_words(answer.upper_bound)}" in bound


def test_a_newcomer_that_cannot_help():
    """The reason, the place that prepares best, and no other place than the one allowed."""
    square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)], edge_names=["s", "e", "n", "w"])
    swarm = Swarm(square, [Robot((1, 0), 0.0), Robot((-1, 0), 3.0)])
    said = place(swarm, Newcomer(), [Zone(square.stretch("n"))]).explanation
    assert said.startswith("Without the newcomer the quality is 0: at ")
    assert "No allowed place for the newcomer raises that: force closure takes at least 4" in said
    assert "The newcomer at n, (" in said
    assert "prepares best for the next robot." in said
    assert "There is no other place for the newcomer." in said
    assert said.endswith("No allowed place gives any: that is proven.")


def test_an_answer_to_a_criterion():
    """The condition is told, and who is lost."""
    barge = load_example("deck-barge")
    found = place(barge.swarm, barge.newcomer, barge.zones, losing=1)
    assert "Without Fortuna, after the worst loss of 1 robot, the quality is 0" in found.explanation
    assert "The worst loss is that of " in found.explanation
