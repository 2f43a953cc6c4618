"""What the values of a scenario file measure, said beside their types.

A value that measures something may be written as a number, in the file's unit, or as text with a
unit of its own: "60 t", "25 kn". Before a document is checked, `quantities` turns such text into
numbers in the file's units, so that everything after it sees numbers.
"""

from dataclasses import dataclass
from typing import Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, PydanticCustomError
from pydantic_core.core_schema import no_info_after_validator_function, str_schema

from swarmgrasp.units import spellings, unit_fault, unit_name

WITH_UNIT: dict[str, Any] = {"type": "string", "pattern": "^\\s*[-+\u2212]?\\.?[0-9]"}
"""The JSON schema of a quantity in text: it begins with a number."""
BEARING = "bearing"
"""Of wind or current: an angle clockwise from the bow, a true bearing, or a compass point."""
HEADING = "heading"
"""Of the object: a true bearing."""
AXIS = "axis"
"""An angle, or one of the axes of the file's coordinates, such as +y."""
AXES = {"+x": 0.0, "x": 0.0, "+y": 0.25, "y": 0.25, "-x": 0.5, "-y": -0.25}
"""The direction of each axis, as a part of a turn in the file's sense of turning."""


@dataclass(frozen=True)
class Measure:
    """What a number measures, such as "length" of `swarmgrasp.units.quantity`, or "bearing"."""

    of: str

    def __get_pydantic_json_schema__(
        self, core_schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        """Allow text beside the number."""
        return {"anyOf": [handler(core_schema), _text(self.of)]}


@dataclass(frozen=True)
class Row:
    """What the numbers of a row measure, one after the other; "" for a number without a unit."""

    of: tuple[str, ...]

    def __get_pydantic_json_schema__(
        self, core_schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        """Allow text beside the numbers."""
        schema = handler(core_schema)
        return {**schema, "items": {"anyOf": [schema["items"], _text(*self.of)]}}


def _text(*of: str) -> dict[str, Any]:
    """Return the JSON schema of the text that some quantity may be."""
    if AXIS in of:
        return {"anyOf": [WITH_UNIT, {"enum": list(AXES)}]}
    return {"type": "string"} if {BEARING, HEADING} & set(of) else WITH_UNIT


@dataclass(frozen=True)
class Unit:
    """The name of a unit of some quantity, in any of its spellings; read as it is called here."""

    quantity: str

    def name(self, written: str) -> str:
        """Return what a unit is called here."""
        name = unit_name(written, self.quantity)
        if name is None:
            raise PydanticCustomError("unit", unit_fault(written, self.quantity))
        return name

    def __get_pydantic_core_schema__(
        self, source: type[Any], handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """Read text as the name of a unit."""
        return no_info_after_validator_function(self.name, str_schema())

    def __get_pydantic_json_schema__(
        self, core_schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        """List the spellings."""
        return {"type": "string", "enum": list(spellings(self.quantity))}
