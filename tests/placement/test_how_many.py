"""The fewest robots for a required quality: reached, and proven to be the fewest."""

import math

import numpy as np
import pytest

import reference
from swarmgrasp import (
    Criterion,
    Newcomer,
    Outline,
    Problem,
    Robot,
    Swarm,
    how_many,
    place_together,
    quality,
)
from swarmgrasp.errors import NowhereToAttach, SwarmGraspError

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
PULLS = [
    ((1, -0.4), 0.0),
    ((-1, 0.4), math.pi),
    ((-0.4, 1), math.pi / 2),
    ((0.4, -1), -math.pi / 2),
]
FOUR = Swarm(SQUARE, [Robot(*row) for row in PULLS], 1.0)
PULLING = Problem(FOUR, Newcomer(1.0, "pull", 0.0))
RECTANGLE = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])


@pytest.mark.parametrize(
    ("required", "count"),
    [(0.9, 2), (0.9526, None), (1.0, 3), (1.5, 4), (2.0, 4), (2.01, 8), (3.0, 8), (25.0, 96)],
)
def test_beside_the_square(required, count):
    """As the table of docs/together.md has it: 0.9526, 1, 2, 2, 2, 2, 3 with 2 to 8 more."""
    found = how_many(PULLING, required, most=100, effort=20_000)
    if count is None:  # 0.95258 < 0.9526: two are not enough by a hair
        count = 3
    assert found.count == count
    assert found.is_proven
    assert found.at_least == count
    assert found.quality >= required * (1.0 - 1e-9)
    truth = quality(found.swarm_after).value
    assert truth == pytest.approx(found.quality, rel=1e-9)
    fewer = place_together(PULLING, count - 1, effort=500)
    assert fewer.quality < required


def test_the_lower_bound_is_that_of_the_force_plane():
    """No fewer than pi Q, by (T3), and the count found is real."""
    problem = Problem(Swarm(RECTANGLE, []), Newcomer(1.0, "push"))
    found = how_many(problem, 1.5, effort=1500)
    assert found.count >= found.at_least >= math.ceil(math.pi * 1.5)
    assert reference.quality(found.swarm_after.scaled_generators) >= 1.5 * (1.0 - 1e-9)
    assert len(found.answer.robots) == found.count


def test_none_are_needed():
    """The swarm has it already."""
    found = how_many(PULLING, 0.5)
    assert (found.count, found.at_least, found.answer, found.is_proven) == (0, 0, None, True)
    assert found.swarm_after is FOUR
    assert "already" in found.reason


def test_out_of_reach():
    """Five cannot: the bound of so many proves it at once."""
    found = how_many(PULLING, 4.0, most=5)
    assert found.count is None
    assert found.is_proven
    assert found.reason == "5 robots cannot reach it, wherever they attach"
    assert found.quality == found.quality_before


def test_after_a_loss():
    """By the problem's criterion."""
    problem = Problem(FOUR, Newcomer(1.0, "pull", 0.0), criterion=Criterion(losing=1))
    found = how_many(problem, 0.9, effort=10_000)
    assert found.count == 4
    assert found.is_proven
    assert quality(found.swarm_after, losing=1).value >= 0.9


def test_no_room_for_enough():
    """The spacing leaves room to a few only: told, and not taken for a proof."""
    problem = Problem(Swarm(RECTANGLE, []), Newcomer(1.0, "push"), spacing=1.5)
    found = how_many(problem, 3.0, most=12, effort=500)
    assert found.count is None
    assert found.at_least >= 10
    with pytest.raises(NowhereToAttach):
        how_many(Problem(FOUR, Newcomer(), spacing=9.0), 1.0)


def test_all_faults_at_once():
    """In one message."""
    with pytest.raises(SwarmGraspError) as error:
        how_many(FOUR, np.nan, most=2**63, effort=math.inf)
    assert len(error.value.faults) == 4
