"""Failing schedules made small."""

from simulated import drawn, planner_of
from swarmgrasp.agents.protocol import Agent
from swarmgrasp.agents.protocol.confirming import Confirmations
from swarmgrasp.agents.simulator import Mode, Schedule, What, World, read_faults, shrink


def careless(*arguments, **more):
    """Return a robot that asks nobody before it fastens."""

    class Nobody(Confirmations):
        needed = ()

    agent = Agent(*arguments, **more)
    agent._confirmations.__class__ = Nobody
    return agent


def test_a_failing_schedule_shrinks_to_what_matters():
    """Robots that ask nobody break the spacing; two of them are enough, and nothing else."""

    def run(schedule):
        return World(planner_of(schedule.mode), schedule, agent=careless).run()

    text = (
        "join@0:R1; join@0.13:R2; deaf@0-29.2:R2,R1; join@14.3:R3; hang@15-16:R3; "
        "crash@17-18:R3; split@4-5:R1; fall@19:R3"
    )
    failing = run(Schedule(Mode.MAIN, 4, read_faults(text), loss=0.05, locks=False, calm=30.0))
    small = shrink(failing, run)
    assert small.broken.invariant == failing.broken.invariant == "spacing"
    assert small.schedule.names == ("R1", "R2")
    assert [fault.what for fault in small.schedule.faults] == [What.JOIN, What.JOIN, What.DEAF]
    assert small.schedule.loss == 0.0
    assert run(small.schedule).trace == small.trace


def test_a_schedule_that_holds_is_left_as_it_is():
    """There is nothing to shrink."""

    def run(schedule):
        return World(planner_of(schedule.mode), schedule).run()

    outcome = run(drawn(Mode.MAIN, 1))
    assert shrink(outcome, run) is outcome
