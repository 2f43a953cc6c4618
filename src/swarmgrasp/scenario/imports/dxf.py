"""Outlines from drawings in DXF: one closed polyline, its arcs as chords."""

import math
from collections import Counter
from collections.abc import Callable
from io import BytesIO
from typing import Any

from swarmgrasp.packages import check_installed
from swarmgrasp.ranges import shown
from swarmgrasp.scenario.imports.curves import FINE, bulged
from swarmgrasp.scenario.imports.hull import MOST_CORNERS, Hull, Point, opened
from swarmgrasp.scenario.imports.source import Source

_UNITS = {
    1: "in", 2: "ft", 3: "mile", 4: "mm", 5: "cm", 6: "m", 7: "km", 10: "yard", 14: "decimeter",
    21: "survey_foot",
}  # fmt: skip
"""The units of $INSUNITS in which people draw what is pushed."""
_MOST_NAMED = 10


def read_dxf(
    source: Source, part: str = "", tolerance: Callable[[str], float | None] = lambda _: None
) -> Hull | None:
    """Read the one polyline of a drawing, or that of a layer or handle.

    `tolerance` tells how far chords are off arcs at most, in the drawing's unit.
    """
    raw = source.raw()
    if raw is None:
        return None
    check_installed("ezdxf", extra="drawings", purpose="Reading DXF")
    drawing = _drawing(raw, source)
    lines = None if drawing is None else _polylines(drawing, source, part)
    if drawing is None or lines is None:
        return None
    corners = _corners(lines)
    called = f"the polyline {lines.dxf.handle} on layer {lines.dxf.layer!r}"
    if len(corners) > MOST_CORNERS or not all(math.isfinite(v) for c in corners for v in c):
        source.fault(f"{called} should have at most {MOST_CORNERS} corners of finite numbers")
        return None
    spans = [max(c[k] for c in corners) - min(c[k] for c in corners) for k in (0, 1)]
    extent = math.hypot(*spans)
    if not 0.0 < extent < math.inf:
        source.fault(f"{called} has no extent")
        return None
    unit = _UNITS.get(int(drawing.header.get("$INSUNITS", 0)), "")
    within = tolerance(unit) or FINE * extent
    points, said = _flattened(corners, bool(lines.is_closed), within), list[str]()
    if any(bulge for _, _, bulge in corners):
        said.append(f"Arcs are chords that are off by at most {within:.3g} units of the drawing.")
    if lines.dxftype() != "LWPOLYLINE" and any(v.dxf.location.z for v in lines.vertices):
        said.append("Heights, the third number of points, are left out.")
    kept, is_ring = opened(points)
    return Hull(kept, unit, bool(lines.is_closed) or is_ring, tuple(said))


def _drawing(raw: bytes, source: Source) -> Any:
    """Return a drawing; None after a fault."""
    import logging

    import ezdxf.recover

    logging.getLogger("ezdxf").setLevel(logging.CRITICAL)
    try:
        drawing, auditor = ezdxf.recover.read(BytesIO(raw))
    except Exception as error:  # ezdxf stumbles in many ways over what is no drawing
        source.fault(f"cannot be read as DXF: {shown(str(error) or type(error).__name__)}")
        return None
    if auditor.has_errors:
        source.fault(f"is damaged: {shown(auditor.errors[0].message)}; save it anew")
        return None
    return drawing


def _polylines(drawing: Any, source: Source, part: str) -> Any:
    """Return the one polyline that is meant; None after a fault."""
    every = list(drawing.modelspace())
    named = [e for e in every if not part or part in (e.dxf.layer, e.dxf.handle)]
    found = [e for e in named if e.dxftype() in ("LWPOLYLINE", "POLYLINE") and _is_flat(e)]
    if len(found) == 1:
        return found[0]
    if found:
        names = [f"{e.dxf.handle} on layer {e.dxf.layer!r}" for e in found[:_MOST_NAMED]]
        said = (
            f"holds {len(found)} polylines, {', '.join(names)}; say which by part, layer or handle"
        )
    elif part and not named:
        layers = sorted({e.dxf.layer for e in every})[:_MOST_NAMED]
        said = f"has nothing on a layer or of a handle {shown(part)}; layers: {', '.join(layers)}"
    else:
        kinds = Counter(e.dxftype() for e in named)
        there = ", ".join(f"{count} {kind}" for kind, count in kinds.most_common(_MOST_NAMED))
        said = f"holds no polyline, only {there or 'nothing'}; join them to one"
    source.fault(said)
    return None


def _is_flat(polyline: Any) -> bool:
    """Tell whether a polyline is one, and no mesh."""
    kind = polyline.dxftype()
    return bool(kind == "LWPOLYLINE" or polyline.is_2d_polyline or polyline.is_3d_polyline)


def _corners(polyline: Any) -> list[tuple[float, float, float]]:
    """Return the corners x, y and the bulge after each of a polyline."""
    if polyline.dxftype() == "LWPOLYLINE":
        return [(float(x), float(y), float(b)) for x, y, b in polyline.get_points("xyb")]
    return [
        (float(v.dxf.location.x), float(v.dxf.location.y), float(v.dxf.get("bulge", 0.0)))
        for v in polyline.vertices
    ]


def _flattened(
    corners: list[tuple[float, float, float]], is_closed: bool, tolerance: float
) -> list[Point]:
    """Return the corners of a polyline with its arcs as chords."""
    points = [corners[0][:2]]
    following = [*corners[1:], corners[0]] if is_closed else corners[1:]
    for (x, y, bulge), after in zip(corners, following, strict=False):
        points += bulged((x, y), after[:2], bulge, tolerance)
        if len(points) > MOST_CORNERS:
            break
    return points
