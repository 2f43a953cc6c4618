"""The keys of a scenario file that tell how far a robot may be from what the file says."""

from typing import Annotated

from pydantic import Discriminator, Field, Tag
from pydantic.config import JsonValue

from swarmgrasp.scenario.fields import AnyAngle, Coordinate, Distance, Force, Section


def _kind(value: object) -> str:
    """Tell two offsets from one number, to choose a branch of the unions below."""
    return "offsets" if isinstance(value, list) else "spread"


_ByKind = Discriminator(_kind)

_SIDES: dict[str, JsonValue] = {"prefixItems": [{"maximum": 0}, {"minimum": 0}]}
_TURNS: dict[str, JsonValue] = {
    "prefixItems": [{"minimum": -180, "maximum": 0}, {"minimum": 0, "maximum": 180}]
}

Reach = Annotated[
    Annotated[Distance, Tag("spread")]
    | Annotated[
        list[Coordinate],
        Field(min_length=2, max_length=2, json_schema_extra=_SIDES),
        Tag("offsets"),
    ],
    _ByKind,
]
"""How far a contact may lie off: either way, or between two offsets."""

Turn = Annotated[
    Annotated[AnyAngle, Field(ge=0, json_schema_extra={"maximum": 180}), Tag("spread")]
    | Annotated[
        list[AnyAngle], Field(min_length=2, max_length=2, json_schema_extra=_TURNS), Tag("offsets")
    ],
    _ByKind,
]
"""The same of a direction."""


class ToleranceSection(Section):
    """How far a robot may be from what the file says; `{}` means not at all."""

    contact: Reach | None = Field(
        None,
        description="The contact lies within this distance along the boundary, across corners; "
        "or between two offsets, the first at most 0, the second at least 0, counter-clockwise. "
        "Not for a mounted robot [units.length].",
        examples=[2, [-1, 3]],
    )
    direction: Turn | None = Field(
        None,
        description="The same for the direction of the force, at most half a turn [units.angle].",
        examples=[0.1, [-0.1, 0.2]],
    )
    least_limit: Force | None = Field(
        None,
        description="The limit is at least this much; the limit itself when left out "
        "[units.force].",
        examples=[50],
    )
    may_be_absent: bool = Field(
        False, strict=True, description="The robot may not be there at all."
    )
