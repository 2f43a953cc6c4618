"""Robots in groups that share summaries."""

from msgspec.structs import replace

import swarmgrasp as sg
from groups_by_hand import begun
from swarmgrasp.agents.groups.member import SlotsTold, Tell
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


def test_a_clock_that_jumps_silences_nobody():
    """The writer tells its slot again, an hour earlier and two days later; others may go on."""
    writer = begun(2, 4).members["G00N00"]
    for start in (-3600.0, 2.0e5):
        effects = []
        for step in range(20):
            clock = start + 0.5 * step
            effects += writer.handle(clock, ev.Tick())
            assert clock <= writer.wake <= clock + 1.0 + 1e-6
        told = [effect for effect in effects if isinstance(effect, Tell)]
        assert 2 <= len(told) <= 4
        assert {slot.count for effect in told for slot in effect.slots} == {4}


def test_what_no_sound_robot_tells_is_reported():
    """A slot of no group is dropped, the others are kept."""
    world = begun(2, 4)
    slot = world.members["G00N00"].slots.get(0)
    newer, none = (replace(slot, sequence=9), replace(slot, group=7))
    watcher = world.members["G01N01"]
    effects = watcher.handle(world.clock, SlotsTold("G00N01", (none, newer)))
    assert [e.what for e in effects if isinstance(e, ev.Report)] == ["refused"]
    assert watcher.slots.get(0) == newer
