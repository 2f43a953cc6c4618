"""The keys of a scenario file that tell which forces a robot can exert."""

from typing import Annotated, Literal

from pydantic import Discriminator, Field, Tag

from swarmgrasp.scenario.fields import STRONGEST, AnyAngle, Force, Number, Range, Section
from swarmgrasp.scenario.measures import Measure
from swarmgrasp.swarm.robot import MOST_FRICTION


def _by(**kinds: type) -> Discriminator:
    """Choose the branch of a union that is for values of a type, else the one called "value"."""

    def kind(value: object) -> str:
        """Return the name of the branch."""
        return next((name for name, each in kinds.items() if type(value) is each), "value")

    return Discriminator(kind)


class BothWaysSection(Section):
    """The limits of what pushes both ways, such as a propeller that is weaker astern."""

    ahead: Force = Field(description="Largest force along the direction [units.force].")
    astern: Force = Field(description="Largest force against the direction [units.force].")


_Component = Annotated[Number, Field(ge=-STRONGEST, le=STRONGEST), Measure("force")]
_Pair = Annotated[list[Force], Field(min_length=2, max_length=2), Tag("pair")]
_OneWay = Annotated[Force, Tag("value")]
_BothWays = Annotated[BothWaysSection, Tag("both")]
_HALF_TURN = Field(ge=0, json_schema_extra={"maximum": 180})

Limit = Annotated[_OneWay | _BothWays, _by(both=dict)]
"""One limit, or those ahead and astern."""
RobotLimit = Annotated[_OneWay | _Pair | _BothWays, _by(pair=list, both=dict)]
"""The same, or the least and the largest force of what always exerts some."""
Steers = Annotated[
    Annotated[Literal["any"], Tag("word")] | Annotated[AnyAngle, _HALF_TURN, Tag("value")],
    _by(word=str),
]
"""How far either side of its direction a robot turns its force, or any way."""
Friction = Annotated[Number, Field(gt=0, le=MOST_FRICTION)]
SectorRanges = Annotated[list[Range], Field(min_length=1)]
"""Directions that a robot may push in, with gaps between."""
Corner = Annotated[list[_Component], Field(min_length=2, max_length=2)]

LIMIT = "Largest force; or, of what pushes both ways, {ahead: .., astern: ..} [units.force]."
TWO_WAY = "Pushes either way along its direction, each way up to its limit."
FRICTION = (
    "It is a finger with this coefficient of friction: its force across the normal is at most "
    "so many times that along it, and that is at most the limit."
)
