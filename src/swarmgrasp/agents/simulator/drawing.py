"""Schedules drawn from a mode and a seed."""

import math
import random
import re
from collections.abc import Sequence
from dataclasses import replace

from swarmgrasp.agents.protocol.record import id_fault
from swarmgrasp.agents.simulator.faults import LASTING, PAIRS, Fault, Mode, Schedule, What
from swarmgrasp.errors import ScheduleInvalid

SIZE = 25
"""Robots of a group, in the mean, unless their number is given."""
FEWEST = 8
"""Robots of a swarm in groups."""
CAST = 24
"""Robots in groups, beside those that join, to whom something happens."""


def draw(
    mode: Mode, seed: int, *, robots: int | None = None, groups: int | None = None,
    first: Sequence[str] = (), **fixed: float,
) -> Schedule:  # fmt: skip
    """Draw a schedule.

    Parameters
    ----------
    mode : Mode
    seed : int
    robots : int, optional
        How many join; in mode groups, how many there are in all. Drawn too when left out.
    groups : int, optional
        In mode groups: how many of them; so that each has some 25 robots when left out.
    first : sequence of str
        The mission's own robots, of which some may have a process.
    **fixed : float
        Attributes of the schedule that are given: `loss`, `doubled`, `delay`, `missed`, `turned`,
        `locks`.

    Raises
    ------
    ScheduleInvalid
        If the mode needs more robots, or a number is out of its range.
    """
    chance = random.Random(f"{mode} {seed}")
    few, many = _SIZES[mode]
    drawn = chance.randint(few, many)
    if mode is Mode.ONE_WAY and robots == 1:
        raise ScheduleInvalid("mode one-way is about two robots or more, not 1")
    count = drawn if robots is None else robots
    if mode is Mode.GROUPS:
        return _in_groups(seed, count, groups, chance, fixed)
    taken = set(first)
    first = [name for name in first if not (id_fault(name) or set(name) & set(",:;@"))]
    names = [name for k in range(1, count + len(taken) + 1) if (name := f"R{k}") not in taken]
    names = names[:count]
    calm = 20.0 if mode is Mode.BURST else round(chance.uniform(10.0, 30.0), 1)
    values = _values(mode, chance)
    if mode is Mode.BURST:
        values |= {"loss": 0.0, "delay": round(chance.uniform(0.005, 0.05), 3), "locks": False}
    faults = _joins(mode, names, calm, chance)
    if mode not in {Mode.BURST, Mode.COLD} and first and chance.random() < 0.3:
        own = chance.sample(list(first), min(len(first), chance.randint(1, 2)))
        faults += [Fault(What.START, 0.0, names=(name,)) for name in own]
        names = [*own, *names]
    faults += _MIXES[mode](names, calm, chance)
    faults = [each for each in faults if each.at < calm]
    return replace(
        Schedule(mode, seed, tuple(faults), calm=calm),
        **(values | fixed),  # type: ignore[arg-type]
    )


_SIZES = dict.fromkeys(Mode, (4, 9)) | {
    Mode.BURST: (10, 20), Mode.COLD: (4, 5), Mode.GROUPS: (60, 120),
}  # fmt: skip


def _values(mode: Mode, chance: random.Random) -> dict[str, float]:
    """Return the numbers of a schedule."""
    is_mild = chance.random() < 0.4
    exact = mode in {Mode.BURST, Mode.RESOLVE, Mode.COLD} or chance.random() < 0.5
    return {
        "loss": 0.0 if is_mild else round(chance.uniform(0.0, 0.5), 2),
        "doubled": round(chance.choice([0.0, 0.1, 0.3]), 2),
        "delay": round(math.exp(chance.uniform(math.log(0.005), math.log(1.0))), 3),
        "missed": 0.0 if exact else round(chance.uniform(0.0, 0.2), 2),
        "turned": 0.0 if exact else round(chance.uniform(0.0, 0.1), 2),
        "locks": mode not in {Mode.RESOLVE, Mode.ROSTER} and chance.random() < 0.3,
    }


def _in_groups(
    seed: int, count: int, groups: int | None, chance: random.Random, fixed: dict[str, float]
) -> Schedule:
    """Draw a schedule of many robots in groups, of whom a twentieth joins."""
    if count < FEWEST:
        raise ScheduleInvalid(f"mode groups is about {FEWEST} robots or more, not {count}")
    coming = [f"J{k}" for k in range(1, 1 + min(max(2, count // 20), 20))]
    begin, calm = count - len(coming), round(chance.uniform(15.0, 25.0), 1)
    values = _values(Mode.GROUPS, chance)
    there = [f"B{k}" for k in range(1, begin + 1)]
    near = there[: 2 * SIZE]  # of the first groups, so that some know each other
    cast = coming + chance.sample(near, min(CAST // 2, len(near)))
    cast += chance.sample(there, min(CAST // 2, len(there)))
    cast = list(dict.fromkeys(cast))
    times = (round(chance.uniform(0.0, 0.7 * calm), 2) for _ in coming)
    faults = [Fault(What.JOIN, at, names=(n,)) for at, n in zip(times, coming, strict=True)]
    faults += [each for each in _mixed(cast, calm, chance) if each.at < calm]
    return crowded(seed, tuple(faults), count, groups, calm=calm, **(values | fixed))


def crowded(
    seed: int, faults: tuple[Fault, ...], robots: int, groups: int | None = None, **fixed: float
) -> Schedule:
    """Return a schedule of many robots in groups.

    Parameters
    ----------
    seed : int
    faults : tuple of Fault
        They say who joins; all others, B1, B2 and so on, hold the object when it begins.
    robots : int
        How many there are in all.
    groups : int, optional
        How many; so that each has some 25 robots when left out.
    **fixed : float
        Attributes of the schedule that are given: `loss`, `calm` and so on.

    Raises
    ------
    ScheduleInvalid
        If there are no more robots than join, or a number is out of its range.
    """
    coming = {name for each in faults for name in each.names if each.what is What.JOIN}
    begin = robots - len([name for name in coming if not re.fullmatch("B[1-9][0-9]*", name)])
    if begin < 1:
        raise ScheduleInvalid(f"{robots} robots in groups are no more than those that join")
    schedule = Schedule(
        Mode.GROUPS, seed, faults, begin=begin, groups=groups or max(2, round(robots / SIZE))
    )
    return replace(schedule, **fixed)  # type: ignore[arg-type]


def _joins(mode: Mode, names: Sequence[str], calm: float, chance: random.Random) -> list[Fault]:
    """Return who joins when: all at once, or one after the other."""
    burst = mode is Mode.BURST or chance.random() < 0.5
    last = 1.0 if burst else 0.7 * calm
    started = mode is Mode.BURST or chance.random() < 0.5
    faults = [Fault(What.START, 0.0, names=(name,)) for name in names] if started else []
    begin = 5.0 if mode is Mode.BURST else 0.0
    times = (round(begin + chance.uniform(0.0, last), 2) for _ in names)
    return faults + [Fault(What.JOIN, at, names=(n,)) for at, n in zip(times, names, strict=True)]


def _mixed(names: Sequence[str], calm: float, chance: random.Random) -> list[Fault]:
    """Return faults of all kinds."""
    kinds = [What.HANG, What.CRASH, What.FORGET, What.CUT, What.DEAF, What.SPLIT, What.FALL]
    kinds += [What.LEAVE, What.JUMP, What.MOVE, What.SPLIT, What.CUT, What.HANG]
    return [
        _one(chance.choice(kinds), names, calm, chance)
        for _ in range(chance.randint(0, len(names) + 2))
    ]


def _one(what: What, names: Sequence[str], calm: float, chance: random.Random) -> Fault:
    """Return one fault of a kind."""
    at = round(chance.uniform(0.0, calm), 2)
    until = min(at + round(math.exp(chance.uniform(math.log(0.5), math.log(20.0))), 2), calm)
    number_of = 2 if what in PAIRS else 1
    if what is What.SPLIT:
        number_of = chance.randint(1, max(1, len(names) // 2))
    who = tuple(chance.sample(list(names), min(number_of, len(names))))
    return Fault(what, at, round(until, 2) if what in LASTING else math.inf, who)


def _moves(names: Sequence[str], calm: float, chance: random.Random) -> list[Fault]:
    """Return mixed faults, and everybody told to move, at about the same time."""
    begin = chance.uniform(0.5, 0.9) * calm
    within = math.exp(chance.uniform(math.log(0.01), math.log(5.0)))
    told = (round(begin + chance.uniform(0.0, within), 2) for _ in names)
    moves = [Fault(What.MOVE, at, names=(n,)) for at, n in zip(told, names, strict=True)]
    mixed = _mixed(names, calm, chance)
    return moves + mixed[: len(mixed) // 2]


def _dead(names: Sequence[str], calm: float, chance: random.Random) -> list[Fault]:
    """Return mixed faults, and killed robots that never return."""
    kills = chance.sample(list(names), chance.randint(1, max(1, len(names) // 3)))
    dead = [Fault(What.CRASH, round(chance.uniform(1.0, calm), 2), names=(name,)) for name in kills]
    return dead + [each for each in _mixed(names, calm, chance) if each.what is not What.FORGET]


def _hangs(names: Sequence[str], calm: float, chance: random.Random) -> list[Fault]:
    """Return hangs of everybody, short and long."""
    faults = []
    for name in names:
        for _ in range(chance.randint(1, 3)):
            at = round(chance.uniform(0.0, calm), 2)
            until = round(min(at + chance.uniform(3.0, 8.0), calm), 2)
            faults.append(Fault(What.HANG, at, until, (name,)))
    return faults


def _splits(names: Sequence[str], calm: float, chance: random.Random) -> list[Fault]:
    """Return mixed faults and a long split, so that robots get too close."""
    at = round(chance.uniform(0.0, 0.4 * calm), 2)
    half = tuple(chance.sample(list(names), max(1, len(names) // 2)))
    mixed = _mixed(names, calm, chance)
    return [Fault(What.SPLIT, at, calm, half), *mixed[: len(mixed) // 2]]


def _one_way(names: Sequence[str], calm: float, chance: random.Random) -> list[Fault]:
    """Return that one never hears another."""
    first, second = chance.sample(list(names), 2)
    at = round(chance.choice([0.0, chance.uniform(0.0, calm)]), 2)
    return [Fault(What.DEAF, at, names=(first, second))]


def _none(names: Sequence[str], calm: float, chance: random.Random) -> list[Fault]:
    """Return no faults."""
    del names, calm, chance
    return []


def _few(names: Sequence[str], calm: float, chance: random.Random) -> list[Fault]:
    """Return one or two faults of all kinds, or none."""
    return _mixed(names, calm, chance)[: chance.randint(0, 2)]


_MIXES = {
    Mode.MAIN: _mixed,
    Mode.ROSTER: _mixed,
    Mode.MOVES: _moves,
    Mode.RESOLVE: _splits,
    Mode.DEAD: _dead,
    Mode.HANGS: _hangs,
    Mode.COLD: _few,
    Mode.ONE_WAY: _one_way,
    Mode.BURST: _none,
}
