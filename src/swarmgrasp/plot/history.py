"""The history of a run: errors, shares and what was out of reach, over time."""

import math
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swarmgrasp.environment import KNOT
from swarmgrasp.plot import style, written
from swarmgrasp.plot.coordinates import Scale
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.simulation.run import Run
from swarmgrasp.simulation.verdict import Verdict
from swarmgrasp.terms import SI, Terms
from swarmgrasp.units import LENGTHS
from swarmgrasp.words import time_unit

PANELS: Final = ("position", "heading", "shares", "shortfall", "wind")
SHORT: Final = {"lost": "lost", "left": "leaves", "sent": "sent", "joined": "joins"}
"""What happens to a robot, in a word."""
MARKED: Final = (*SHORT, "aim", "weather")
"""Kinds of happenings that are marked."""
LEFT: Final = 0.8
"""Of the panels [in]: numbers, and names beside them."""
HEIGHT: Final = 0.78
"""Of a panel [in]."""
ROWS: Final = 2
"""Of names above the panels."""
LETTER: Final = 0.65
"""Width of a letter over its size, with room."""
MOST_NAMED: Final = 10
"""Robots whose shares are told apart."""
LINES: Final = (
    style.BLUE, style.VERMILION, style.GREEN, style.ORANGE, style.PURPLE, style.SKY, style.INK,
    style.WINE, "#999933", style.GREY,
)  # fmt: skip


def history(
    run: Run, verdict: Verdict, *, index: int = 0, terms: Terms = SI, width: float = style.WIDTH
) -> Figure:
    """Draw errors of position and heading, shares, shortfall and wind over time, events marked.

    Parameters
    ----------
    run : Run
    verdict : Verdict
        Of the run.
    index : int
        Which of the runs.
    terms : Terms
        The units and the words in which it is told.
    width : float [in]

    Returns
    -------
    Figure
    """
    with style.settings(width, terms):
        total = HEIGHT * len(PANELS) + 1.0
        figure = Drawn(figsize=(style.width(), total))
        axes = panels(figure, 0.45 / total, 1.0 - 0.35 / total)
        draw_history(axes, run, verdict, index)
    return figure


def panels(figure: Figure, bottom: float, top: float) -> list[Axes]:
    """Return the axes of a history between two heights, as shares of the figure's."""
    left, right = LEFT / style.width(), 1.0 - 0.95 / style.width()
    step = (top - bottom) / len(PANELS)
    found: list[Axes] = []
    for row in range(len(PANELS)):
        low = top - (row + 1) * step
        share = found[0] if found else None
        found.append(figure.add_axes((left, low + 0.1 * step, right - left, 0.8 * step),
                                     sharex=share))  # fmt: skip
    return found


def draw_history(axes: list[Axes], run: Run, verdict: Verdict, index: int) -> None:
    """Draw the panels of a history."""
    position, heading, shares, shortfall, wind = axes
    times = run.times
    length = style.terms().length
    metres = LENGTHS[length]
    far = run.distances[index] / metres
    _draw_error(position, times, far, verdict.within / metres, f"off by\n[{length}]")
    turns, turn = np.degrees(run.turns[index]), math.degrees(verdict.within_turn)
    _draw_error(heading, times, turns, turn, "turned\nby [deg]")
    _draw_shares(shares, run, index)
    missing = run.shortfalls[index].astype(float)
    unit = written.unit_of(float(missing.max(initial=0.0)))
    missing /= unit.newtons
    shortfall.fill_between(times, 0.0, missing, color=style.VERMILION, linewidth=0.0)
    shortfall.set_ylabel(f"out of\nreach [{unit.name}]")
    shortfall.set_ylim(0.0, max(1.05 * float(missing.max(initial=0.0)), 1.0))
    speeds = np.hypot(*run.streams[index, :, :2].astype(float).T)
    scale, name = (KNOT, "kn") if speeds.max(initial=0.0) > 2.0 else (1.0, "m/s")
    wind.plot(times, speeds / scale, color=style.GREY, linewidth=0.7)
    wind.set_ylim(0.0, max(1.1 * float(speeds.max(initial=0.0)) / scale, 0.1))
    wind.set_ylabel(f"wind\n[{name}]")
    for ax in axes:
        _finish(ax, run, is_last=ax is wind)
    _mark(axes, run)


def _draw_error(ax: Axes, times: Any, errors: Any, limit: float, name: str) -> None:
    """Draw an error, and what it may be at most."""
    most = float(errors.max(initial=0.0))
    ax.plot(times, errors, color=style.INK, linewidth=0.9)
    if most > 0.3 * limit:
        ax.axhline(limit, color=style.VERMILION, linewidth=0.7, linestyle=(0, (4, 3)))
    ax.set_ylim(0.0, 1.1 * max(most, 1e-3 * limit))
    ax.set_ylabel(name)


def _draw_shares(ax: Axes, run: Run, index: int) -> None:
    """Draw what is asked of each robot, while it is there."""
    shares = run.shares[index].astype(float)
    there = np.zeros(shares.shape, bool)
    for stint in run.stints:
        now = (run.times >= stint.start) & (run.times <= stint.end)
        columns = np.array([run.names.index(name) for name in stint.swarm.names], dtype=int)
        there[now[:, None] & np.isin(np.arange(len(run.names)), columns)] = True
    shares[~there] = np.nan
    many = len(run.names) > MOST_NAMED
    for column, name in enumerate(run.names):
        colour = style.BLUE if many else LINES[column]
        dashes = "-" if many else style.DASHES[column % len(style.DASHES)]
        ax.plot(run.times, shares[:, column], color=colour, linewidth=0.8, linestyle=dashes,
                alpha=0.4 if many else 1.0, label=None if many else name)  # fmt: skip
    ax.set_ylim(0.0, 1.05)
    ax.set_ylabel("share of\nits limit")
    if not many:
        ax.legend(
            loc="center left",
            bbox_to_anchor=(1.0, 0.5),
            fontsize=style.text(7.0),
            handlelength=1.0,
            labelspacing=0.15,
            borderaxespad=0.4,
        )


def _finish(ax: Axes, run: Run, *, is_last: bool) -> None:
    """Give a panel its frame."""
    ax.set_xlim(0.0, max(float(run.times[-1]), 1e-9))
    ax.spines[["top", "right"]].set_visible(False)
    ax.grid(True, axis="y")
    ax.set_axisbelow(True)
    ax.locator_params(axis="y", nbins=4)
    ax.tick_params(length=3.0, labelsize=style.text(7.0), labelbottom=is_last)
    ax.yaxis.label.set_fontsize(style.text(7.5))
    ax.yaxis.set_label_coords(-0.42 / (ax.bbox.width / ax.get_figure(root=True).dpi), 0.5)  # type: ignore[union-attr]
    size, unit = time_unit(float(run.times[-1]))
    Scale(size).put_on(ax.xaxis, max(3, round(style.width() / 0.75)))
    if is_last:
        ax.set_xlabel(f"time [{unit}]", labelpad=2.0)


def _mark(axes: list[Axes], run: Run) -> None:
    """Mark what happened by a line through all panels, named above where there is room."""
    span = max(float(run.times[-1]), 1e-9)
    point = span / (axes[0].bbox.width * 72.0 / axes[0].get_figure(root=True).dpi)  # type: ignore[union-attr]
    size = style.text(7.0)
    taken = [-math.inf] * ROWS
    for at in run.happenings:
        if at.kind not in MARKED:
            continue
        for ax in axes:
            ax.axvline(at.time, color=style.GREY, linewidth=0.6, linestyle=(0, (1, 2)))
        name = f"{at.robot} {SHORT[at.kind]}" if at.kind in SHORT else f"new {at.kind}"
        is_late = at.time > 0.85 * span
        long = LETTER * size * len(name) * point
        start = at.time - long if is_late else at.time
        row = next((k for k, end in enumerate(taken) if end <= start), None)
        if row is None:
            continue  # its line is there, and the table has its name
        taken[row] = start + long
        axes[0].annotate(
            name, (at.time, 1.0), xycoords=("data", "axes fraction"),
            xytext=(0.0, 2.0 + 9.0 * row), textcoords="offset points", fontsize=size,
            ha="right" if is_late else "left", va="bottom", color=style.GREY,
        )  # fmt: skip
