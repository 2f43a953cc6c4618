"""How `swarmgrasp study` tells what was found."""

import math
from pathlib import Path

from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.simulation.study import Findings, Gathered
from swarmgrasp.words import Unit

FIGURES = 4
"""Digits of the largest force that are shown."""


def show(folder: Path, found: Gathered) -> None:
    """Write what was found for people."""
    report, plan, findings = Report(), found.plan, found.findings
    report.headline(f"{plan.name}: {findings.headline}")
    report.blank()
    columns, rows = cells(findings)
    report.table(columns, rows, "findings")
    report.blank()
    report.facts(
        [
            ("Runs", _runs(found)),
            ("of", plan.study.words),
            *(("Fault", fault) for fault in found.faults),
            ("Rows", f"{folder}/part-*.parquet, digest {found.digest}"),
            ("Seed", str(plan.seed)),
        ]
    )


def cells(findings: Findings) -> tuple[list[Column], list[list[str]]]:
    """Return what was found as a table: forces in one unit, shares in percent."""
    headings, rows = findings.headings, findings.rows
    forces = [
        value
        for row in rows
        for heading, value in zip(headings, row, strict=True)
        if heading.unit == "N" and math.isfinite(value)
    ]
    largest = max(forces, default=0.0)
    unit = Unit.for_size(largest)
    decimals = FIGURES - len(f"{largest / unit.newtons:.0f}")
    named = {"N": unit.name}
    columns = [
        Column(f"{h.words} [{named.get(h.unit, h.unit)}]" if h.unit else h.words, is_number=True)
        for h in headings
    ]
    told = [
        [
            _cell(value, h.unit, unit, max(decimals, 0))
            for h, value in zip(headings, row, strict=True)
        ]
        for row in rows
    ]
    return columns, told


def _cell(value: float, unit: str, force: Unit, decimals: int) -> str:
    """Return a number as the table has it.

    Examples
    --------
    >>> kilo = Unit.for_size(2000.0)
    >>> [_cell(*cell, kilo, 2) for cell in ((0.1234, "%"), (1500.0, "N"), (7, ""))]
    ['12.3', '1.50', '7']
    >>> _cell(math.pi, "deg", kilo, 2)
    '180.00'
    >>> _cell(math.nan, "%", kilo, 2)
    '-'
    """
    if not math.isfinite(value):
        return "-"
    if unit == "%":
        return f"{100.0 * value:.1f}"
    if unit == "deg":
        return f"{math.degrees(value):.2f}"
    if unit == "N":
        return f"{value / force.newtons:.{decimals}f}"
    return str(value) if isinstance(value, int) else f"{value:.2f}"


def _runs(found: Gathered) -> str:
    """Say how many runs there are."""
    all_of = "" if found.is_whole else f" of {found.plan.runs}; go on to do the others"
    failed = f", {found.failed} failed" if found.failed else ""
    return f"{found.runs}{all_of}{failed}"
