"""Outlines from drawings in SVG: one closed shape, its curves as chords."""

import math
import xml.parsers.expat
from collections.abc import Callable
from dataclasses import dataclass, field
from io import BytesIO
from typing import Any

from swarmgrasp.packages import check_installed
from swarmgrasp.ranges import shown
from swarmgrasp.scenario.imports.curves import FINE, chorded
from swarmgrasp.scenario.imports.hull import MOST_CORNERS, Hull, Point, opened
from swarmgrasp.scenario.imports.source import Source

_SHAPES = ("path", "polygon", "polyline", "rect", "circle", "ellipse")
_SIZES = ("width", "height", "viewBox", "preserveAspectRatio")
"""What of a drawing says how large it is shown, which is not how large the object is."""


@dataclass(eq=False)
class _Scan:
    """What is known of a drawing before it is taken apart."""

    raw: bytes
    lines: dict[str, int] = field(default_factory=dict)
    """Of each shape, by its id, or by its number where it has none."""
    said: str = ""
    line: int = 0

    def __post_init__(self) -> None:
        """Go through its tags."""
        parser = xml.parsers.expat.ParserCreate()
        parser.StartElementHandler = self._start
        parser.EntityDeclHandler = self._entity
        self._parser, self._depth, self._count = parser, 0, 0
        parser.EndElementHandler = self._end
        try:
            parser.Parse(self.raw, True)
        except xml.parsers.expat.ExpatError as error:
            self.said = self.said or f"is no XML: {xml.parsers.expat.ErrorString(error.code)}"
            self.line = self.line or error.lineno
        except _Refused:
            self.line = parser.CurrentLineNumber

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        """Take a start tag."""
        self._depth += 1
        plain = name.rpartition(":")[2]
        if self._depth == 1 and plain != "svg":
            self.said = f"should be a drawing in SVG; its first tag is {shown(name)}"
            raise _Refused
        if self._depth > 100:
            self.said = "nested too deep; at most 100 levels are read"
            raise _Refused
        if plain in _SHAPES:
            self.lines[attributes.get("id") or f"number {self._count + 1}"] = (
                self._parser.CurrentLineNumber
            )
            self._count += 1

    def _end(self, _: str) -> None:
        """Take an end tag."""
        self._depth -= 1

    def _entity(self, *_: Any) -> None:
        """Refuse a drawing that defines entities: they can grow without end."""
        self.said = "defines entities; save it as plain SVG"
        raise _Refused


class _Refused(Exception):
    """A drawing is refused, for what its scan says."""


def read_svg(source: Source, part: str = "", tolerance: float | None = None) -> Hull | None:
    """Read the one closed shape of a drawing, or that of an id, with y turned up."""
    raw = source.raw()
    if raw is None:
        return None
    check_installed("svgelements", extra="drawings", purpose="Reading SVG")
    scan = _Scan(raw)
    if scan.said:
        source.fault(scan.said, scan.line)
        return None
    shapes = _shapes(raw, source)
    chosen = None if shapes is None else _one(shapes, scan, source, part)
    if chosen is None:
        return None
    name, path = chosen
    line = scan.lines.get(name, 0)
    box = path.bbox()
    extent = math.hypot(box[2] - box[0], box[3] - box[1]) if box else 0.0
    if not 0.0 < extent < math.inf:
        source.fault(f"the shape {name} has no extent", line)
        return None
    within = FINE * extent if tolerance is None else tolerance
    try:
        points, is_closed, has_curves = _flattened(path, within)
        is_finite = all(math.isfinite(value) for point in points for value in point)
    except (ArithmeticError, ValueError):  # svgelements takes any word for a number
        is_finite = False
    if not is_finite:
        source.fault(f"the shape {name} holds numbers that are not finite", line)
        return None
    if len(points) > MOST_CORNERS:
        source.fault(
            f"the shape {name} has more than {MOST_CORNERS} corners; allow more tolerance", line
        )
        return None
    said = ["The drawing's y, which points down, is turned up."]
    if has_curves:
        said.append(f"Curves are chords that are off by at most {within:.3g} units of the drawing.")
    kept, is_ring = opened([(x, 0.0 - y) for x, y in points])
    return Hull(kept, "", is_closed or is_ring, tuple(said))


def _shapes(raw: bytes, source: Source) -> list[tuple[str, Any]] | None:
    """Return the shapes of a drawing, in its own units, by their ids; None after a fault."""
    from xml.etree import ElementTree

    from svgelements import SVG, Path, Shape

    try:
        tree = ElementTree.fromstring(raw)  # whose entities are refused before
        for key in _SIZES:
            tree.attrib.pop(key, None)
        drawing = SVG.parse(BytesIO(ElementTree.tostring(tree)), reify=True)
        found = [each for each in drawing.elements() if isinstance(each, Shape)]
        names = [each.values.get("id") or "" for each in found]
        paths = [Path(each) for each in found]
    except Exception as error:  # svgelements stumbles in many ways over wrong numbers
        source.fault(f"cannot be read as SVG: {shown(str(error) or type(error).__name__)}")
        return None
    return [
        (str(name) or f"number {i}", path)
        for i, (name, path) in enumerate(zip(names, paths, strict=True), start=1)
        if len(path) > 1
    ]


def _one(
    shapes: list[tuple[str, Any]], scan: _Scan, source: Source, part: str
) -> tuple[str, Any] | None:
    """Return the one shape that is meant; None after a fault."""
    names = ", ".join(name for name, _ in shapes[:10]) + (", ..." if len(shapes) > 10 else "")
    named = [shape for shape in shapes if not part or shape[0] == part]
    if not named:
        there = f"; it has {names}" if shapes else ""
        source.fault(f"holds no shape called {shown(part)}{there}" if part else "holds no shape")
    elif len(named) > 1:
        line = scan.lines.get(named[1][0], 0)
        source.fault(f"holds {len(named)} shapes, {names}; say which by part, its id", line)
    elif len(list(named[0][1].as_subpaths())) > 1:
        line = scan.lines.get(named[0][0], 0)
        source.fault(
            f"the shape {named[0][0]} has several parts or a hole; keep its outer ring", line
        )
    else:
        return named[0]
    return None


def _flattened(path: Any, tolerance: float) -> tuple[list[Point], bool, bool]:
    """Return the points of a path, whether it is closed, and whether it has curves."""
    import svgelements as svg

    points: list[Point] = []
    is_closed = has_curves = False
    for piece in path:
        if isinstance(piece, svg.Move):
            points.append((piece.end.x, piece.end.y))
        elif isinstance(piece, svg.Close):
            is_closed = True
        elif isinstance(piece, svg.Line):
            points.append((piece.end.x, piece.end.y))
        else:
            has_curves = True
            points += chorded(_at(piece), _bend(piece), tolerance)
        if len(points) > MOST_CORNERS:
            break
    return points, is_closed, has_curves


def _at(curve: Any) -> Callable[[float], complex]:
    """Return what tells where a curve is at a parameter from 0 to 1."""
    return lambda t: complex(*curve.point(t))


def _bend(curve: Any) -> float:
    """Return the largest second derivative of a curve in its parameter from 0 to 1."""
    import svgelements as svg

    if isinstance(curve, svg.Arc):
        return float(curve.sweep**2 * max(curve.rx, curve.ry))
    ends = [complex(*point) for point in curve]
    steps = [abs(a - 2.0 * b + c) for a, b, c in zip(ends, ends[1:], ends[2:], strict=False)]
    return float((len(ends) - 1) * (len(ends) - 2) * max(steps))
