"""Outlines from GeoJSON (RFC 7946): a Polygon, a Feature, or a FeatureCollection that has one."""

import json
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.files import MOST_DEPTH
from swarmgrasp.ranges import is_number, plain_name, shown
from swarmgrasp.scenario.document import read_document
from swarmgrasp.scenario.faults import Faults
from swarmgrasp.scenario.faults import Path as Keys
from swarmgrasp.scenario.imports.hull import MOST_CORNERS, Hull, Point, opened
from swarmgrasp.scenario.imports.source import Source

_DEGREES = re.compile(r"(?i)crs:?84|4326")
"""What a coordinate reference system is called whose coordinates are degrees."""


@dataclass(frozen=True, eq=False)
class _Found:
    """A geometry, where it stands, and what it is called."""

    geometry: dict[str, Any]
    keys: Keys
    name: str


@dataclass(eq=False)
class _Reader:
    """The reading of one file."""

    source: Source
    text: str
    said: list[str] = field(default_factory=list)
    is_sound: bool = True

    def fault(self, keys: Keys, sentence: str) -> None:
        """Note a fault where keys lead to."""
        self.is_sound = False
        self.source.fault(sentence, _line_of(self.text, keys), keys)

    def geometries(self, data: Any, keys: Keys = (), name: str = "") -> Iterator[_Found]:
        """Go through all geometries."""
        kind = data.get("type") if isinstance(data, dict) else None
        if kind == "Feature" and isinstance(data.get("geometry"), dict):
            yield from self.geometries(
                data["geometry"], (*keys, "geometry"), _name_of(data) or name
            )
        elif kind in ("FeatureCollection", "GeometryCollection"):
            key = "features" if kind == "FeatureCollection" else "geometries"
            parts = data.get(key)
            if not isinstance(parts, list):
                self.fault((*keys, key), "should be a list")
                return
            for i, part in enumerate(parts):
                yield from self.geometries(part, (*keys, key, i), name)
        elif isinstance(data, dict) and isinstance(kind, str):
            yield _Found(data, keys, name)
        elif isinstance(data, dict) and str(data.get("format")).startswith("swarmgrasp "):
            said = "is an answer, and no map; commands ask it again as it stands, as in"
            self.fault(keys, f"{said} `swarmgrasp place ANSWER.json`")
        else:
            said = "should be GeoJSON: a mapping with type, such as Polygon or Feature"
            self.fault(keys, f"{said} (got {shown(data)})")

    def ring(self, found: _Found) -> list[Point] | None:
        """Return the corners of a polygon without holes; None after a fault."""
        keys, rings = (*found.keys, "coordinates"), found.geometry.get("coordinates")
        if found.geometry["type"] == "MultiPolygon" and isinstance(rings, list) and rings:
            self.said.append("The MultiPolygon of one polygon is taken for that.")
            keys, rings = (*keys, 0), rings[0]
        called = f"the polygon {found.name!r}" if found.name else "the polygon"
        if not isinstance(rings, list) or not rings or not isinstance(rings[0], list):
            self.fault(keys, "should be a list of rings, each a list of points")
            return None
        if len(rings) > 1:
            holes = "a hole" if len(rings) == 2 else f"{len(rings) - 1} holes"
            self.fault(
                (*keys, 1),
                f"{called} has {holes}; an outline has none: what pushes from outside never meets "
                "them, leave out all rings but the first",
            )
            return None
        if len(rings[0]) > MOST_CORNERS:
            self.fault((*keys, 0), f"{called} has more than {MOST_CORNERS} corners")
            return None
        points = [self.point(p, (*keys, 0, i)) for i, p in enumerate(rings[0])]
        if any(isinstance(p, list) and len(p) > 2 for p in rings[0]):
            self.said.append("Heights, the third number of points, are left out.")
        return None if None in points else [p for p in points if p is not None]

    def point(self, given: Any, keys: Keys) -> Point | None:
        """Return a corner; None after a fault."""
        good = isinstance(given, list) and 2 <= len(given) <= 4 and all(map(is_number, given))
        if not good or not all(map(_is_finite, given[:2])):
            self.fault(keys, f"should be [x, y], two finite numbers (got {shown(given)})")
            return None
        return float(given[0]), float(given[1])


def read_geojson(source: Source, part: str = "") -> Hull | None:
    """Read the one polygon of a file, or that of a name; its unit is "m", "deg" or not known."""
    text = source.text()
    data = None if text is None else _json(source, text)
    if text is None or data is None:
        return None
    reader = _Reader(source, text)
    every = list(reader.geometries(data))
    named = [each for each in every if not part or each.name == part]
    found = _one_polygon(reader, every, named, part)
    ring = None if found is None else reader.ring(found)
    if found is None or ring is None or not reader.is_sound:
        return None
    kept, _ = opened(ring)
    return Hull(kept, _unit_of(data), True, tuple(reader.said))


def _one_polygon(
    reader: _Reader, every: list[_Found], named: list[_Found], part: str
) -> _Found | None:
    """Return the one polygon of geometries; None after a fault."""
    areas = [each for each in named if each.geometry["type"] in ("Polygon", "MultiPolygon")]
    names = [each.name or f"number {i + 1}" for i, each in enumerate(every)]
    if not reader.is_sound:
        return None
    if part and not named:
        reader.fault((), f"has no feature called {shown(part)}; it has {_list(names)}")
    elif not areas:
        kinds = sorted({each.geometry["type"] for each in named})
        reader.fault((), f"holds no Polygon, only {_list(kinds) if kinds else 'nothing'}")
    elif len(areas) > 1:
        called = [each.name or f"number {i + 1}" for i, each in enumerate(areas)]
        reader.fault(
            areas[1].keys, f"there are {len(areas)} polygons, {_list(called)}; say which by part"
        )
    elif areas[0].geometry["type"] == "MultiPolygon":
        parts = areas[0].geometry.get("coordinates")
        if isinstance(parts, list) and len(parts) > 1:
            name = f" {areas[0].name!r}" if areas[0].name else ""
            reader.fault(
                (*areas[0].keys, "coordinates", 1),
                f"the MultiPolygon{name} has {len(parts)} polygons; an outline is one: keep one",
            )
    return areas[0] if reader.is_sound else None


def _json(source: Source, text: str) -> Any:
    """Return what JSON holds; None after a fault."""
    try:
        data = json.loads(text)
    except json.JSONDecodeError as error:
        source.fault(f"is no JSON: {error.msg}", error.lineno)
        return None
    except RecursionError:
        source.fault(f"nested too deep; at most {MOST_DEPTH} levels are read")
        return None
    except ValueError:  # a number of more digits than Python reads
        source.fault("holds a number of too many digits")
        return None
    if not isinstance(data, dict):
        source.fault(f"should be GeoJSON: a mapping with type (got {shown(data)})", 1)
        return None
    return data


def _unit_of(data: dict[str, Any]) -> str:
    """Return the unit that a named reference system gives: "" where none is named."""
    name: Any = data.get("crs")
    for key in ("properties", "name"):
        name = name.get(key) if isinstance(name, dict) else None
    if not isinstance(name, str):
        return ""
    return "deg" if _DEGREES.search(name) else "m"


def _name_of(feature: dict[str, Any]) -> str:
    """Return what a feature is called."""
    properties = feature.get("properties")
    held = (
        [properties.get(key) for key in ("name", "Name", "NAME")]
        if isinstance(properties, dict)
        else []
    )
    name = next((v for v in (*held, feature.get("id")) if isinstance(v, str) and v), "")
    return plain_name(name[:60])


def _line_of(text: str, keys: Keys) -> int:
    """Return the line that keys lead to; 0 where it cannot be told."""
    try:
        root = read_document(text.replace("\t", " "), Faults(""))
    except ScenarioInvalid:
        return 0
    return root.find(keys).mark[0]


def _is_finite(value: float) -> bool:
    """Tell whether a number is finite as a float."""
    try:
        return math.isfinite(value)
    except OverflowError:
        return False


def _list(names: list[str]) -> str:
    """Return the first of some names in a row."""
    return ", ".join(names[:10]) + (", ..." if len(names) > 10 else "")
