"""The sensitivities of a quality: for `swarmgrasp quality --sensitivities`."""

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.cli.show.change import unit_of
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.quality import Sensitivities
from swarmgrasp.telling import Telling
from swarmgrasp.words import digits, list_words

WAYS = ("-", "+")
TURNED = ("along", "to", "start", "end")
"""Columns of what goes clockwise, or the other way."""


def show_sensitivities(report: Report, found: Sensitivities, tell: Telling) -> None:
    """Write the table of what the quality gains when one robot changes and the others stay.

    Parameters
    ----------
    report : Report
    found : Sensitivities
    tell : Telling
    """
    swarm, is_force = found.swarm, found.quality.criterion.task is None
    if not len(swarm):
        return
    unit, limits, length = unit_of(found.quality.criterion, tell), tell.force, tell.length
    of = unit.name if is_force else "1"
    kinds = [
        ("along", f"{of}/{length.name}", found.contact * length.metres / unit.newtons),
        ("to", f"{of}/deg", found.direction_per_degree / unit.newtons),
        ("limit", f"{of}/{limits.name}", found.limit * limits.newtons / unit.newtons),
        ("astern", f"{of}/{limits.name}", found.reverse_limit * limits.newtons / unit.newtons),
        ("start", f"{of}/deg", np.radians(found.start) / unit.newtons),
        ("end", f"{of}/deg", np.radians(found.end) / unit.newtons),
    ]
    kinds = [kind for kind in kinds if not np.isnan(kind[2]).all()]
    columns, cells = [Column(tell.terms.robot)], [list(swarm.names)]
    for name, per, slopes in kinds:
        columns += [Column(f"{name} {way} [{per}]", is_number=True) for way in WAYS]
        cells += _columns(slopes)
    report.blank()
    per = f"{length.name}, degree or {limits.name} of one {tell.terms.robot}"
    report.headline(f"What the quality gains per {per}")
    report.table(columns, list(zip(*cells, strict=True)), "sensitivities")
    if found.is_ridge:
        report.sentence(
            f"{len(found.weakest)} directions are equally weak: it may fall whichever way "
            f"a {tell.terms.robot} goes."
        )
    names = [name for name, _, _ in kinds]
    turned = [name for name in names if name in TURNED]
    sized = [name for name in names if name not in TURNED]
    report.note(
        f"{list_words(turned).capitalize()}: - clockwise, + counter-clockwise; "
        f"{list_words(sized)}: - weaker, + stronger."
    )
    if "start" in names:
        report.note("Start and end: the ends of what a robot steers, counter-clockwise.")


def _columns(slopes: NDArray[np.float64]) -> list[list[str]]:
    """Write slopes (n, 2) as two columns, with the decimals that give the largest four digits."""
    largest = float(np.nanmax(np.abs(slopes), initial=0.0))
    return [
        ["" if np.isnan(slope) else digits(float(slope), largest, 4) for slope in column]
        for column in slopes.T
    ]
