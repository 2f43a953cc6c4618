"""What an answer file says, checked for form only."""

import json
import math
from collections import Counter
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator
from shapely import LinearRing

from swarmgrasp.errors import AnswerInvalid

MOST_TURNED = 1e6
"""Of any angle [rad]: beyond it, rounding eats the direction."""
LARGEST = 1e100
"""Of any number: its cube is still one."""
SMALLEST = 1e-100
"""Of the metric's numbers, and of the largest number of a task: it can be divided by."""

Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
Size = Annotated[float, Field(ge=0.0, le=LARGEST)]
Positive = Annotated[float, Field(gt=0.0, le=LARGEST)]
Angle = Annotated[float, Field(ge=-MOST_TURNED, le=MOST_TURNED)]
HalfAngle = Annotated[float, Field(ge=0.0, le=math.pi / 2)]
Past = Annotated[float, Field(ge=-LARGEST, le=0.0)]
TurnBack = Annotated[float, Field(ge=-math.pi, le=0.0)]
TurnOn = Annotated[float, Field(ge=0.0, le=math.pi)]
HalfTurn = Annotated[float, Field(ge=0.0, le=math.pi)]
Point = tuple[Number, Number]
Wrench = tuple[Number, Number, Number]

_SAID = {"extra_forbidden": "unknown key", "missing": "is missing"}
"""What is said of keys, as of those of scenarios."""


class _Form(BaseModel):
    """Strict: no number from text, nothing infinite, nothing unknown."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False, frozen=True)


class ToleranceClaim(_Form):
    """How far a robot may be from what is said of it."""

    contact: tuple[Past, Size]
    direction: tuple[TurnBack, TurnOn]
    least_limit: Positive | None
    may_be_absent: bool

    @property
    def is_spread(self) -> bool:
        """Whether contact or direction is uncertain."""
        return (*self.contact, *self.direction) != (0.0, 0.0, 0.0, 0.0)

    def certain(self, limit: float) -> float:
        """Return what a robot of a limit [N] exerts for certain."""
        if self.may_be_absent:
            return 0.0
        return limit if self.least_limit is None else min(self.least_limit, limit)


class BodyClaim(_Form):
    """The room that a robot takes up beside the object."""

    length: Positive
    beam: Positive


class RobotClaim(_Form):
    """A robot in contact."""

    contact: Point
    direction: Angle
    limit: Positive
    name: str
    mounted: bool
    tolerance: ToleranceClaim | None
    reverse_limit: Size
    steers: HalfTurn
    friction: Size | None
    least: Size
    envelope: list[Point] | None = Field(min_length=2)
    group: str
    sectors: list[tuple[Angle, Angle]] | None = Field(min_length=1)
    body: BodyClaim | None
    lever: Number

    @property
    def is_line(self) -> bool:
        """Whether it pushes along one line, one way or both."""
        return not (self.steers or self.friction or self.least or self.envelope or self.sectors)

    @model_validator(mode="after")
    def check_mounted(self) -> Self:
        """Refuse a mounted robot that may be elsewhere."""
        if self.mounted and self.tolerance and self.tolerance.contact != (0.0, 0.0):
            raise ValueError("a mounted robot's contact has no tolerance")
        return self

    @model_validator(mode="after")
    def check_kind(self) -> Self:
        """Refuse what a robot cannot be at once."""
        if self.envelope and (self.steers or self.reverse_limit or self.friction or self.least):
            raise ValueError("an envelope says all forces")
        if self.friction and (self.steers or self.reverse_limit):
            raise ValueError("friction goes with neither steering nor a reverse limit")
        if self.least and (self.reverse_limit or self.least > self.limit):
            raise ValueError("the least force is at most the limit, and without a reverse limit")
        return self

    @model_validator(mode="after")
    def check_lever(self) -> Self:
        """Refuse a couple with a direction, and one that is not on board."""
        turns = self.tolerance.direction if self.tolerance else (0.0, 0.0)
        more = (self.steers, self.friction, self.envelope, self.sectors, self.least, any(turns))
        if self.lever and (any(more) or not self.mounted):
            raise ValueError("a couple has no direction, and is mounted")
        return self

    @model_validator(mode="after")
    def check_sectors(self) -> Self:
        """Refuse sectors that are none, and those beside what says other directions."""
        if any(not 0.0 <= end - start <= 2.0 * math.pi for start, end in self.sectors or ()):
            raise ValueError("a sector should run counter-clockwise, at most once around")
        more = (self.steers, self.reverse_limit, self.friction, self.least, self.envelope)
        if self.sectors is not None and any(more):
            raise ValueError("sectors say all directions")
        return self


class StretchClaim(_Form):
    """A stretch of the boundary by arc length."""

    start: Size
    end: Size
    name: str

    @property
    def is_point(self) -> bool:
        """Whether it is a single point, such as a bollard."""
        return self.start == self.end


class ZoneClaim(_Form):
    """Where a newcomer may attach, and how."""

    stretch: StretchClaim | None
    attachment: Literal["push", "pull", "free"] | None
    half_angle: HalfAngle | None
    directions: tuple[Angle, Angle] | None
    area: list[Point] | None = Field(min_length=1)
    name: str


class NewcomerClaim(_Form):
    """The newcomer."""

    limit: Positive
    attachment: Literal["push", "pull", "free"]
    half_angle: HalfAngle | None
    name: str
    tolerance: ToleranceClaim | None
    steers: bool
    reverse_limit: Size
    friction: Size | None
    mounted: bool
    body: BodyClaim | None


class TaskClaim(_Form):
    """Wrenches that the swarm should be able to make: vertices of a polytope, or axes."""

    vertices: list[Wrench] = Field([], min_length=1)
    axes: list[Wrench] = Field([], min_length=1)

    @model_validator(mode="after")
    def check_size(self) -> Self:
        """Refuse a task of two kinds, and one of nothing."""
        if len(self.model_fields_set) != 1:
            raise ValueError("a task has either vertices or axes")
        if max(abs(number) for row in self.rows for number in row) < SMALLEST:
            raise ValueError(f"some number of the task should be at least {SMALLEST:g}")
        return self

    @property
    def rows(self) -> list[Wrench]:
        """The vertices or the axes."""
        return self.vertices or self.axes


class CriterionClaim(_Form):
    """What quality means."""

    losing: int = Field(ge=0)
    worst_case: bool
    load: Wrench
    task: TaskClaim | None
    failures: list[Annotated[list[str], Field(min_length=1)]]


class ChoiceClaim(_Form):
    """The sector that each robot with gaps between its sectors keeps."""

    sectors: dict[str, tuple[Angle, Angle]]
    is_best: bool
    """Whether no other choice is better: not checked, as the quality with this one is told."""


class RunnerUpClaim(_Form):
    """The best robot in another place."""

    robot: RobotClaim
    quality: Size
    place: str


class ProofClaim(_Form):
    """A convex combination of directions."""

    normals: list[Wrench] = Field(min_length=1)
    weights: list[Number] = Field(min_length=1)


class BoxClaim(_Form):
    """A convex combination that bounds a box of contacts and directions."""

    start: Point
    end: Point
    lo: Angle
    hi: Angle
    kinds: list[Literal["met", "demanded", "travelling", "flat"]]
    vectors: list[Wrench] = Field(min_length=1)
    weights: list[Number]
    lost: list[list[str]]


class SpanClaim(_Form):
    """Directions that bound a span of contacts."""

    start: Point
    end: Point
    lo: Angle
    hi: Angle
    kind: Literal["chords", "travelling"]
    normals: list[Wrench] = Field(min_length=1)
    weights: list[Number]


class PatchClaim(_Form):
    """Directions that bound a patch of contacts."""

    corners: list[Point] = Field(min_length=1, max_length=3)
    lo: Angle
    hi: Angle
    kind: Literal["chords", "travelling"]
    normals: list[Wrench] = Field(min_length=1)
    weights: list[Number]


class PlacementClaim(_Form):
    """What is said of one newcomer."""

    robot: RobotClaim
    place: str
    quality_before: Size
    quality: Size
    upper_bound: Size
    asked_gap: float = Field(gt=0.0, lt=1.0)
    asked_runners_up: float | None = Field(ge=0.0, le=1.0)
    stopped_early: bool
    improves: bool
    reason: str
    runners_up: list[RunnerUpClaim]
    choice_before: ChoiceClaim | None
    choice: ChoiceClaim | None
    proofs: list[ProofClaim]
    boxes: list[BoxClaim]
    spans: list[SpanClaim]
    patches: list[PatchClaim]


class OutlineClaim(_Form):
    """The object, counter-clockwise."""

    vertices: list[Point] = Field(min_length=3)
    origin: Point
    edge_names: list[str]
    precision: Size

    @model_validator(mode="after")
    def check_ring(self) -> Self:
        """Refuse a polygon that crosses itself, runs clockwise or has no area."""
        ring = LinearRing(self.vertices)
        if len(set(self.vertices)) < len(self.vertices) or not (ring.is_simple and ring.is_ccw):
            raise ValueError("the vertices should run counter-clockwise around a simple polygon")
        if len(self.edge_names) != len(self.vertices):
            raise ValueError("there should be one edge name per vertex")
        return self

    @property
    def perimeter(self) -> float:
        """Length of the boundary [m]."""
        return float(LinearRing(self.vertices).length)


class SwarmClaim(_Form):
    """The object, the robots that hold it, and the metric of wrenches."""

    outline: OutlineClaim
    robots: list[RobotClaim]
    characteristic_length: Positive
    force_weights: tuple[Positive, Positive]

    @model_validator(mode="after")
    def check_size(self) -> Self:
        """Refuse numbers that cannot be divided by."""
        if min(*self.force_weights, self.characteristic_length) < SMALLEST:
            raise ValueError(f"weights and length should be at least {SMALLEST:g}")
        return self

    @model_validator(mode="after")
    def check_names(self) -> Self:
        """Refuse a name that several robots have: losses and failures are told by names."""
        names = Counter(robot.name for robot in self.robots)
        for name, uses in names.items():
            if uses > 1:
                raise ValueError(f"{uses} robots are called {name!r}")
        return self

    def called(self, name: str) -> frozenset[str]:
        """Return the names of the robots of a group, or else that of a robot; none of no name."""
        group = frozenset(robot.name for robot in self.robots if name and robot.group == name)
        return group or frozenset(robot.name for robot in self.robots if robot.name == name)


class ProblemClaim(_Form):
    """The question: where a newcomer goes."""

    swarm: SwarmClaim
    newcomer: NewcomerClaim
    zones: list[ZoneClaim] | None
    no_go: list[StretchClaim]
    spacing: Size
    criterion: CriterionClaim

    @model_validator(mode="after")
    def check_failures(self) -> Self:
        """Refuse a failure that takes somebody unknown."""
        for k, failure in enumerate(self.criterion.failures):
            for name in failure:
                if not self.swarm.called(name):
                    raise ValueError(
                        f"criterion.failures.{k} takes {name!r}, which is no robot and no group"
                    )
        return self

    @model_validator(mode="after")
    def check_stretches(self) -> Self:
        """Refuse stretches beyond the boundary's length."""
        reach = self.swarm.outline.perimeter * (1.0 + 1e-6)
        mounted = self.newcomer.mounted
        for k, zone in enumerate(self.zones or []):
            if (zone.area is None, zone.stretch is None) != (not mounted, mounted):
                raise ValueError(f"zones.{k} should be {'an area' if mounted else 'a stretch'}")
        zones = [zone.stretch for zone in self.zones or [] if zone.stretch]
        for kind, stretches in (("zones", zones), ("no_go", self.no_go)):
            for k, stretch in enumerate(stretches):
                if max(stretch.start, stretch.end) > reach:
                    raise ValueError(f"{kind}.{k} leaves the boundary")
        return self


class Claims(_Form):
    """A whole answer file: newcomers of one kind, each of which finds those before it."""

    format: Literal["swarmgrasp placements 3"]
    name: str
    version: str
    date: str
    units: Literal["SI: m, N, N m, rad"]
    terms: dict[str, Any] | None = None
    """In which commands tell the answer: nothing is computed from them."""
    problem: ProblemClaim
    placements: list[PlacementClaim] = Field(min_length=1)
    digest: str


def read_claims(document: dict[str, Any]) -> Claims:
    """Return the document in typed form.

    Raises
    ------
    AnswerInvalid
        If entries are missing, unknown or of the wrong kind; all of them are named.
    """
    try:
        text = json.dumps(document)  # as JSON, lists stand for tuples even strictly
    except (TypeError, ValueError, RecursionError) as error:
        raise AnswerInvalid(f"the answer is not plain data: {error}") from None
    try:
        return Claims.model_validate_json(text)
    except ValidationError as error:
        raise AnswerInvalid(
            f"{'.'.join(map(str, fault['loc'])) or 'the file'}: "
            f"{_SAID.get(fault['type'], fault['msg'])}"
            for fault in error.errors()
        ) from None
