"""The keys of a scenario file that tell a newcomer: the one to place, or one that is sent."""

from pydantic import ConfigDict, Field

from swarmgrasp.scenario.fields import AnyAngle, Label, Length, Section
from swarmgrasp.scenario.force_schema import FRICTION, LIMIT, TWO_WAY, Friction, Limit
from swarmgrasp.scenario.tolerance_schema import ToleranceSection
from swarmgrasp.swarm.robot import Attachment

ATTACHMENT = "Force into the object (push), out of it (pull), or in any direction (free)."
HALF_ANGLE = (
    "Greatest angle between the force and the normal, 0 to a right angle, which is the default; "
    "0 means exactly along the normal [units.angle]."
)
BODY_LENGTH = (
    "How far it reaches from its contact, away from the object; with the line, if it pulls on one. "
    "Goes with `beam`: a newcomer's body is kept clear of the object and of others' "
    "[units.length]."
)
BEAM = "Its width; goes with `length` [units.length]."


class NewcomerSection(Section):
    """A robot that has no place yet."""

    model_config = ConfigDict(
        json_schema_extra={"dependentRequired": {"length": ["beam"], "beam": ["length"]}}
    )

    name: Label = Field("", description="A label.", examples=["Hector"])
    limit: Limit = Field(description=LIMIT, examples=[60])
    attachment: Attachment = Field("free", description=ATTACHMENT)
    half_angle: AnyAngle | None = Field(
        None,
        description=HALF_ANGLE + " Not for a free attachment.",
        json_schema_extra={"minimum": 0, "maximum": 90},
        examples=[0.5],
    )
    steers: bool = Field(
        False,
        strict=True,
        description="Steers at any time within the whole sector of its attachment, or any way if "
        "it is free; otherwise it keeps the one direction that is best.",
    )
    two_way: bool = Field(False, strict=True, description=TWO_WAY)
    friction: Friction | None = Field(
        None, description=FRICTION + " Its attachment is push.", examples=[0.5]
    )
    mounted: bool = Field(
        False, strict=True, description="Goes anywhere inside the outline; its attachment is free."
    )
    length: Length | None = Field(None, description=BODY_LENGTH, examples=[30])
    beam: Length | None = Field(None, description=BEAM, examples=[10])
    tolerance: ToleranceSection | None = Field(
        None,
        description="How far it may end up from where it is placed; instead of the file's own.",
    )
