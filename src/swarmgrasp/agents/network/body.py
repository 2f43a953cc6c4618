"""The robot itself: a stand-in that travels by itself, or a real one behind lines of JSON.

A real robot's software is told orders, and tells events; both are objects of JSON, one a line on
standard input and output, or one a sample under the keys `.../body/<name>/order` and `.../event`.
"""

import hashlib
import json
import math
from dataclasses import dataclass
from typing import Any, Protocol

from swarmgrasp.agents.network.plain import place_data
from swarmgrasp.agents.protocol.events import (
    AtPlace,
    Event,
    Fasten,
    Fastened,
    Go,
    Halt,
    Join,
    Leave,
    Loosen,
    Loosened,
    Move,
    Refused,
    Witness,
)
from swarmgrasp.agents.protocol.record import Place, id_fault
from swarmgrasp.errors import AgentInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.ranges import nearest_name, number, shown

Order = Go | Halt | Fasten | Loosen
ORDERS = {Go: "go", Halt: "halt", Fasten: "fasten", Loosen: "let go"}
WISHES: dict[str, type[Join | Leave | Move]] = {"join": Join, "leave": Leave, "move": Move}
EVENTS = ("at place", "fastened", "refused", "loosened", "pose", "witness", *WISHES)
MOST_BYTES = 4096
"""Length of an event."""
AROUND = 0.75
"""Distance from the middle of the object at which stand-ins start, in its extents."""


class Body(Protocol):
    """What goes, holds and lets go.

    Attributes
    ----------
    repeats : bool
        Whether its order is told again and again, for software that starts later.
    """

    repeats: bool

    @property
    def wake(self) -> float:
        """When it has something to tell, by the clock [s] it was given."""

    def order(self, clock: float, number: int, order: Order) -> None:
        """Take an order, which has a number."""

    def due(self, clock: float) -> list[Event]:
        """Return what has happened to it by now."""

    def told(self, data: bytes) -> list[Event]:
        """Return what its software says in an object of JSON.

        Raises
        ------
        AgentInvalid
            If that is no event.
        """


class StandIn:
    """A robot for trials: it goes straight to its place, takes hold, and lets go.

    Parameters
    ----------
    name : str
        Decides where around the object it starts.
    outline : Outline
    speed : float [m/s]
    fastening : float [s]
        How long it takes to take hold, and to let go.
    attached : Place, optional
        Where it begins, if it is attached.
    """

    repeats = False

    def __init__(
        self, name: str, outline: Outline, speed: float, fastening: float,
        attached: Place | None = None,
    ) -> None:  # fmt: skip
        if not 0.0 < number(speed) <= 1e6 or not 0.0 <= number(fastening) <= 1e6:
            raise AgentInvalid(
                f"the speed is {shown(speed)} and fastening takes {shown(fastening)}; they should "
                "be 0 < speed <= 1e6 [m/s] and 0 <= fastening <= 1e6 [s]"
            )
        self._speed, self._fastening = speed, fastening
        turn = hashlib.blake2b(name.encode(), digest_size=4).digest()
        angle = math.tau * int.from_bytes(turn, "big") / 2**32
        far = AROUND * outline.extent
        self._at = far * math.cos(angle), far * math.sin(angle)
        if attached is not None:
            self._at = attached.x, attached.y
        self._from, self._left_at = self._at, 0.0
        self._next: tuple[float, Event] | None = None
        self._target: Place | None = None

    @property
    def wake(self) -> float:
        """When it has something to tell."""
        return self._next[0] if self._next else math.inf

    def order(self, clock: float, number: int, order: Order) -> None:  # noqa: ARG002
        """Do as it is told."""
        self._stop(clock)
        match order:
            case Go(place):
                self._target, self._from, self._left_at = place, self._at, clock
                way = math.hypot(place.x - self._at[0], place.y - self._at[1])
                self._next = clock + way / self._speed, AtPlace()
            case Fasten(place):
                self._at = place.x, place.y
                self._next = clock + self._fastening, Fastened(place)
            case Loosen():
                self._next = clock + self._fastening, Loosened()

    def due(self, clock: float) -> list[Event]:
        """Return what has happened."""
        if self._next is None or clock < self._next[0]:
            return []
        event = self._next[1]
        self._stop(clock)
        return [event]

    def told(self, data: bytes) -> list[Event]:
        """Return what it is asked to do; it knows by itself what happens to it."""
        name, known = _event_of(data)
        if name not in WISHES and name != "witness":
            raise AgentInvalid(f"a stand-in is told {name!r}, which it finds out by itself")
        return _common(name, known)

    def _stop(self, clock: float) -> None:
        """Be where it is by now."""
        if self._target is not None:
            (x, y), target = self._from, self._target
            way = math.hypot(target.x - x, target.y - y)
            done = min(1.0, self._speed * (clock - self._left_at) / way) if way else 1.0
            self._at = x + done * (target.x - x), y + done * (target.y - y)
        self._target = self._next = None


@dataclass(frozen=True)
class Pose:
    """Where a robot measures itself to be."""

    x: float
    y: float
    direction: float


class RealBody:
    """A robot that its own software drives.

    Its orders are numbered; reports on an order that has been replaced are not heeded.
    """

    repeats = True
    wake = math.inf

    def __init__(self) -> None:
        self._number = 0
        self._order: Order | None = None
        self._pose: Pose | None = None

    def order(self, clock: float, number: int, order: Order) -> None:  # noqa: ARG002
        """Note the order; it is told by the process, as every robot's is."""
        self._number, self._order = number, order

    def due(self, clock: float) -> list[Event]:  # noqa: ARG002
        """Return nothing: all that happens is told."""
        return []

    def told(self, data: bytes) -> list[Event]:
        """Return what its software says."""
        name, known = _event_of(data)
        if known.get("order", self._number) != self._number:
            return []
        match name:
            case "at place":
                return [AtPlace()] if isinstance(self._order, Go) else []
            case "refused":
                return [Refused()]
            case "loosened":
                return [Loosened()]
            case "pose":
                self._pose = _pose_of(known)
                return []
            case "fastened":
                if "x" in known:
                    self._pose = _pose_of(known)
                return [Fastened(self._place())]
        return _common(name, known)

    def _place(self) -> Place:
        """Return where it holds the object: as measured, or else as ordered."""
        ordered = self._order.place if isinstance(self._order, Go | Fasten) else None
        if self._pose is not None:
            steers = ordered.steers if ordered else 0.0
            return Place(self._pose.x, self._pose.y, self._pose.direction, steers)
        if ordered is None:
            raise AgentInvalid("the event 'fastened' says no x, y and direction, and none is known")
        return ordered


def order_data(order: Order, number: int) -> dict[str, Any]:
    """Return an order as plain data."""
    place = place_data(order.place) if isinstance(order, Go | Fasten) else None
    return {"order": ORDERS[type(order)], "number": number, **(place or {})}


def _event_of(data: bytes) -> tuple[str, dict[str, Any]]:
    """Return an event's name, and what it says."""
    if len(data) > MOST_BYTES:
        raise AgentInvalid(f"an event has {len(data)} bytes; at most {MOST_BYTES} are read")
    try:
        known = json.loads(data)
    except (ValueError, RecursionError):
        known = None
    name = known.get("event") if isinstance(known, dict) else None
    if name not in EVENTS:
        said = shown(data.decode("utf-8", "replace"))
        likely = nearest_name(str(name), EVENTS) if name else ""
        raise AgentInvalid(f"{said} is no event{likely}; the events are {', '.join(EVENTS)}")
    return str(name), known


def _common(name: str, known: dict[str, Any]) -> list[Event]:
    """Return what any robot may be told."""
    if name != "witness":
        return [WISHES[name]()]
    robot = known.get("robot")
    if not isinstance(robot, str) or id_fault(robot):
        raise AgentInvalid(f"the event 'witness' is about {shown(robot)}; it should name a robot")
    return [Witness(robot)]


def _pose_of(known: dict[str, Any]) -> Pose:
    """Return a measured pose."""
    values = [number(known.get(key)) for key in ("x", "y", "direction")]
    if not all(abs(value) <= 1e6 for value in values):
        raise AgentInvalid(f"{shown(known)} should have the numbers x, y [m] and direction [rad]")
    return Pose(*values)
