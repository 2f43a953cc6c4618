"""The largest winds held at every bearing: by statics, simulated steady, simulated in gusts."""

import math
from typing import Any, Final, cast

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from swarmgrasp.environment import KNOT
from swarmgrasp.plot import polar, style, written
from swarmgrasp.simulation.limits import Limits
from swarmgrasp.terms import SI, Terms
from swarmgrasp.words import span

Vector = NDArray[np.float64]

BELOW: Final = 0.92
"""Height of the caption [in]."""
HULL: Final = 0.42
"""Length of the object's silhouette over the outer ring's radius."""
LOOKS: Final[dict[str, dict[str, Any]]] = {
    "static": {"color": style.INK, "linewidth": 1.0, "linestyle": (0, (4, 2))},
    "steady": {"color": style.BLUE, "linewidth": 1.8},
    "gusty": {"color": style.VERMILION, "linewidth": 1.5},
}
"""How the curves are drawn, by their name in `Limits`."""


def limits_diagram(
    found: Limits, title: str = "", *, terms: Terms = SI, width: float = style.WIDTH
) -> Figure:
    """Draw the largest winds held as a polar diagram, bow up, bearings clockwise.

    Dashed what statics says, blue what is held in a simulated steady wind, and vermilion the mean
    wind that is held in the simulation's own weather, the least of its seeds.

    Parameters
    ----------
    found : Limits
    title : str
        Such as the object's name.
    terms : Terms
        The units and the frame in which it is told; bearings are true with a heading.
    width : float [in]

    Returns
    -------
    Figure
    """
    curves = {"static": found.static, "steady": found.steady, "gusty": found.gusty.min(axis=0)}
    with style.settings(width, terms):
        ax = polar.new_axes(BELOW)
        step, top = polar.rings(max(float(speeds.max()) for speeds in curves.values()))
        page = polar.frame(ax, top)
        polar.draw_rings(page, step, top)
        outline = found.simulation.problem.swarm.outline
        low, high = outline.vertices.min(axis=0), outline.vertices.max(axis=0)
        x, y = ((outline.vertices - 0.5 * (low + high)) * HULL * top / float((high - low).max())).T
        ax.fill(-y, x, facecolor=style.PALE, edgecolor=style.INK, linewidth=0.8, zorder=3)
        for name, speeds in curves.items():
            line = polar.envelope(found.bearings, speeds, top)
            ax.plot(
                *polar.within(line, top).T,
                **LOOKS[name],
                solid_joinstyle="round",
                zorder=5,
                gid=name,
            )
        polar.label_rings(page, step, top)
        figure = cast(Figure, ax.get_figure(root=True))
        _write_caption(figure, found, curves, title)
    return figure


def _write_caption(figure: Figure, found: Limits, curves: dict[str, Vector], title: str) -> None:
    """Write the title above, and below what the curves are and how far they part."""
    top = figure.get_size_inches()[1] - 0.22
    heading = polar.cut(title, polar.LONGEST_TITLE) or "Simulated capability"
    polar.write(figure, heading, 0.12, top, size=10.0, weight="bold", gid="heading")
    said = f"The largest wind held, by where it comes from, {polar.from_words()}"
    polar.write(figure, said, 0.12, top - 0.17, size=9.0, color=style.GREY, gid="title")
    height = figure.get_size_inches()[1]
    gusts = found.simulation.weather.gusts != "none"
    words = {
        "static": "by statics",
        "steady": "simulated, steady wind",
        "gusty": f"simulated, {'gusts, ' if gusts else ''}noisy sensors",
    }
    y = BELOW - 0.14
    for name, speeds in curves.items():
        ends = (
            [polar.across(0.12), polar.across(0.42)],
            [(y + 0.035) / height] * 2,
        )
        figure.add_artist(Line2D(*ends, transform=figure.transFigure, **LOOKS[name]))
        polar.write(figure, words[name], 0.5, y, size=8.0)
        polar.write(figure, _least(found, speeds), 2.6, y, size=8.0)
        y -= 0.17
    held = f"{written.length(found.within)} and {math.degrees(found.within_turn):.3g}°"
    said = f"Held within {held} for {span(found.simulation.duration)}; no waves."
    polar.write(figure, said, 0.12, y - 0.02, size=7.0, color=style.GREY)


def _least(found: Limits, speeds: Vector) -> str:
    """Say the least of some speeds [m/s], and their part of what statics says."""
    worst = float(speeds.min())
    told = f"{worst / KNOT:.3g} kn" if worst > 2.0 else f"{worst:.2g} m/s"
    if speeds is found.static or not found.static.all():
        return f"least {told}"
    shares = speeds / found.static
    more = "more than " if found.exceeds(speeds).any() else ""
    return f"least {told}; {shares.min():.2f} to {more}{shares.max():.2f} of statics"
