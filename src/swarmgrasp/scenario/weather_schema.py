"""The keys of a scenario file that tell wind, current and waves."""

from typing import Annotated, Literal

from pydantic import ConfigDict, Field

from swarmgrasp.environment import AIR, BLENDERMANN, WATER
from swarmgrasp.scenario.fields import (
    STRONGEST,
    Area,
    Coordinate,
    Distance,
    Label,
    Number,
    Point,
    Section,
)
from swarmgrasp.scenario.measures import BEARING, Measure, Row

FASTEST = 1e3
"""Largest speed, in the file's unit."""

Speed = Annotated[Number, Field(ge=0, le=FASTEST), Measure("speed")]
Bearing = Annotated[Number, Field(ge=-1e6, le=1e6), Measure(BEARING)]
LoadRow = Annotated[
    list[Annotated[Number, Field(ge=-STRONGEST, le=STRONGEST)]],
    Field(min_length=5, max_length=5),
    Row(("speed", "angle", "force", "force", "torque")),
]
Coefficient = Annotated[Number, Field(gt=0, le=10)]
Density = Annotated[Number, Field(gt=0, le=1e5), Measure("density")]


class WindCoefficientsSection(Section):
    """Blendermann's drag coefficients [1] of what is above the water."""

    transverse: Coefficient = Field(
        description="CD_t, of the lateral area in a beam wind.", examples=[0.9]
    )
    bow: Coefficient = Field(
        description="CD_l(0), of the frontal area in a head wind.", examples=[0.7]
    )
    stern: Coefficient = Field(
        description="CD_l(pi), of the frontal area in a stern wind.", examples=[0.7]
    )
    cross_force: Annotated[Number, Field(ge=0, le=1)] = Field(
        0.0, description="The cross-force parameter delta, from 0 to 1."
    )


class CurrentCoefficientsSection(Section):
    """Drag coefficients [1] of the underwater hull; by default those of DNV-ST-0111."""

    surge: Coefficient = Field(0.07, description="Of the frontal area, along the hull.")
    sway: Coefficient = Field(0.6, description="Of the lateral area, across the hull.")


CENTROID = "How far the centre of the lateral area is forward of midship [units.length]."
COMES_FROM = "comes from, clockwise from the bow: 90 degrees is starboard [units.angle]."


class WindTableSection(Section):
    """The loads of winds by speed and bearing."""

    rows: list[LoadRow] = Field(
        min_length=2,
        description="Speed and bearing of a wind, clockwise from the bow, and the surge, sway and "
        "yaw that it exerts; every speed with the same bearings [units.speed, units.angle, "
        "units.force, units.force, units.force times units.length].",
        examples=[[[10, 0, -9, 0, 0], [10, 90, 0, 40, 0], [10, 180, 9, 0, 0]]],
    )
    about: Point | None = Field(
        None,
        description="The point that yaw moments are about, in the coordinates of the vertices; "
        "midship, the middle of the outline's extent, when left out [units.length].",
        examples=[[0, 0]],
    )
    frame: Literal["ENU", "NED"] | None = Field(
        None,
        description="ENU: sway to port, yaw counter-clockwise; NED: sway to starboard, yaw "
        "clockwise. That of the file when left out; surge is forward.",
    )


class WindSection(Section):
    """What the object shows to the wind, and perhaps a steady wind.

    Exactly one of `vessel` and `coefficients` gives the drag, beside the areas; or a `table` the
    loads.
    """

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": [
                {"required": ["vessel", "frontal_area", "lateral_area"]},
                {"required": ["coefficients", "frontal_area", "lateral_area"]},
                {"required": ["table"]},
            ],
            "dependentRequired": {"from": ["speed"], "speed": ["from"]},
        }
    )

    table: WindTableSection | None = Field(
        None, description="The loads themselves, instead of all that says drag and areas."
    )
    vessel: Label | None = Field(
        None,
        description="A type of vessel, for Blendermann's coefficients (1994).",
        json_schema_extra={"enum": list(BLENDERMANN)},
        examples=["offshore supply vessel"],
    )
    coefficients: WindCoefficientsSection | None = Field(
        None, description="The coefficients themselves, instead of `vessel`."
    )
    frontal_area: Area | None = Field(
        None,
        description="Area above the water seen from ahead [units.length squared].",
        examples=[6],
    )
    lateral_area: Area | None = Field(
        None,
        description="Area above the water seen from the side [units.length squared].",
        examples=[20],
    )
    lateral_centroid: Coordinate = Field(0.0, description=CENTROID)
    speed: Speed | None = Field(
        None, description="Of a steady wind, 10 m above the sea [units.speed]; goes with `from`."
    )
    bearing: Bearing | None = Field(
        None, alias="from", description=f"Where the steady wind {COMES_FROM}", examples=[45]
    )
    density: Density = Field(AIR, description="Density of the air [kg/m^3], whatever the units.")


class CurrentSection(Section):
    """What the object shows to the current, and the current."""

    frontal_area: Area = Field(
        description="Area under water seen from ahead, about beam times draught "
        "[units.length squared].",
        examples=[2],
    )
    lateral_area: Area = Field(
        description="Area under water seen from the side, about length times draught "
        "[units.length squared].",
        examples=[4],
    )
    lateral_centroid: Coordinate = Field(0.0, description=CENTROID)
    speed: Speed = Field(0.0, description="Of the current [units.speed].", examples=[0.5])
    bearing: Bearing | None = Field(
        None,
        alias="from",
        description=f"Where the current {COMES_FROM} From where the wind comes when left out.",
    )
    coefficients: CurrentCoefficientsSection = Field(
        CurrentCoefficientsSection(), description="Drag coefficients of the underwater hull."
    )
    density: Density = Field(
        WATER, description="Density of the water [kg/m^3], whatever the units."
    )


class WavesSection(Section):
    """The sea, whose mean drift pushes the object.

    Exactly one of `height`, with `period`, and `with_wind` tells it. The outline is the waterline.
    """

    model_config = ConfigDict(
        json_schema_extra={
            "oneOf": [{"required": ["height", "period"]}, {"required": ["with_wind"]}],
        }
    )

    height: Distance | None = Field(
        None,
        description="Significant height [units.length]; goes with `period`.",
        examples=[0.5],
    )
    period: Annotated[Number, Field(ge=1e-3, le=1e3), Measure("time")] | None = Field(
        None, description="Peak period [s], whatever the units; goes with `height`.", examples=[3]
    )
    with_wind: Literal[True] | None = Field(
        None,
        description="The sea that goes with the wind, by the steps of DNV-ST-0111 and straight "
        "lines between, instead of `height` and `period`.",
    )
    bearing: Bearing | None = Field(
        None,
        alias="from",
        description=f"Where the sea {COMES_FROM} From where the wind comes when left out.",
    )
    bow_angle: Annotated[Number, Field(gt=0, le=91), Measure("angle")] | None = Field(
        None,
        description="Between the centre line and the line from the stem to the waterline a quarter "
        "of the beam off it [units.angle]; of the outline when left out.",
    )
    aft_fullness: Annotated[Number, Field(ge=0, le=2)] | None = Field(
        None,
        description="The part of half the length times the beam that the waterplane aft of midship "
        "fills; of the outline when left out.",
    )
    density: Density = Field(
        WATER, description="Density of the water [kg/m^3], whatever the units."
    )


class EnvironmentSection(Section):
    """Wind, current and waves around the object."""

    wind: WindSection = Field(description="The wind, and what the object shows to it.")
    current: CurrentSection | None = Field(
        None, description="The current, and what the object shows to it; still water if left out."
    )
    waves: WavesSection | None = Field(
        None, description="The sea; flat, without drift, if left out."
    )
    dynamic_factor: Annotated[Number, Field(ge=1, le=10)] = Field(
        1.0,
        description="Multiplies all loads, an allowance for gusts and motions: 1.25 in "
        "DNV-ST-0111, 1 is none.",
        examples=[1.25],
    )
