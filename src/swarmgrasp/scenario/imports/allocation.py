"""Allocation matrices from files: CSV, JSON, YAML or NumPy's own."""

import json
import warnings
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.ranges import array_of, shown
from swarmgrasp.scenario.document import read_document
from swarmgrasp.scenario.faults import Faults
from swarmgrasp.scenario.imports.cells import Cells, check_units, read_cells
from swarmgrasp.scenario.imports.source import Source

AXES = ("fx", "fy", "mz")
"""What the rows of a matrix are called."""
_CALLED = {
    "fx": "fx", "x": "fx", "surge": "fx", "fy": "fy", "y": "fy", "sway": "fy", "mz": "mz",
    "n": "mz", "yaw": "mz", "tz": "mz", "nz": "mz", "limit": "limit", "limits": "limit",
    "max": "limit", "least": "least", "min": "least", "name": "name", "thruster": "name",
}  # fmt: skip
"""What else people call them, and the limits and names beside them."""
_MATRICES = ("matrix", "tam", "T", "B")
"""Keys that a matrix stands under."""
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


def read_allocation(source: Source) -> Matrix | None:
    """Read an allocation matrix; None after a fault."""
    suffix = source.path.suffix.lower()
    if suffix == ".npy":
        return _of_numpy(source)
    if suffix in (".json", ".yaml", ".yml"):
        return _of_mapping(source)
    if suffix in SUFFIXES:
        return _of_table(source)
    source.fault(f"is no matrix by its name; that should end in {', '.join(SUFFIXES)}")
    return None


def is_allocation_file(path: Path) -> bool:
    """Tell whether a file is a matrix by its name or by what it holds; what is damaged is none."""
    suffix, quiet = path.suffix.lower(), Source(path, Faults(str(path)))
    if suffix == ".npy":
        return True
    if suffix in (".csv", ".tsv", ".txt"):
        cells = read_cells(quiet, width=1)
        is_wide = cells is not None and not cells.headings and len(cells.rows) in (3, 6)
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
    """Tell whether a table is an allocation matrix by its headings, or by those of its rows."""
    above = {_CALLED.get(heading.name) for heading in cells.headings}
    beside = {_CALLED.get(row.cells[0].lower()) for row in cells.rows}
    return above >= {"fx", "fy", "mz"} or beside >= {"fx", "fy", "mz"}


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
    return _checked(source, found if isinstance(found, np.ndarray) else None)


def _of_mapping(source: Source) -> Matrix | None:
    """Read a mapping with a matrix, and perhaps limits, names and a frame."""
    text = source.text()
    if text is None:
        return None
    own = Faults(str(source.path))
    try:
        data: Any = json.loads(text) if source.path.suffix == ".json" else None
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
    frame = data.get("frame", "")
    if frame not in ("", "ENU", "NED"):
        source.fault(
            f"frame: should be ENU or NED (got {shown(frame)})", root.key_marks["frame"][0]
        )
        return None
    for key in ("limits", "names"):
        if not isinstance(data.get(key, []), list):
            source.fault(f"{key}: should be a list, one a column", root.key_marks[key][0])
            return None
    found = _checked(source, data[keys[0]], root.key_marks[keys[0]][0])
    names = data.get("names")
    return found and Matrix(
        found.rows, data.get("limits"), names and list(map(str, names)), frame, found.said
    )


def _of_table(source: Source) -> Matrix | None:
    """Read a table: a thruster a row, or a thruster a column, or numbers alone."""
    cells = read_cells(source, width=1)
    if cells is None:
        return None
    if not cells.headings and is_allocation(cells):
        return _by_rows(source, cells, None)
    if not cells.headings:
        rows = [[cells.number(cell) for cell in row.cells] for row in cells.rows]
        return _checked(source, rows, cells.rows[0].line)
    above = [_CALLED.get(heading.name, "") for heading in cells.headings]
    if {"fx", "fy", "mz"} <= set(above):
        return _by_columns(source, cells, above)
    return _by_rows(source, cells, [heading.name for heading in cells.headings])


def _by_columns(source: Source, cells: Cells, above: list[str]) -> Matrix | None:
    """Read a table of a thruster a line."""
    before = len(source.faults)
    check_units(cells, {"limit": "force", "limits": "force", "max": "force", "least": "force",
                        "min": "force"}, source)  # fmt: skip
    strange = [h.name for h, known in zip(cells.headings, above, strict=True) if not known]
    sound = len(source.faults) == before
    twice = {name for name in above if name and above.count(name) > 1}
    for name in (*strange, *sorted(twice)):
        source.fault(f"has a column {name!r} too many; known: name, Fx, Fy, Mz, limit, least", 1)
    if strange or twice or not sound:
        return None
    lists = {name: [row.cells[k] for row in cells.rows] for k, name in enumerate(above)}
    units = {name: h.unit for name, h in zip(above, cells.headings, strict=True)}
    rows = [[cells.number(cell) for cell in lists[axis]] for axis in AXES]
    found = _checked(source, rows, cells.rows[0].line)
    limits = _limits(cells, lists, units)
    return found and Matrix(found.rows, limits, lists.get("name"), said=found.said)


def _by_rows(source: Source, cells: Cells, names: list[str] | None) -> Matrix | None:
    """Read a table of a line each for Fx, Fy and Mz, the first cell saying which."""
    held: dict[str, list[str]] = {}
    for row in cells.rows:
        called = _CALLED.get(row.cells[0].lower(), "")
        if called in ("", "name") or called in held:
            known = "Fx, Fy, Mz, limit and least, each once"
            source.fault(f"a row is called {row.cells[0]!r}; known: {known}", row.line)
            return None
        held[called] = row.cells[1:]
    missing = [axis.capitalize() for axis in AXES if axis not in held]
    if missing:
        source.fault(f"has no row {', '.join(missing)}")
        return None
    rows = [[cells.number(cell) for cell in held[axis]] for axis in AXES]
    found = _checked(source, rows, cells.rows[0].line)
    limits = _limits(cells, held, {})
    return found and Matrix(found.rows, limits, names[1:] if names else None, said=found.said)


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
    rows = None if given is None else array_of(given)
    if rows is None or rows.ndim != 2 or rows.shape[0] not in (3, 6) or not rows.size:
        size = "" if rows is None else f" (got {rows.shape})"
        source.fault(f"should be a matrix of 3 rows, Fx, Fy and Mz, of numbers{size}", line)
        return None
    if not np.isfinite(rows).all():
        i, k = np.argwhere(~np.isfinite(rows))[0]
        source.fault(f"row {i + 1}, column {k + 1} of the matrix is no finite number", line)
        return None
    if rows.shape[0] == 3:
        return Matrix(rows.tolist())
    said = "Of six rows surge, sway and yaw are taken, and heave, roll and pitch left out."
    return Matrix(rows[list(_SPACE)].tolist(), said=(said,))
