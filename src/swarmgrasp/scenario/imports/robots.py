"""Robots from a table, one a line, its columns called as the keys of a robot."""

import re
from typing import Any

from swarmgrasp.scenario.document import Node, resolve
from swarmgrasp.scenario.imports.cells import Cells, Row, check_heads, check_units, read_cells
from swarmgrasp.scenario.imports.source import Source

KEYS = (
    "name", "x", "y", "theta", "at", "edge", "along", "direction", "limit", "ahead", "astern",
    "least", "steers", "friction", "mounted", "two_way", "lever", "group", "length", "beam",
)  # fmt: skip
"""Columns that a table of robots may have: x and y are the contact."""
_KINDS = {
    **dict.fromkeys(("x", "y", "at", "along", "lever", "length", "beam"), "length"),
    **dict.fromkeys(("theta", "direction", "steers"), "angle"),
    **dict.fromkeys(("limit", "ahead", "astern", "least"), "force"),
}
"""What they measure."""
_TEXTS = ("name", "group", "edge")
"""Columns of text: "7" is a name there."""
_BOTH = {"x": "y", "y": "x", "ahead": "astern", "astern": "ahead"}
"""Columns that go together."""
_WHOLE = re.compile(r"[0-9]+")


def read_robots(source: Source) -> list[Node] | None:
    """Read robots as the items of a document's list; None after a fault.

    Empty cells are keys left out. A unit in a head, as in "limit [kN]", is that of its numbers.
    """
    cells = read_cells(source)
    if cells is None:
        return None
    if not cells.heads:
        source.fault(f"needs a header that names its columns; known: {', '.join(KEYS)}", 1)
        return None
    before = len(source.faults)
    check_heads(cells, KEYS, source)
    check_units(cells.heads, _KINDS, source)
    names = [head.name for head in cells.heads]
    for name in names:
        other = _BOTH.get(name)
        if other and other not in names:
            source.fault(f"has a column {name} and none of {other}; they go together", 1)
    if "limit" in names and "ahead" in names:
        source.fault("limit, and ahead with astern, each say the limit; keep one", 1)
    if "least" in names and "limit" not in names:
        source.fault("has a column least and none of limit; they go together", 1)
    if len(source.faults) > before:
        return None
    return [_robot(cells, row, source) for row in cells.rows]


def _robot(cells: Cells, row: Row, source: Source) -> Node:
    """Return a robot as a mapping of a document."""
    mark: Any = (row.line, 0, str(source.path))
    held = {
        head.name: _value(cells, cell, head.name, head.unit, mark)
        for head, cell in zip(cells.heads, row.cells, strict=True)
        if cell
    }
    for key, parts in (("contact", ("x", "y")), ("limit", ("least", "limit"))):
        if all(part in held for part in parts):
            held[key] = Node(mark, [held.pop(part) for part in parts])
    if "ahead" in held or "astern" in held:
        both: dict[str, Node] = {k: held.pop(k) for k in ("ahead", "astern") if k in held}
        held["limit"] = Node(mark, both, key_marks=dict.fromkeys(both, mark))
    return Node(mark, held, key_marks=dict.fromkeys(held, mark))


def _value(cells: Cells, cell: str, name: str, unit: str, mark: Any) -> Node:
    """Return what a cell holds, as a document has it."""
    plain = cells.plain(cell)
    value = resolve(plain)
    if name in _TEXTS and not (name == "edge" and _WHOLE.fullmatch(plain)):
        value = cell
    elif unit and isinstance(value, int | float) and not isinstance(value, bool):
        value = f"{plain} {unit}"
    elif isinstance(value, str) and value.lower() in ("true", "false", "yes", "no"):
        value = value.lower() in ("true", "yes")  # spreadsheets write TRUE
    return Node(mark, value, plain)
