"""What a server says to a page, beside the parts of an answer."""

from typing import Literal

from msgspec import Struct

from swarmgrasp.gui.messages import Doc, Fault, Pair, Part, PartName, RobotData, Speech


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
    """The answer to the right key: what there is, and whether it can be asked for."""

    protocol: int
    version: str
    limits: Limits
    scenes: tuple[SceneTitle, ...]
    opens: str
    run: str | None
    watch: bool
    demonstration: bool
    reports: bool


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


LivePhase = Literal[
    "idle", "coming", "arrived", "making fast", "holds", "leaving", "left", "not answering"
]
"""Where an agent is on its way."""
LiveProcess = Literal["runs", "stopped", "ended"]
"""What an agent's process does."""


class LiveRobot(Part, frozen=True, forbid_unknown_fields=True):
    """An agent: where it is or will be, by how many of how many it is confirmed, whom it hears.

    How many it hears, whom not, and what its process does are known in a demonstration only.
    """

    name: str
    phase: LivePhase
    at: Pair | None
    direction: float | None
    limit: float
    confirmed: int
    of: int
    hears: int | None
    deaf: tuple[str, ...]
    there: bool
    process: LiveProcess | None


class LiveTold(_Said, frozen=True, tag="live"):
    """What has changed among agents, or all of it if `whole`; several sides when they are cut.

    `cut` tells whether a demonstration's network is in two: None where there is no demonstration.
    """

    t: float
    whole: bool
    first: First
    second: str
    certified: float | None
    robots: tuple[LiveRobot, ...]
    sides: tuple[tuple[str, ...], ...]
    conflicts: tuple[str, ...]
    cut: bool | None


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
