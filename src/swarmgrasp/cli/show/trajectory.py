"""How `swarmgrasp forces --wrenches` tells the forces for many wrenches."""

import csv as tables
import io
from collections.abc import Sequence

import numpy as np

from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.forces import IDLE, share, share_words, size_of, wrench_text
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.forces import ForcesAlong
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms

MOST_TOLD = 20
"""Wrenches of a table that are listed."""


def table_text(found: ForcesAlong, terms: Terms) -> str:
    """Return the forces as a table: what was wanted, how well it is made, and who does what.

    Directions follow where robots can push more than one way. It can be asked for again.
    """
    out = io.StringIO(newline="")
    writer = tables.writer(out, lineterminator="\n")
    tell = Telling.of(terms, found.swarm.outline.extent, found.forces.max(axis=0).tolist())
    unit = tell.force
    robots = [f"{name} [{unit.name}]" for name in found.swarm.names]
    told = found.forces / unit.newtons
    if not found.swarm.has_rays_only:
        ways = [[float(tell.degrees(way)) for way in row] for row in found.directions.tolist()]
        robots += [f"{name} [deg]" for name in found.swarm.names]
        told = np.hstack([told, ways])
    wanted = terms.frame.wrench_to_file(found.wanted) / unit.newtons / [1.0, 1.0, unit.metres]
    writer.writerow([
        f"fx [{unit.name}]", f"fy [{unit.name}]", f"tz [{unit.torque}]", "largest_share",
        "needed", f"shortfall [{unit.name}]", *robots,
    ])  # fmt: skip
    columns = zip(
        wanted.tolist(), found.largest_shares.tolist(), found.needed.tolist(),
        (found.shortfalls / unit.newtons).tolist(), told.tolist(), strict=True,
    )  # fmt: skip
    for wanted, largest, needed, shortfall, forces in columns:
        writer.writerow([*wanted, largest, needed, shortfall, *forces])
    return out.getvalue()


def show(name: str, found: ForcesAlong, lines: Sequence[int], terms: Terms) -> None:
    """Write the forces for many wrenches for people."""
    report, swarm = Report(), found.swarm
    sizes = [size_of(swarm, wanted) for wanted in found.wanted]
    tell = telling_of(terms, swarm, sizes)
    missed = [i for i, is_degraded in enumerate(found.is_degraded) if is_degraded]
    many = f"{len(found)} wrench{'es' if len(found) > 1 else ''}"
    if missed:
        report.headline(f"{name}: {many}, {len(missed)} out of reach", "caution")
    else:
        top = share(float(found.largest_shares.max(initial=0.0)))
        report.headline(f"{name}: {many}, all made, with shares up to {top}", "good")
    report.blank()
    report.facts(_facts(found, lines, missed, tell))
    _show_robots(report, found, lines, tell)
    _show_wrenches(report, found, lines, tell)
    report.small_print(swarm, tell, share_words(swarm, terms))


def _facts(
    found: ForcesAlong, lines: Sequence[int], missed: Sequence[int], tell: Telling
) -> list[tuple[str, str]]:
    """Tell which wrench is hardest, and which are out of reach."""
    facts = []
    if found.load.any():
        facts.append(("Load", f"{wrench_text(found.swarm, found.load, tell)}, on the object"))
    if missed:
        worst = int(found.shortfalls.argmax())
        short = tell.force.text(float(found.shortfalls[worst]))
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


def _show_robots(report: Report, found: ForcesAlong, lines: Sequence[int], tell: Telling) -> None:
    """Write the table of what each robot does at most."""
    swarm, unit = found.swarm, tell.force
    if not len(swarm):
        return
    columns = [
        Column(tell.terms.robot),
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
    report.table(columns, rows, "robots")


def _show_wrenches(report: Report, found: ForcesAlong, lines: Sequence[int], tell: Telling) -> None:
    """Write the table of the wrenches, or of the hardest."""
    swarm, unit, torques = found.swarm, tell.force, f"tz [{tell.force.torque}]"
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
        parts = tell.wrench(found.wanted[i].tolist(), swarm.characteristic_length)
        numbers = [part.split()[0] for part in parts]
        short = float(found.shortfalls[i])
        largest = share(float(found.largest_shares[i]))
        rows.append([str(lines[i]), *numbers, largest, unit.number(short) if short else ""])
    report.blank()
    if len(rows) < len(found):
        report.headline(f"The {len(rows)} hardest wrenches (--csv writes the forces for all)")
    report.table(columns, rows, "wrenches")
