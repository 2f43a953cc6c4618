"""What an answer says of itself is true."""

import numpy as np
import pytest

import reference
from swarmgrasp import Newcomer, Outline, Polytope, Robot, Swarm, Zone, place, quality
from swarmgrasp.scenario import load_example
from swarmgrasp.words import Unit

KN = Unit(1e3, "kN", figures=4)


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
    assert f"the quality is {KN.text(answer.quality_before)}" in before
    assert "weakest at turning to port while moving to starboard, set by Castor and Dione" in before
    swarm = answer.swarm_after
    there = reference.support(swarm.scaled_generators, np.array(answer.before.normal))[0]
    assert gain.startswith("Fortuna at port aft pads, (-12.19, 10.97) m, its force towards -112.9")
    assert f"raises that to {KN.text(there)}, and the quality to " in gain
    assert f"{KN.text(answer.quality)} (+108 %)" in gain
    assert "now weakest at turning to starboard while moving to starboard" in now
    assert setters.startswith("Castor and Fortuna set this limit")


def test_the_runner_up_and_the_bound(answer):
    """Where the best other place is, what it would give, and what nothing exceeds."""
    *_, runner, bound = answer.explanation.splitlines()
    best = answer.runners_up[0]
    assert runner.startswith(f"The runner-up at {best.place}, ")
    assert f"would give {KN.text(best.quality)}, 97.5 % of it." in runner
    assert f"No allowed place gives more than {KN.text(answer.upper_bound)}" in bound


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


def test_a_reason_beside_a_load_does_not_ask_for_force_closure():
    """Three robots can surround a load that one more opposes, so that four are not needed."""
    barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    pads = [Robot((-20, -10), np.pi / 2, 100.0), Robot((20, -10), np.pi / 2, 100.0)]
    load = (0.0, -50.0, 0.0)
    answer = place(
        Swarm(barge, pads),
        Newcomer(100.0, "push", 0.0),
        [Zone(barge.stretch(0), directions=(np.pi / 2, np.pi / 2))],
        load=load,
    )
    assert (answer.quality, answer.reason) == (
        0.0,
        "no allowed robot gives the swarm force closure beside the load",
    )
    assert place(Swarm(barge, pads[:1]), Newcomer(100.0), load=load).reason == (
        "holding a load takes at least 3 robots, wherever they are; with this one there are 2"
    )
    assert place(Swarm(barge, []), Newcomer(100.0), losing=1).reason == (
        "force closure takes at least 4 robots beside the 1 lost; with this one there is 1"
    )


def test_three_robots_hold_a_load_with_a_margin():
    """What the reason says of three is so: their wrenches surround none beside the load."""
    disc = Outline([(np.cos(t), np.sin(t)) for t in np.arange(12) * np.pi / 6])
    pulls = [Robot((np.cos(t), np.sin(t)), t + 0.3, 1.0) for t in np.arange(3) * 2 * np.pi / 3]
    swarm = Swarm(disc, pulls, characteristic_length=1.0)
    assert quality(swarm).value == 0.0
    half = -0.5 * swarm.generators.sum(axis=0)
    assert quality(swarm, load=half).value > 0.1


def test_of_a_task_the_wrench_is_told_and_not_the_normal():
    """Straight ahead is limited where the robots turn the object; the task asks for no turn."""
    barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    spots = [((-40, 4), 0.0), ((-40, -8), 0.0), ((0, -10), np.pi / 2), ((3, 10), -np.pi / 2)]
    swarm = Swarm(barge, [Robot(contact, angle, 100.0) for contact, angle in spots])
    task = Polytope([(1000.0, 0.0, 0.0)])
    found = quality(swarm, task=task)
    assert abs(found.direction[2]) > 0.9
    assert found.weakest_words == "moving ahead"
    answer = place(swarm, Newcomer(100.0, "push", 1.0), task=task)
    assert answer.reason == "what remains weakest is moving ahead"
    assert "turning" not in answer.explanation
