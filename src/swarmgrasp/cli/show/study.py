"""How `swarmgrasp study` tells what was found."""

import math
from pathlib import Path

from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.simulation.study import Findings, Gathered
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms

FIGURES = 4
"""Digits of the largest force that are shown."""


def show(folder: Path, found: Gathered, terms: Terms) -> None:
    """Write what was found for people."""
    report, plan, findings = Report(), found.plan, found.findings
    report.headline(f"{plan.name}: {findings.headline}")
    report.blank()
    columns, rows = cells(findings, terms)
    report.table(columns, rows, "findings")
    report.blank()
    report.facts(
        [
            ("Runs", _runs(found)),
            ("of", plan.study.words(terms)),
            *(("Fault", fault) for fault in found.faults),
            ("Rows", f"{folder}/part-*.parquet, digest {found.digest}"),
            ("Seed", str(plan.seed)),
        ]
    )


def cells(findings: Findings, terms: Terms) -> tuple[list[Column], list[list[str]]]:
    """Return what was found as a table: forces in one unit, shares in percent."""
    headings, rows = findings.headings, findings.rows
    forces = [
        value
        for row in rows
        for heading, value in zip(headings, row, strict=True)
        if heading.unit == "N" and math.isfinite(value)
    ]
    largest = max(forces, default=0.0)
    tell = Telling.of(terms, 1.0, [largest])
    unit = tell.force
    decimals = FIGURES - len(f"{largest / unit.newtons:.0f}")
    named = {"N": unit.name, "m": terms.length}
    columns = [
        Column(f"{h.words} [{named.get(h.unit, h.unit)}]" if h.unit else h.words, is_number=True)
        for h in headings
    ]
    told = [
        [
            _cell(value, h.unit, tell, max(decimals, 0))
            for h, value in zip(headings, row, strict=True)
        ]
        for row in rows
    ]
    return columns, told


def _cell(value: float, unit: str, tell: Telling, decimals: int) -> str:
    """Return a number as the table has it.

    Examples
    --------
    >>> from swarmgrasp.terms import SI
    >>> kilo = Telling.of(SI, 1.0, [2000.0])
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
        return f"{value / tell.force.newtons:.{decimals}f}"
    if unit == "m":
        return f"{value / tell.length.metres:.2f}"
    return str(value) if isinstance(value, int) else f"{value:.2f}"


def _runs(found: Gathered) -> str:
    """Say how many runs there are."""
    all_of = "" if found.is_whole else f" of {found.plan.runs}; go on to do the others"
    failed = f", {found.failed} failed" if found.failed else ""
    return f"{found.runs}{all_of}{failed}"
