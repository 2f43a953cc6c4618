"""Schedules as text, and schedules that cannot be."""

import math

import pytest

from simulated import drawn
from swarmgrasp.agents.simulator import Fault, Mode, Schedule, What, read_faults
from swarmgrasp.errors import ScheduleInvalid


@pytest.mark.parametrize("mode", Mode)
def test_a_schedule_is_its_text(mode):
    """What is drawn can be written down and read back, to the last digit."""
    for seed in range(20):
        schedule = drawn(mode, seed)
        again = read_faults(schedule.text)
        assert sorted(map(str, again)) == sorted(map(str, schedule.faults))
        assert {f.until for f in again} <= {f.until for f in schedule.faults}


def test_names_are_those_that_something_happens_to():
    """In the order of their numbers."""
    schedule = Schedule(Mode.MAIN, 1, read_faults("join@0:R10; cut@1-2:R2,R10; join@0:R1"))
    assert schedule.names == ("R1", "R2", "R10")


def test_all_that_is_wrong_is_told_at_once():
    """Each in its words: no such fault, wrong robots, wrong times, numbers out of range."""
    with pytest.raises(ScheduleInvalid) as raised:
        read_faults("jion@0:R1; cut@1-2:R1; join@1-2:R1; hang@5-4:R1; join@99999:R1")
    assert len(raised.value.faults) == 5
    with pytest.raises(ScheduleInvalid, match="not even who joins"):
        read_faults(" ; ")
    join = (Fault(What.JOIN, 0.0, names=("R1",)),)
    with pytest.raises(ScheduleInvalid) as raised:
        Schedule(Mode.MAIN, 1, join, loss=1.5, delay=math.nan, calm=0.0)
    assert len(raised.value.faults) == 3
    with pytest.raises(ScheduleInvalid, match="0 robots"):
        Schedule(Mode.MAIN, 1, ())
    with pytest.raises(ScheduleInvalid, match="two robots"):
        drawn(Mode.ONE_WAY, 1, robots=1)


def test_what_is_given_is_not_drawn():
    """Loss and the like can be fixed, all else stays as it is drawn."""
    fixed, free = drawn(Mode.MAIN, 4, loss=0.25), drawn(Mode.MAIN, 4)
    assert fixed.loss == 0.25
    assert fixed.faults == free.faults
