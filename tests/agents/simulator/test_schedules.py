"""Whole schedules: every invariant after every event, in every mode."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from simulated import drawn, planner_of, run
from swarmgrasp.agents.simulator import FLAT, Mode, Schedule, World, read_faults, simulate

QUICK = dict.fromkeys(FLAT, 37) | {Mode.BURST: 4}
"""Schedules of each mode without groups, which have a mission of their own: 300 in all."""
LONG = 2223


def check(mode, seeds):
    """Run schedules, and tell the first that fails."""
    for seed in seeds:
        outcome = run(drawn(mode, seed))
        assert outcome.broken is None, f"{mode} {seed}: {outcome.broken}"


@pytest.mark.parametrize("mode", FLAT)
def test_all_invariants_hold(mode):
    """Whatever is lost, late, doubled, cut, stopped or killed (S, Q, L; E where it is promised)."""
    check(mode, range(1, 1 + QUICK[mode]))


@pytest.mark.long
@pytest.mark.parametrize("mode", FLAT)
def test_all_invariants_hold_for_long(mode):
    """The same, for a long time."""
    check(mode, range(10_000, 10_000 + LONG))


@pytest.mark.parametrize(("mode", "seed"), [(Mode.MOVES, 10_919), (Mode.RESOLVE, 12_219)])
def test_who_leaves_while_moving_moves_no_more(mode, seed):
    """Another may let go at once: a robot that has gone is under way to no place."""
    check(mode, [seed])


def test_the_same_seed_is_the_same_run_in_any_process():
    """Nothing depends on the order of sets: not a message more or less under another hash seed."""
    program = (
        "from simulated import drawn, run\n"
        "from swarmgrasp.agents.simulator import Mode\n"
        "print(*(run(drawn(mode, 5)).trace for mode in (Mode.MAIN, Mode.BURST, Mode.COLD)))\n"
    )
    here = str(Path(__file__).parents[2])
    said = {
        subprocess.run(
            [sys.executable, "-c", program], capture_output=True, text=True, check=True,
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": here},
        ).stdout
        for seed in ("1", "2")
    }  # fmt: skip
    assert len(said) == 1
    assert len(set(said.pop().split())) == 3


def test_twenty_at_once_turn_at_most_twice_each():
    """Computing what others do instead of waiting for their word keeps turns few."""
    outcome = run(drawn(Mode.BURST, 3, robots=20))
    assert outcome.broken is None
    assert len(outcome.places) >= 15
    assert outcome.turns <= 40


def test_a_world_of_one_robot_settles():
    """The smallest swarm: it listens, and fastens, confirmed by nobody."""
    outcome = run(Schedule(Mode.MAIN, 1, read_faults("join@0:R1"), calm=1.0))
    assert outcome.broken is None
    assert [name for name, _ in outcome.places] == ["R1"]


def test_who_is_not_heard_is_waited_for_in_words():
    """R2 never hears R1: R1 asks it for ever, and says so."""
    faults = read_faults("join@0:R1; join@0.5:R2; deaf@0:R2,R1")
    world = World(planner_of(Mode.ONE_WAY), Schedule(Mode.ONE_WAY, 1, faults, calm=20.0))
    assert world.run().broken is None
    assert world.nodes["R1"].agent.waits_for == ("R2",)
    assert any("waits for R2" in words for _, words in world.reports)


def test_two_that_never_heard_each_other_are_excused_and_told_of():
    """Attached in two halves of a split network: nobody can know better (guarantee S)."""
    faults = read_faults("start@0:R1; start@0:R2; split@0-25:R1; join@5:R1; join@5:R2")
    outcome = simulate(planner_of(Mode.MAIN), Schedule(Mode.MAIN, 1, faults, calm=25.0))
    assert (outcome.broken, outcome.excused) == (None, 1)
    assert sum("too close" in words for _, words in outcome.reports) == 2
    with_roster = run(Schedule(Mode.ROSTER, 1, faults, calm=25.0))
    assert (with_roster.broken, with_roster.excused) == (None, 0)


REGRESSIONS = {
    "a newborn takes a clock that does not begin at 0 for time in which it listened": (
        Mode.RESOLVE, 14, "join@8:R1; split@9-24:R2; join@13:R2", 24.5,
    ),
    "a robot confirms another's move while it lets go itself": (
        Mode.MOVES, 3, "start@0:A4; join@1:R1; move@30:R1; move@30.5:A4", 31.0,
    ),
}  # fmt: skip


@pytest.mark.parametrize("fault", REGRESSIONS)
def test_what_once_broke_holds(fault):
    """Schedules that broke an invariant, made small."""
    mode, seed, text, calm = REGRESSIONS[fault]
    outcome = run(Schedule(mode, seed, read_faults(text), calm=calm))
    assert outcome.broken is None
