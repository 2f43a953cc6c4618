"""Turn the quantities of a document, "60 t" or "25 kn", into numbers in the file's units."""

from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from functools import cache
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin

import numpy as np
from pydantic import BaseModel

from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.outline.precision import written_precision
from swarmgrasp.ranges import is_number, shown
from swarmgrasp.scenario.document import Node
from swarmgrasp.scenario.faults import Faults, Path
from swarmgrasp.scenario.measures import AXES, AXIS, BEARING, HEADING, Measure, Row
from swarmgrasp.scenario.units import NAMED, Units
from swarmgrasp.units import BEAUFORT, bearing, in_unit, is_quantity, quantity, split, unit_name


@dataclass
class _Shape:
    """Where in a value quantities may stand: itself, the items of a list, the keys of a mapping."""

    of: str = ""
    row: tuple[str, ...] = ()
    item: "_Shape | None" = None
    keys: "dict[str, _Shape]" = field(default_factory=dict)

    def at(self, index: int) -> "_Shape | None":
        """Return the shape of an item of a list."""
        return _Shape(self.row[index]) if index < len(self.row) else self.item


def measured(
    root: Node, model: type[BaseModel], kinds: Collection[str]
) -> Iterator[tuple[Path, Node]]:
    """Yield every value of a document that measures one of some kinds, with its path."""
    yield from _within(root, _shape_of(model), kinds, ())


def _within(
    node: Node, shape: _Shape, kinds: Collection[str], path: Path
) -> Iterator[tuple[Path, Node]]:
    """Yield the values within a node that measure one of some kinds."""
    parts: list[tuple[str | int, Node, _Shape | None]] = []
    if isinstance(node.value, dict):
        parts = [(key, part, shape.keys.get(key)) for key, part in node.value.items()]
    elif isinstance(node.value, list):
        parts = [(i, part, shape.at(i)) for i, part in enumerate(node.value)]
    elif shape.of in kinds:
        yield path, node
    for key, part, told in parts:
        if told is not None:
            yield from _within(part, told, kinds, (*path, key))


@cache
def _shape_of(model: type[BaseModel]) -> _Shape:
    """Return the shape of a mapping."""
    found = _Shape()
    for name, info in model.model_fields.items():
        part = _Shape()
        _add(part, info.annotation, tuple(info.metadata))
        found.keys[info.alias or name] = part
    return found


def _add(shape: _Shape, annotation: Any, metadata: tuple[Any, ...] = ()) -> None:
    """Add to a shape what an annotation says, the branches of a union one after the other."""
    origin, inner = get_origin(annotation), get_args(annotation)
    for each in metadata:
        if isinstance(each, Measure):
            shape.of = each.of
        elif isinstance(each, Row):
            shape.row = each.of
    if origin is Annotated:
        _add(shape, inner[0], inner[1:])
    elif origin in (Union, UnionType):
        for branch in inner:
            _add(shape, branch)
    elif origin is list:
        shape.item = shape.item or _Shape()
        _add(shape.item, inner[0])
    elif isinstance(annotation, type) and issubclass(annotation, BaseModel):
        shape.keys |= _shape_of(annotation).keys


def in_numbers(root: Node, model: type[BaseModel], faults: Faults) -> tuple[Any, list[Path]]:
    """Return a document as plain data in which every quantity is a number in the file's units.

    A file in Beaufort comes out in metres per second.

    Parameters
    ----------
    root : Node
    model : type of BaseModel
        Of the whole document.
    faults : Faults
        Receives every quantity that cannot be read, with its place.

    Returns
    -------
    data : dict
    bad : list of tuple
        The paths to the quantities that cannot be read, which are left as they are written.
    """
    data: Any = root.plain()
    reading = _Reading(root, _units_in(data), faults)
    reading.heading = reading.heading_in(data)
    reading.turn(data, _shape_of(model), ())
    if reading.units.speed == BEAUFORT:
        data["units"]["speed"] = "m/s"
    return data, reading.bad


def precision_of(vertices: Node, units: Units) -> float | None:
    """Return how well corners are known that are written with units of their own.

    Returns
    -------
    float or None [the file's unit]
        By their decimals in the unit that they are all written in; 0 for several units, which a
        computation mixed. None for plain numbers, of which the outline itself tells.
    """
    written: list[Any] = [node.value for row in items_of(vertices) for node in items_of(row)]
    if not any(isinstance(value, str) for value in written):
        return None
    told = [split(value, "length") for value in written]
    names = {name or units.length for number, name in told if number}
    if len(names) != 1:
        return 0.0
    numbers = np.reshape([number for number, _ in told], (-1, 2))
    return written_precision(numbers) * in_unit(f"1 {names.pop()}", "length", units.length)


def items_of(node: Node) -> list[Node]:
    """Return the items of a list."""
    return node.value if isinstance(node.value, list) else []


def _units_in(data: Any) -> Units:
    """Return the units that a document is written in: SI for those that have faults."""
    written = data.get("units")
    given = written if isinstance(written, dict) else {}
    names = {of: unit_name(given[of], of) for of in NAMED if isinstance(given.get(of), str)}
    found: dict[str, Any] = {of: name for of, name in names.items() if name is not None}
    return Units(**found)


@dataclass
class _Reading:
    """The pass over one document."""

    root: Node
    units: Units
    faults: Faults
    heading: float | None = None
    """The true bearing of the bow [rad], if the file has one; 0 for one with a fault."""
    bad: list[Path] = field(default_factory=list)

    def heading_in(self, data: Any) -> float | None:
        """Return the true bearing of the bow [rad], None where the document says nothing of it."""
        written = data.get("heading")
        if written is None:
            return None
        try:
            found = self._number(written, HEADING)
        except QuantityInvalid:  # told by `turn`
            return 0.0
        return self.units.radians(found) if is_number(found) else 0.0

    def turn(self, data: Any, shape: _Shape, path: Path) -> None:
        """Turn every quantity within plain data into a number, in place."""
        pairs = data.items() if isinstance(data, dict) else enumerate(data)
        for key, value in list(pairs):
            part = shape.keys.get(key) if isinstance(data, dict) else shape.at(key)
            if part is None:
                continue
            if isinstance(value, dict | list):
                self.turn(value, part, (*path, key))
            elif part.of:
                try:
                    data[key] = self._number(value, part.of)
                except QuantityInvalid as error:
                    self._fault((*path, key), str(error))

    def _fault(self, path: Path, said: str) -> None:
        """Note a quantity that cannot be read, and show it."""
        node = self.root.find(path)
        told = "" if node.shown() in said else f" (got {node.shown()})"
        self.faults.add(node.mark, path, said + told)
        self.bad.append(path)

    def _number(self, value: Any, of: str) -> Any:
        """Return a quantity as a number in the file's unit, and anything else as it is."""
        if of in (BEARING, HEADING):
            from_north = 0.0 if of == HEADING else self.heading
            is_text = isinstance(value, str)
            return bearing(value, self.units.angle, from_north) if is_text else value
        if of == AXIS:
            of = "angle"
            if isinstance(value, str) and value in AXES:
                return self.units.turn(AXES[value])
            if isinstance(value, str) and not is_quantity(value):
                said = f"{shown(value)} is no axis; write +x, +y, -x, -y, or an angle"
                raise QuantityInvalid(said)
        if of == "speed" and self.units.speed == BEAUFORT:
            is_told = is_quantity(value) or is_number(value)
            return quantity(value, of, BEAUFORT) if is_told else value
        return in_unit(value, of, self.units.of(of)) if is_quantity(value) else value
