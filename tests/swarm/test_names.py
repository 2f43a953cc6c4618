"""Names of robots: unique, kept, and nothing else is needed to speak of one."""

import numpy as np
import pytest

from swarmgrasp import Newcomer, Outline, Problem, Robot, Swarm, place, place_sequence
from swarmgrasp.errors import RobotInvalid, RobotOffBoundary
from swarmgrasp.swarm.names import names_of, numbered

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])


def swarm_of(*names):
    """Return robots of these names along the boundary."""
    spots = np.linspace(0.0, 7.9, len(names))
    return Swarm(
        SQUARE,
        [
            Robot(SQUARE.at_arc_length(s).point, s, name=n)
            for s, n in zip(spots, names, strict=True)
        ],
    )


@pytest.mark.parametrize(
    ("given", "called"),
    [
        (["", "", ""], ["R1", "R2", "R3"]),
        (["", "Ajax", ""], ["R1", "Ajax", "R2"]),
        (["R2", "", ""], ["R2", "R1", "R3"]),
        (["", "R1", "R3"], ["R2", "R1", "R3"]),
        (["R01", "R0", "R 1", ""], ["R01", "R0", "R 1", "R1"]),
        ([], []),
    ],
)
def test_the_nameless_take_the_first_numbers_that_nobody_has(given, called):
    """At once, or one after the other where all others are there already."""
    swarm = swarm_of(*given)
    assert list(swarm.names) == [robot.name for robot in swarm] == called
    assert [swarm.index(name) for name in called] == list(range(len(called)))
    assert names_of(called) == names_of(given)
    assert [swarm[name] for name in called] == list(swarm.robots)


def test_names_stay_when_robots_come_and_go():
    """Whatever leaves and joins, the same names are the same robots."""
    rng = np.random.default_rng(4)
    pool = ["Ajax", "R2", "R7", "R1", "B", "R12"]
    for _ in range(200):
        names = names_of([])
        truth: list[str] = []
        for _ in range(12):
            if truth and rng.random() < 0.4:
                gone = int(rng.integers(len(truth)))
                names = names.without([gone])
                del truth[gone]
            else:
                free = [name for name in pool if name not in truth]
                name = str(rng.choice(free)) if free and rng.random() < 0.5 else ""
                names = names.joined(name)
                first = next(f"R{k}" for k in range(1, 99) if f"R{k}" not in truth)
                truth.append(name or first)
            assert list(names) == truth
            assert names == names_of(truth)
            assert hash(names) == hash(names_of(truth))
            assert [names.index(name) for name in truth] == list(range(len(truth)))
            assert not any(names.index(n) is not None for n in {*pool, "R3", "", 3} - {*truth})


def test_one_name_is_one_robot():
    """Both robots of a name are told, wherever the second one comes from."""
    with pytest.raises(RobotInvalid, match="robots 1 and 3 are both called 'Ajax'"):
        swarm_of("Ajax", "", "Ajax")
    with pytest.raises(RobotInvalid, match="robots 1, 2 and 3 are all called 'B'") as caught:
        swarm_of("B", "B", "B", "C", "C")
    assert len(caught.value.faults) == 2
    with pytest.raises(RobotInvalid, match="robots 2 and 3 are both called 'R2'"):
        swarm_of("", "").with_robot(Robot((1, 0), 0.0, name="R2"))


def test_a_swarm_is_known_by_names():
    """A robot of a name, whether there is one, all of them, and the swarm without some."""
    swarm = swarm_of("Ajax", "", "Boreas")
    assert "Ajax" in swarm
    assert "R1" in swarm
    assert "R2" not in swarm
    assert 0 not in swarm
    assert swarm["R1"].name == "R1"
    assert list(swarm.without(["Ajax", "R1"]).names) == ["Boreas"]
    assert list(swarm.without({"Boreas"}).names) == ["Ajax", "R1"]
    assert list(swarm.without("Ajax")) == list(swarm.robots[1:])
    with pytest.raises(RobotInvalid, match="no robot called 'Castor'; there are Ajax, R1, Boreas"):
        swarm["Castor"]


def test_a_robot_moves_and_stays_where_it_is_in_the_order():
    """The same swarm as one made anew; a place on the boundary is still needed."""
    swarm = swarm_of("Ajax", "", "Boreas")
    moved = swarm.with_pose("R1", (1, 0.25), 2.0)
    robots = [swarm["Ajax"], Robot((1, 0.25), 2.0), swarm["Boreas"]]
    anew = Swarm(SQUARE, robots)
    assert moved == anew
    np.testing.assert_array_equal(moved.generators, anew.generators)
    assert swarm.with_pose("R1", (1, 0.25))["R1"].direction == swarm["R1"].direction
    with pytest.raises(RobotOffBoundary, match="R1 at"):
        swarm.with_pose("R1", (0, 0))
    with pytest.raises(RobotInvalid, match="the contact is"):
        swarm.with_pose("R1", "here")


def test_newcomers_get_names_that_nobody_has():
    """One after the other, several at a time, and where such a name is taken."""
    swarm = swarm_of("newcomer 2", "", "", "")
    problem = Problem(swarm, Newcomer())
    first, second = place_sequence(problem, 2)
    assert [first.robot.name, second.robot.name] == ["newcomer 1", "newcomer 3"]
    once = place(problem)
    again = place(once.swarm_after, Newcomer())
    assert [once.robot.name, again.robot.name] == ["newcomer", "newcomer 3"]
    assert place(problem) == place(swarm, Newcomer())


def test_a_million_names_are_rules_and_no_objects():
    """Names are found and kept among a million that nobody has written down."""
    names = numbered(1_000_000).without([0, 5]).joined("Ajax")
    assert (len(names), names[0], names[4], names[999_998]) == (999_999, "R2", "R7", "Ajax")
    assert (names.index("R1000000"), names.index("R6"), names.index("Ajax")) == (
        999_997,
        None,
        999_998,
    )
    assert names.joined("")[999_999] == "R1"
    assert len(names.given) == 1
