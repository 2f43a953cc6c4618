"""The wrenches that `swarmgrasp forces` is asked for, in options and in tables."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from swarmgrasp.cli.inputs import UsageFault, noting
from swarmgrasp.ranges import STRONGEST, WEAKEST, shown
from swarmgrasp.scenario.faults import Faults
from swarmgrasp.scenario.imports.cells import Cells, check_units, read_cells, wrench_names
from swarmgrasp.scenario.imports.source import Source
from swarmgrasp.terms import SI, Terms
from swarmgrasp.units import quantity

Triple = tuple[float, float, float]

COLUMNS = ("fx", "fy", "tz")
OF = dict(zip(COLUMNS, ("force", "force", "torque"), strict=True))
"""What the parts of a wrench are called, and what they measure."""
ANY = "any"
"""Said of a part of a wrench that may be anything."""
MOST_ROWS = 1_000_000
LARGEST_FILE = 100_000_000
"""Wrenches and bytes of a table that is read."""


@dataclass(frozen=True)
class Wrench:
    """A wrench that an option gives.

    Attributes
    ----------
    option : str
    given : sequence of str
        Its three parts, each a number, one with a unit, or "any".

    Examples
    --------
    >>> pull = Wrench("--wrench", ("3", "any", "500 N m"))
    >>> pull.value(Terms(force="kN")), pull.free, pull.faults()
    ((3000.0, 0.0, 500.0), ['fy'], [])
    """

    option: str
    given: Sequence[str]

    @property
    def free(self) -> list[str]:
        """The parts that may be anything."""
        return [part for part, text in zip(COLUMNS, self.given, strict=True) if text == ANY]

    def faults(self) -> list[str]:
        """Return what is wrong with it, whatever the units of numbers that have none."""
        faults: list[str] = []
        with noting(faults):
            self.value(SI)
        if len(self.free) == len(COLUMNS):
            faults.append(
                f"{self.option} is {' '.join(self.given)}; one of the three should be a number"
            )
        return faults

    def value(self, terms: Terms) -> Triple:
        """Return it in SI units and the file's frame; 0 for a part that may be anything.

        Raises
        ------
        UsageFault
            If a part is no force or torque, or they are too large or too small.
        """
        faults: list[str] = []
        values = []
        called = f"{self.option} is {' '.join(self.given)}"
        for text, of in zip(self.given, OF.values(), strict=True):
            with noting(faults):
                unit = terms.unit_of(of)
                values.append(0.0 if text == ANY else quantity(text, of, unit))
        if faults:
            raise UsageFault(f"{called}: {fault}" for fault in faults)
        x, y, turn = values
        if wrong := size_faults((x, y, turn)):
            raise UsageFault(f"{called}; {fault}" for fault in wrong)
        return x, y, turn


def size_faults(wrench: Triple) -> list[str]:
    """Return what is wrong with the size of a wrench [N, N, N m]."""
    largest = max(map(abs, wrench))
    if largest == 0.0 or WEAKEST <= largest <= STRONGEST:
        return []
    return [f"the largest of the three should be 0, or {WEAKEST:g} to {STRONGEST:g} in SI units"]


@dataclass(frozen=True)
class Wrenches:
    """The wrenches of a table, as it has them.

    Attributes
    ----------
    path : Path
    lines : list of int
    rows : list of (float, float, float)
    units : tuple of str
        Of the columns; "" where the table says none.
    """

    path: Path
    lines: list[int]
    rows: list[Triple]
    units: tuple[str, ...]

    def values(self, terms: Terms) -> list[Triple]:
        """Return them in SI units and the file's frame.

        Raises
        ------
        UsageFault
            If one is too large or too small, with its line.
        """
        sizes = [
            quantity(1.0, of, unit or terms.unit_of(of))
            for of, unit in zip(OF.values(), self.units, strict=True)
        ]
        found = [(x * sizes[0], y * sizes[1], turn * sizes[2]) for x, y, turn in self.rows]
        faults = [
            f"{self.path}:{line}: {fault}"
            for line, wrench in zip(self.lines, found, strict=True)
            for fault in size_faults(wrench)
        ]
        if faults:
            raise UsageFault(faults)
        return found


def read_wrenches(path: Path) -> Wrenches:
    """Read the wrenches of a table, whose first line names its columns; others are left out.

    Raises
    ------
    UsageFault
        If the file cannot be read or is no such table; all faults of it, each with its line.
    """
    source = Source(path, Faults(str(path)), largest=LARGEST_FILE)
    cells = read_cells(source, width=3, most=MOST_ROWS)
    found = None if cells is None else _wrenches(cells, source)
    if found is None or source.faults:
        raise UsageFault(source.faults.error().faults)
    return found


def _wrenches(cells: Cells, source: Source) -> Wrenches | None:
    """Return the wrenches of a table; None after a fault."""
    names = wrench_names(*COLUMNS)
    called = [names.get(head.name, "") for head in cells.heads]
    for name in COLUMNS:
        if called.count(name) != 1:
            many = "two columns" if name in called else "no column"
            source.fault(f"has {many} {name}; its first line should name fx, fy and tz once", 1)
    chosen = [head for head in cells.heads if head.name in names]
    check_units(chosen, {name: OF[part] for name, part in names.items()}, source)
    if source.faults:
        return None
    at = [called.index(name) for name in COLUMNS]
    rows = []
    for row in cells.rows:
        values = [cells.number(row.cells[k]) for k in at]
        for name, k, value in zip(COLUMNS, at, values, strict=True):
            if math.isnan(value):
                source.fault(f"{name} should be a finite number (got {shown(row.cells[k])})",
                             row.line)  # fmt: skip
        rows.append((values[0], values[1], values[2]))
    units = tuple(cells.heads[k].unit for k in at)
    return Wrenches(source.path, [row.line for row in cells.rows], rows, units)
