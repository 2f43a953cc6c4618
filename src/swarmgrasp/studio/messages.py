"""What page and server say to each other, strictly: unknown keys and wrong kinds are refused.

The page's types, `client/src/messages.ts`, are made of these classes by `typescript`.
"""

from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta, Struct

PROTOCOL = 1
"""Version of all this; a page of another one is told to be loaded anew."""
MOST_NUMBER = 2**53
"""Of any number of a message: what a page counts to without loss."""
MOST_TEXT = 1_000_000
"""Characters of a scenario, as `scenario` limits its files."""
MOST_NAME = 200
MOST_ROBOTS = 1000
"""Robots placed one after the other."""

Number = Annotated[int, Meta(ge=0, le=MOST_NUMBER)]
Name = Annotated[str, Meta(max_length=MOST_NAME)]
Source = Annotated[str, Meta(max_length=MOST_TEXT)]
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


class Write(_Asked, frozen=True, forbid_unknown_fields=True):
    """The text with what the document changes."""

    n: Number
    doc: Doc
    text: Source


class Forces(_Asked, frozen=True, forbid_unknown_fields=True):
    """How hard each robot pushes for a wrench [N, N, N m]."""

    n: Number
    doc: Doc
    speech: Speech
    wrench: Triple


class Sequence(_Asked, frozen=True, forbid_unknown_fields=True):
    """Several newcomers, one after the other or together."""

    n: Number
    doc: Doc
    speech: Speech
    robots: Annotated[int, Meta(ge=1, le=MOST_ROBOTS)]
    together: bool


class Report(_Asked, frozen=True, forbid_unknown_fields=True):
    """The sheet about the job."""

    n: Number
    doc: Doc
    speech: Speech
    text: Source
    format: Literal["html"]


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
    what: Literal["kill", "stop", "go on", "split", "join"]


class Cancel(_Asked, frozen=True, forbid_unknown_fields=True):
    """Leave the rest of an ask."""

    n: Number


FromPage = (
    Hello | Open | Text | Ask | Write | Forces | Sequence | Report | Run | Watch | Control | Cancel
)
"""What a page may say."""

# -- to the page --------------------------------------------------------------------------


class _Said(Struct, frozen=True, tag_field="kind", tag=str.lower):
    """A message to a page."""


class Limits(Part, frozen=True, forbid_unknown_fields=True):
    """What a page keeps to: bytes of a message, messages a second, robots."""

    message: int
    rate: int
    text: int
    robots: int


class SceneTitle(Part, frozen=True, forbid_unknown_fields=True):
    """A scene to choose."""

    name: str
    title: str


class Welcome(_Said, frozen=True):
    """The answer to the right key."""

    protocol: int
    version: str
    limits: Limits
    scenes: tuple[SceneTitle, ...]
    opens: str
    run: str | None
    watch: bool
    demonstration: bool


class Scene(_Said, frozen=True):
    """A scenario as it was read."""

    n: int
    name: str
    text: str
    doc: Doc
    speech: Speech
    warnings: tuple[Fault, ...]


class Faults(_Said, frozen=True):
    """What is wrong with a text."""

    n: int
    faults: tuple[Fault, ...]


class Refused(_Said, frozen=True):
    """What is wrong with a document."""

    n: int
    faults: tuple[Fault, ...]


class Empty(_Said, frozen=True):
    """Why a part has nothing."""

    n: int
    of: PartName
    why: str


class Done(_Said, frozen=True):
    """All parts of an ask have been told."""

    n: int


class Error(_Said, frozen=True):
    """What could not be done."""

    n: int | None
    say: str


class Written(_Said, frozen=True, tag="text"):
    """The text of a document."""

    n: int
    text: str


class First(Part, frozen=True, forbid_unknown_fields=True):
    """The verdict, and whether it is a good one."""

    text: str
    good: bool


class Array(Part, frozen=True, forbid_unknown_fields=True):
    """An array that follows the head of a binary frame, each at a multiple of 8 bytes."""

    name: str
    type: Literal["f4", "f8", "i2", "u2", "i1", "u4"]
    shape: tuple[int, ...]


class ForceTold(Part, frozen=True, forbid_unknown_fields=True):
    """The force [N, N] of one robot, and its share of the largest it has that way."""

    name: str
    force: Pair
    share: float
    say: str


class ForcesTold(_Said, frozen=True, tag="forces"):
    """How hard each robot pushes: the largest share, and by how much [N] it falls short."""

    n: int
    robots: tuple[ForceTold, ...]
    top: float
    shortfall: float
    say: str
    held: bool


class Placed(Part, frozen=True, forbid_unknown_fields=True):
    """One of several newcomers in its place, with the quality [N] before it came and after."""

    newcomer: RobotData
    place: str
    do: str
    before: float
    after: float
    text: str


class SequenceTold(_Said, frozen=True, tag="sequence"):
    """Several newcomers, and how far from the best they can be."""

    n: int
    answers: tuple[Placed, ...]
    say: str


class ReportTold(_Said, frozen=True, tag="report"):
    """The sheet as one file."""

    n: int
    html: str


class RunRobot(Part, frozen=True, forbid_unknown_fields=True):
    """A robot of a run: its contact from the outline's origin, its way [rad], when it is there [s].

    A newcomer is one that was sent.
    """

    name: str
    contact: Pair
    direction: float
    limit: float
    newcomer: bool
    there: tuple[Pair, ...]


class RunRoute(Part, frozen=True, forbid_unknown_fields=True):
    """The way of a robot that is sent, in the object's frame, and its times [s]."""

    robot: str
    start: float
    arrival: float
    joined: float
    points: tuple[Pair, ...]


class RunHappening(Part, frozen=True, forbid_unknown_fields=True):
    """Something that happened."""

    time: float
    kind: str
    robot: str
    words: str


class RunTold(_Said, frozen=True, tag="run"):
    """A recorded run of m instants and n robots, in the earth's frame.

    Arrays f4: `times` (m,), `poses`, `references` (m, 3), `wind`, `water` (m, 2), `shortfalls`
    (m,), `forces` and `angles` (m, n): of a robot that is not there the force is 0, the angle NaN.
    Farther than `within` [m] from where it is to be, or turned by more than `turn` [rad], the
    object is not held.
    """

    n: int
    name: str
    first: First
    second: str
    seed: int
    within: float
    turn: float
    outline: tuple[Pair, ...]
    robots: tuple[RunRobot, ...]
    routes: tuple[RunRoute, ...]
    happenings: tuple[RunHappening, ...]
    arrays: tuple[Array, ...]


LivePhase = Literal["idle", "coming", "arrived", "making fast", "holds", "leaving", "not answering"]
"""Where an agent is on its way."""


class LiveRobot(Part, frozen=True, forbid_unknown_fields=True):
    """An agent: where it is or will be, by how many of how many it is confirmed, whom it hears."""

    name: str
    phase: LivePhase
    at: Pair | None
    direction: float | None
    limit: float
    confirmed: int
    of: int
    hears: int
    deaf: tuple[str, ...]
    there: bool


class LiveTold(_Said, frozen=True, tag="live"):
    """What has changed among agents, or all of it if `whole`; several sides when they are cut."""

    t: float
    whole: bool
    first: First
    second: str
    certified: float | None
    robots: tuple[LiveRobot, ...]
    sides: tuple[tuple[str, ...], ...]
    conflicts: tuple[str, ...]


# -- parts of an answer -------------------------------------------------------------------


class _PartSaid(Struct, frozen=True, tag_field="name", kw_only=True):
    """A part of the answer to an ask, with the milliseconds of thread time that it took."""

    kind: Literal["part"] = "part"
    n: int
    ms: float


class Order(Part, frozen=True, forbid_unknown_fields=True):
    """Who goes where, and does what: a force acts on the object along `way` [rad]."""

    name: str
    place: str
    contact: Pair
    way: float
    do: str


class Figure(Part, frozen=True, forbid_unknown_fields=True):
    """A large figure before and after, in a unit that people read."""

    before: float | None
    after: float
    unit: str
    text: str


class Fact(Part, frozen=True, forbid_unknown_fields=True):
    """A fact with the mark that is its key in the pictures."""

    mark: Literal["proven", "weakest", "loss", "load", "note"]
    label: str
    text: str
    names: tuple[str, ...]


class NextPlace(Part, frozen=True, forbid_unknown_fields=True):
    """The best of another place; its share is of the best of all."""

    place: str
    contact: Pair
    direction: float
    value: float
    text: str
    share: float


class WeakestTold(Part, frozen=True, forbid_unknown_fields=True):
    """The weakest wrench [N, N, N m], and who sets it."""

    wrench: Triple
    names: tuple[str, ...]


class AnswerPart(_PartSaid, frozen=True, kw_only=True, tag="answer"):
    """The answer in words and figures.

    `before`, `after` and `bound` are qualities [N] ("quality"), winds [m/s] ("wind"), or how many
    times the load is held ("load"); `next` is empty while moving.
    """

    question: Literal["quality", "wind", "load"]
    first: First
    second: str
    order: Order | None
    figures: tuple[Figure, ...]
    facts: tuple[Fact, ...]
    next: tuple[NextPlace, ...]
    newcomer: RobotData | None
    before: float
    after: float
    bound: float | None
    margin: float | None
    load: Triple
    weakest: WeakestTold | None
    worst_loss: tuple[str, ...] | None
    share: float | None


class Ball(Part, frozen=True, forbid_unknown_fields=True):
    """The largest ball, in the mesh's steps: where it is, and where it touches which face."""

    centre: Triple
    radius: float
    touches: Triple
    face: int | None


class MeshPart(_PartSaid, frozen=True, kw_only=True, tag="mesh"):
    """The wrench set in the metric's coordinates, in whole steps of `unit` newtons.

    Arrays `corners` i2 (v, 3), `faces` u2 (indices, flat), `starts` u2 (f + 1,) and `normals` i1
    (f, 3).
    """

    unit: float
    ball: Ball | None
    before: float | None
    needed: Triple
    arrays: tuple[Array, ...]


class Least(Part, frozen=True, forbid_unknown_fields=True):
    """The least wind held [m/s], from a bearing [rad]."""

    bearing: float
    speed: float


class CapabilityPart(_PartSaid, frozen=True, kw_only=True, tag="capability"):
    """The winds held [m/s] at bearings [rad] clockwise from the bow; none is told as NaN.

    Arrays f4 (m,): `bearings`, `intact`, `lost`, and with a newcomer `before_intact` and
    `before_lost`.
    """

    least: Least
    figure: Figure
    arrays: tuple[Array, ...]


class LossRow(Part, frozen=True, forbid_unknown_fields=True):
    """What the loss of one leaves [N]."""

    name: str
    value: float
    held: bool
    worst: bool
    text: str


class LossesPart(_PartSaid, frozen=True, kw_only=True, tag="losses"):
    """What each loss leaves, the worst first, and what all have together [N]."""

    rows: tuple[LossRow, ...]
    all: float
    text: str


class Slope(Part, frozen=True, forbid_unknown_fields=True):
    """How fast the quality rises when one robot moves [N/m] the better way, or turns [N/deg].

    It is better moved towards `direction` [rad], and turned counter-clockwise if `per_degree` is
    positive, clockwise if it is negative; 0 or less a metre is nothing to gain.
    """

    name: str
    per_metre: float | None
    direction: float | None
    per_degree: float | None
    text: str


class SlopesPart(_PartSaid, frozen=True, kw_only=True, tag="slopes"):
    """The slopes of every robot: clockwise along the boundary or in turning, and the other way."""

    rows: tuple[Slope, ...]


class LandscapePiece(Part, frozen=True, forbid_unknown_fields=True):
    """A piece of the boundary: its arc lengths [m], and the part of the array that is its own.

    Its values stand at `first` and on, column by column: (columns, rows).
    """

    name: str
    edge: str
    start: float
    end: float
    columns: tuple[float, ...]
    rows: tuple[float, ...]
    first: int


class LandscapePart(_PartSaid, frozen=True, kw_only=True, tag="landscape"):
    """The quality at every allowed place and direction.

    Arrays `values` u2, flat: 0 where nothing is allowed, else 1 + value / `unit`; and `strip` u2,
    the best over the directions of each column, columns after columns.
    """

    pieces: tuple[LandscapePiece, ...]
    unit: float
    low: float
    high: float
    arrays: tuple[Array, ...]


class ProofPart(_PartSaid, frozen=True, kw_only=True, tag="proof"):
    """What the check says of the answer."""

    ok: bool
    text: str


PartSaid = (
    AnswerPart | MeshPart | CapabilityPart | LossesPart | SlopesPart | LandscapePart | ProofPart
)
ToPage = (
    Welcome
    | Scene
    | Faults
    | Refused
    | Empty
    | Done
    | Error
    | Written
    | ForcesTold
    | SequenceTold
    | ReportTold
    | RunTold
    | LiveTold
)
"""What a server may say, beside parts."""

ARRAYS: dict[str, dict[str, str]] = {
    "MeshPart": {"corners": "i2", "faces": "u2", "starts": "u2", "normals": "i1"},
    "CapabilityPart": {
        "bearings": "f4",
        "intact": "f4",
        "lost": "f4",
        "before_intact?": "f4",
        "before_lost?": "f4",
    },
    "LandscapePart": {"values": "u2", "strip": "u2"},
    "RunTold": {
        "times": "f4",
        "poses": "f4",
        "references": "f4",
        "wind": "f4",
        "water": "f4",
        "shortfalls": "f4",
        "forces": "f4",
        "angles": "f4",
    },
}
"""The arrays that follow parts, and their types; those with "?" may be missing."""
CALLED = {
    "Error": "ErrorTold",
    "ForcesTold": "Forces",
    "LiveTold": "Live",
    "Measure": "UnitData",
    "ReportTold": "Report",
    "SequenceTold": "Sequence",
    "RunTold": "Run",
    "Speech": "SpeechData",
}
"""What messages are called in the page, where it is another name."""

_reader = msgspec.json.Decoder(FromPage)
_writer = msgspec.json.Encoder()


def read_message(raw: str | bytes) -> FromPage:
    """Read a message of a page.

    Raises
    ------
    msgspec.DecodeError
        If it is none; the error says where and why.
    """
    message: FromPage = _reader.decode(raw)
    return message


def write_message(message: ToPage | PartSaid) -> bytes:
    """Write a message to a page, or the head of one that has arrays."""
    return _writer.encode(message)
