"""The keys of a scenario file that tell its units, and its words."""

from typing import Annotated

from pydantic import Field, Tag

from swarmgrasp.scenario.fields import BY_KIND, Section, Word
from swarmgrasp.scenario.measures import Unit
from swarmgrasp.units import PLAIN


def _one_of(quantity: str) -> str:
    """Say which units of a quantity a file may be in."""
    return f"One of {', '.join(PLAIN[quantity])}, as people spell them."


class UnitsSection(Section):
    """Units of every number in the file that has none of its own; SI where left out."""

    length: Annotated[str, Unit("length")] = Field("m", description=_one_of("length"))
    force: Annotated[str, Unit("force")] = Field(
        "N", description=_one_of("force") + " A t is a tonne-force here, as in bollard pull."
    )
    angle: Annotated[str, Unit("angle")] = Field("rad", description=_one_of("angle"))
    speed: Annotated[str, Unit("speed")] = Field(
        "m/s", description=_one_of("speed") + " Or Bft, the strongest wind of a Beaufort number."
    )


class WordsSection(Section):
    """What things are called in answers."""

    robot: Word = Field(description="One robot.", examples=["tug"])


Words = Annotated[Annotated[Word, Tag("word")] | Annotated[WordsSection, Tag("value")], BY_KIND]
"""What robots are called, or a mapping that says so."""
