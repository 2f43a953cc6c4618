"""Events: each checks its values, and together they may not contradict."""

import math

import numpy as np
import pytest

from swarmgrasp import Newcomer
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.plain import read
from swarmgrasp.simulation.control import Control
from swarmgrasp.simulation.events import (
    Change,
    Event,
    Follow,
    Leave,
    Lose,
    Move,
    Send,
    event_faults,
    in_order,
    joining_names,
)
from swarmgrasp.simulation.weather import Series, Weather

ONE_OF_EACH = (
    Leave(1, "Ajax"),
    Lose(2, "Boreas", 3.0),
    Send(3, Newcomer(5.0, name="Castor"), 100.0, 2.0, 30.0, 1.0),
    Send(3),
    Move(4, 1.0, -2.0, 0.5),
    Follow(5, [(1, 0), (2, 3)], 0.5),
    Change(6, wind_speed=10.0, current_bearing=-1.0),
)
BEYOND = [
    (lambda: Lose(-1, "A", math.nan), "time is -1(.|\n)*delay of notice is nan"),
    (lambda: Leave(1, 3), "name is 3"),
    (lambda: Send(1, 7, -1, 0, -2), "away is -1(.|\n)*speed is 0(.|\n)*fast is -2(.|\n)*7 is no N"),
    (lambda: Move(1, math.inf, "2"), "x is inf(.|\n)*y is '2'"),
    (lambda: Follow(1, [], 1.0), "one or more points"),
    (lambda: Follow(1, [(1, 2, 3)], 0.0), "speed is 0(.|\n)*one or more points"),
    (lambda: Change(1), "nothing changes"),
    (lambda: Change(1, wind_speed=-1, current_bearing="N"), "speed is -1(.|\n)*bearing is 'N'"),
    (lambda: Series([0, 0], [1, 2], [0, 0]), "should increase"),
    (lambda: Series([0, 1], [1], "x"), "bearings are 'x'(.|\n)*as many of each"),
    (lambda: Series([0.0], [-1.0], [0.0]), "speed is -1"),
    (lambda: Weather("squalls", 3), "gusts are 'squalls'(.|\n)*series is 3"),
    (lambda: Control(0.0, position_noise=-1), "period is 0(.|\n)*position noise is -1"),
    (lambda: Control(heading_noise=None), "heading noise is None"),
]  # fmt: skip


@pytest.mark.parametrize(("make", "words"), BEYOND)
def test_values_outside_their_ranges_are_refused(make, words: str) -> None:
    """All at once, each with its range."""
    with pytest.raises(SimulationInvalid, match=words):
        make()


def test_plain_forms_are_read_back_as_the_same_kind() -> None:
    """By their keys: one that leaves is not one that is lost."""
    faults: list[str] = []
    data = [event.to_data() for event in ONE_OF_EACH]
    assert read(data, tuple[Event, ...], (), faults) == ONE_OF_EACH
    assert not faults
    gale = Weather("npd", Series([0.0, 60.0], [5.0, 20.0], [0.1, 0.2]))
    assert Weather.from_data(gale.to_data()) == gale


def test_events_stand_in_the_order_of_time_and_then_as_given() -> None:
    """Whatever the order they are given in."""
    mixed = [ONE_OF_EACH[i] for i in (5, 2, 3, 0, 6, 4, 1)]
    assert in_order(mixed) == ONE_OF_EACH


def faults_of(*events: Event, newcomer: Newcomer | None = None, duration: float = 100.0) -> str:
    """Return what contradicts, for a swarm of Ajax and R1."""
    groups = {"bus A": ["Ajax", "R1"]}
    coming = newcomer or Newcomer()
    found = event_faults(["Ajax", "R1"], groups, in_order(events), coming, duration)
    assert all(event in events for event, _ in found)
    return "\n".join(fault for _, fault in found)


def test_a_robot_that_is_gone_cannot_be_lost() -> None:
    """Nor one that was never there, nor one before it is sent."""
    assert "'Ajax' is gone since 1 s" in faults_of(Lose(1, "Ajax"), Leave(2, "Ajax"))
    assert "'Ajax' is gone since 1 s" in faults_of(Lose(1, "Ajax"), Lose(1, "Ajax"))
    assert "no robot called 'Bob' then; known: Ajax, R1" in faults_of(Leave(1, "Bob"))
    assert "called 'newcomer'" in faults_of(Lose(1, "newcomer"), Send(2))
    assert faults_of(Send(1), Lose(1, "newcomer"), Leave(3, "Ajax")) == ""


def test_a_group_is_lost_with_those_of_it_that_are_there() -> None:
    """Once; a group cannot leave, for it is robots that do."""
    assert faults_of(Lose(1, "Ajax"), Lose(2, "bus A")) == ""
    assert "'bus A' is gone since 1 s" in faults_of(Lose(1, "bus A"), Lose(2, "bus A"))
    assert "'R1' is gone since 1 s" in faults_of(Lose(1, "bus A"), Leave(2, "R1"))
    both = (Leave(1, "Ajax"), Lose(2, "R1"), Lose(3, "bus A"))
    assert "all robots of 'bus A' are gone" in faults_of(*both)
    assert "no robot called 'bus A'" in faults_of(Leave(1, "bus A"))


def test_a_newcomer_is_called_what_nobody_has_been_called() -> None:
    """Also after those who had the name have left; later events know it by that."""
    again = Newcomer(name="Ajax")
    sent = (Send(1), Send(2, again), Send(3))
    assert joining_names(["Ajax", "R3"], sent, Newcomer()) == ("newcomer", "Ajax 2", "newcomer 2")
    assert faults_of(Leave(1, "Ajax"), Send(2, again), Lose(3, "Ajax 2")) == ""


def test_one_instant_has_one_aim_and_one_weather() -> None:
    """Changes of different things may come together."""
    assert "another aim" in faults_of(Move(1, 0, 0), Follow(1, [(1, 1)], 1.0))
    assert "another wind speed" in faults_of(Change(1, 3.0), Change(1, 4.0, 0.0))
    assert faults_of(Change(1, 3.0), Change(1, None, 0.0), Move(1, 0, 0), Move(2, 0, 0)) == ""


def test_nothing_happens_after_the_end() -> None:
    """An event at the end itself would change nothing."""
    assert "run ends at 100 s" in faults_of(Move(100, 0, 0))
    assert faults_of(Move(np.nextafter(100, 0), 0, 0)) == ""
