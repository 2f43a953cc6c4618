"""What a robot says of itself: the only thing that is shared, and each robot writes its own."""

import math
from enum import IntEnum
from functools import lru_cache

import msgspec

from swarmgrasp.errors import MessageInvalid
from swarmgrasp.ranges import MOST_TURNED, STRONGEST, WEAKEST, name_fault, shown
from swarmgrasp.swarm.robot import Attachment

MOST_NAME = 64
"""Bytes of a name."""
FARTHEST = 1e9
"""Largest coordinate [m]."""
LIVES = 1 << 20
"""An incarnation is the number of a start times so many, plus a number drawn at that start."""
MOST_INCARNATION = 1 << 52
MOST_SEQUENCE = 1 << 32
MOST_TICKET = 1 << 62
MOST_GONE = 256
"""Robots that one robot may testify gone."""
MOST_PLANNED = 32
"""Robots in one joint plan."""
BASIS = 8
"""Bytes of a digest."""

Version = tuple[int, int]


class Phase(IntEnum):
    """Where a robot is on its way."""

    LEFT = 0
    """Not at the object, and not about to be."""
    WAITING = 1
    """It would come, but has no place."""
    COMING = 2
    ARRIVED = 3
    """Beside its place: it asks everyone to confirm."""
    FASTENING = 4
    ATTACHED = 5
    ASKING = 6
    """Attached, and asks everyone whether it may let go."""


class Place(msgspec.Struct, frozen=True, array_like=True):
    """Where a robot is or will be.

    Attributes
    ----------
    x, y : float [m]
        Its contact, in the frame of the outline's vertices.
    direction : float [rad]
        Of its force; of a robot that steers, the middle of its sector.
    steers : float [rad]
        Half of that sector; 0 for a robot that does not steer.
    """

    x: float
    y: float
    direction: float
    steers: float = 0.0


class Kind(msgspec.Struct, frozen=True, array_like=True):
    """What a robot is, where it differs from the mission's newcomer: see `Newcomer`."""

    limit: float
    attachment: Attachment
    half_angle: float | None = None
    steers: bool = False
    reverse_limit: float = 0.0
    friction: float | None = None


class Plan(msgspec.Struct, frozen=True, array_like=True):
    """Places for several robots together, where one after the other is worth little (T17).

    Attributes
    ----------
    basis : bytes
        Digest of the robots that it goes beside.
    quality : float [N]
        Of those and the planned ones.
    places : tuple of (str, Place)
    """

    basis: bytes
    quality: float
    places: tuple[tuple[str, Place], ...]


class Record(msgspec.Struct, frozen=True, array_like=True):
    """One robot, as it told of itself last.

    Attributes
    ----------
    id : str
        Its name.
    incarnation, sequence : int
        Its version: which life of its process, and which word of that.
    phase : Phase
    ticket : int
        When it asked to join, in Lamport's time; 0 if it was attached before anyone asked.
    arrival, asked : int
        How often it has arrived at a place, and how often it has asked to let go of one: what
        confirmations are of.
    kind : Kind, optional
        None for the mission's newcomer, and for a robot of the mission itself.
    place : Place, optional
        Its target; attached, where it was measured to be.
    lower : float [N]
        The certified quality of the robots it counted, itself among them.
    basis : bytes
        Digest of the robots it counted before itself.
    gone : tuple of (str, int)
        Robots, each with its incarnation, that it saw not to be at the object.
    plan : Plan, optional
    """

    id: str
    incarnation: int
    sequence: int
    phase: Phase
    ticket: int = 0
    arrival: int = 0
    asked: int = 0
    kind: Kind | None = None
    place: Place | None = None
    lower: float = 0.0
    basis: bytes = b""
    gone: tuple[tuple[str, int], ...] = ()
    plan: Plan | None = None

    @property
    def version(self) -> Version:
        """Incarnation and sequence: the higher is the newer."""
        return self.incarnation, self.sequence

    @property
    def order(self) -> tuple[int, str]:
        """The ticket, and the name where tickets are equal: who goes before whom."""
        return self.ticket, self.id

    @property
    def arrived_as(self) -> tuple[str, int, int]:
        """Which arrival of which robot this is, whatever life of its process tells it."""
        return self.id, self.ticket, self.arrival

    @property
    def asks_for(self) -> tuple[int, int, int, int]:
        """What a confirmation of it is of."""
        return self.incarnation, self.ticket, self.arrival, self.asked

    @property
    def is_on_its_way(self) -> bool:
        """Whether it wants a place and is at none yet."""
        return self.phase in {Phase.WAITING, Phase.COMING}

    @property
    def is_at_its_place(self) -> bool:
        """Whether it is beside the object: it stays there until it or a witness says otherwise."""
        return self.phase >= Phase.ARRIVED

    @property
    def is_fixed(self) -> bool:
        """Whether it holds the object, or is about to."""
        return self.phase >= Phase.FASTENING

    @property
    def asks(self) -> bool:
        """Whether it waits for everyone's confirmation."""
        return self.phase in {Phase.ARRIVED, Phase.ASKING}


def record_fault(record: Record) -> str:
    """Return what is wrong with a record, as the rest of a sentence; "" if nothing is.

    Examples
    --------
    >>> record_fault(Record("Ajax", 1 << 20, 1, Phase.COMING))
    'has no place, though it is coming'
    """
    fault = id_fault(record.id)
    if fault:
        return fault
    counts = (
        ("incarnation", record.incarnation, MOST_INCARNATION),
        ("sequence", record.sequence, MOST_SEQUENCE),
        ("ticket", record.ticket, MOST_TICKET),
        ("arrival", record.arrival, MOST_SEQUENCE),
        ("asked", record.asked, MOST_SEQUENCE),
    )
    for what, value, most in counts:
        if not 0 <= value < most:
            return f"has the {what} {shown(value)}; it should be 0 <= {what} < {most}"
    if record.phase >= Phase.COMING and record.place is None:
        return f"has no place, though it is {record.phase.name.lower()}"
    if record.phase is Phase.WAITING and record.place is not None:
        return "has a place, though it waits for one"
    if record.is_on_its_way and not record.ticket:
        return "is on its way without a ticket"
    if not 0.0 <= record.lower <= math.inf or math.isinf(record.lower):
        return f"claims a quality of {shown(record.lower)} N"
    if len(record.basis) not in {0, BASIS} or len(record.gone) > MOST_GONE:
        return "has a basis or a list of the gone of impossible length"
    names = [name for name, _ in record.gone]
    plan = record.plan
    places = [record.place] if record.place else []
    if plan is not None:
        if len(plan.places) > MOST_PLANNED or len(plan.basis) != BASIS or not plan.quality >= 0.0:
            return "has an impossible plan"
        names += [name for name, _ in plan.places]
        places += [place for _, place in plan.places]
    faults = [f for f in map(id_fault, names) if f] + [f for f in map(_place_fault, places) if f]
    return faults[0] if faults else _kind_fault(record.kind)


@lru_cache(4096)  # it is asked of every name in every message
def id_fault(name: str) -> str:
    """Return what is wrong with a robot's name, as the rest of a sentence; "" if nothing is.

    It is a part of a key: not empty, short, and without the signs that keys are made with.
    """
    if not name or len(name.encode("utf-8", "replace")) > MOST_NAME:
        return f"has the name {shown(name)}; it should have 1 to {MOST_NAME} bytes"
    if any(sign in "/*$?#@" for sign in name):
        return f"has the name {shown(name)}; a name on the network holds none of / * $ ? # @"
    return name_fault(name)


def check_id(name: str) -> str:
    """Return a robot's name.

    Raises
    ------
    MessageInvalid
        If it cannot be one on the network.
    """
    fault = id_fault(name)
    if fault:
        raise MessageInvalid(f"the robot {fault}")
    return name


def _place_fault(place: Place) -> str:
    """Return what is wrong with a place."""
    if not (abs(place.x) <= FARTHEST and abs(place.y) <= FARTHEST):
        return f"has the contact ({shown(place.x)}, {shown(place.y)}) m"
    if not (abs(place.direction) <= MOST_TURNED and 0.0 <= place.steers <= math.pi):
        return f"has the direction {shown(place.direction)} and steers {shown(place.steers)} rad"
    return ""


def _kind_fault(kind: Kind | None) -> str:
    """Return what is wrong with a kind of robot; what goes together is seen when one is made."""
    if kind is not None and not WEAKEST <= kind.limit <= STRONGEST:
        return f"has the limit {shown(kind.limit)} N"
    return ""


class Row(msgspec.Struct, frozen=True, array_like=True):
    """A robot that is reckoned with, where it is or will be."""

    id: str
    ticket: int
    place: Place
    kind: Kind | None = None
