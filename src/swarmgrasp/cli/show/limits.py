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
from swarmgrasp.words import digits, span

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
        more = ["", *(">" * bool(found.exceeds(each)[i]) for each in (found.steady, gusty))]
        less = "<" * bool(more[2])
        told = [
            f"{sign}{digits(v / scale, v / scale, 4)}" for sign, v in zip(more, speeds, strict=True)
        ]
        shares = [
            f"{sign}{v / speeds[0]:.3f}" if speeds[0] else ""
            for sign, v in zip(more[1:], speeds[1:], strict=True)
        ]
        factor = f"{less}{(speeds[0] / speeds[2]) ** 2:.2f}" if speeds[2] else ""
        rows.append([bare(found.bearings[i], tell), *told, *shares, factor])
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
    word = "gusts" if found.simulation.weather.gusts != "none" else "a steady wind, noisy sensors"
    steady, more = (_shares(found, speeds) for speeds in (found.steady, gusty))
    short = ""
    if found.exceeds(found.steady).any() or found.exceeds(gusty).any():
        short = f"; {span(found.simulation.duration)} are too short to tell them all"
    return (
        f"simulated, {steady} of the static limits are held in a steady wind, {more} in "
        f"{word}{short}"
    )


def _shares(found: Limits, speeds: NDArray[np.float64]) -> str:
    """Say between which parts of the static limits some are; above the most that was tried, more.

    Parameters
    ----------
    found : Limits
    speeds : (m,) [m/s]
    """
    shares, exceeds = speeds / found.static, found.exceeds(speeds)
    if exceeds.all():
        return f"more than {shares.min():.3f}"
    return f"{shares.min():.3f} to {'more than ' * bool(exceeds.any())}{shares.max():.3f}"
