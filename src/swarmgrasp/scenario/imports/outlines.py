"""Outlines from files of any kind, in one unit: their corners, and what was assumed of them."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final, Literal

from swarmgrasp.errors import PackageMissing
from swarmgrasp.scenario.fields import FARTHEST
from swarmgrasp.scenario.imports.csv_outline import read_csv_outline
from swarmgrasp.scenario.imports.dxf import read_dxf
from swarmgrasp.scenario.imports.earth import on_the_plane
from swarmgrasp.scenario.imports.geojson import read_geojson
from swarmgrasp.scenario.imports.hull import Hull, centreline, looks_halved, mirrored, pointed_along
from swarmgrasp.scenario.imports.source import Source
from swarmgrasp.scenario.imports.svg import read_svg
from swarmgrasp.units import canonical, may_be_geographic, size, spellings

Coordinates = Literal["degrees", "metres"]
SUFFIXES = (".geojson", ".json", ".csv", ".tsv", ".txt", ".svg", ".dxf")
"""Of files that hold outlines."""
MAPS = (".geojson", ".json")
"""Of those in GeoJSON."""
ROUNDED = 1.5e-4
"""By how much rounding projected corners changes a distance at most [m]."""
DRAWINGS = (".svg", ".dxf")
"""And in drawings."""
DETECT: Final = "detect"
HALF = (
    "looks like one half of a hull: its ends lie on the {axis} axis, and all else on one side; say "
    "mirror: true to have the other half, or mirror: false if this is all of it"
)


@dataclass(frozen=True)
class Wish:
    """How a file is to be understood.

    Attributes
    ----------
    part : str
        Which of several shapes: the name of a feature, an id, a layer or a handle.
    scale : float, optional
        What one unit of the file is, in the unit wanted.
    tolerance : float, optional
        How far chords are off curves at most, in the unit wanted.
    mirror : bool or "detect", optional
        Whether it is one half of a hull, or is if it looks like one; when left out, what looks like
        one is refused.
    coordinates : {"degrees", "metres"}, optional
        Whether it has longitudes and latitudes; by their range when left out.
    """

    part: str = ""
    scale: float | None = None
    tolerance: float | None = None
    mirror: bool | Literal["detect"] | None = None
    coordinates: Coordinates | None = None


def read_outline(source: Source, unit: str, wish: Wish | None = None) -> Hull | None:
    """Read an outline in a unit of length; None after a fault.

    Parameters
    ----------
    source : Source
    unit : str
        As `swarmgrasp.units` calls it.
    wish : Wish, optional
    """
    wanted = wish or Wish()
    suffix = source.path.suffix.lower()
    if suffix not in SUFFIXES:
        source.fault(f"is no outline by its name; that should end in {', '.join(SUFFIXES)}")
        return None
    faults_before = len(source.faults)
    try:
        hull = _read(source, suffix, unit, wanted)
    except PackageMissing as error:
        source.fault("; ".join(error.faults))
        return None
    hull = hull and _in_unit(hull, source, unit, wanted)
    if hull is None or not _is_near(hull, source, unit):
        return None
    hull = _whole(hull, source, wanted)
    if hull is None or len(source.faults) > faults_before:
        return None
    if len(hull.points) < 3:
        source.fault(f"has {len(hull.points)} corners; an outline needs at least 3")
        return None
    return hull


def _read(source: Source, suffix: str, unit: str, wish: Wish) -> Hull | None:
    """Read a file as it is."""
    if suffix in DRAWINGS and wish.coordinates is not None:
        source.fault("has no longitudes and latitudes; leave out coordinates")
        return None
    if suffix == ".svg":
        return read_svg(source, wish.part, wish.tolerance and wish.tolerance / (wish.scale or 1.0))
    if suffix == ".dxf":
        return read_dxf(source, wish.part, _in_drawing(wish, unit))
    idle = {"has no parts by name; leave out part": wish.part and suffix not in MAPS}
    idle["has no curves; leave out tolerance"] = wish.tolerance is not None
    if said := [sentence for sentence, is_idle in idle.items() if is_idle]:
        for sentence in said:
            source.fault(sentence)
        return None
    if suffix in MAPS:
        return read_geojson(source, wish.part)
    return read_csv_outline(source)


def _in_drawing(wish: Wish, unit: str) -> Callable[[str], float | None]:
    """Return what tells the tolerance in a drawing's own unit, "" for one that names none."""

    def told(own: str) -> float | None:
        if wish.tolerance is None:
            return None
        if wish.scale is not None or not own:
            return wish.tolerance / (wish.scale or 1.0)
        return wish.tolerance * size(unit, "length") / size(own, "length")

    return told


def _in_unit(hull: Hull, source: Source, unit: str, wish: Wish) -> Hull | None:
    """Return a hull with its corners in a unit of length."""
    is_map = source.path.suffix.lower() in MAPS
    own = hull.unit
    if wish.coordinates is not None:
        own = "deg" if wish.coordinates == "degrees" else "m" if own == "deg" else own
    elif not own and is_map:
        own = "deg" if may_be_geographic(hull.points) else "m"
        if own == "m":
            said = "The coordinates are taken for metres: they are no longitudes and latitudes"
            hull = hull.with_word(f"{said} of anything smaller than 5 km.")
    if own == "deg" and wish.scale is not None:
        source.fault("is in degrees of longitude and latitude; leave out scale")
        return None
    if own == "deg":
        return _projected(hull, source, unit)
    if wish.scale is not None:
        factor = wish.scale
        though = f", though it says {own}" if own else ""
        hull = hull.with_word(f"One unit of the file is {factor:g} {unit}{though}.")
    elif own:
        known = canonical(own, "length")
        if known is None:
            known_units = ", ".join(sorted(set(spellings("length").values())))
            source.fault(f"is in {own!r}, which is no unit of length; known: {known_units}", 1)
            return None
        factor = size(known, "length") / size(unit, "length")
        hull = hull if known == unit else hull.with_word(f"Its {known} are turned into {unit}.")
    else:
        said = f"The file names no unit of length; its numbers are taken for {unit}."
        return hull.with_word(said)
    return replace(hull, points=[(x * factor, y * factor) for x, y in hull.points])


def _projected(hull: Hull, source: Source, unit: str) -> Hull | None:
    """Return a hull of longitudes and latitudes on the plane at their middle."""
    wrong = next((i for i, (x, y) in enumerate(hull.points) if abs(x) > 360 or abs(y) > 90), None)
    if wrong is not None:
        x, y = hull.points[wrong]
        line = hull.lines[wrong] if hull.lines else 0
        source.fault(f"({x:g}, {y:g}) is no longitude and latitude in degrees", line)
        return None
    flat = on_the_plane(hull.points)
    if not flat.error <= 1e-3 * max(math.dist(p, flat.points[0]) for p in flat.points):
        source.fault("spans too much of the earth for one plane; an object is smaller than 300 km")
        return None
    lon, lat = flat.middle
    said = (
        f"Longitudes and latitudes (WGS 84) are projected on the plane at {lon:.6f}, {lat:.6f}: x "
        "to the east, y to true north, rounded to a tenth of a millimetre; no distance is off by "
        f"more than {flat.error + ROUNDED:.1g} m."
    )
    factor = 1.0 / size(unit, "length")
    points = [(round(x, 4) * factor, round(y, 4) * factor) for x, y in flat.points]
    return replace(hull, points=points).with_word(said)


def _is_near(hull: Hull, source: Source, unit: str) -> bool:
    """Tell whether no corner is farther than a scenario can have it; note the first that is."""
    far = next((i for i, p in enumerate(hull.points) if not max(map(abs, p)) <= FARTHEST), None)
    if far is None:
        return True
    x, y = hull.points[far]
    line = hull.lines[far] if hull.lines else 0
    source.fault(f"({x:.6g}, {y:.6g}) {unit} is too far; at most {FARTHEST:g} {unit}", line)
    return False


def _whole(hull: Hull, source: Source, wish: Wish) -> Hull | None:
    """Return a hull with both its halves."""
    axis = looks_halved(hull.points)
    if wish.mirror is None and axis is not None:
        source.fault(HALF.format(axis=axis))
        return None
    if not wish.mirror or (wish.mirror == DETECT and axis is None):
        if hull.is_closed or source.path.suffix.lower() not in DRAWINGS:
            return hull
        return hull.with_word("The shape is open; a straight side joins its ends.")
    axis = centreline(hull.points)
    if axis is None:
        source.fault(
            "is no half of a hull: its first and last corners should lie on the x or the y axis, "
            "the centreline, and all others on one side; leave out mirror"
        )
        return None
    bow = pointed_along(hull.points, axis)
    whole = replace(hull, points=mirrored(hull.points, axis), lines=(), bow=bow)
    said = f"It is one half of the hull; the other is its mirror image in the {axis} axis."
    return whole.with_word(said)
