"""Gains that rounding may make, and zeros that are exact."""

import math

import numpy as np
import pytest

from cases import rounded_tank
from swarmgrasp import (
    Newcomer,
    Outline,
    Polytope,
    Problem,
    Robot,
    Stretch,
    Swarm,
    Tolerance,
    Zone,
    place,
    place_sequence,
    place_together,
    qualities,
    qualities_with,
    quality,
)
from swarmgrasp.answer_file import document_of
from swarmgrasp.verify import verify_document
from swarmgrasp.verify.digest import digest_of

PUSHING = Newcomer(limit=392_266.0, attachment="push", half_angle=math.radians(40.0))
TURNS = Polytope([(0, 0, 1e6), (0, 0, -1e6), (1e5, 0, 0), (-1e5, 0, 0), (0, 1e5, 0), (0, -1e5, 0)])


def forged(document, **claims):
    """Return a document with other claims, and a digest that fits."""
    document["placements"][0] |= claims
    del document["digest"]
    return {**document, "digest": digest_of(document)}


@pytest.mark.parametrize("terms", [{}, {"task": TURNS}])
@pytest.mark.parametrize(("corners", "decimals"), [(36, 3), (360, 6)])
def test_a_gain_that_rounding_may_make_is_none(corners, decimals, terms):
    """The newcomer goes where the tie-break has it, and the reason says why."""
    tank = rounded_tank(corners, 5, decimals)
    answer = place(tank, PUSHING, spacing=8.0, **terms)
    assert answer.quality - answer.quality_before <= answer.noise
    assert answer.upper_bound <= answer.quality_before + answer.noise
    claims = (answer.improves, answer.stopped_early, answer.is_open)
    assert claims == (False, False, False)
    assert "by more than rounding in the outline's coordinates may make" in answer.reason
    assert answer.verify()
    document = document_of(answer)
    said = "the newcomer is said to improve the swarm, and does not"
    assert said in verify_document(forged(document, improves=True)).faults


def test_ties_up_to_rounding_are_broken_as_those_of_the_exact_outline():
    """What the sixth decimal gains is not what decides."""
    rounded, exact = (
        place(rounded_tank(360, 5, decimals), PUSHING, spacing=8.0) for decimals in (6, 15)
    )
    assert exact.quality == exact.upper_bound == 0.0
    np.testing.assert_allclose(rounded.robot.contact, exact.robot.contact, atol=0.3)
    assert math.remainder(rounded.robot.direction - exact.robot.direction, math.tau) < 0.1


def test_a_gain_above_rounding_counts():
    """Tugs that turn a tank to one side, and one that turns it to the other."""
    tank = rounded_tank(360, 5, 6)
    robots = [Robot(r.contact, r.direction + 0.1, r.limit) for r in tank.robots]
    answer = place(Swarm(tank.outline, [*tank.robots, *robots]), PUSHING)
    assert answer.improves
    assert 0.0 < answer.noise < 1e-3 * answer.quality
    assert answer.verify()
    claimed = document_of(answer)
    assert verify_document(forged(claimed, improves=False)).faults == (
        "the newcomer is said not to improve the swarm, and does",
    )


def test_several_that_gain_by_rounding_gain_nothing():
    """One after the other, and together."""
    tank = rounded_tank(360, 5, 6)
    arcs = tank.outline.corner_arc_lengths[:-1] + 0.5 * tank.outline.lengths
    zones = tuple(Zone(Stretch(arc, arc, f"pad {arc:.1f}")) for arc in arcs[5::40].tolist())
    problem = Problem(tank, Newcomer(392_266.0, "push", 0.0), zones)
    first, second = place_sequence(problem, 2)
    assert not first.improves
    assert not second.improves
    assert not place_together(problem, 1).improves


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("count", range(4))
def test_fewer_than_four_robots_have_none_by_any_path(seed, count):
    """Exactly 0, bounds included: not what rounding leaves of it."""
    rng = np.random.default_rng(seed)
    outline = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    contacts = [outline.at_arc_length(s) for s in rng.uniform(0.0, outline.perimeter, count)]
    sure = Tolerance(direction=0.05)
    robots = [
        Robot(at.point, at.inward + turn, 10.0**power, tolerance=sure)
        for at, turn, power in zip(contacts, (0.0, 0.3, 0.0), (5.0, 5.6, 3.0), strict=False)
    ]
    swarm = Swarm(outline, robots)
    generators = swarm.scaled_generators
    found = [quality(swarm), quality(swarm, losing=1), quality(swarm, worst_case=True)]
    assert [(one.value, str(one.force_closure)) for one in found] == [(0.0, "no")] * 3
    assert not count or not qualities([generators, generators]).any()
    for terms in [{"losing": 1}] if count == 3 else [{}, {"losing": 1}, {"worst_case": True}]:
        answer = place(swarm, PUSHING, **terms)
        assert answer.quality == answer.upper_bound == answer.quality_before == 0.0
        assert answer.verify()
    if count < 3:
        spots = [outline.at_arc_length(s).point for s in (3.0, 90.0, 170.0)]
        assert not qualities_with(swarm, spots, [1.0, 2.0, 3.0], limits=4e5).any()
