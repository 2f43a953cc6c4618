"""Swarms in groups on networks that fail: every invariant after every event."""

import pytest

import swarmgrasp as sg
from swarmgrasp.agents.groups import Member, Slots
from swarmgrasp.agents.simulator import (
    GroupWorld,
    Mode,
    crowded,
    draw,
    mission_of,
    read_faults,
    simulate,
)
from swarmgrasp.errors import ScheduleInvalid


def mission(groups, spacing=1.0):
    """Return the planner of a barge with room for some 30 pushing robots in each group."""
    length = 15.0 * groups
    barge = sg.Outline([(0, 0), (length, 0), (length, 10), (0, 10)])
    problem = sg.Problem(sg.Swarm(barge, []), sg.Newcomer(1.0, "push", 0.5), spacing=spacing)
    return mission_of(problem, Mode.GROUPS)


def drawn(robots, groups, seed):
    """Run a schedule that is drawn."""
    return simulate(mission(groups), draw(Mode.GROUPS, seed, robots=robots, groups=groups))


@pytest.mark.parametrize("robots", [40, pytest.param(100, marks=pytest.mark.long)])
def test_many_robots_in_groups_agree_whatever_fails(robots):
    """All hold or have left, and everybody knows the quality between two bounds."""
    outcome = drawn(robots, 4, 1)
    assert outcome.broken is None
    census = outcome.census
    assert census.counted == len(outcome.places) >= 0.95 * robots
    assert census.lower <= census.true <= census.upper < 1.01 * census.true


@pytest.mark.parametrize("seed", [10, 11, 12])
def test_small_groups_agree_whatever_fails(seed):
    """Of eight robots each, which hang, are killed, fall off and are cut off."""
    outcome = drawn(16, 2, seed)
    assert outcome.broken is None


SCHEDULES = {
    "its former life is a ghost in another group": (
        3, "join@5:J1; split@10.5-17:J1; forget@11-11.5:J1", 19.0, "_seek",
    ),
    "a writer returns from a split and its slot is old": (
        1, "split@6-16:B2,B4", 16.0, "_correct",
    ),
}  # fmt: skip


@pytest.mark.parametrize("fault", SCHEDULES)
def test_a_rule_of_groups_that_is_taken_away_is_missed(fault, monkeypatch):
    """The schedule holds with the rule, and breaks without."""
    seed, text, calm, rule = SCHEDULES[fault]
    schedule = crowded(seed, read_faults(text), 12, 2, calm=calm)
    assert simulate(mission(2), schedule).broken is None
    monkeypatch.setattr(Member, rule, lambda *_: [])
    assert simulate(mission(2), schedule).broken is not None


def test_bounds_that_are_wrong_are_seen(monkeypatch):
    """A robot that counts its own group's slot twice claims more than is there."""
    once = Slots.summary
    monkeypatch.setattr(Slots, "summary", lambda self, _=None: once(self) + once(self))
    broken = drawn(16, 2, 10).broken
    assert broken is not None
    assert broken.invariant == "quality is certified"


def test_robots_without_room_are_told_of():
    """So are names that the mission has."""
    with pytest.raises(ScheduleInvalid, match="group 0 has no room for 20 robots at the start"):
        GroupWorld(mission(2, spacing=5.0), draw(Mode.GROUPS, 1, robots=42, groups=2))
    with pytest.raises(ScheduleInvalid, match="mode groups is about 8 robots or more, not 3"):
        draw(Mode.GROUPS, 1, robots=3)


@pytest.mark.long
def test_what_a_robot_sends_does_not_grow_with_the_swarm():
    """From 100 robots to 1 000, in groups of 25, under the faults of two seeds."""
    few, many = ([drawn(robots, robots // 25, seed) for seed in (1, 2)] for robots in (100, 1000))
    for outcome in (*few, *many):
        assert outcome.broken is None
    sent = [sum(each.census.sent for each in outcomes) for outcomes in (few, many)]
    assert sent[1] <= sent[0]
