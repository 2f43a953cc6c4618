"""`swarmgrasp forces --wrenches`: the forces for many wrenches, from and to tables."""

import csv as tables
import io
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from swarmgrasp.cli.dash import DASH
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.inputs import UsageFault, print_json
from swarmgrasp.cli.pushes import (
    IDLE,
    Triple,
    load_of,
    number_faults,
    share,
    size_of,
    wrench_text,
)

if TYPE_CHECKING:
    from swarmgrasp.cli.report import Forces as Unit
    from swarmgrasp.cli.report import Report
    from swarmgrasp.forces import ForcesAlong
    from swarmgrasp.scenario import Scenario

COLUMNS = ("fx", "fy", "tz")
MOST_TOLD = 20
"""Faults of a table that are told, and wrenches of one that are listed."""
LARGEST_FILE = 100_000_000
"""Bytes of a table that is read."""


def tell_trajectory(
    scenario: "Scenario",
    lines: Sequence[int],
    rows: Sequence[Triple],
    load: Triple | None,
    *,
    csv: str | None,
    json: str | None,
) -> None:
    """Find and tell the forces for the wrenches of a table.

    Parameters
    ----------
    scenario : Scenario
    lines : sequence of int
        Of the table, one for each wrench.
    rows : sequence of tuple of float [N, N, N m]
    load : tuple of float [N, N, N m] or None
    csv, json : str or None
        Where to write the forces.
    """
    from swarmgrasp.answer_file import document_of
    from swarmgrasp.files import write_whole
    from swarmgrasp.forces import forces_along

    found = forces_along(scenario.swarm, rows, load=load_of(scenario, load))

    def draw() -> list[str]:
        if csv in (None, DASH):
            return []
        write_whole(str(csv), table_text(found).encode())
        return [str(csv)]

    def tell() -> None:
        if csv == DASH:
            print_json(table_text(found))
        else:
            show(scenario.name, found, lines)

    deliver(json, document_of(found, scenario.name), tell, draw, aside=csv == DASH)


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
        raise UsageFault(f"{path}: cannot be read: {error.strerror}") from None
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


def table_text(found: "ForcesAlong") -> str:
    """Return the forces as a table: what was wanted, how well it is made, and who does what."""
    out = io.StringIO(newline="")
    writer = tables.writer(out, lineterminator="\n")
    robots = [f"{name} [N]" for name in found.swarm.names]
    writer.writerow([*COLUMNS, "largest_share", "needed", "shortfall", *robots])
    columns = zip(
        found.wanted.tolist(), found.largest_shares.tolist(), found.needed.tolist(),
        found.shortfalls.tolist(), found.forces.tolist(), strict=True,
    )  # fmt: skip
    for wanted, largest, needed, shortfall, forces in columns:
        writer.writerow([*wanted, largest, needed, shortfall, *forces])
    return out.getvalue()


def show(name: str, found: "ForcesAlong", lines: Sequence[int]) -> None:
    """Write the forces for many wrenches for people."""
    from swarmgrasp.cli.report import NOTES, Forces, Report

    report, swarm = Report(), found.swarm
    sizes = [size_of(swarm, wanted) for wanted in found.wanted]
    unit = Forces.for_size(*sizes)
    missed = [i for i, is_degraded in enumerate(found.is_degraded) if is_degraded]
    many = f"{len(found)} wrench{'es' if len(found) > 1 else ''}"
    if missed:
        report.headline(f"{name}: {many}, {len(missed)} out of reach", "caution")
    else:
        top = share(float(found.largest_shares.max(initial=0.0)))
        report.headline(f"{name}: {many}, all made, with shares up to {top}", "good")
    report.blank()
    report.facts(_facts(found, lines, missed, unit))
    _show_robots(report, found, lines)
    _show_wrenches(report, found, lines, unit)
    report.blank()
    report.note(f"Metric: {swarm.metric_sentence}.")
    report.note("Share: a robot's force as a part of its limit.")
    for note in NOTES:
        report.note(note)


def _facts(
    found: "ForcesAlong", lines: Sequence[int], missed: Sequence[int], unit: "Unit"
) -> list[tuple[str, str]]:
    """Tell which wrench is hardest, and which are out of reach."""
    facts = []
    if found.load.any():
        facts.append(("Load", f"{wrench_text(found.swarm, found.load, unit)}, by the environment"))
    if missed:
        worst = int(found.shortfalls.argmax())
        short = unit.text(float(found.shortfalls[worst]))
        facts.append(("Out of reach", f"{_ranges([lines[i] for i in missed])} of the table"))
        facts.append(("Worst", f"line {lines[worst]}, short by {short} in the metric"))
        return facts
    largest = int(found.largest_shares.argmax())
    top = share(float(found.largest_shares[largest]))
    facts.append(("Largest share", f"{top}, at line {lines[largest]} of the table"))
    return facts


def _ranges(lines: Sequence[int]) -> str:
    """Tell line numbers, which ascend, as ranges.

    Examples
    --------
    >>> _ranges([2]), _ranges([2, 4, 5, 6])
    ('line 2', 'lines 2, 4 to 6')
    """
    runs: list[list[int]] = []
    for line in lines:
        if runs and line == runs[-1][-1] + 1:
            runs[-1][1:] = [line]
        else:
            runs.append([line])
    told = [" to ".join(map(str, run)) for run in runs[:MOST_TOLD]]
    more = " and more" if len(runs) > MOST_TOLD else ""
    return f"line{'s' if len(lines) > 1 else ''} {', '.join(told)}{more}"


def _show_robots(report: "Report", found: "ForcesAlong", lines: Sequence[int]) -> None:
    """Write the table of what each robot does at most."""
    swarm = found.swarm
    if not len(swarm):
        return
    from swarmgrasp.cli.report import Column, Forces

    unit = Forces.for_size(*swarm.limits.tolist())
    columns = [
        Column("robot"),
        *(Column(text, is_number=True) for text in (
            f"largest force [{unit.name}]", "share", "at line", "mean share",
        )),
    ]  # fmt: skip
    rows = []
    for i in range(len(swarm)):
        shares = found.shares[:, i]
        hardest = int(shares.argmax())
        is_idle = shares[hardest] <= IDLE
        force = 0.0 if is_idle else float(found.forces[hardest, i])
        rows.append([
            swarm.names[i], unit.number(force), share(float(shares[hardest])),
            "" if is_idle else str(lines[hardest]), share(float(shares.mean())),
        ])  # fmt: skip
    report.blank()
    report.table(columns, rows)


def _show_wrenches(
    report: "Report", found: "ForcesAlong", lines: Sequence[int], unit: "Unit"
) -> None:
    """Write the table of the wrenches, or of the hardest."""
    import numpy as np

    from swarmgrasp.cli.report import Column

    swarm, torques = found.swarm, f"tz [{unit.name} m]"
    columns = [
        Column(text, is_number=True)
        for text in (
            "line", f"fx [{unit.name}]", f"fy [{unit.name}]", torques, "largest share",
            f"short by [{unit.name}]",
        )
    ]  # fmt: skip
    order = np.lexsort((-found.largest_shares, -found.shortfalls))[:MOST_TOLD]
    rows = []
    for i in sorted(order.tolist()):
        size = size_of(swarm, found.wanted[i])
        wholes = (size, size, size * swarm.characteristic_length)
        parts = zip(found.wanted[i].tolist(), wholes, strict=True)
        numbers = [unit.number(0.0 if abs(v) < 1e-4 * whole else v) for v, whole in parts]
        short = float(found.shortfalls[i])
        largest = share(float(found.largest_shares[i]))
        rows.append([str(lines[i]), *numbers, largest, unit.number(short) if short else ""])
    report.blank()
    if len(rows) < len(found):
        report.headline(f"The {len(rows)} hardest wrenches (--csv writes the forces for all)")
    report.table(columns, rows)
