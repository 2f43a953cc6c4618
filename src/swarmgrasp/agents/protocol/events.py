"""What a robot's own software and the network tell an agent, and what it answers."""

from dataclasses import dataclass

from swarmgrasp.agents.protocol.planner import Who
from swarmgrasp.agents.protocol.record import Place, Plan, Row
from swarmgrasp.agents.protocol.wire import Message

EVERYONE = "*"
ANYONE = "?"
"""Of those that are heard, whichever the transport likes."""


@dataclass(frozen=True)
class Start:
    """The process begins; where the robot is attached, if it is."""

    attached: Place | None = None


@dataclass(frozen=True)
class Join:
    """The robot is to come and help."""


@dataclass(frozen=True)
class Leave:
    """The robot is to let go, if it holds the object, and go."""


@dataclass(frozen=True)
class Move:
    """The robot is to look for a better place."""


@dataclass(frozen=True)
class Tick:
    """Time has passed."""


@dataclass(frozen=True)
class Received:
    """A message came in, from the robot whose key it was sent under.

    Attributes
    ----------
    sender : str
    message : Message
    is_direct : bool
        Whether it was sent to this robot alone.
    """

    sender: str
    message: Message
    is_direct: bool = True


@dataclass(frozen=True)
class Refuted:
    """Bytes came in that are no message of a sound robot, or are under another's key."""

    sender: str
    fault: str


@dataclass(frozen=True)
class Up:
    """The network says that a robot's process is there."""

    name: str


@dataclass(frozen=True)
class Down:
    """The network says that a robot's process has ended."""

    name: str


@dataclass(frozen=True)
class Cut:
    """The robot's own link to the network is broken, or has just been made anew."""


@dataclass(frozen=True)
class Stranger:
    """A robot is heard that works on something else, or by another protocol."""

    name: str
    mission: str


@dataclass(frozen=True)
class AtPlace:
    """The robot is where it was told to go."""


@dataclass(frozen=True)
class Fastened:
    """The robot holds the object, there by its own measurement."""

    place: Place


@dataclass(frozen=True)
class Refused:
    """The robot's place is seen to be taken."""


@dataclass(frozen=True)
class Loosened:
    """The robot has let go of the object."""


@dataclass(frozen=True)
class Witness:
    """The robot sees that another is not where it should be."""

    name: str


@dataclass(frozen=True)
class Planned:
    """A joint plan that was asked for; None if none was found."""

    plan: Plan | None


Event = (
    Start | Join | Leave | Move | Tick | Received | Refuted | Up | Down | Cut | Stranger
    | AtPlace | Fastened | Refused | Loosened | Witness | Planned
)  # fmt: skip


@dataclass(frozen=True)
class Send:
    """Send a message to a robot, to `EVERYONE` or to `ANYONE`."""

    to: str
    message: Message


@dataclass(frozen=True)
class Go:
    """Go beside this place."""

    place: Place


@dataclass(frozen=True)
class Halt:
    """Go nowhere: there is no place."""


@dataclass(frozen=True)
class Fasten:
    """Take hold of the object there."""

    place: Place


@dataclass(frozen=True)
class Loosen:
    """Let go of the object."""


@dataclass(frozen=True)
class MakePlan:
    """Find places for several robots together, beside others, and tell `Planned`.

    It may take seconds: it is to be done beside all else.
    """

    beside: tuple[Row, ...]
    names: tuple[str, ...]
    who: Who


@dataclass(frozen=True)
class Report:
    """Something a person should know.

    Attributes
    ----------
    what : str
        One word for programs.
    words : str
        A sentence.
    about : tuple of str
        The robots it is about.
    """

    what: str
    words: str
    about: tuple[str, ...] = ()


Effect = Send | Go | Halt | Fasten | Loosen | MakePlan | Report
