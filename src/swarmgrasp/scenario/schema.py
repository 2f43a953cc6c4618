"""The keys of a scenario file: names, types and ranges that hold whatever the outline is.

What depends on the outline or on the file's units is checked in `build`.
"""

from typing import Annotated, Literal

from pydantic import ConfigDict, Field, Tag
from pydantic.config import JsonDict, JsonValue

from swarmgrasp.scenario.allocation import AllocationSection
from swarmgrasp.scenario.criterion_schema import CriterionSection
from swarmgrasp.scenario.fields import (
    BY_KIND,
    Angle,
    AnyAngle,
    Coordinate,
    Distance,
    Label,
    Length,
    Point,
    Range,
    Section,
    Weight,
)
from swarmgrasp.scenario.force_schema import (
    FRICTION,
    LIMIT,
    TWO_WAY,
    Corner,
    Friction,
    RobotLimit,
    SectorRanges,
    Steers,
)
from swarmgrasp.scenario.measures import AXIS, HEADING, Measure
from swarmgrasp.scenario.newcomer_schema import (
    ATTACHMENT,
    BEAM,
    BODY_LENGTH,
    HALF_ANGLE,
    NewcomerSection,
)
from swarmgrasp.scenario.simulation_schema import SimulationSection
from swarmgrasp.scenario.terms_schema import UnitsSection, Words
from swarmgrasp.scenario.tolerance_schema import ToleranceSection
from swarmgrasp.scenario.weather_schema import EnvironmentSection
from swarmgrasp.swarm.robot import Attachment

Direction = Annotated[
    Annotated[Literal["inward", "outward"], Tag("word")] | Annotated[Angle, Tag("value")], BY_KIND
]
Origin = Annotated[
    Annotated[Literal["centroid"], Tag("word")] | Annotated[Point, Tag("value")], BY_KIND
]
Edge = Annotated[
    Annotated[Label, Tag("word")]
    | Annotated[int, Field(strict=True, ge=0, le=10**6), Tag("value")],
    BY_KIND,
]

CONTACT = "Contact [x, y] on the boundary, in the frame of the vertices [units.length]."
THETA = "Contact where the ray from the origin at this angle meets the boundary [units.angle]."
AT = "Contact by arc length, counter-clockwise from the first vertex [units.length]."
EDGE = "An edge by name, or by index from 0: edge i runs from vertex i to i + 1 of this file."
ALONG = "Distance along `edge` from its counter-clockwise start [units.length]."
FROM = "Where the stretch starts: along `edge`, or as arc length without one [units.length]."
TO = "Where the stretch ends, counter-clockwise from its start [units.length]."


def _ways(*keys: list[JsonValue]) -> list[JsonValue]:
    """Return the JSON schemas of "these keys are given", one per set of keys."""
    return [{"required": key} for key in keys]


class OutlineSection(Section):
    """The object's outline: a simple polygon, convex or not."""

    vertices: list[Point] = Field(
        min_length=3,
        description="Corners [x, y] in order, either way round; x forward, y to port "
        "[units.length].",
        examples=[[[0, 0], [4, 0], [4, 2], [0, 2]]],
    )
    edges: list[Label] | None = Field(
        None,
        description="One name per edge, in the order of the vertices: the first belongs to the "
        'edge from the first vertex to the second. "" for a nameless edge.',
        examples=[["starboard", "bow", "port", "stern"]],
    )
    origin: Origin = Field(
        "centroid",
        description="Point that moments are taken about: the centroid, or [x, y] [units.length].",
        examples=["centroid", [0, 0]],
    )
    precision: Distance | None = Field(
        None,
        description="How far each coordinate may be off, 0 for exact ones; half a unit in the "
        "last decimal, of 3 to 12 of them, when left out [units.length].",
        examples=[0.005],
    )


class MetricSection(Section):
    """The metric that makes torque and force comparable."""

    force_weights: Annotated[list[Weight], Field(min_length=2, max_length=2)] = Field(
        [1.0, 1.0], description="Weights a1 (surge) and a2 (sway) [1].", examples=[[1, 1]]
    )
    characteristic_length: Length | None = Field(
        None,
        description="Length L that turns torque into force; by default the largest distance "
        "from the origin to the outline [units.length].",
        examples=[38.1],
    )


class RobotSection(Section):
    """A robot in contact with the object.

    Exactly one of `contact`, `theta`, `at`, or `edge` with `along` says where.
    """

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": _ways(["contact"], ["theta"], ["at"], ["edge", "along"]),
            "dependentRequired": {
                "along": ["edge"],
                "edge": ["along"],
                "mounted": ["contact"],
                "length": ["beam"],
                "beam": ["length"],
            },
            "if": {"properties": {"mounted": {"const": True}}, "required": ["mounted"]},
            "then": {"properties": {"tolerance": {"properties": {"contact": False}}}},
            "allOf": [
                {"oneOf": _ways(["limit"], ["envelope"])},
                {
                    "anyOf": [
                        *_ways(["direction"], ["friction"], ["sectors"], ["lever"]),
                        {"properties": {"steers": {"const": "any"}}, "required": ["steers"]},
                    ]
                },
            ],
        }
    )

    name: Label = Field("", description="A label, different for each robot.", examples=["Ajax"])
    contact: Point | None = Field(None, description=CONTACT, examples=[[4, 1.5]])
    theta: AnyAngle | None = Field(None, description=THETA, examples=[0.5])
    at: Distance | None = Field(None, description=AT, examples=[5.5])
    edge: Edge | None = Field(None, description=EDGE, examples=["port", 2])
    along: Distance | None = Field(None, description=ALONG, examples=[1.5])
    direction: Direction | None = Field(
        None,
        description="Direction of the force on the object, counter-clockwise from +x "
        "[units.angle], or along the normal: inward or outward. May be left out for what steers "
        "any way, and for a finger with friction, which pushes inward; not with sectors.",
        examples=[0.5, "inward", "outward"],
    )
    limit: RobotLimit | None = Field(
        None,
        description=LIMIT + " Or [least, largest], of what always exerts some force.",
        examples=[60, {"ahead": 51, "astern": 40}, [2, 20]],
    )
    steers: Steers | None = Field(
        None,
        description="Turns its force at any time within this angle either side of its direction, "
        "or any way, as an azimuth thruster does [units.angle].",
        examples=[0.5, "any"],
    )
    sectors: SectorRanges | None = Field(
        None,
        description="The directions that it may push in, with gaps between, as an azimuth thruster "
        "beside another one: each counter-clockwise from the first to the second, measured from "
        "+x, instead of a direction [units.angle].",
        examples=[[[0.5, 2.5], [3.5, 6]]],
    )
    friction: Friction | None = Field(None, description=FRICTION, examples=[0.5])
    envelope: list[Corner] | None = Field(
        None,
        min_length=2,
        description="The corners of all forces it can exert, each [along its direction, to the "
        "left of it], instead of a limit [units.force].",
        examples=[[[60, 0], [40, 30], [0, 0], [40, -30]]],
    )
    mounted: bool = Field(
        False,
        strict=True,
        description="The vessel's own thruster: `contact` may lie anywhere inside the outline, "
        "and `direction` is an angle.",
    )
    two_way: bool = Field(False, strict=True, description=TWO_WAY)
    lever: Coordinate | None = Field(
        None,
        description="Turns the object instead of pushing it, with two opposite forces of `limit` "
        "so far apart, counter-clockwise, or clockwise if negative; mounted, without a direction "
        "[units.length].",
        examples=[1],
    )
    group: Label = Field(
        "",
        description="Robots of one group fail together, as the thrusters of one switchboard do.",
        examples=["bus A"],
    )
    length: Length | None = Field(None, description=BODY_LENGTH, examples=[30])
    beam: Length | None = Field(None, description=BEAM, examples=[10])
    tolerance: ToleranceSection | None = Field(
        None, description="How far the robot may be from all this; instead of the file's own."
    )


_STRETCH: JsonDict = {"anyOf": _ways(["edge"], ["from", "to"])}


class StretchSection(Section):
    """A stretch of the boundary.

    Either `edge` (the whole of it, or `from` and `to` along it), or `from` and `to` as arc
    lengths, which may run across the first vertex.
    """

    model_config = ConfigDict(json_schema_extra=_STRETCH)

    name: Label = Field("", description="A label; the edge's by default.", examples=["ladder"])
    edge: Edge | None = Field(None, description=EDGE, examples=["port", 2])
    start: Distance | None = Field(None, alias="from", description=FROM, examples=[0.5])
    end: Distance | None = Field(None, alias="to", description=TO, examples=[1.5])


class ZoneSection(StretchSection):
    """Where a newcomer may attach: a stretch of the boundary, or a point such as a bollard.

    A point is given by one of `contact`, `theta`, `at`, or `edge` with `along`; for a mounted
    newcomer, `area` gives a part of the inside.
    """

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": [*_ways(["contact"], ["theta"], ["at"], ["area"]), _STRETCH],
            "dependentRequired": {"along": ["edge"], "half_angle": ["attachment"]},
        }
    )

    contact: Point | None = Field(None, description=CONTACT, examples=[[4, 1.5]])
    theta: AnyAngle | None = Field(None, description=THETA, examples=[0.5])
    at: Distance | None = Field(None, description=AT, examples=[5.5])
    along: Distance | None = Field(None, description=ALONG, examples=[1.5])
    area: list[Point] | None = Field(
        None,
        min_length=1,
        description="Corners [x, y], in order, of an area inside the outline, for a mounted "
        "newcomer; two are a line, and one is a spot [units.length].",
        examples=[[[1, -0.5], [2, -0.5], [2, 0.5], [1, 0.5]]],
    )
    attachment: Attachment | None = Field(
        None, description=ATTACHMENT + " Overrides the newcomer's own."
    )
    half_angle: AnyAngle | None = Field(
        None,
        description=HALF_ANGLE + " Goes with `attachment`.",
        json_schema_extra={"minimum": 0, "maximum": 90},
        examples=[0.5],
    )
    directions: Range | None = Field(
        None,
        description="Force directions allowed here, counter-clockwise from the first to the "
        "second, measured from +x; further limits the attachment [units.angle].",
        examples=[[0, 1.5]],
    )


class ScenarioFile(Section):
    """A scenario: an object, the robots that hold it, and the robot to place."""

    name: Label = Field("", description="A title.", examples=["Barge in the lock"])
    description: str = Field("", description="Free text.")
    units: UnitsSection = Field(UnitsSection(), description="Units of every number in the file.")
    frame: Literal["ENU", "NED"] = Field(
        "ENU",
        description="How coordinates and angles run. ENU: x forward, y to port, angles "
        "counter-clockwise. NED: x forward, y to starboard, and all that turns turns clockwise.",
    )
    bow: Annotated[Angle, Measure(AXIS)] = Field(
        0.0,
        description="Direction of the bow in the coordinates of this file, from +x in its sense of "
        "turning [units.angle]; or an axis, such as +y.",
        examples=["+y", 90],
    )
    heading: Annotated[Angle, Measure(HEADING)] | None = Field(
        None,
        description="True bearing of the bow, clockwise from north [units.angle], or a point of "
        "the compass; wind and current may then come from true bearings too.",
        examples=[45, "NE"],
    )
    words: Words | None = Field(
        None, description="What robots are called in answers.", examples=["tug", {"robot": "tug"}]
    )
    outline: OutlineSection = Field(description="The object.")
    metric: MetricSection = Field(MetricSection(), description="How wrenches are compared.")
    robots: list[RobotSection] = Field(description="Robots already in contact; may be empty.")
    allocation: AllocationSection | None = Field(
        None, description="Thrusters beside the robots, by their allocation matrix."
    )
    newcomer: NewcomerSection | None = Field(None, description="The robot to place.")
    zones: list[ZoneSection] | None = Field(
        None,
        min_length=1,
        description="Where a newcomer may attach; the whole boundary when left out.",
    )
    no_go: list[StretchSection] = Field(
        [], description="Stretches of the boundary no newcomer may use."
    )
    spacing: Distance = Field(
        0.0,
        description="Least distance of a newcomer from the robots already there [units.length].",
        examples=[2],
    )
    tolerance: ToleranceSection | None = Field(
        None,
        description="How far every robot and the newcomer may be from what is said of them, "
        "unless they have a tolerance of their own.",
    )
    criterion: CriterionSection | None = Field(
        None, description="What quality means, for `swarmgrasp quality` and `swarmgrasp place`."
    )
    environment: EnvironmentSection | None = Field(
        None,
        description="Wind, current and waves, for `swarmgrasp capability` and as a load.",
    )
    simulation: SimulationSection | None = Field(
        None, description="A run in this environment, for `swarmgrasp simulate`."
    )
