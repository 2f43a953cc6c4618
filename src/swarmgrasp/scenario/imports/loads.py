"""Load tables from files: speed and bearing of a wind, and what it exerts."""

import math
from typing import Any

from swarmgrasp.ranges import shown
from swarmgrasp.scenario.imports.cells import check_headings, check_units, read_cells, wrench_names
from swarmgrasp.scenario.imports.source import Source

_CALLED = {
    "speed": "speed", "wind speed": "speed", "v": "speed", "wind": "speed", "bearing": "bearing",
    "from": "bearing", "angle": "bearing", "wind angle": "bearing",
    **wrench_names("fx", "fy", "mz"), "x": "fx", "y": "fy", "n": "mz",
}  # fmt: skip
"""What people call the columns."""
_KINDS = {"speed": "speed", "bearing": "angle", "fx": "force", "fy": "force", "mz": "torque"}
"""What the columns measure."""
COLUMNS = ("speed", "bearing", "fx", "fy", "mz")


def read_loads(source: Source) -> list[list[float | str]] | None:
    """Read the rows of a load table, as a scenario has them; None after a fault.

    A unit in a heading, as in "Fx [kN]", is that of its numbers. Without a header there are five
    columns, in this order.
    """
    cells = read_cells(source, width=5)
    if cells is None:
        return None
    before = len(source.faults)
    check_headings(cells, list(_CALLED), source)
    check_units(cells.headings, {name: _KINDS[column] for name, column in _CALLED.items()}, source)
    called = [_CALLED.get(h.name, h.name) for h in cells.headings] or list(COLUMNS)
    missing = [name for name in COLUMNS if name not in called]
    if missing and len(source.faults) == before:
        source.fault(f"has no column {', '.join(missing)}", 1)
    if len(called) > len(COLUMNS) or (not cells.headings and len(cells.rows[0].cells) > 5):
        source.fault(f"should have five columns, {', '.join(COLUMNS)}", 1)
    if len(source.faults) > before:
        return None
    units = [heading.unit for heading in cells.headings] or [""] * len(COLUMNS)
    order = [called.index(name) for name in COLUMNS]
    rows: list[list[float | str]] = []
    for row in cells.rows:
        told: list[Any] = []
        for k, name in zip(order, COLUMNS, strict=True):
            value = cells.number(row.cells[k])
            if math.isnan(value):
                source.fault(
                    f"{name} should be a finite number (got {shown(row.cells[k])})", row.line
                )
            told.append(f"{cells.plain(row.cells[k])} {units[k]}" if units[k] else value)
        rows.append(told)
    return rows if len(source.faults) == before else None
