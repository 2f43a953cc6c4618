"""The parts of an answer, as a page is told them."""

from typing import Literal

from msgspec import Struct

from swarmgrasp.gui.messages import Pair, Part, RobotData, Triple
from swarmgrasp.gui.replies import Array, First


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
