"""The wrenches that `swarmgrasp forces` is asked for, in options and in tables."""

import csv as tables
import io
import math
from collections.abc import Sequence
from pathlib import Path

from swarmgrasp.cli.inputs import UsageFault
from swarmgrasp.files import read_fault
from swarmgrasp.ranges import STRONGEST, WEAKEST

Triple = tuple[float, float, float]

COLUMNS = ("fx", "fy", "tz")
MOST_TOLD = 20
"""Faults of a table that are told."""
LARGEST_FILE = 100_000_000
"""Bytes of a table that is read."""


def number_faults(triple: Triple) -> list[str]:
    """Return what is wrong with three numbers of a wrench."""
    largest = max(map(abs, triple))
    if all(map(math.isfinite, triple)) and (largest == 0 or WEAKEST <= largest <= STRONGEST):
        return []
    return [
        f"they should be finite, the largest 0 or {WEAKEST:g} to {STRONGEST:g} in size [N, N, N m]"
    ]


ANY = "any"
"""Said of a part of a wrench that may be anything."""
OF = ("force", "force", "torque")


def parse_wrench(option: str, given: Sequence[str]) -> tuple[Triple, list[str], list[str]]:
    """Read the three parts of a wrench, each a number, one with a unit, or "any".

    Returns
    -------
    wrench : tuple of float [N, N, N m]
        0 for a part that may be anything.
    free : list of {"fx", "fy", "tz"}
        The parts that may be anything.
    faults : list of str

    Examples
    --------
    >>> parse_wrench("--wrench", ("300kN", "any", "-5"))
    ((300000.0, 0.0, -5.0), ['fy'], [])
    """
    from swarmgrasp.errors import QuantityInvalid
    from swarmgrasp.units import quantity

    free = [part for part, text in zip(COLUMNS, given, strict=True) if text == ANY]
    values, faults = [], []
    for text, of in zip(given, OF, strict=True):
        try:
            values.append(0.0 if text == ANY else quantity(text, of))
        except QuantityInvalid as error:
            faults += [f"{option} is {' '.join(given)}; {fault}" for fault in error.faults]
            values.append(0.0)
    x, y, turn = values
    if len(free) == len(COLUMNS):
        faults.append(f"{option} is {' '.join(given)}; one of the three should be a number")
    faults += [f"{option} is {' '.join(given)}; {fault}" for fault in number_faults((x, y, turn))]
    return (x, y, turn), free, faults


def read_wrenches(path: Path) -> tuple[list[int], list[Triple]]:
    """Read the wrenches of a table and the line of each.

    Raises
    ------
    UsageFault
        If the file cannot be read or is no such table; all faults of it, each with its line.
    """
    try:
        raw = path.read_bytes()
    except OSError as error:
        raise UsageFault(read_fault(path, error)) from None
    if len(raw) > LARGEST_FILE:
        raise UsageFault(f"{path}: is too large; it should have at most {LARGEST_FILE} bytes")
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise UsageFault(f"{path}: is not UTF-8 text, from byte {error.start} on") from None
    reader = tables.reader(io.StringIO(text, newline=""), skipinitialspace=True)
    faults: list[str] = []
    lines, rows = [], []
    try:
        header = _header(path, next(reader, []))
        for cells in reader:
            if any(cell.strip() for cell in cells):
                lines.append(reader.line_num)
                row, wrong = _row(cells, header)
                rows.append(row)
                faults += (f"{path}:{reader.line_num}: {fault}" for fault in wrong)
    except tables.Error as error:
        faults.append(f"{path}:{reader.line_num}: cannot be read as a table: {error}")
    if not rows and not faults:
        faults.append(f"{path}:1: has no wrenches below its first line")
    if faults:
        left = len(faults) - MOST_TOLD
        raise UsageFault(faults[:MOST_TOLD] + ([f"... and {left} more"] if left > 0 else []))
    return lines, rows


def _header(path: Path, cells: Sequence[str]) -> list[str]:
    """Return the names of the columns.

    Raises
    ------
    UsageFault
        If one of those needed is missing or there twice.
    """
    header = [cell.strip().lower() for cell in cells]
    faults = [
        f"{path}:1: has {header.count(name) or 'no'} column{'s' if name in header else ''} {name}; "
        "the first line should name fx, fy and tz [N, N, N m] once, separated by commas"
        for name in COLUMNS
        if header.count(name) != 1
    ]
    if faults:
        raise UsageFault(faults)
    return header


def _row(cells: Sequence[str], header: Sequence[str]) -> tuple[Triple, list[str]]:
    """Return the wrench of a line, and what is wrong with it."""
    none = (0.0, 0.0, 0.0)
    if len(cells) != len(header):
        return none, [f"has {len(cells)} values; the first line names {len(header)} columns"]
    values, faults = [], []
    for name in COLUMNS:
        cell = cells[header.index(name)].strip()
        try:
            values.append(float(cell))
        except ValueError:
            faults.append(f"{name} is {cell!r}; it should be a number")
    if faults:
        return none, faults
    x, y, turn = values
    given = " ".join(f"{value:g}" for value in values)
    return (x, y, turn), [
        f"fx, fy, tz are {given}; {fault}" for fault in number_faults((x, y, turn))
    ]
