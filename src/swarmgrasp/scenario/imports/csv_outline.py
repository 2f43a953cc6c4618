"""Outlines from tables of corners, as spreadsheets and instruments write them."""

import math

from swarmgrasp.ranges import shown
from swarmgrasp.scenario.imports.cells import Cells, Row, column, read_cells
from swarmgrasp.scenario.imports.hull import Hull, Point, opened
from swarmgrasp.scenario.imports.source import Source

_X = ("x", "east", "easting", "e", "lon", "long", "longitude", "lng")
_Y = ("y", "north", "northing", "n", "lat", "latitude")
_DEGREES = frozenset(("lon", "long", "longitude", "lng"))


def read_csv_outline(source: Source) -> Hull | None:
    """Read the corners x, y of an outline, one a line, with or without a header.

    With a header, columns called x and y, east and north, or longitude and latitude are taken, and
    others left out. Without one there are two columns, or three with a height at the end.
    """
    cells = read_cells(source)
    if cells is None:
        return None
    at, said = (0, 1), list[str]()
    if cells.heads:
        x, y = column(cells, _X, source, "x"), column(cells, _Y, source, "y")
        if x is None or y is None:
            return None
        at = (x, y)
    elif not _is_plain(cells, source, said):
        return None
    points = [_point(cells, row, at, source) for row in cells.rows]
    if any(point is None for point in points):
        return None
    others = [head.name for i, head in enumerate(cells.heads) if i not in at]
    if others:
        said.append(f"The columns {', '.join(others)} are left out.")
    unit = cells.heads[at[0]].unit if cells.heads else ""
    if cells.heads and cells.heads[at[1]].unit != unit:
        source.fault("the columns x and y are in different units; give both in one", 1)
        return None
    if cells.heads and cells.heads[at[0]].name in _DEGREES:
        unit = "deg"
    kept, is_ring = opened([point for point in points if point is not None])
    lines = tuple(row.line for row in cells.rows)[: len(kept)]
    return Hull(kept, unit, is_ring, tuple(said), lines)


def _is_plain(cells: Cells, source: Source, said: list[str]) -> bool:
    """Tell whether a table without a header can only mean x and y; note why not."""
    width, first = len(cells.rows[0].cells), cells.rows[0].line
    if width > 3:
        source.fault(f"has {width} columns and no header; name the columns x and y", first)
        return False
    if width == 3:
        firsts = [cells.number(row.cells[0]) for row in cells.rows]
        if firsts in ([float(i + k) for i in range(len(firsts))] for k in (0, 1)):
            source.fault("counts its lines in the first column; name the columns x and y", first)
            return False
        said.append("The third column is taken for a height and left out.")
    return True


def _point(cells: Cells, row: Row, at: tuple[int, int], source: Source) -> Point | None:
    """Return a corner; None after a fault."""
    x, y = (cells.number(row.cells[k]) for k in at)
    for value, k, name in ((x, at[0], "x"), (y, at[1], "y")):
        if math.isnan(value):
            source.fault(f"{name} should be a finite number (got {shown(row.cells[k])})", row.line)
    return None if math.isnan(x) or math.isnan(y) else (x, y)
