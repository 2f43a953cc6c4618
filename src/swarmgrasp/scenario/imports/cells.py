"""Tables as text: their separator, their decimal comma, their header, and each cell's line."""

import csv
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.ranges import nearest_name, shown
from swarmgrasp.scenario.imports.source import MOST_ROWS, Source
from swarmgrasp.units import quantity

_WRENCH = (("fx", "surge"), ("fy", "sway"), ("tz", "mz", "nz", "yaw"))
"""What people call the parts of a wrench."""
_NUMBER = re.compile(r"[-+\u2212]?(\d+[.,]?\d*|[.,]\d+)([eE][-+]?\d+)?")
_COMMA = re.compile(r"[-+\u2212]?\d*,\d+([eE][-+]?\d+)?(\s*[^\d\s,;][^,;]*)?")
"""A number with a decimal comma, perhaps with its unit."""
_UNIT = re.compile(r"(.*?)\s*(?:\[([^\]]*)\]|\(([^)]*)\))")
"""A head with its unit in brackets."""
MOST_CELLS = 200
"""Columns of a table."""


class Row(NamedTuple):
    """A line of a table: its number, counted from 1, and its cells."""

    line: int
    cells: list[str]


@dataclass(frozen=True)
class ColumnHead:
    """What stands above a column.

    Attributes
    ----------
    name : str
        In small letters.
    unit : str
        That it gives in brackets; "" if none.
    """

    name: str
    unit: str = ""


@dataclass(frozen=True, eq=False)
class Cells:
    """A table as text.

    Attributes
    ----------
    heads : tuple of ColumnHead
        None at all if the first line holds numbers.
    rows : list of Row
    has_decimal_comma : bool
    """

    heads: tuple[ColumnHead, ...]
    rows: list[Row]
    has_decimal_comma: bool

    def number(self, cell: str) -> float:
        """Return the number in a cell; nan if it is none, or not finite."""
        if not _NUMBER.fullmatch(cell) or ("," in cell and not self.has_decimal_comma):
            return math.nan
        value = float(cell.replace(",", ".").replace("\u2212", "-"))
        return value if math.isfinite(value) else math.nan

    def plain(self, cell: str) -> str:
        """Return a cell with a point for a decimal comma, if it holds a number."""
        return cell.replace(",", ".") if self.has_decimal_comma and _COMMA.fullmatch(cell) else cell


def read_cells(source: Source, *, width: int = 2, most: int = MOST_ROWS) -> Cells | None:
    """Read the table in a file; None after a fault.

    The separator is a semicolon, a tab, a comma, or blanks, the first of these that there is; a
    comma within numbers is a decimal one where something else separates them. Empty lines and what
    follows # at the start of a line are left out.

    Parameters
    ----------
    source : Source
    width : int
        Cells that a line has at least.
    most : int
        Rows that are read.
    """
    text = source.text()
    if text is None:
        return None
    lines = list(_lines(text))
    if not lines:
        source.fault("holds no rows")
        return None
    separator, has_comma = _separator([line for _, line in lines])
    rows: list[Row] = []
    try:
        for number, line in lines:
            rows.append(Row(number, _split(line, separator)))
    except csv.Error as error:
        source.fault(f"is no table: {error}", number)
        return None
    if len(rows) > most:
        source.fault(f"has {len(rows)} rows; at most {most} are read", rows[most].line)
        return None
    found = Cells((), rows, has_comma)
    if not any(_NUMBER.fullmatch(cell) for cell in rows[0].cells):
        found = Cells(tuple(map(head_of, rows[0].cells)), rows[1:], has_comma)
        if not found.rows:
            source.fault("has a header and no rows", rows[0].line)
            return None
    return found if _is_even(found, width, source, separator) else None


def wrench_names(*parts: str) -> dict[str, str]:
    """Return which of three parts is meant, for every name of a part of a wrench.

    Examples
    --------
    >>> names = wrench_names("fx", "fy", "mz")
    >>> names["surge"], names["yaw"]
    ('fx', 'mz')
    """
    return {name: part for part, names in zip(parts, _WRENCH, strict=True) for name in names}


def head_of(cell: str) -> ColumnHead:
    """Return a head, its unit in brackets apart."""
    found = _UNIT.fullmatch(cell)
    if found is None:
        return ColumnHead(cell.strip().lower())
    return ColumnHead(found[1].strip().lower(), (found[2] or found[3] or "").strip())


def column(cells: Cells, names: Sequence[str], source: Source, said: str) -> int | None:
    """Return which column has one of some names, the first of them first; None after a fault."""
    called = [head.name for head in cells.heads]
    for name in names:
        if name in called:
            return called.index(name)
    known = ", ".join(repr(head.name) for head in cells.heads)
    source.fault(f"has no column of {said}, called {names[0]}; its columns are {known}", 1)
    return None


def check_heads(cells: Cells, known: Sequence[str], source: Source) -> None:
    """Note the columns that nobody asked for, and those that stand twice."""
    seen: set[str] = set()
    for head in cells.heads:
        if head.name not in known:
            source.fault(f"unknown column {shown(head.name)}{nearest_name(head.name, known)}", 1)
        elif head.name in seen:
            source.fault(f"there are two columns called {shown(head.name)}; keep one", 1)
        seen.add(head.name)


def check_units(
    heads: Sequence[ColumnHead], kinds: Mapping[str, str], source: Source, line: int = 1
) -> None:
    """Note units in heads that are none of what their columns, or lines, measure.

    Parameters
    ----------
    heads : sequence of ColumnHead
    kinds : mapping of str to str
        What they measure, by their names; others measure nothing.
    source : Source
    line : int
        In which they stand.
    """
    for head in heads:
        kind = kinds.get(head.name, "")
        if head.unit and not kind:
            source.fault(f"{shown(head.name)} has no unit; leave it out", line)
        elif head.unit:
            try:
                quantity(f"1 {head.unit}", kind)
            except QuantityInvalid as error:
                source.fault(f"{shown(head.name)}: {'; '.join(error.faults)}", line)


def _lines(text: str) -> Iterator[tuple[int, str]]:
    """Yield the lines that hold something, with their numbers; Excel's `sep=;` does not."""
    for number, line in enumerate(re.split(r"\r\n|\r|\n", text), start=1):
        plain = line.strip(" ").strip("\u00a0")
        if plain.strip() and not plain.startswith("#") and not re.fullmatch(r"sep=.", plain):
            yield number, plain


def _separator(lines: Sequence[str]) -> tuple[str, bool]:
    """Return what separates the cells of lines, and whether commas within them are decimal."""
    for mark in (";", "\t"):
        if any(mark in line for line in lines):
            cells = [cell.strip() for line in lines for cell in line.split(mark)]
            return mark, any(_COMMA.fullmatch(cell) for cell in cells)
    blank = [line.split() for line in lines]
    if any("," in line for line in lines):
        numbers = [
            cells for cells in blank if len(cells) > 1 and all(map(_NUMBER.fullmatch, cells))
        ]
        is_decimal = any(_COMMA.fullmatch(cell) for cells in numbers for cell in cells)
        return (" ", True) if is_decimal else (",", False)
    return " ", False


def _split(line: str, separator: str) -> list[str]:
    """Return the cells of a line."""
    if separator == " ":
        return line.split()
    cells = next(csv.reader([line], delimiter=separator, skipinitialspace=True, strict=True))
    return [cell.strip() for cell in cells]


def _is_even(cells: Cells, width: int, source: Source, separator: str) -> bool:
    """Tell whether all lines have as many cells, at least a number; note those that do not."""
    wanted = len(cells.heads) or len(cells.rows[0].cells)
    if not width <= wanted <= MOST_CELLS:
        said = (
            f"has {wanted} cells; a line should have {width} to {MOST_CELLS}, apart by , ; or tabs"
        )
        source.fault(said, cells.rows[0].line)
        return False
    remedy = "; with decimal commas, put ; between cells" if separator == "," else ""
    sound = True
    for row in cells.rows:
        while len(row.cells) > wanted and not row.cells[-1]:
            row.cells.pop()  # what a spreadsheet leaves at the end of lines
        if len(row.cells) != wanted:
            source.fault(f"has {len(row.cells)} cells; there should be {wanted}{remedy}", row.line)
            sound = False
    return sound
