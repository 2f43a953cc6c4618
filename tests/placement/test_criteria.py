"""Placement by criteria: optimal for what is asked, whatever that is."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from strategies import seeds, swarm_of
from swarmgrasp import (
    Criterion,
    Ellipsoid,
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
    qualities_with,
    quality,
)
from swarmgrasp.errors import CriterionInvalid, ZoneInvalid

TASK = Polytope([(1.0, 0.2, 0.0), (-0.3, 0.6, 0.2), (0.0, -0.5, -0.4)])
CRITERIA = (
    {"losing": 1},
    {"losing": 2},
    {"load": (0.2, -0.1, 0.1)},
    {"task": TASK},
    {"task": Ellipsoid([(1.0, 0.0, 0.0), (0.0, 0.4, 0.1)]), "losing": 1},
    {"load": (0.1, 0.1, 0.0), "losing": 1, "task": TASK},
    {"worst_case": True},
    {"worst_case": True, "losing": 1},
)
FAMILIES = ("free", "along normals", "integer grid", "duplicated", "ring", "notched")
SPREAD = Tolerance(contact=0.15, direction=0.1, least_limit=0.9)


def random_robots(rng, swarm, newcomer, count):
    """Yield robots at random allowed places."""
    for at in rng.uniform(0.0, swarm.outline.perimeter, count):
        contact = swarm.outline.at_arc_length(at)
        middle = contact.inward + (math.pi if newcomer.attachment == "pull" else 0.0)
        angle = middle + rng.uniform(-1.0, 1.0) * newcomer.half_angle
        yield Robot(contact.point, angle, newcomer.limit, tolerance=newcomer.tolerance)


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(FAMILIES), seeds, st.integers(4, 12), st.sampled_from(CRITERIA))
def test_no_sample_beats_the_bound(family, seed, n, terms):
    """The answer has the quality it states, its bound is near, and no robot tried exceeds it."""
    rng = np.random.default_rng(seed)
    swarm = swarm_of(family, seed, n)
    if "worst_case" in terms:
        swarm = swarm.with_tolerance(SPREAD)
    newcomer = Newcomer(1.0, str(rng.choice(["push", "pull"])), 0.8)
    answer = place(swarm, newcomer, **terms)
    slack = 1e-9 * answer.quality + 1e-11
    found = quality(answer.swarm_after, **terms)
    assert found.value == pytest.approx(answer.quality, abs=slack)
    assert answer.quality_before == pytest.approx(quality(swarm, **terms).value, abs=slack)
    assert not answer.stopped_early
    assert answer.upper_bound <= answer.quality * (1.0 + 2e-6) + 1e-10
    for robot in random_robots(rng, swarm, newcomer, 12):
        assert quality(swarm.with_robot(robot), **terms).value <= answer.upper_bound + slack


@settings(max_examples=12, deadline=None)
@given(seeds, st.integers(5, 10), st.sampled_from([(0.3, 0.0), (0.0, 0.2), (0.4, 0.15)]))
def test_a_newcomer_that_misses_its_place(seed, n, spread):
    """Aiming elsewhere is no better in the worst case; the bound holds and is near."""
    rng = np.random.default_rng(seed)
    swarm = swarm_of("free", seed, n)
    contact, direction = spread
    newcomer = Newcomer(1.0, "push", 1.0, tolerance=Tolerance(contact, direction))
    answer = place(swarm, newcomer, worst_case=True, gap=1e-4)
    assert answer.robot.tolerance == newcomer.tolerance
    after = quality(answer.swarm_after, worst_case=True)
    assert after.value == pytest.approx(answer.quality, rel=1e-9, abs=1e-12)
    assert not answer.stopped_early
    assert answer.upper_bound <= (1.0 + 2e-4) * answer.quality + 1e-10
    assert answer.upper_bound <= place(swarm, newcomer).quality * (1.0 + 2e-6) + 1e-10
    for robot in random_robots(rng, swarm, newcomer, 25):
        value = quality(swarm.with_robot(robot), worst_case=True).value
        assert value <= answer.upper_bound * (1.0 + 1e-6) + 1e-11


def test_losing_one_asks_for_another_place_than_losing_none():
    """A swarm placed for the loss of one is better after a loss, and no better without."""
    swarm = swarm_of("free", 4, 10)
    newcomer = Newcomer(1.0, "push", 0.8)
    careful, bold = place(swarm, newcomer, losing=1), place(swarm, newcomer)
    assert careful.quality > quality(bold.swarm_after, losing=1).value * (1.0 + 1e-6)
    assert bold.quality > quality(careful.swarm_after).value * (1.0 + 1e-6)


def test_no_newcomer_exceeds_what_one_loss_less_leaves():
    """With k lost, one robot more is worth at most what k - 1 lost leave without it."""
    swarm = swarm_of("free", 5, 10)
    newcomer = Newcomer(1e6, "free")
    for losing in (1, 2):
        answer = place(swarm, newcomer, losing=losing)
        assert answer.quality <= quality(swarm, losing=losing - 1).value * (1.0 + 1e-12)
        assert answer.quality == pytest.approx(answer.upper_bound, rel=2e-6)


def test_one_after_the_other_and_runners_up():
    """A sequence goes on by the same criterion; other places are no better."""
    swarm = swarm_of("free", 9, 8)
    problem = Problem(swarm, Newcomer(1.0, "push", 0.5), criterion=Criterion(losing=1))
    first, second = place_sequence(problem, 2, runners_up=0.5)
    assert second.problem.swarm is first.swarm_after
    after = quality(second.swarm_after, losing=1).value
    assert second.quality == pytest.approx(after, rel=1e-9)
    assert first.quality >= max((r.quality for r in first.runners_up), default=0.0)


def test_a_bollard_for_a_tolerant_newcomer():
    """A point is a place too; the contact then lies around it, across the corner."""
    square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    pulls = [((1, -0.4), 0.0), ((-1, 0.4), math.pi), ((-0.4, 1), math.pi / 2), ((0.4, -1), -1.4)]
    swarm = Swarm(square, [Robot(c, a) for c, a in pulls], characteristic_length=1.0)
    zones = (Zone(Stretch(0.0, 0.0, "corner"), "pull"), Zone(Stretch(3.0, 3.0, "side"), "pull"))
    newcomer = Newcomer(1.0, tolerance=Tolerance(0.2, 0.1))
    answer = place(swarm, newcomer, zones, worst_case=True, runners_up=0.0)
    assert answer.place in ("corner", "side")
    assert {runner.place for runner in answer.runners_up} <= {"corner", "side"} - {answer.place}
    assert answer.quality <= place(swarm, newcomer, zones).upper_bound * (1.0 + 1e-12)


def test_many_newcomers_at_once():
    """The qualities with each of several robots, as if they were placed one at a time."""
    swarm = swarm_of("free", 6, 9)
    contacts = [swarm.outline.at_arc_length(s).point for s in (0.5, 2.0, 3.5)]
    angles = [0.3, 1.2, -2.0]
    found = qualities_with(swarm, contacts, angles, losing=1)
    for contact, angle, value in zip(contacts, angles, found, strict=True):
        together = swarm.with_robot(Robot(contact, angle))
        assert value == pytest.approx(quality(together, losing=1).value, rel=1e-11)


def test_wrong_terms_are_named():
    """A criterion's faults are the criterion's; a newcomer that may be absent is worth nothing."""
    swarm = swarm_of("free", 9, 8)
    with pytest.raises(CriterionInvalid, match="whole number"):
        place(swarm, Newcomer(), losing=1.5)
    with pytest.raises(ZoneInvalid, match="may be absent"):
        place(swarm, Newcomer(tolerance=Tolerance(may_be_absent=True)), worst_case=True)
    with pytest.raises(CriterionInvalid, match="no Criterion"):
        Problem(swarm, Newcomer(), criterion="losing")


def test_a_gain_that_is_not_certain_is_none():
    """Worst cases are certified to 1e-7: less more is no improvement, to search and check alike."""
    barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    amiss = Tolerance(contact=1.0, direction=math.radians(5), least_limit=180e3)
    tugs = [
        Robot((x, y), math.copysign(math.pi / 2, -y), 300e3, steers=math.pi / 6, tolerance=amiss)
        for x, y in ((-30, -10), (30, -10), (-30, 10), (30, 10))
    ]
    answer = place(Swarm(barge, tugs), Newcomer(200e3, "push", math.pi / 6), worst_case=True)
    assert not answer.improves
    assert answer.quality == pytest.approx(answer.quality_before, rel=1e-7)
    assert answer.verify()
