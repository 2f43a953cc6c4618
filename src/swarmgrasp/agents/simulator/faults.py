"""What happens to robots on a simulated network, as a list: it shrinks by leaving things out.

A schedule can be written as text and read back.
"""

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

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
    GROUPS = "groups"
    """Many hold the object, in groups that share summaries, and some more join."""


FLAT = tuple(mode for mode in Mode if mode is not Mode.GROUPS)
"""Modes in which everybody knows everybody."""


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
    begin : int
        In mode groups: how many hold the object when it begins, B1, B2 and so on.
    groups : int
        In mode groups: how many there are.
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
    begin: int = 0
    groups: int = 0
    names: tuple[str, ...] = field(init=False, repr=False, compare=False)
    """All robots that it is about, in order."""

    def __post_init__(self) -> None:
        """Check the numbers."""
        faults = number_faults({what: getattr(self, what) for what in RANGES})
        names = {name for each in self.faults for name in each.names}
        names.update(f"B{k}" for k in range(1, self.begin + 1))
        if not 1 <= len(names) <= MOST_ROBOTS or len(self.faults) > MOST_FAULTS:
            faults.append(
                f"a schedule of {len(names)} robots and {len(self.faults)} faults; it should have "
                f"1 to {MOST_ROBOTS} robots and at most {MOST_FAULTS} faults"
            )
        is_flat = self.mode is not Mode.GROUPS
        if is_flat if self.groups or self.begin else not is_flat:
            faults.append("groups, and robots that hold the object first, are of mode groups")
        if faults:
            raise ScheduleInvalid(faults)
        vars(self).update(names=tuple(sorted(names, key=_by_number)))

    @property
    def text(self) -> str:
        """The faults as text, in order of time."""
        return "; ".join(map(str, sorted(self.faults, key=lambda each: each.at)))


RANGES = {
    "loss": (0.0, 1.0, ""),
    "doubled": (0.0, 1.0, ""),
    "delay": (0.0, 60.0, " s"),
    "missed": (0.0, 1e6, " m"),
    "turned": (0.0, math.pi, " rad"),
    "calm": (1.0, LONGEST, " s"),
}
"""The least and the largest number of a schedule, and its unit."""


def number_faults(values: Mapping[str, float]) -> list[str]:
    """Return what is wrong with numbers of a schedule, each a sentence.

    Parameters
    ----------
    values : mapping of str to float
        By name, of those that a `Schedule` has: `loss`, `delay` [s] and so on.
    """
    faults = []
    for what, value in values.items():
        low, high, unit = RANGES[what]
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


def _by_number(name: str) -> tuple[int, str]:
    """Return what puts R2 before R10."""
    return len(name), name
