"""The worst of uncertain poses, against all corners and against samples."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from strategies import seeds
from swarmgrasp import Newcomer, Outline, Robot, Swarm, Tolerance, quality
from swarmgrasp.errors import RobotInvalid
from swarmgrasp.quality.poses import boundary_parts

BARGE = Outline([(-2.0, -1.0), (2.0, -1.0), (2.0, 1.0), (-2.0, 1.0)])


def swarm_with(rng, n, tolerances):
    """Return n robots at random places, with tolerances in turn."""
    robots = []
    for k, at in enumerate(rng.uniform(0.0, BARGE.perimeter, n)):
        angle = rng.uniform(-math.pi, math.pi)
        given = tolerances[k % len(tolerances)]
        robots.append(Robot(BARGE.at_arc_length(at).point, angle, tolerance=given))
    return Swarm(BARGE, robots, characteristic_length=1.3)


def contacts_within(robot, spread):
    """Return a robot's contact and those at the ends of its interval, and corners in between."""
    at = BARGE.at_point(robot.contact).arc_length
    corners = [k * BARGE.perimeter + c for k in (-1, 0, 1) for c in BARGE.corner_arc_lengths[:4]]
    places = [at - spread, at + spread, *(c for c in corners if abs(c - at) < spread)]
    return [BARGE.at_arc_length(s % BARGE.perimeter).point for s in places]


@settings(max_examples=25, deadline=None)
@given(seeds, st.integers(4, 6), st.sampled_from([0.1, 0.6, 1.5]), st.integers(0, 1))
def test_intervals_of_contacts_are_as_bad_as_their_corners(seed, n, spread, losing):
    """Uncertain contacts, also across corners: all choices of ends and corners are listed."""
    swarm = swarm_with(np.random.default_rng(seed), n, [Tolerance(contact=spread), None])
    corners = []
    for k, robot in enumerate(swarm.robots):
        places = contacts_within(robot, spread) if k % 2 == 0 else [robot.contact]
        corners.append(
            reference.generators(
                places, [robot.direction] * len(places), [1.0] * len(places), (0, 0), swarm.scale
            )
        )
    truth = reference.quality_of_corners(corners, losing)
    found = quality(swarm, worst_case=True, losing=losing)
    assert found.value == pytest.approx(truth, rel=1e-9, abs=1e-11)
    assert found.bound <= found.value <= found.bound * (1.0 + 1e-6) + 1e-11


@settings(max_examples=25, deadline=None)
@given(seeds, st.integers(5, 12), st.sampled_from([0.02, 0.2, 0.7]))
def test_no_sample_is_worse_and_one_is_as_bad(seed, n, turn):
    """Contacts and directions: the worst poses reach the value, and random ones none less."""
    rng = np.random.default_rng(seed)
    spread = Tolerance(contact=(-0.4, 0.1), direction=(-turn, 0.5 * turn), least_limit=0.8)
    swarm = swarm_with(rng, n, [spread, spread, None])
    found = quality(swarm, worst_case=True)
    assert quality(found.worst_swarm).value == pytest.approx(found.value, rel=1e-9, abs=1e-11)
    assert found.value <= quality(swarm).value * (1.0 + 1e-12)
    for _ in range(40):
        robots = []
        for robot in swarm.robots:
            if robot.tolerance is None:
                robots.append(robot)
                continue
            at = BARGE.at_point(robot.contact).arc_length + rng.uniform(-0.4, 0.1)
            point = BARGE.at_arc_length(at % BARGE.perimeter).point
            angle = robot.direction + rng.uniform(-turn, 0.5 * turn)
            robots.append(Robot(point, angle, rng.uniform(0.8, 1.0)))
        sample = quality(Swarm(BARGE, robots, characteristic_length=1.3)).value
        assert sample >= found.bound - 1e-11


def test_the_worst_poses_are_within_their_tolerances():
    """Each of them, and the robots that may be absent are."""
    spread = Tolerance(contact=0.3, direction=0.2, least_limit=0.5)
    swarm = swarm_with(np.random.default_rng(4), 9, [spread, None, Tolerance(may_be_absent=True)])
    worst = quality(swarm, worst_case=True).worst_swarm
    meant = [robot for k, robot in enumerate(swarm.robots) if k % 3 != 2]
    assert len(worst) == len(meant) == 6
    for found, robot in zip(worst.robots, meant, strict=True):
        if robot.tolerance is None:
            assert found.contact == robot.contact
            continue
        moved = BARGE.at_point(found.contact).arc_length - BARGE.at_point(robot.contact).arc_length
        assert abs((moved + 6.0) % 12.0 - 6.0) <= 0.3 + 1e-9
        assert abs(found.direction - robot.direction) <= 0.2 + 1e-12
        assert found.limit == 0.5


def test_without_tolerances_the_worst_case_is_the_nominal_one():
    """And a tolerance of nothing at all is none."""
    plain = swarm_with(np.random.default_rng(1), 10, [None])
    assert quality(plain, worst_case=True).value == pytest.approx(quality(plain).value, rel=1e-12)
    same = plain.with_tolerance(Tolerance())
    assert quality(same, worst_case=True).value == pytest.approx(quality(plain).value, rel=1e-12)


def test_any_direction_is_worth_nothing():
    """Robots that may push any way, or may not be there, hold nothing."""
    crew = swarm_with(np.random.default_rng(2), 12, [None])
    for tolerance in (Tolerance(direction=math.pi), Tolerance(may_be_absent=True)):
        assert quality(crew.with_tolerance(tolerance), worst_case=True).value == 0.0


def test_the_boundary_between_two_arc_lengths():
    """Across corners, across the first vertex, all the way round, and a single point."""
    assert boundary_parts(BARGE, 1.0, 1.5) == [((-1.0, -1.0), (-0.5, -1.0))]
    assert [len(boundary_parts(BARGE, a, b)) for a, b in ((3, 7), (-1, 1), (0.5, 12.5))] == [
        3,
        2,
        5,
    ]
    total = sum(math.dist(p, q) for p, q in boundary_parts(BARGE, -3.0, 9.0))
    assert total == pytest.approx(12.0)
    assert boundary_parts(BARGE, 2.0, 2.0) == [((0.0, -1.0), (0.0, -1.0))]


def test_wrong_tolerances_are_named():
    """All faults of one at once, and those that do not go with the robot or the outline."""
    with pytest.raises(RobotInvalid) as fault:
        Tolerance(contact=-1, direction=(0.1, 0.2), least_limit=0, may_be_absent=1)
    assert len(fault.value.faults) == 4
    for wrong in (4.0, math.nan, "wide", (1, 2, 3)):
        with pytest.raises(RobotInvalid, match="direction tolerance"):
            Tolerance(direction=wrong)
    with pytest.raises(RobotInvalid, match="least limit"):
        Robot((2, 0), 0.0, 1.0, tolerance=Tolerance(least_limit=2.0))
    with pytest.raises(RobotInvalid, match="no Tolerance"):
        Newcomer(tolerance=0.5)
    with pytest.raises(RobotInvalid, match="mounted"):
        Robot((0, 0), 0.0, mounted=True, tolerance=Tolerance(contact=1.0))
    with pytest.raises(RobotInvalid, match="perimeter"):
        Swarm(BARGE, [Robot((2, 0), 0.0, tolerance=Tolerance(contact=7.0))])
