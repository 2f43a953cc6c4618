"""Numbers, points and labels of a scenario file, and what all its mappings have in common."""

from typing import Annotated

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Discriminator,
    Field,
    StringConstraints,
)
from pydantic_core import PydanticCustomError

from swarmgrasp.ranges import name_fault
from swarmgrasp.scenario.measures import Measure

FARTHEST = 1e9
"""Largest coordinate or distance, in the file's unit: beyond it, rounding eats a tolerance."""

WIDEST = 1e15
"""Largest area, in the square of the file's unit: 1e9 m2 in square millimetres."""

STRONGEST = 1e12
"""Largest force, in the file's unit."""

Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Coordinate = Annotated[Number, Field(ge=-FARTHEST, le=FARTHEST), Measure("length")]
Distance = Annotated[Number, Field(ge=0, le=FARTHEST), Measure("length")]
Length = Annotated[Number, Field(gt=0, le=FARTHEST), Measure("length")]
Area = Annotated[Number, Field(gt=0, le=WIDEST), Measure("area")]
Force = Annotated[Number, Field(gt=0, le=STRONGEST), Measure("force")]
Weight = Annotated[Number, Field(gt=0, le=STRONGEST)]
Point = Annotated[list[Coordinate], Field(min_length=2, max_length=2)]
Angle = Annotated[Number, Field(ge=-1e6, le=1e6), Measure("angle")]
AnyAngle = Annotated[Number, Measure("angle")]
Range = Annotated[list[Angle], Field(min_length=2, max_length=2)]


def _plain(name: str) -> str:
    """Return a name that may stand anywhere."""
    fault = name_fault(name)
    if fault:
        raise PydanticCustomError("name_fault", fault)
    return name


Label = Annotated[str, StringConstraints(max_length=200), AfterValidator(_plain)]

Word = Annotated[str, StringConstraints(min_length=1, max_length=200), AfterValidator(_plain)]
"""A name that something has to have."""


def _kind(value: object) -> str:
    """Tell text from anything else."""
    return "word" if isinstance(value, str) else "value"


BY_KIND = Discriminator(_kind)
"""Chooses a branch of what may be a word or something else."""


class Section(BaseModel):
    """A mapping with known keys only."""

    model_config = ConfigDict(extra="forbid", populate_by_name=False)
