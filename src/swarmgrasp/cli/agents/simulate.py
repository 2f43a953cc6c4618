"""`swarmgrasp agents simulate`: robots that agree on a network where everything goes wrong."""

import re
import shlex
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from cyclopts import Parameter

from swarmgrasp.cli.amounts import Amount
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.inputs import (
    blaming,
    json_faults,
    read_scenario,
    source_of,
    whole_faults,
)
from swarmgrasp.cli.progress import shown_progress
from swarmgrasp.cli.question import check_newcomer
from swarmgrasp.errors import SwarmGraspError

if TYPE_CHECKING:
    from swarmgrasp.agents.protocol import ProblemPlanner
    from swarmgrasp.agents.simulator import Mode, Outcome, Schedule

BROKEN = 1
"""Exit status when an invariant does not hold."""
MOST_SEEDS = 1_000_000
MANY = 200
"""Robots that know each other all, at most, unless a mode is given."""
FIELDS = ("loss", "doubled", "delay", "missed", "turned", "calm")
"""Numbers of a schedule that have an option of the same name."""
UNITS = {"delay": "s", "missed": "m", "turned": "rad", "calm": "s"}
"""Of those that have one, in a command that repeats a schedule."""
KINDS = {"s": "time", "m": "length", "rad": "angle"}
"""What is measured in them."""


def simulate(
    file: Dashed,
    /,
    *,
    seeds: Annotated[str, Parameter(metavar="FIRST:LAST")] = "1:100",
    mode: Annotated[str | None, Parameter(metavar="MODES")] = None,
    robots: Annotated[str | None, Parameter(metavar="INT")] = None,
    groups: Annotated[str | None, Parameter(metavar="INT")] = None,
    loss: float | None = None,
    doubled: float | None = None,
    delay: Annotated[str | None, Parameter(metavar="TIME")] = None,
    missed: Annotated[str | None, Parameter(metavar="LENGTH")] = None,
    turned: Annotated[str | None, Parameter(metavar="ANGLE")] = None,
    locks: Annotated[bool, Parameter(negative="")] = False,
    faults: Annotated[str | None, Parameter(metavar="TEXT")] = None,
    calm: Annotated[str | None, Parameter(metavar="TIME")] = None,
    shrink: Annotated[bool, Parameter(negative="")] = False,
    json: Dashed | None = None,
) -> int:
    """Let robots agree on simulated networks that fail, and check that nothing goes wrong.

    Each seed draws a schedule: who joins when, which messages are lost, late or doubled, who
    hangs, is killed or falls off, how the network splits. Then it is calm, and all must settle.
    The invariants are checked after every event. The first schedule in which one breaks is told
    with the command that repeats it, and the exit status is 1.

    Above 200 robots, or with --groups, they are in groups that share summaries: most hold the
    object from the start, and a twentieth joins.

    Lengths without a unit are in the file's, angles in degrees, times in seconds.

    Example: swarmgrasp agents simulate deck-barge --seeds 1:1000 --shrink
    Example: swarmgrasp agents simulate rectangle-5 --robots 1000 --seeds 1

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as deck-barge.
    seeds
        Which schedules, such as 1:1000, or a single one, such as 17.
    mode
        What kinds, with commas: main (everything mixed), roster, moves, resolve, dead (the killed
        never return), hangs, cold (nobody is there at first), one-way (one never hears another),
        burst (10 to 20 at once); or all of these; or groups. Main unless given.
    robots
        How many join, drawn too unless given; in groups, how many there are in all.
    groups
        How many groups, from 2; so many that each has some 25 robots unless given.
    loss
        Share of messages that are lost, 0 to 1, instead of what is drawn.
    doubled
        Share of messages that come twice.
    delay
        How long a message takes, at the mean.
    missed
        How far robots attach from where they should, at most.
    turned
        How far their directions are from what they should be, at most.
    locks
        A robot sees that its place is taken before it touches.
    faults
        What happens, instead of what is drawn: such as "join@0:R1; hang@2-7:R1; cut@3-9:R1,R2".
    calm
        With --faults: when calm begins.
    shrink
        Make a failing schedule as small as it gets.
    json
        Also write what came of each schedule to this .json file; "-" prints it and nothing else.
    """
    from swarmgrasp.packages import check_installed

    check_installed("msgspec", purpose="Simulating robots on a network")
    wrong = _seeds_faults(seeds) + json_faults(json)
    wrong += whole_faults("--robots", robots, 1, 1000) + whole_faults("--groups", groups, 2, 1000)
    mode = mode or ("groups" if groups or (not wrong and int(robots or 0) > MANY) else "main")
    wrong += _mode_faults(mode, groups)
    amounts = _amounts(delay=delay, missed=missed, turned=turned, calm=calm)
    wrong += [fault for amount in amounts.values() for fault in amount.faults()]
    wrong += _number_faults(loss=loss, doubled=doubled) + _text_faults(faults, calm, robots, mode)
    scenario = read_scenario(file, wrong)
    check_newcomer(scenario, file, "agents simulate")
    from swarmgrasp.agents import simulator

    with blaming(file):
        problem = scenario.problem()
        kinds = [simulator.Mode(each) for each in _modes(mode)]
        planners = {kind: simulator.mission_of(problem, kind) for kind in kinds}
    asked = _Asked(robots, groups, faults)
    given: dict[str, Any] = {"loss": loss, "doubled": doubled, "locks": locks or None}
    fixed = {what: value for what, value in given.items() if value is not None}
    fixed |= {what: amount.value(scenario.terms) for what, amount in amounts.items()}
    numbers = _seeds(seeds)
    done: list[Outcome] = []
    with shown_progress(len(numbers) * len(kinds), "simulating") as told:
        for kind, seed in _each(kinds, numbers):
            run = _runner(planners[kind])
            with blaming(file):
                done.append(run(_schedule(kind, seed, planners[kind], asked, fixed)))
            if told is not None:
                told(len(done))
            if done[-1].broken:
                break
    last = done[-1]
    if shrink and last.broken:
        with shown_progress(simulator.MOST_SCHEDULES, "shrinking") as told:
            last = simulator.shrink(last, run, told)
    from swarmgrasp.cli.show.simulation import document_of, show

    command = _command(source_of(file), last.schedule)
    document = document_of(done, last, command)
    deliver(json, document, lambda: show(done, last, command))
    return BROKEN if last.broken else 0


class _Asked(NamedTuple):
    """What was asked for of all schedules, as it was written."""

    robots: str | None
    groups: str | None
    faults: str | None


def _schedule(
    kind: "Mode", seed: int, planner: "ProblemPlanner", asked: _Asked, fixed: dict[str, Any]
) -> "Schedule":
    """Return a schedule as asked for: drawn, or of faults given as text."""
    from swarmgrasp.agents import simulator

    count = None if asked.robots is None else int(asked.robots)
    groups = None if asked.groups is None else int(asked.groups)
    if asked.faults is None:
        first = [row.id for row in planner.present]
        return simulator.draw(kind, seed, robots=count, groups=groups, first=first, **fixed)
    faults = simulator.read_faults(asked.faults)
    if kind is simulator.Mode.GROUPS:
        return simulator.crowded(seed, faults, count or 0, groups, **fixed)
    return simulator.Schedule(kind, seed, faults, **fixed)


def _runner(planner: "ProblemPlanner") -> "Callable[[Schedule], Outcome]":
    """Return what runs schedules of one mission."""
    from swarmgrasp.agents.simulator import simulate as run

    return lambda schedule: run(planner, schedule)


def _each(kinds: "list[Mode]", numbers: range) -> "Iterator[tuple[Mode, int]]":
    """Yield what is to be simulated: every mode of a seed before the next seed."""
    return ((kind, seed) for seed in numbers for kind in kinds)


def _command(file: str, schedule: "Schedule") -> str:
    """Return the command that repeats a schedule."""
    words = ["swarmgrasp", "agents", "simulate", file, "--mode", schedule.mode.value]
    words += ["--seeds", str(schedule.seed), "--faults", schedule.text]
    if schedule.groups:
        words += ["--robots", str(len(schedule.names)), "--groups", str(schedule.groups)]
    usual = {field: getattr(type(schedule), field) for field in FIELDS}
    for what, value in usual.items():
        if getattr(schedule, what) != value:
            words += [f"--{what}", f"{getattr(schedule, what):.9g}{UNITS.get(what, '')}"]
    words += ["--locks"] if schedule.locks else []
    return shlex.join(words)


def _modes(mode: str) -> list[str]:
    """Return the modes that are asked for."""
    from swarmgrasp.agents.simulator import FLAT

    return [*FLAT] if mode == "all" else list(dict.fromkeys(mode.split(",")))


def _mode_faults(mode: str, groups: str | None) -> list[str]:
    """Return what is wrong with the modes."""
    from swarmgrasp.agents.simulator import Mode

    faults = [
        f"--mode is {each}; it should be all, or of {', '.join(Mode)}"
        for each in _modes(mode)
        if each not in [*Mode]
    ]
    if groups and _modes(mode) != [Mode.GROUPS]:
        faults.append(f"--groups is for --mode groups, not {mode}")
    return faults


def _seeds(seeds: str) -> range:
    """Return the seeds that are asked for."""
    first, _, last = seeds.partition(":")
    return range(int(first), int(last or first) + 1)


def _seeds_faults(seeds: str) -> list[str]:
    """Return what is wrong with the seeds."""
    match = re.fullmatch(r"([0-9]{1,15})(?::([0-9]{1,15}))?", seeds)
    if match is None or not 1 <= len(_seeds(seeds)) <= MOST_SEEDS:
        return [
            f"--seeds is {seeds}; it should be a number, or two such as 1:1000, the first not "
            f"above the last, at most {MOST_SEEDS} of them"
        ]
    return []


def _amounts(**given: str | None) -> dict[str, Amount]:
    """Return the amounts of a schedule that are given, by what they are."""
    from swarmgrasp.agents.simulator import RANGES

    return {
        what: Amount(f"--{what}", text, KINDS[UNITS[what]], *RANGES[what][:2])
        for what, text in given.items()
        if text is not None
    }


def _number_faults(**values: float | None) -> list[str]:
    """Return what is wrong with the numbers of a schedule."""
    from swarmgrasp.agents.simulator import number_faults

    given = {what: value for what, value in values.items() if value is not None}
    return [f"--{fault}" for fault in number_faults(given)]


def _text_faults(faults: str | None, calm: str | None, robots: str | None, mode: str) -> list[str]:
    """Return what is wrong with faults given as text."""
    wrong = []
    if faults is None:
        if calm is not None:
            wrong.append("--calm is of --faults; without them it is drawn")
        return wrong
    from swarmgrasp.agents.simulator import read_faults

    if robots is not None and mode != "groups":
        wrong.append("--robots is not for --faults, which say who joins")
    if robots is None and mode == "groups":
        wrong.append("--faults in groups needs --robots: how many there are in all")
    try:
        read_faults(faults)
    except SwarmGraspError as error:
        wrong += [f"--faults: {fault}" for fault in error.faults]
    return wrong
