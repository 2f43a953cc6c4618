"""What robots can exert: hulls of points and arcs, by their support functions."""

import math
import pickle

import numpy as np
import pytest

import swarmgrasp as sg
from swarmgrasp import Outline, Robot, Swarm
from swarmgrasp.errors import ForceSetUnsupported, RobotInvalid
from swarmgrasp.swarm import Newcomer

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
KINDS = {
    "ray": {},
    "segment": {"reverse_limit": 0.7},
    "sector": {"steers": 0.6},
    "half turn": {"steers": math.pi / 2},
    "wide": {"steers": 2.2},
    "azimuth": {"steers": math.pi},
    "both ways": {"steers": 0.4, "reverse_limit": 0.6},
    "stronger astern": {"steers": 0.4, "reverse_limit": 1.9},
    "finger": {"friction": 0.8},
    "taut": {"least": 0.3},
    "taut and steering": {"steers": 0.9, "least": 0.5},
    "taut and round": {"steers": 2.0, "least": 0.5},
    "finger that holds": {"friction": 0.8, "least": 0.4},
    "envelope": {"envelope": [(1.2, 0.0), (0.3, 0.9), (-0.5, 0.1), (0.2, -0.7), (0.3, 0.1)]},
}


def forces_of(robot):
    """Return forces (m, 2) that the robot can exert, its farthest among them, in its own frame."""
    if robot.envelope:
        return np.array(robot.envelope)
    sizes = [robot.limit, robot.least if robot.least else 0.0, -robot.reverse_limit]
    if robot.friction:
        return np.array([(a, side * robot.friction * a) for a in sizes[:2] for side in (-1, 1)])
    turns = np.linspace(-robot.steers, robot.steers, 20001)
    if robot.least:
        sizes = sizes[:2]
    return np.concatenate([np.column_stack([a * np.cos(turns), a * np.sin(turns)]) for a in sizes])


def support_of(elements, p):
    """Return how far the elements are along p whose normal cone holds it."""
    angle, found = math.atan2(p[1], p[0]), []
    for radius, x, y, start, end in elements:
        is_in = (angle - start) % math.tau <= end - start or end - start >= math.tau
        if is_in:
            found.append(radius * math.hypot(*p) if radius else x * p[0] + y * p[1])
    return found


@pytest.mark.parametrize("kind", KINDS)
def test_elements_give_the_support_function(kind):
    """Along any direction one element is the farthest, and it is as far as any force."""
    rng = np.random.default_rng(5)
    for limit in (1.0, 1.7) if kind != "envelope" else (1.0,):
        robot = Robot((1, 0), rng.uniform(-4, 4), limit, **KINDS[kind])
        sets = Swarm(SQUARE, [robot, Robot((1, 0.5), 0.3)]).force_sets
        elements = sets.elements[: sets.counts[0]]
        assert np.diff(elements[:, 3:]).sum() == pytest.approx(math.tau)
        for turn in rng.uniform(-4, 4, 60):
            way = np.array([math.cos(turn), math.sin(turn)])
            values = support_of(elements, 2.0 * way)
            own = turn - robot.direction
            most = (forces_of(robot) @ [math.cos(own), math.sin(own)]).max()
            assert len(values) == 1
            assert values[0] == pytest.approx(2.0 * most, abs=1e-7)


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_has_a_plain_form(kind):
    """A robot of any kind, alone and in a swarm, comes back from plain data and from a pickle."""
    robot = Robot((1, 0), 0.4, **KINDS[kind], group="bus A")
    swarm = Swarm(SQUARE, [robot, Robot((1, 0.5), 0.3)])
    assert Robot.from_data(robot.to_data()) == robot
    assert Swarm.from_data(swarm.to_data()) == swarm
    assert pickle.loads(pickle.dumps(swarm)) == swarm
    assert swarm.without("R2").with_robot(swarm["R2"]) == swarm
    assert swarm.with_pose("R1", (1, -0.2))["R1"].contact == (1, -0.2)
    assert swarm.has_rays_only == (kind == "ray")


def test_columns_and_robots_say_the_same():
    """A swarm made from arrays has the force sets of one made from robots."""
    steers, reverse = [0.0, 0.5, math.pi], [0.2, 0.0, 0.0]
    contacts, turns = [(1, 0), (1, 0.5), (-1, 0)], [0.1, 0.2, 0.3]
    from_arrays = Swarm.from_arrays(SQUARE, contacts, turns, steers=steers, reverse_limits=reverse)
    robots = [
        Robot(c, t, steers=s, reverse_limit=r)
        for c, t, s, r in zip(contacts, turns, steers, reverse, strict=True)
    ]
    swarm = Swarm(SQUARE, robots)
    np.testing.assert_array_equal(from_arrays.force_sets.elements, swarm.force_sets.elements)
    assert from_arrays["R2"].steers == 0.5


def test_robots_of_a_group_are_one_machine():
    """Groups may lie anywhere in the order; a robot without one is a machine by itself."""
    groups = ["", "bus B", "bus A", "bus B", ""]
    robots = [Robot((1, 0.1 * k), 0.0, group=group) for k, group in enumerate(groups)]
    swarm = Swarm(SQUARE, robots)
    assert swarm.machines.tolist() == [0, 1, 2, 1, 3]
    assert swarm.without("R2").machines.tolist() == [0, 1, 2, 3]


def test_what_does_not_go_together_is_refused_at_once():
    """All faults of a robot, of a newcomer and of arrays are told together."""
    with pytest.raises(RobotInvalid) as caught:
        Robot((1, 0), 0.0, 2.0, least=3.0, reverse_limit=1.0, friction=0.3, steers=4.0)
    assert len(caught.value.faults) == 3
    with pytest.raises(RobotInvalid, match="size of the largest force, 1 "):
        Robot((1, 0), 0.0, 3.0, envelope=[(1, 0), (0, 1)])
    with pytest.raises(RobotInvalid, match="neither steering nor"):
        Newcomer(1.0, "push", friction=0.3, steers=True)
    with pytest.raises(RobotInvalid, match=r"R2: it steers 9.0"):
        Swarm.from_arrays(SQUARE, [(1, 0), (1, 0.5)], [0.0, 0.0], steers=[1.0, 9.0])


AJAX = Robot((1, 0), 3.0, name="Ajax", steers=0.5)
PUSHERS = [Robot((1, 0.3), 3.0), Robot((-1, 0.5), 0.4), Robot((0.2, -1), 1.7), AJAX]
STEERING = Swarm(SQUARE, PUSHERS)
FIXED = Swarm(SQUARE, PUSHERS[:3])
MOUNTED = sg.Problem(FIXED, Newcomer(mounted=True))


def test_what_knows_rays_only_refuses_other_robots():
    """No answer takes a robot that steers for one that does not."""
    with pytest.raises(ForceSetUnsupported, match="one ray"):
        sg.Summary.of(FIXED, 12).place(SQUARE, Newcomer(steers=True))


def test_a_newcomer_inside_has_no_landscape_along_the_boundary():
    """Its places are not on the boundary."""
    with pytest.raises(ForceSetUnsupported, match="sits inside"):
        sg.cell_qualities(MOUNTED, (2, 2))
