"""What page and server say to each other, strictly: unknown keys and wrong kinds are refused.

The page's types, `client/src/messages.ts`, are made of these classes by `typescript`.
"""

from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta, Struct

from swarmgrasp.gui.frames import columns_of, unframed

PROTOCOL = 1
"""Version of all this; a page of another one is told to be loaded anew."""
MOST_NUMBER = 2**53
"""Of any number of a message: what a page counts to without loss."""
MOST_TEXT = 1_000_000
"""Characters of a scenario, as `scenario` limits its files."""
MOST_NAME = 200
MOST_ROBOTS = 1000
"""Robots placed one after the other."""
MOST_ROBOTS_SHOWN = 100_000
"""Robots of a document."""

Number = Annotated[int, Meta(ge=0, le=MOST_NUMBER)]
Name = Annotated[str, Meta(max_length=MOST_NAME)]
Source = Annotated[str, Meta(max_length=MOST_TEXT)]
Names = tuple[Name, ...]
"""Of the robots of a document whose numbers follow as columns."""
Pair = tuple[float, float]
Triple = tuple[float, float, float]
PartName = Literal["answer", "mesh", "capability", "losses", "landscape", "slopes", "proof"]
"""The parts of an answer."""
ProblemData = dict[str, Any]
"""The plain form of a `Problem`, which `Problem.from_data` checks."""
EnvironmentData = dict[str, Any]
"""The plain form of an `Environment`."""
RobotData = dict[str, Any]
"""The plain form of a `Robot`."""


class Part(Struct, frozen=True, forbid_unknown_fields=True):
    """A part of messages of both ways."""


class Measure(Part, frozen=True, forbid_unknown_fields=True):
    """A unit: its name in the library, its size in SI units, and what people read."""

    unit: Name
    size: float
    label: Name


class Speech(Part, frozen=True, forbid_unknown_fields=True):
    """How a file's people speak; angles in radians, the bow in the file's frame."""

    length: Measure
    force: Measure
    angle: Measure
    speed: Measure
    torque_unit: Name
    robot: Name
    bow: float
    mirrored: bool
    heading: float | None
    bearings: bool


class Doc(Part, frozen=True, forbid_unknown_fields=True):
    """The state of a page: what is asked, in SI units and our frame.

    With `in_weather` the load is the environment's, and the criterion's own plays no part. Without
    `newcomer` there is nobody to place.
    """

    name: Name
    description: Source
    problem: ProblemData
    environment: EnvironmentData | None
    in_weather: bool
    newcomer: bool


class Fault(Part, frozen=True, forbid_unknown_fields=True):
    """One thing that is wrong: at a line and column of the text, or at a key of the document."""

    line: int | None
    column: int | None
    path: str
    sentence: str


# -- from the page ------------------------------------------------------------------------


class _Asked(Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", tag=str.lower):
    """A message of a page."""


class Hello(_Asked, frozen=True, forbid_unknown_fields=True):
    """The first one: the key of the link, which nobody else knows."""

    key: Annotated[str, Meta(max_length=100)]
    protocol: int


class Open(_Asked, frozen=True, forbid_unknown_fields=True):
    """A scene by name."""

    n: Number
    name: Name


class Text(_Asked, frozen=True, forbid_unknown_fields=True):
    """A scenario as text."""

    n: Number
    text: Source
    name: Name


class Ask(_Asked, frozen=True, forbid_unknown_fields=True):
    """Where the newcomer goes, and all that follows; while `moving` only what is cheap."""

    n: Number
    moving: bool
    doc: Doc
    speech: Speech
    wants: tuple[PartName, ...] | None = None
    names: Names | None = None


class Write(_Asked, frozen=True, forbid_unknown_fields=True):
    """The text with what the document changes."""

    n: Number
    doc: Doc
    text: Source
    names: Names | None = None


class Forces(_Asked, frozen=True, forbid_unknown_fields=True):
    """How hard each robot pushes for a wrench [N, N, N m]."""

    n: Number
    doc: Doc
    speech: Speech
    wrench: Triple
    names: Names | None = None


class Sequence(_Asked, frozen=True, forbid_unknown_fields=True):
    """Several newcomers, one after the other or together."""

    n: Number
    doc: Doc
    speech: Speech
    robots: Annotated[int, Meta(ge=1, le=MOST_ROBOTS)]
    together: bool
    names: Names | None = None


class Report(_Asked, frozen=True, forbid_unknown_fields=True):
    """The sheet about the job."""

    n: Number
    doc: Doc
    speech: Speech
    text: Source
    format: Literal["html"]
    names: Names | None = None


class Run(_Asked, frozen=True, forbid_unknown_fields=True):
    """The recorded run."""

    n: Number
    name: Name


class Watch(_Asked, frozen=True, forbid_unknown_fields=True):
    """Begin to tell of the agents, or end it."""

    n: Number
    on: bool


class Control(_Asked, frozen=True, forbid_unknown_fields=True):
    """In a demonstration: do something to an agent, or to the network."""

    n: Number
    robot: Name | None
    what: Literal["kill", "stop", "go on", "come", "leave", "split", "join"]


class Cancel(_Asked, frozen=True, forbid_unknown_fields=True):
    """Leave the rest of an ask."""

    n: Number


FromPage = (
    Hello | Open | Text | Ask | Write | Forces | Sequence | Report | Run | Watch | Control | Cancel
)
"""What a page may say."""

_reader = msgspec.json.Decoder(FromPage)


def read_message(raw: str | bytes) -> FromPage:
    """Read a message of a page: JSON, or a binary frame whose columns become its robots.

    Raises
    ------
    msgspec.DecodeError
        If it is none; the error says where and why.
    """
    head, body = (raw, None) if isinstance(raw, str) else unframed(raw)
    message: FromPage = _reader.decode(head)
    if body is not None:
        _take_columns(message, body)
    return message


def _take_columns(message: FromPage, body: memoryview) -> None:
    """Put columns in the place of the robots of a message's document."""
    doc = getattr(message, "doc", None)
    swarm = doc.problem.get("swarm") if isinstance(doc, Doc) else None
    if not isinstance(swarm, dict) or swarm.get("robots") != []:
        raise msgspec.ValidationError("Columns go with a document without robots")
    swarm["robots"] = columns_of(body, getattr(message, "names", None))
