"""What can be told of edges before there is an outline, which faults of its own keep from being.

An edge that is named is there or not whatever the corners are, and one whose two ends can be read
has its length whatever the others are. What needs the whole boundary waits.
"""

import math
from collections.abc import Collection, Iterator, Sequence

from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.ranges import nearest_name, number
from swarmgrasp.scenario.document import Node
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.quantities import items_of
from swarmgrasp.scenario.schema import RobotSection, StretchSection
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.units import in_unit, is_quantity

VERTICES: Path = ("outline", "vertices")
Corner = tuple[float, float] | None


def length_name(checked: Checked, units: Units) -> str:
    """Return the file's unit of length, or what the file calls one that is none.

    Coordinates with units of their own are in metres then.
    """
    if checked.is_sound("units", "length") or True in checked.measures.get(VERTICES, ()):
        return units.length
    written = checked.root.find(("units", "length")).value
    is_named = checked.has("units", "length") and isinstance(written, str) and written
    return str(written) if is_named else "units"


def comparable(paths: Collection[Path], checked: Checked) -> frozenset[Path]:
    """Return the paths to lengths that are in the unit of the vertices.

    That is all of them as a rule. Beside a unit of length that cannot be read, those that are
    written as the vertices are: as plain numbers, or with units of their own.
    """
    if checked.is_sound("units", "length"):
        return frozenset(paths)
    found = checked.measures
    vertices = found.get(VERTICES, set())
    return frozenset(p for p in paths if len(vertices | found.get(p[:2], set())) <= 1)


def check_edges(checked: Checked, units: Units, paths: Collection[Path]) -> None:
    """Note edges that are not there, and places beyond the end of one.

    Parameters
    ----------
    checked : Checked
    units : Units
    paths : collection of tuple
        Robots, zones and stretches that the outline cannot be asked about.
    """
    corners = _corners(checked, units)
    is_named = checked.is_sound("outline", "edges")
    named = (checked.file.outline.edges if is_named else None) or []
    count = max(len(corners), len(named))
    unnamed = [""] * (count - len(named))
    labels = [name or f"edge {i}" for i, name in enumerate([*named, *unnamed])]
    indices = {label: i for i, label in enumerate(labels)}
    sized = comparable(paths, checked)
    for path, section in _sections(checked, paths):
        edge = section.edge
        if edge is None or not count or not checked.is_sound(*path, "edge"):
            continue
        if isinstance(edge, str) and not is_named:
            continue
        index = indices.get(edge, count) if isinstance(edge, str) else edge
        if index >= count:
            known = nearest_name(edge, labels) if isinstance(edge, str) else ""
            said = f"there is no such edge; they run from 0 to {count - 1}{known}"
            checked.fault((*path, "edge"), said)
        elif path in sized and len(corners) == count:
            length = _length(corners[index], corners[(index + 1) % count])
            _check_ends(section, path, labels[index], length, checked, units)


def _sections(
    checked: Checked, paths: Collection[Path]
) -> Iterator[tuple[Path, RobotSection | StretchSection]]:
    """Yield the robots, zones and stretches at some paths."""
    file = checked.file
    places: list[tuple[str, Sequence[RobotSection | StretchSection]]] = [
        ("robots", file.robots),
        ("zones", file.zones or ()),
        ("no_go", file.no_go),
    ]
    for key, sections in places:
        yield from (((key, i), part) for i, part in enumerate(sections) if (key, i) in paths)


def _corners(checked: Checked, units: Units) -> list[Corner]:
    """Return the corners as they are written, in the file's unit; None for each with a fault.

    One that the next repeats, as the first does at the end of a ring, is left out, as outlines do.
    """
    written = [_corner(row, units) for row in items_of(checked.root.find(VERTICES))]
    after = [*written[1:], *written[:1]]
    return [a for a, b in zip(written, after, strict=True) if a is None or a != b]


def _corner(row: Node, units: Units) -> Corner:
    """Return one corner, None if it has a fault."""
    point = []
    for node in items_of(row):
        value: object = node.value
        if isinstance(value, str) and is_quantity(value):
            try:
                value = in_unit(value, "length", units.length)
            except QuantityInvalid:
                return None
        point.append(number(value))
    return (point[0], point[1]) if len(point) == 2 and all(map(math.isfinite, point)) else None


def _length(start: Corner, end: Corner) -> float:
    """Return how long an edge is, if both ends are known and are not the same."""
    return (math.dist(start, end) if start and end else 0.0) or math.inf


def _check_ends(
    section: RobotSection | StretchSection,
    path: Path,
    label: str,
    length: float,
    checked: Checked,
    units: Units,
) -> None:
    """Note what is said to be on an edge and is beyond its end."""
    for key, name in (("along", "along"), ("start", "from"), ("end", "to")):
        distance = getattr(section, key, None)
        if distance is not None and distance > length * (1.0 + 1e-9):
            unit = length_name(checked, units)
            said = f"should lie in [0, {length:.9g}] {unit}, the length of {label}"
            checked.fault((*path, name), said)
