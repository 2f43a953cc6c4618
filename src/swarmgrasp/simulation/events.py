"""What happens during a run: robots lost, sent, sent away, and a new aim or weather.

Events are the same for all runs of a batch. A place is in metres in the earth's frame, which is the
object's at the start; a bearing is where a stream comes from, clockwise from the bow at the start.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from swarmgrasp.environment.limits import BEARING, SPEED, Range
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import (
    is_number,
    items,
    kind_faults,
    name_faults,
    nearest_name,
    numbers,
    shown,
)
from swarmgrasp.swarm import Newcomer
from swarmgrasp.swarm.names import names_of

TIME = Range(0.0, 1e7, "s")
FAR = Range(-1e7, 1e7, "m")
AWAY = Range(0.0, 1e7, "m")
PACE = Range(1e-6, 1e3, "m/s")
"""Of what is on its way: it arrives."""
ANGLE = Range(-1e6, 1e6, "rad")


@dataclass(frozen=True)
class _Event(Plain):
    """What happens at an instant.

    Attributes
    ----------
    at : float [s]
        Since the start of the run.
    """

    at: float

    does: ClassVar[str]
    """What it is called in messages."""

    def __post_init__(self) -> None:
        """Check the values."""
        faults = [*TIME.faults("time", self.at), *self._faults()]
        if faults:
            raise SimulationInvalid(f"{self.does} at {shown(self.at)} s: {f}" for f in faults)
        kept = {name: float(value) for name, value in vars(self).items() if is_number(value)}
        vars(self).update(kept)

    def _faults(self) -> list[str]:
        """Return what is wrong with the values beside the time."""
        raise NotImplementedError


@dataclass(frozen=True)
class Leave(_Event):
    """A robot lets go as planned; the others know it at once.

    Attributes
    ----------
    at : float [s]
    robot : str
        Its name.

    Raises
    ------
    SimulationInvalid
        If a value is outside its range; all faults at once.
    """

    robot: str

    does = "leave"

    def _faults(self) -> list[str]:
        return name_faults(self.robot)


@dataclass(frozen=True)
class Lose(_Event):
    """A robot exerts nothing any more, or a group: a line parts, a switchboard fails.

    Others of its group, if it has one, are not lost with it: say so of each.

    Attributes
    ----------
    at : float [s]
    robot : str
        Its name, or that of a group, whose robots are lost as one; a name that both have means
        the group.
    noticed : float [s]
        So long after, those who share out the forces know it. Until then they count on it.

    Raises
    ------
    SimulationInvalid
        If a value is outside its range; all faults at once.

    Examples
    --------
    >>> Lose(60, "Castor", noticed=5).noticed
    5.0
    """

    robot: str
    noticed: float = 0.0

    does = "lose"

    def _faults(self) -> list[str]:
        return name_faults(self.robot) + TIME.faults("delay of notice", self.noticed)


@dataclass(frozen=True)
class Send(_Event):
    """A newcomer comes to help: it travels, makes fast, and joins.

    Its place is chosen as it is sent: that which `place` finds by margin beside the mean load,
    among the robots known to be there and those on their way.

    Attributes
    ----------
    at : float [s]
    newcomer : Newcomer, optional
        The problem's own when left out. If a robot has had its name, it gets a number too.
    away : float [m]
        How far from the outline's origin it waits.
    speed : float [m/s]
        At which it travels, round the object the shorter way.
    make_fast : float [s]
        From its arrival until it can push.
    bearing : float [rad]
        Where it waits, clockwise from the bow.

    Raises
    ------
    SimulationInvalid
        If a value is outside its range; all faults at once.
    """

    newcomer: Newcomer | None = None
    away: float = 400.0
    speed: float = 3.0
    make_fast: float = 60.0
    bearing: float = 0.0

    does = "send"

    def _faults(self) -> list[str]:
        faults = AWAY.faults("distance away", self.away) + PACE.faults("speed", self.speed)
        faults += TIME.faults("time to make fast", self.make_fast)
        faults += BEARING.faults("bearing", self.bearing)
        if self.newcomer is not None:
            faults += kind_faults(self.newcomer, Newcomer, "Newcomer(limit)")
        return faults


@dataclass(frozen=True)
class Move(_Event):
    """The object is to be elsewhere.

    Attributes
    ----------
    at : float [s]
    x, y : float [m]
        Where its origin is to be.
    heading : float [rad]
        Counter-clockwise from the heading at the start.

    Raises
    ------
    SimulationInvalid
        If a value is outside its range; all faults at once.
    """

    x: float
    y: float
    heading: float = 0.0

    does = "move"

    def _faults(self) -> list[str]:
        return [
            *FAR.faults("x", self.x),
            *FAR.faults("y", self.y),
            *ANGLE.faults("heading", self.heading),
        ]


@dataclass(frozen=True)
class Follow(_Event):
    """The object is to follow a path, with the heading that it is to have then.

    Attributes
    ----------
    at : float [s]
    path : sequence of (float, float) [m, m]
        Corners after the place where it is to be then.
    speed : float [m/s]
        Along the path.

    Raises
    ------
    SimulationInvalid
        If a value is outside its range; all faults at once.

    Examples
    --------
    >>> Follow(30, [(50, 0), (50, 20)], speed=0.5).path
    ((50.0, 0.0), (50.0, 20.0))
    """

    path: Sequence[tuple[float, float]]
    speed: float

    does = "follow"

    def _faults(self) -> list[str]:
        corners = tuple(map(numbers, items(self.path) or ()))
        vars(self).update(path=corners)
        faults = PACE.faults("speed", self.speed)
        if not corners or any(len(corner) != 2 for corner in corners):
            faults.append("the path should be one or more points of two finite numbers [m, m]")
        return faults + [f for corner in corners for c in corner for f in FAR.faults("corner", c)]


@dataclass(frozen=True)
class Change(_Event):
    """The mean weather changes, at once; what is left out stays as it is.

    Attributes
    ----------
    at : float [s]
    wind_speed, current_speed : float [m/s], optional
    wind_bearing, current_bearing : float [rad], optional
        Where they come from, clockwise from the bow at the start.

    Raises
    ------
    SimulationInvalid
        If a value is outside its range, or nothing changes; all faults at once.
    """

    wind_speed: float | None = None
    wind_bearing: float | None = None
    current_speed: float | None = None
    current_bearing: float | None = None

    does = "change"

    @property
    def said(self) -> dict[str, float]:
        """What changes, by name."""
        kept: dict[str, Any] = {n: v for n, v in vars(self).items() if n != "at"}
        return {name: value for name, value in kept.items() if value is not None}

    def _faults(self) -> list[str]:
        known = {"speed": SPEED, "bearing": BEARING}
        faults = [
            fault
            for name, value in self.said.items()
            for fault in known[name.split("_")[1]].faults(name.replace("_", " "), value)
        ]
        return faults if self.said else ["nothing changes: give a speed or a bearing"]


Event = Leave | Lose | Send | Move | Follow | Change
KINDS = (Leave, Lose, Send, Move, Follow, Change)


def in_order(events: Iterable[Event]) -> tuple[Event, ...]:
    """Return events by time; those of one instant in the order given."""
    return tuple(sorted(events, key=lambda event: event.at))


def joining_names(
    present: Iterable[str], events: Iterable[Event], newcomer: Newcomer
) -> tuple[str, ...]:
    """Return the name of each newcomer that is sent, in the order of time: one nobody has had.

    Parameters
    ----------
    present : iterable of str
        Names of the robots at the start.
    events : iterable of Event
        In order.
    newcomer : Newcomer
        Sent where an event has none of its own.

    Examples
    --------
    >>> joining_names(["Ajax"], [Send(0.0), Send(1.0, Newcomer(name="Ajax"))], Newcomer())
    ('newcomer', 'Ajax 2')
    """
    had = list(present)
    names = []
    for event in events:
        if isinstance(event, Send):
            wanted = (event.newcomer or newcomer).name or "newcomer"
            names += names_of(had).fresh(wanted)
            had.append(names[-1])
    return tuple(names)


def event_faults(
    present: Iterable[str],
    groups: Mapping[str, Sequence[str]],
    events: Sequence[Event],
    newcomer: Newcomer,
    duration: float,
) -> list[tuple[Event, str]]:
    """Return what contradicts in events that are in order: each event at fault, and why it is.

    Parameters
    ----------
    present : iterable of str
        Names of the robots at the start.
    groups : mapping of str to sequence of str
        The robots of each group, by its name.
    events : tuple of Event
    newcomer : Newcomer
        Sent where an event has none of its own.
    duration : float [s]
        Of the run.
    """
    names = iter(joining_names(present, events, newcomer))
    there = list(present)
    gone: dict[str, float] = {}
    aims: dict[tuple[float, str], str] = {}
    faults: list[tuple[Event, str]] = []
    for event in events:
        found = []
        if event.at >= duration:
            found.append(f"the run ends at {duration:g} s; it should be before")
        if isinstance(event, Send):
            there.append(next(names))
        elif isinstance(event, Lose | Leave):
            known = groups if isinstance(event, Lose) else {}
            going = set(known.get(event.robot, (event.robot,))) & set(there)
            if going:
                there = [name for name in there if name not in going]
                gone |= dict.fromkeys([*going, event.robot], event.at)
            elif event.robot in gone:
                found.append(f"{event.robot!r} is gone since {gone[event.robot]:g} s")
            elif event.robot in known:
                found.append(f"all robots of {event.robot!r} are gone")
            else:
                near = nearest_name(event.robot, [*there, *known])
                found.append(f"there is no robot called {event.robot!r} then{near}")
        for aim in _aims(event):
            if (event.at, aim) in aims:
                found.append(f"{aims[event.at, aim]} says another {aim} at the same instant")
            aims[event.at, aim] = event.does
        faults += ((event, f"{event.does} at {event.at:g} s: {fault}") for fault in found)
    return faults


def _aims(event: Event) -> tuple[str, ...]:
    """Return what only one event can say at an instant."""
    if isinstance(event, Move | Follow):
        return ("aim",)
    return tuple(name.replace("_", " ") for name in event.said) if isinstance(event, Change) else ()
