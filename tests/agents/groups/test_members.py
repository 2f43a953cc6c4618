"""Robots in groups that share summaries."""

import pytest

import swarmgrasp as sg
from groups_by_hand import begun
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.record import Phase


def join(world, count, until):
    """Let robots come and join, one each second."""
    for k in range(count):
        world.add(f"J{k:02d}")
        world.put(world.clock + 1.0 + k, f"J{k:02d}", ev.Join())
    world.run(until)


def certain(world):
    """Return what each robot knows of the quality, and the truth."""
    return [m.slots.bounds() for m in world.members.values()], sg.quality(world.swarm).value


def test_newcomers_join_the_best_group_and_all_know_the_quality():
    """Nobody comes too close, all agree on the slots, and the truth lies between their bounds."""
    world = begun(3, 8)
    before = sg.quality(world.swarm).value
    join(world, 4, 40.0)
    assert len(world.swarm) == 28
    assert world.nearest() >= world.problem.spacing - 1e-6
    known, truth = certain(world)
    assert truth > before
    assert len(set(known)) == 1
    lower, upper = known[0]
    assert lower <= truth <= upper < 1.1 * truth
    assert {m.slots.count for m in world.members.values()} == {28}
    joined = world.members["J03"].agent.record
    assert 0.0 < joined.lower <= truth


def test_lost_messages_are_told_again():
    """With a third of all messages lost, the slots agree in the end."""
    world = begun(3, 5, seed=4, loss=0.3)
    join(world, 2, 70.0)
    assert len(world.swarm) == 17
    known, truth = certain(world)
    assert len(set(known)) == 1
    assert known[0][0] <= truth <= known[0][1]
    assert world.nearest() >= world.problem.spacing - 1e-6


def test_another_writes_when_the_writer_is_silent_and_when_the_last_has_left():
    """It counts those that are silent and hold the object; who has left does not count."""
    world = begun(2, 4)
    watcher = world.members["G01N00"]
    assert watcher.slots.get(0).writer == "G00N00"
    world.crash("G00N00")
    world.run(16.0)
    slot = watcher.slots.get(0)
    assert (slot.writer, slot.turn, slot.count) == ("G00N01", 1, 4)
    for k in (1, 2, 3):
        world.put(world.clock + 3.0 * k, f"G00N0{k}", ev.Leave())
    world.run(40.0)
    assert watcher.slots.get(0).count == 1  # the one that crashed there
    assert watcher.slots.get(0).writer == "G00N03"


def test_a_full_group_is_left_for_another():
    """Newcomers go where there is room."""
    world = begun(2, 3)
    join(world, 13, 90.0)
    phases = {m.agent.record.phase for m in world.members.values()}
    assert phases == {Phase.ATTACHED}
    assert len({m.group for n, m in world.members.items() if n.startswith("J")}) == 2
    assert world.nearest() >= world.problem.spacing - 1e-6


@pytest.mark.long
def test_bytes_that_a_robot_sends_do_not_grow_with_the_swarm():
    """From 100 robots to 1 000, in groups of 50, while ten join."""
    rates = []
    for groups in (2, 20):
        world = begun(groups, 50)
        world.sent.clear()
        start = world.clock
        join(world, 10, 34.0)
        assert len(world.swarm) == 50 * groups + 10
        known, truth = certain(world)
        assert len(set(known)) == 1
        assert known[0][0] <= truth <= known[0][1]
        rates.append(sum(world.sent.values()) / len(world.members) / (world.clock - start))
    assert rates[1] <= 1.05 * rates[0]
