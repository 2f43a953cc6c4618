"""How `swarmgrasp simulate --capability` tells its answer."""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.cli.show.all_round import bare, clockwise_note
from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.simulation.limits import Limits
from swarmgrasp.terms import Terms
from swarmgrasp.units import SPEEDS
from swarmgrasp.words import span

ROWS = 24
"""Bearings that are told at most."""


def show(name: str, found: Limits, terms: Terms) -> None:
    """Write the largest winds held for people."""
    report, tell = Report(), telling_of(terms, found.simulation.problem.swarm, [])
    gusty, static = found.gusty.min(axis=0), found.static
    known = static > 0.0
    report.headline(f"{name}: {_headline(found, gusty, known)}", "good" if known.all() else "bad")
    report.blank()
    unit, scale = terms.speed, SPEEDS[terms.speed]
    far = tell.length.short(found.within)
    columns = [
        Column("from [deg]", is_number=True),
        *(Column(f"{each} [{unit}]", is_number=True) for each in ("static", "steady", "gusty")),
        *(Column(each, is_number=True) for each in ("steady/static", "gusty/static")),
        Column("load factor", is_number=True),
    ]
    step = max(1, math.ceil(len(found.bearings) / ROWS))
    rows = []
    for i in range(0, len(found.bearings), step):
        speeds = [float(each[i]) for each in (static, found.steady, gusty)]
        shares = [f"{v / speeds[0]:.3f}" if speeds[0] else "" for v in speeds[1:]]
        factor = f"{(speeds[0] / speeds[2]) ** 2:.2f}" if speeds[2] else ""
        rows.append(
            [bare(found.bearings[i], tell), *(f"{v / scale:.4g}" for v in speeds), *shares, factor]
        )
    report.table(columns, rows, "bearings")
    report.blank()
    duration = found.simulation.duration
    weather = found.simulation.weather.gusts
    for note in (
        "Static: as `capability` tells, without allowance. Steady: in a simulated steady wind, "
        "with sensors that tell the truth.",
        f"Gusty: the mean wind held in {'gusts' if weather != 'none' else 'a steady wind'} with "
        "noisy sensors. Load factor: the load of the static limit over that of the gusty one.",
        f"Held: within {far} and {math.degrees(found.within_turn):.3g} deg for "
        f"{span(duration)}; short runs flatter. Limits are found to {100 * found.gap:.2g} %.",
        clockwise_note(tell),
    ):
        report.note(note)


def _headline(found: Limits, gusty: NDArray[np.float64], known: NDArray[np.bool_]) -> str:
    """Say how far what is simulated is from what statics says."""
    if not known.all():
        return "statics holds no wind from every bearing"
    steady = found.steady / found.static
    shares = gusty / found.static
    word = "gusts" if found.simulation.weather.gusts != "none" else "a steady wind, noisy sensors"
    return (
        f"simulated, {steady.min():.3f} to {steady.max():.3f} of the static limits are held in a "
        f"steady wind, {shares.min():.3f} to {shares.max():.3f} in {word}"
    )
