"""Allocation matrices from files: CSV, JSON, YAML or NumPy's own."""

import json
import math
import warnings
from dataclasses import dataclass, field, replace
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.ranges import array_of, nearest_name, shown
from swarmgrasp.scenario.document import Node, read_document
from swarmgrasp.scenario.faults import Faults
from swarmgrasp.scenario.imports.cells import (
    Cells,
    ColumnHead,
    Row,
    check_units,
    head_of,
    read_cells,
    wrench_names,
)
from swarmgrasp.scenario.imports.source import Source
from swarmgrasp.units import quantity, size

AXES = ("fx", "fy", "mz")
"""What the rows of a matrix are called."""
_CALLED = {
    **wrench_names("fx", "fy", "mz"), "x": "fx", "y": "fy", "n": "mz", "limit": "limit",
    "limits": "limit",
    "max": "limit", "least": "least", "min": "least", "name": "name", "thruster": "name",
}  # fmt: skip
"""What else people call them, and the limits and names beside them."""
_OF_POINTS = ("x", "y", "n")
"""What the columns of surveyed points are called, too: their numbers, x and y."""
_KINDS = {
    called: "length" if known == "mz" else "force"
    for called, known in _CALLED.items()
    if known in ("mz", "limit", "least")
}
"""What columns measure: a yaw is for each unit of force, as surge and sway, which are numbers."""
_MATRICES = ("matrix", "tam", "T", "B")
"""Keys that a matrix stands under."""
_BESIDE = ("limits", "names", "frame")
"""And those that may stand beside."""
_SPACE = (0, 1, 5)
"""The rows surge, sway and yaw of a matrix of six."""
SUFFIXES = (".npy", ".json", ".yaml", ".yml", ".csv", ".tsv", ".txt")


@dataclass(frozen=True)
class Matrix:
    """A matrix as a file has it.

    Attributes
    ----------
    rows : list of list of float
        Three.
    limits : list or None
        Each a number, a pair, or text with a unit.
    names : list of str or None
    frame : str
        "" where the file names none.
    said : tuple of str
        What was assumed of it.
    """

    rows: list[list[float]]
    limits: list[Any] | None = None
    names: list[str] | None = None
    frame: str = ""
    said: tuple[str, ...] = field(default=())


def read_allocation(source: Source, unit: str) -> Matrix | None:
    """Read an allocation matrix, its yaw in a unit of length; None after a fault."""
    suffix = source.path.suffix.lower()
    if suffix == ".npy":
        return _of_numpy(source)
    if suffix in (".json", ".yaml", ".yml"):
        return _of_mapping(source)
    if suffix in SUFFIXES:
        return _of_table(source, unit)
    source.fault(f"is no matrix by its name; that should end in {', '.join(SUFFIXES)}")
    return None


def is_allocation_file(path: Path) -> bool:
    """Tell whether a file is a matrix by its name or by what it holds; what is damaged is none."""
    suffix, quiet = path.suffix.lower(), Source(path, Faults(str(path)))
    if suffix == ".npy":
        return True
    if suffix in (".csv", ".tsv", ".txt"):
        cells = read_cells(quiet, width=1)
        is_wide = cells is not None and not cells.heads and len(cells.rows) in (3, 6)
        return cells is not None and (
            is_allocation(cells) or (is_wide and len(cells.rows[0].cells) > 3)
        )
    text = quiet.text() if suffix in (".json", ".yaml", ".yml") else None
    if text is not None and suffix == ".json" and text.lstrip().startswith("["):
        return True
    try:
        root = None if text is None else read_document(text.replace("\t", " "), quiet.faults)
    except ScenarioInvalid:
        return False
    return (
        root is not None
        and isinstance(root.value, dict)
        and any(key in root.value for key in _MATRICES)
    )


def is_allocation(cells: Cells) -> bool:
    """Tell whether a table is an allocation matrix by its heads, or by those of its rows.

    Columns x, y and n are those of surveyed points unless limits stand beside them.
    """
    above = [head.name for head in cells.heads]
    return _are_axes(above) or _are_axes([_head_of(row).name for row in cells.rows])


def _are_axes(names: list[str]) -> bool:
    """Tell whether heads can only be those of a matrix."""
    called = {_CALLED.get(name) for name in names}
    sure = {_CALLED.get(name) for name in names if name not in _OF_POINTS}
    return called >= set(AXES) and bool(sure & {*AXES, "limit", "least"})


def _head_of(row: Row) -> ColumnHead:
    """Return what a line of a table is called, by its first cell."""
    return head_of(row.cells[0])


def _of_numpy(source: Source) -> Matrix | None:
    """Read an array as NumPy writes it."""
    raw = source.raw()
    if raw is None:
        return None
    try:
        with warnings.catch_warnings(action="ignore"):
            found = np.load(BytesIO(raw), allow_pickle=False)
    except Exception as error:  # NumPy stumbles in many ways over a wrong header
        source.fault(f"cannot be read as an array of NumPy: {shown(str(error))}")
        return None
    return _checked(source, found if isinstance(found, np.ndarray) else ())


def _of_mapping(source: Source) -> Matrix | None:
    """Read a mapping with a matrix, and perhaps limits, names and a frame."""
    text = source.text()
    if text is None:
        return None
    own = Faults(str(source.path))
    try:
        data: Any = json.loads(text) if source.path.suffix.lower() == ".json" else None
        if isinstance(data, list):
            return _checked(source, data)
        root = read_document(text.replace("\t", " "), own)
    except (ScenarioInvalid, ValueError, RecursionError) as error:
        source.fault(f"cannot be read: {shown(str(error))}")
        return None
    data = root.plain()
    keys = [key for key in _MATRICES if key in data]
    if not keys:
        source.fault(f"holds no matrix under {', '.join(_MATRICES)}", 1)
        return None
    before, frame = len(source.faults), data.get("frame", "")
    if frame not in ("", "ENU", "NED"):
        source.fault(
            f"frame: should be ENU or NED (got {shown(frame)})", root.key_marks["frame"][0]
        )
    for key in ("limits", "names"):
        if not isinstance(data.get(key, []), list):
            source.fault(f"{key}: should be a list, one a column", root.key_marks[key][0])
    for key in keys[1:]:
        said = f"{keys[0]} and {key} each say the matrix; keep one"
        source.fault(said, root.key_marks[key][0])
    found = _checked(source, data[keys[0]], root.key_marks[keys[0]][0])
    said_of_others = _left_out(source, root)
    if found is None or len(source.faults) > before:
        return None
    names = data.get("names")
    told = *found.said, *said_of_others
    return Matrix(found.rows, data.get("limits"), names and list(map(str, names)), frame, told)


def _left_out(source: Source, root: Node) -> tuple[str, ...]:
    """Say which keys of a mapping are left out; note those that are known ones, misspelt."""
    known = (*_MATRICES, *_BESIDE)
    others = [str(key) for key in root.value if key not in known]  # type: ignore[union-attr]
    for key in others:
        remedy = nearest_name(key, _BESIDE)
        if remedy.startswith("; did"):
            source.fault(f"unknown key {shown(key)}{remedy}", root.key_marks[key][0])
    return (f"The keys {', '.join(others)} are left out.",) if others else ()


def _of_table(source: Source, unit: str) -> Matrix | None:
    """Read a table: a thruster a row, or a thruster a column, or numbers alone."""
    cells = read_cells(source, width=1)
    if cells is None:
        return None
    if not cells.heads and all(math.isnan(cells.number(row.cells[0])) for row in cells.rows):
        return _by_rows(source, cells, unit)
    if not cells.heads:
        columns = [f"column {k + 1}" for k in range(len(cells.rows[0].cells))]
        return _checked(source, _numbers(source, cells, cells.rows, columns))
    above = [_CALLED.get(head.name, "") for head in cells.heads]
    if set(AXES) <= set(above):
        return _by_columns(source, cells, above, unit)
    return _by_rows(source, cells, unit)


def _by_columns(source: Source, cells: Cells, above: list[str], unit: str) -> Matrix | None:
    """Read a table of a thruster a line."""
    before = len(source.faults)
    check_units(cells.heads, _KINDS, source)
    strange = [h.name for h, known in zip(cells.heads, above, strict=True) if not known]
    twice = {name for name in above if name and above.count(name) > 1}
    for name in (*strange, *sorted(twice)):
        source.fault(f"has a column {name!r} too many; known: name, Fx, Fy, Mz, limit, least", 1)
    if strange or twice or len(source.faults) > before:
        return None
    lists = {name: [row.cells[k] for row in cells.rows] for k, name in enumerate(above)}
    units = {name: h.unit for name, h in zip(above, cells.heads, strict=True)}
    at = [above.index(axis) for axis in AXES]
    lines = [Row(row.line, [row.cells[k] for k in at]) for row in cells.rows]
    numbers = _numbers(source, cells, lines, [axis.capitalize() for axis in AXES])
    found = _checked(source, numbers and [list(axis) for axis in zip(*numbers, strict=True)])
    return found and _whole(cells, found, lists, units, lists.get("name"), unit)


def _by_rows(source: Source, cells: Cells, unit: str) -> Matrix | None:
    """Read a table of a line each for Fx, Fy and Mz, the first cell saying which."""
    held, units, before = dict[str, Row](), dict[str, str](), len(source.faults)
    for row in cells.rows:
        head = _head_of(row)
        called = _CALLED.get(head.name, "")
        if called in ("", "name") or called in held:
            known = "Fx, Fy, Mz, limit and least, each once"
            source.fault(f"a row is called {row.cells[0]!r}; known: {known}", row.line)
            continue
        check_units([head], _KINDS, source, row.line)
        held[called], units[called] = row, head.unit
    missing = [axis.capitalize() for axis in AXES if axis not in held]
    if missing:
        source.fault(f"has no row {', '.join(missing)}")
    if len(source.faults) > before:
        return None
    lines = [Row(held[axis].line, held[axis].cells[1:]) for axis in AXES]
    columns = [f"column {k + 2}" for k in range(len(lines[0].cells))]
    found = _checked(source, _numbers(source, cells, lines, columns))
    names = [head.name for head in cells.heads][1:]
    lists = {name: row.cells[1:] for name, row in held.items()}
    return found and _whole(cells, found, lists, units, names or None, unit)


def _numbers(
    source: Source, cells: Cells, lines: list[Row], columns: list[str]
) -> list[list[float]] | None:
    """Return the numbers of lines of a table, what their columns are called; None after a fault."""
    found = [[cells.number(cell) for cell in line.cells] for line in lines]
    before = len(source.faults)
    for line, values in zip(lines, found, strict=True):
        for cell, value, name in zip(line.cells, values, columns, strict=True):
            if math.isnan(value):
                source.fault(f"{name} should be a finite number (got {shown(cell)})", line.line)
    return found if len(source.faults) == before else None


def _whole(
    cells: Cells, found: Matrix, lists: dict[str, list[str]], units: dict[str, str],
    names: list[str] | None, unit: str,
) -> Matrix:  # fmt: skip
    """Return a matrix with the limits and names of a table, its yaw in a unit of length."""
    x, y, turns = found.rows
    if own := units.get("mz"):
        factor = quantity(f"1 {own}", "length") / size(unit, "length")
        turns = [factor * turn for turn in turns]
    return replace(found, rows=[x, y, turns], limits=_limits(cells, lists, units), names=names)


def _limits(cells: Cells, held: dict[str, list[str]], units: dict[str, str]) -> list[Any] | None:
    """Return the limits of a table, as a scenario has them."""
    if "limit" not in held:
        return None
    told = [_told(cells, cell, units.get("limit", "")) for cell in held["limit"]]
    if "least" not in held:
        return told
    least = [_told(cells, cell, units.get("least", "")) for cell in held["least"]]
    return [list(pair) for pair in zip(least, told, strict=True)]


def _told(cells: Cells, cell: str, unit: str) -> float | str:
    """Return a limit as a number, or with its unit."""
    value = cells.number(cell)
    if value != value:
        return cells.plain(cell)
    return f"{cells.plain(cell)} {unit}" if unit else value


def _checked(source: Source, given: Any, line: int = 0) -> Matrix | None:
    """Return a matrix of three rows, of three given or six; None after a fault."""
    if given is None:
        return None
    rows = array_of(given)
    if rows is None or rows.ndim != 2 or rows.shape[0] not in (3, 6) or not rows.size:
        got = "" if rows is None else f" (got {rows.shape})"
        source.fault(f"should be a matrix of 3 rows, Fx, Fy and Mz, of numbers{got}", line)
        return None
    wrong = np.argwhere(~np.isfinite(rows))
    for i, k in wrong:
        source.fault(f"row {i + 1}, column {k + 1} of the matrix is no finite number", line)
    if len(wrong):
        return None
    if rows.shape[0] == 3:
        return Matrix(rows.tolist())
    said = "Of six rows surge, sway and yaw are taken, and heave, roll and pitch left out."
    return Matrix(rows[list(_SPACE)].tolist(), said=(said,))
