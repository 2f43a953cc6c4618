"""Among equal answers, the one that lets the robots to come do more (T17)."""

import math

import numpy as np
import pytest
from hypothesis import given, settings

from strategies import seeds, swarm_of
from swarmgrasp import Newcomer, Outline, Robot, Swarm, place, place_sequence
from swarmgrasp.placement import Problem

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
PULLS = [
    ((1, -0.4), 0.0),
    ((-1, 0.4), math.pi),
    ((-0.4, 1), math.pi / 2),
    ((0.4, -1), -math.pi / 2),
]
BALANCED = Swarm(SQUARE, [Robot(*row) for row in PULLS], 1.0)


def test_greedy_placement_does_not_stall():
    """Four balanced robots are stuck at 0.6963; eight more reach at least 2.75."""
    answers = place_sequence(Problem(BALANCED, Newcomer(1.0, "pull", 0.0)), 8)
    values = [a.quality for a in answers]
    assert (np.diff(values) >= -1e-12).all()
    assert values[-1] >= 2.75
    assert not answers[0].improves
    assert all(a.verify() for a in answers)


def test_a_swarm_grows_from_nothing():
    """No robot helps below four, yet each is placed so that later ones can."""
    nobody = Swarm(SQUARE, [], 1.0)
    answers = place_sequence(Problem(nobody, Newcomer(1.0, "push", name="tug")), 12)
    assert [a.quality for a in answers[:3]] == [0.0] * 3
    assert answers[11].quality >= 2.0
    assert [a.robot.name for a in answers[:2]] == ["tug 1", "tug 2"]
    assert all(a.verify() for a in answers)


@given(seeds)
@settings(max_examples=25)
def test_a_tie_costs_no_more_than_the_gap(seed):
    """Breaking it never gives quality away, whatever the gap."""
    swarm = swarm_of("balanced", seed, 8)
    newcomer = Newcomer(0.7, "free")
    for gap in (1e-3, 1e-6):
        answer = place(swarm, newcomer, gap=gap)
        total = np.linalg.norm(answer.swarm_after.scaled_generators, axis=1).sum()
        assert answer.upper_bound <= (1.0 + gap) * answer.quality + 4e-12 * total


def test_equal_answers_are_repeatable():
    """The same question has the same answer to the last bit."""
    newcomer = Newcomer(1.0, "pull", 0.0)
    first, again = (place(BALANCED, newcomer).robot for _ in range(2))
    assert first == again


@pytest.mark.parametrize("present", range(5))
def test_a_newcomer_that_cannot_help_is_told_why(present):
    """Too few robots, or a swarm that is as weak one way as the other."""
    swarm = Swarm(SQUARE, BALANCED.robots[:present], 1.0)
    answer = place(swarm, Newcomer(1.0, "pull", 0.0))
    if present == 3:
        assert answer.improves
        assert answer.reason.startswith("what remains weakest is ")
        return
    assert not answer.improves
    assert answer.quality == pytest.approx(answer.quality_before, rel=1e-12)
    says = "takes at least 4 robots" if present < 3 else "equally weak at"
    assert says in answer.reason
    assert answer.verify()
