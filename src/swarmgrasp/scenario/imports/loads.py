"""Load tables from files: speed and bearing of a wind, and what it exerts."""

import math

from swarmgrasp.ranges import shown
from swarmgrasp.scenario.document import Node
from swarmgrasp.scenario.imports.cells import check_heads, check_units, read_cells, wrench_names
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


def read_loads(source: Source) -> list[Node] | None:
    """Read the rows of a load table, as a document has them; None after a fault.

    A unit in a head, as in "Fx [kN]", is that of its numbers. Without a header there are five
    columns, in this order.
    """
    cells = read_cells(source, width=5)
    if cells is None:
        return None
    before = len(source.faults)
    check_heads(cells, list(_CALLED), source)
    check_units(cells.heads, {name: _KINDS[column] for name, column in _CALLED.items()}, source)
    called = [_CALLED.get(h.name, h.name) for h in cells.heads] or list(COLUMNS)
    missing = [name for name in COLUMNS if name not in called]
    if missing and len(source.faults) == before:
        source.fault(f"has no column {', '.join(missing)}", 1)
    if len(called) > len(COLUMNS) or (not cells.heads and len(cells.rows[0].cells) > 5):
        source.fault(f"should have five columns, {', '.join(COLUMNS)}", 1)
    if len(source.faults) > before:
        return None
    units = [head.unit for head in cells.heads] or [""] * len(COLUMNS)
    order = [called.index(name) for name in COLUMNS]
    rows: list[Node] = []
    for row in cells.rows:
        mark, told = (row.line, 0, str(source.path)), list[Node]()
        for k, name in zip(order, COLUMNS, strict=True):
            value = cells.number(row.cells[k])
            if math.isnan(value):
                source.fault(
                    f"{name} should be a finite number (got {shown(row.cells[k])})", row.line
                )
            plain = cells.plain(row.cells[k])
            told.append(Node(mark, f"{plain} {units[k]}" if units[k] else value, plain))
        rows.append(Node(mark, told))
    return rows if len(source.faults) == before else None
