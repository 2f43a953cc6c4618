"""What happens to robots on a simulated network, as a list: it shrinks by leaving things out.

A schedule is drawn from a mode and a seed; it can be written as text and read back.
"""

import math
import random
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum

from swarmgrasp.agents.protocol.record import id_fault
from swarmgrasp.errors import ScheduleInvalid
from swarmgrasp.ranges import number, shown

LONGEST = 3600.0
"""When calm begins, at the latest [s]."""
MOST_ROBOTS = 1000
MOST_FAULTS = 10_000


class What(StrEnum):
    """What happens to one robot, or between several."""

    START = "start"
    """Its process begins; one of the mission's own robots is attached then."""
    JOIN = "join"
    """It is to come and help; its process begins if it has not."""
    LEAVE = "leave"
    MOVE = "move"
    """It is told to look for a better place."""
    FALL = "fall"
    """It loses its hold; another sees that if its own process cannot."""
    HANG = "hang"
    """Its process is stopped, and then gets all that has come in at once."""
    CRASH = "crash"
    """Its process is killed, and starts again with what it has kept."""
    FORGET = "forget"
    """Its process is killed, and starts again with nothing."""
    CUT = "cut"
    """Two do not hear each other."""
    DEAF = "deaf"
    """The first does not hear the second."""
    SPLIT = "split"
    """These do not hear the others, nor the others these."""
    JUMP = "jump"
    """Its clock jumps."""


LASTING = frozenset({What.HANG, What.CRASH, What.FORGET, What.CUT, What.DEAF, What.SPLIT})
"""What has an end; a crash without one is for ever, and so is deafness."""
PAIRS = frozenset({What.CUT, What.DEAF})


class Mode(StrEnum):
    """A family of schedules; each has its own settings, and its own claims at the end."""

    MAIN = "main"
    """Everything that can happen, mixed."""
    ROSTER = "roster"
    """Everybody is on a roster: no two too close, whatever happens."""
    MOVES = "moves"
    """All are told to move, beside the other faults."""
    RESOLVE = "resolve"
    """The later of two that are too close lets go: none is left so."""
    DEAD = "dead"
    """The killed never return."""
    HANGS = "hangs"
    """Everybody hangs one to three times."""
    COLD = "cold"
    """Nobody is at the object: joint plans."""
    ONE_WAY = "one-way"
    """One never hears another: the other waits, and says for whom."""
    BURST = "burst"
    """Ten to twenty join at once: few turns, and the places of one after the other."""


@dataclass(frozen=True)
class Fault:
    """Something that happens.

    Attributes
    ----------
    what : What
    at : float [s]
    until : float [s]
        Of what lasts, its end; inf for never.
    names : tuple of str

    Examples
    --------
    >>> str(Fault(What.CUT, 3.0, 9.5, ("R1", "R2")))
    'cut@3-9.5:R1,R2'
    """

    what: What
    at: float
    until: float = math.inf
    names: tuple[str, ...] = ()

    def __str__(self) -> str:
        """Return it as text."""
        lasts = self.what in LASTING and self.until < math.inf
        end = f"-{self.until:.9g}" if lasts else ""
        return f"{self.what}@{self.at:.9g}{end}:{','.join(self.names)}"


@dataclass(frozen=True)
class Schedule:
    """One run of a simulated network, to the last message.

    Attributes
    ----------
    mode : Mode
    seed : int
        Of all chance: which messages are lost, how long they take, how long robots travel.
    faults : tuple of Fault
    loss : float
        Share of messages that are lost until calm.
    doubled : float
        Share of messages that come twice until calm.
    delay : float [s]
        Mean of how long a message takes until calm; each its own time, so that they overtake.
    missed : float [m]
        How far a measured place is from the claimed one at most, in x and in y.
    turned : float [rad]
        How far a measured direction is from the claimed one at most.
    locks : bool
        Whether a place that is taken is seen to be.
    calm : float [s]
        When all that lasts has ended, and messages are neither lost nor late.
    """

    mode: Mode
    seed: int
    faults: tuple[Fault, ...]
    loss: float = 0.0
    doubled: float = 0.0
    delay: float = 0.02
    missed: float = 0.0
    turned: float = 0.0
    locks: bool = False
    calm: float = 30.0
    names: tuple[str, ...] = field(init=False, repr=False, compare=False)
    """All robots that it is about, in order."""

    def __post_init__(self) -> None:
        """Check the numbers."""
        faults = number_faults({what: getattr(self, what) for what in _RANGES})
        names = {name for each in self.faults for name in each.names}
        if not 1 <= len(names) <= MOST_ROBOTS or len(self.faults) > MOST_FAULTS:
            faults.append(
                f"a schedule of {len(names)} robots and {len(self.faults)} faults; it should have "
                f"1 to {MOST_ROBOTS} robots and at most {MOST_FAULTS} faults"
            )
        if faults:
            raise ScheduleInvalid(faults)
        vars(self).update(names=tuple(sorted(names, key=_by_number)))

    @property
    def text(self) -> str:
        """The faults as text, in order of time."""
        return "; ".join(map(str, sorted(self.faults, key=lambda each: each.at)))


_RANGES = {
    "loss": (0.0, 1.0, ""),
    "doubled": (0.0, 1.0, ""),
    "delay": (0.0, 60.0, " s"),
    "missed": (0.0, 1e6, " m"),
    "turned": (0.0, math.pi, " rad"),
    "calm": (1.0, LONGEST, " s"),
}


def number_faults(values: Mapping[str, float]) -> list[str]:
    """Return what is wrong with numbers of a schedule, each a sentence.

    Parameters
    ----------
    values : mapping of str to float
        By name, of those that a `Schedule` has: `loss`, `delay` [s] and so on.
    """
    faults = []
    for what, value in values.items():
        low, high, unit = _RANGES[what]
        if not low <= number(value) <= high:
            faults.append(f"{what} is {shown(value)}; it should be {low:g} to {high:g}{unit}")
    return faults


def read_faults(text: str) -> tuple[Fault, ...]:
    """Return the faults that a text lists.

    Parameters
    ----------
    text : str
        Faults between semicolons, each as ``what@at:names`` or ``what@at-until:names``, times in
        seconds and names between commas.

    Raises
    ------
    ScheduleInvalid
        If it lists none, or something else; all that is wrong at once.

    Examples
    --------
    >>> [str(fault) for fault in read_faults("join@0:R1; hang@2-5.5:R1")]
    ['join@0:R1', 'hang@2-5.5:R1']
    """
    found, wrong = [], []
    known = ", ".join(What)
    for item in filter(None, (part.strip() for part in text.split(";"))):
        match = re.fullmatch(r"([a-z]+)@([0-9.]+)(?:-([0-9.]+))?:([^:;@]+)", item)
        try:
            if match is None:
                raise ValueError
            what, at = What(match[1]), float(match[2])
            until = float(match[3]) if match[3] else math.inf
        except ValueError:
            wrong.append(
                f"{shown(item)} is no fault; write them as "
                f"`join@0.5:R1; hang@2-7:R1; cut@3-9:R1,R2` with one of {known}"
            )
            continue
        names = tuple(name.strip() for name in match[4].split(","))
        if match[3] and (what not in LASTING or not at < until):
            wrong.append(f"{shown(item)}: a {what} has no such end")
        elif len(names) != 2 if what in PAIRS else len(names) != 1 and what is not What.SPLIT:
            wrong.append(f"{shown(item)}: a {what} is of {2 if what in PAIRS else 1} robots")
        elif not at <= LONGEST:
            wrong.append(f"{shown(item)}: its time should be 0 to {LONGEST:g} s")
        else:
            found.append(Fault(what, at, until, names))
    if wrong or not found:
        raise ScheduleInvalid(wrong or ["no fault is listed: not even who joins"])
    return tuple(found)


def draw(
    mode: Mode, seed: int, *, robots: int | None = None, first: Sequence[str] = (), **fixed: float
) -> Schedule:
    """Draw a schedule.

    Parameters
    ----------
    mode : Mode
    seed : int
    robots : int, optional
        How many join; drawn too when left out.
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
    taken = set(first)
    first = [name for name in first if not (id_fault(name) or set(name) & set(",:;@"))]
    names = [name for k in range(1, count + len(taken) + 1) if (name := f"R{k}") not in taken]
    names = names[:count]
    calm = 20.0 if mode is Mode.BURST else round(chance.uniform(10.0, 30.0), 1)
    is_mild = chance.random() < 0.4
    exact = mode in {Mode.BURST, Mode.RESOLVE, Mode.COLD} or chance.random() < 0.5
    values: dict[str, float] = {
        "loss": 0.0 if is_mild else round(chance.uniform(0.0, 0.5), 2),
        "doubled": round(chance.choice([0.0, 0.1, 0.3]), 2),
        "delay": round(math.exp(chance.uniform(math.log(0.005), math.log(1.0))), 3),
        "missed": 0.0 if exact else round(chance.uniform(0.0, 0.2), 2),
        "turned": 0.0 if exact else round(chance.uniform(0.0, 0.1), 2),
        "locks": mode not in {Mode.RESOLVE, Mode.ROSTER} and chance.random() < 0.3,
    }
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


_SIZES = dict.fromkeys(Mode, (4, 9)) | {Mode.BURST: (10, 20), Mode.COLD: (4, 5)}


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


def _by_number(name: str) -> tuple[int, str]:
    """Return what puts R2 before R10."""
    return len(name), name
