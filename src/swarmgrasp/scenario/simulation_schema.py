"""The keys of a scenario file that tell a simulation: hull, robots, control, weather, events."""

from typing import Annotated, Literal

from pydantic import ConfigDict, Field, Tag

from swarmgrasp.ranges import MOST_SEED
from swarmgrasp.scenario.fields import (
    BY_KIND,
    FARTHEST,
    Angle,
    Distance,
    Label,
    Length,
    Number,
    Point,
    Section,
)
from swarmgrasp.scenario.measures import BEARING, Measure, Row
from swarmgrasp.scenario.newcomer_schema import NewcomerSection
from swarmgrasp.scenario.weather_schema import COMES_FROM, Bearing, Speed

LONGEST = 1e6
"""Longest time [s]."""
HEAVIEST = 1e12
"""Largest mass [kg]."""

Time = Annotated[Number, Field(ge=0, le=LONGEST), Measure("time")]
Span = Annotated[Number, Field(gt=0, le=LONGEST), Measure("time")]
Mass = Annotated[Number, Field(gt=0, le=HEAVIEST), Measure("mass")]
TurnRate = Annotated[Number, Field(gt=0, le=1e6), Measure("turn rate")]
Frequency = Annotated[Number, Field(gt=0, le=1e3)]
Share = Annotated[Number, Field(gt=0, le=1)]
Three = Annotated[list[Number], Field(min_length=3, max_length=3)]
Added = Annotated[
    list[Annotated[Number, Field(ge=0)]],
    Field(min_length=3, max_length=3),
    Row(("mass", "mass", "inertia")),
]
Aim = Annotated[
    list[Annotated[Number, Field(ge=-FARTHEST, le=FARTHEST)]],
    Field(min_length=2, max_length=3),
    Row(("length", "length", "angle")),
]
Sent = Annotated[Annotated[Label, Tag("word")] | Annotated[NewcomerSection, Tag("value")], BY_KIND]
"""A newcomer by its name, or one of another kind by what it can exert."""
Winds = Annotated[Three, Row(("time", "speed", BEARING))]


class HullSection(Section):
    """What the object weighs in water; what is left out is worked out from its draught."""

    draught: Length | None = Field(
        None,
        description="The current's lateral area over the length when left out, or what the mass "
        "needs [units.length].",
        examples=[0.5],
    )
    block: Annotated[Number, Field(ge=0.001, le=1)] = Field(
        1.0, description="Block coefficient: which part of outline times draught is in water [1]."
    )
    mass: Mass | None = Field(
        None, description="That of the water it displaces when left out [kg].", examples=[4000]
    )
    inertia: Annotated[Number, Field(gt=0), Measure("inertia")] | None = Field(
        None, description="About the centre of mass; of an even mass when left out [kg m^2]."
    )
    centre: Point | None = Field(
        None,
        description="Centre of mass [x, y] from the outline's origin; the centroid when left out "
        "[units.length].",
    )
    added: Added | None = Field(
        None,
        description="Added mass ahead, added mass abeam, added inertia [kg, kg, kg m^2].",
    )
    added_at: Point | None = Field(
        None,
        description="Where these act, [x, y] from the outline's origin; midship when left out "
        "[units.length].",
    )
    damping: Annotated[list[Three], Field(min_length=3, max_length=3)] | None = Field(
        None,
        description="A matrix that, times the velocity over the ground, is a wrench against it, "
        "beside the drag of the current; none when left out [N s/m, N s, N m s].",
    )


class ActuatorSection(Section):
    """How a robot answers to orders."""

    lag: Time = Field(5.0, description="Time constant of its force [s].")
    slew: Time = Field(10.0, description="From idle to its full force [s]; 0 for at once.")
    turn_rate: TurnRate | None = Field(
        None,
        description="How fast it turns its force [units.angle per second]; 12 degrees when left "
        "out.",
    )
    turn_lag: Time = Field(3.0, description="Time constant of its direction [s].")
    efficiency: Share = Field(
        1.0, description="The part of an ordered force that reaches the object [1].", examples=[0.9]
    )
    mass: Annotated[Number, Field(ge=0, le=HEAVIEST), Measure("mass")] = Field(
        0.0, description="Of a robot that is fixed to the object and moves with it [kg]."
    )
    follows: Literal["hull", "earth"] = Field(
        "hull",
        description="Whether its force turns with the object, or keeps its direction as that of a "
        "line from a far tug does.",
    )


class NamedActuatorSection(ActuatorSection):
    """How one robot answers to orders; what is left out is as of the others."""

    name: Label = Field(description="The robot's name.", examples=["Ajax"])


class RobotsSection(ActuatorSection):
    """How the robots answer to orders."""

    others: list[NamedActuatorSection] = Field(
        [],
        alias="except",
        description="Robots of which something else holds.",
        examples=[[{"name": "Ajax", "efficiency": 0.9}]],
    )


class WeatherSection(Section):
    """How the wind comes and goes about the mean that the environment gives."""

    gusts: Literal["none", "npd"] = Field(
        "none",
        description="None, or those of the spectrum of the Norwegian Petroleum Directorate.",
    )
    series: Annotated[list[Winds], Field(min_length=1)] | None = Field(
        None,
        description="A mean wind in time, instead of the environment's: [time, speed, from], in "
        "the order of time [s, units.speed, units.angle].",
        examples=[[[0, 10, 45], [300, 18, 60]]],
    )


class ControlSection(Section):
    """How the object is kept where it is to be; what is left out follows from the robots' lag."""

    period: Span | None = Field(None, description="Between two sets of orders [s].")
    frequency: Frequency | None = Field(
        None, description="How fast an error is taken back [rad/s], whatever the units."
    )
    observer: Frequency | None = Field(
        None, description="How fast what the sensors say is believed [rad/s], whatever the units."
    )
    position_noise: Distance | None = Field(
        None, description="Standard deviation of a measured position [units.length]."
    )
    heading_noise: Annotated[Angle, Field(ge=0)] | None = Field(
        None, description="Standard deviation of a measured heading [units.angle]."
    )


class StreamSection(Section):
    """A new mean wind or current; what is left out stays as it is."""

    model_config = ConfigDict(json_schema_extra={"minProperties": 1})

    speed: Speed | None = Field(None, description="[units.speed]")
    bearing: Bearing | None = Field(
        None, alias="from", description=f"Where it {COMES_FROM}", examples=[45]
    )


class EventSection(Section):
    """What happens at an instant: one of lose, leave, send, move, follow, or wind and current."""

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": [
                {"required": ["lose"]},
                {"required": ["leave"]},
                {"required": ["send"]},
                {"required": ["move"]},
                {"required": ["follow", "speed"]},
                {"anyOf": [{"required": ["wind"]}, {"required": ["current"]}]},
            ],
            "dependentRequired": {
                "noticed": ["lose"],
                "as": ["send"],
                "away": ["send"],
                "from": ["send"],
                "make_fast": ["send"],
            },
            "if": {"required": ["as"]},
            "then": {"properties": {"send": {"type": "string"}}},
        }
    )

    at: Time = Field(description="When, since the start [s].", examples=[60])
    lose: Label | None = Field(
        None,
        description="The robot that exerts nothing any more, or the group, such as a switchboard.",
        examples=["Ajax"],
    )
    noticed: Time = Field(
        0.0, description="So long after the loss, those who share out the forces know it [s]."
    )
    leave: Label | None = Field(
        None, description="The robot that lets go as planned.", examples=["Ajax"]
    )
    send: Sent | None = Field(
        None,
        description="Who comes to help: `newcomer`, or the newcomer's name; or another kind of "
        "robot, by the keys of a newcomer.",
        examples=["newcomer", {"name": "Gyges", "limit": 30, "attachment": "push"}],
    )
    name: Label | None = Field(
        None, alias="as", description="Its name, if it is another of the newcomer's kind."
    )
    away: Distance | None = Field(
        None, description="How far it is when it is sent [units.length].", examples=[400]
    )
    bearing: Bearing | None = Field(
        None,
        alias="from",
        description="Where it waits, clockwise from the bow [units.angle].",
        examples=[90],
    )
    speed: Annotated[Speed, Field(gt=0)] | None = Field(
        None,
        description="At which it travels, or at which the object follows a path [units.speed].",
        examples=[0.5],
    )
    make_fast: Time | None = Field(
        None, description="From its arrival until it can push [s].", examples=[60]
    )
    move: Aim | None = Field(
        None,
        description="Where the object's origin is to be, [x, y] or [x, y, heading], from where it "
        "was at the start, heading counter-clockwise [units.length, units.angle].",
        examples=[[10, 15, 5]],
    )
    follow: Annotated[list[Point], Field(min_length=1)] | None = Field(
        None,
        description="Corners [x, y] of a path for the object's origin, after where it is to be "
        "then, counted as in move [units.length].",
        examples=[[[50, 0], [50, 20]]],
    )
    wind: StreamSection | None = Field(None, description="A new mean wind.")
    current: StreamSection | None = Field(None, description="A new current.")


class SimulationSection(Section):
    """A run of the object in its environment, for `swarmgrasp simulate`."""

    hull: HullSection = Field(HullSection(), description="What the object weighs in water.")
    duration: Span = Field(600.0, description="[s]")
    step: Span | None = Field(
        None, description="The longest of motion; a period of control when left out [s]."
    )
    seed: Annotated[int, Field(strict=True, ge=0, le=MOST_SEED)] = Field(
        0, description="Of gusts and of the sensors' noise."
    )
    robots: RobotsSection = Field(RobotsSection(), description="How robots answer to orders.")
    weather: WeatherSection = Field(WeatherSection(), description="Gusts, or a wind in time.")
    control: ControlSection = Field(ControlSection(), description="How the object is kept.")
    events: list[EventSection] = Field(
        [],
        description="What happens.",
        examples=[[{"at": 60, "lose": "Ajax"}, {"at": 65, "send": "newcomer", "away": 400}]],
    )
