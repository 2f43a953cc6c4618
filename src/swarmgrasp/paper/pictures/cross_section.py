"""Fig. 8 and Fig. 9 in kind: brackets along a line of wrenches, and the sets above a level."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swarmgrasp.paper.pictures.axes import below, chart
from swarmgrasp.paper.studies.cross_section import Section
from swarmgrasp.plot import style

LEVELS = 12
"""Colours over the plane, about."""


def cross_section(found: Section) -> Figure:
    """Draw the quality along a line as the least of brackets, and over a plane as contours."""
    low, high = float(found.quality.min()), float(found.quality.max())
    with style.settings():
        figure, (line, plane) = chart(2, height=3.4)
        for k, row in enumerate(found.brackets):
            label = "" if k else "h(n) + max(0, n · b), one direction n each"
            line.plot(found.along, row, color=style.SKY, linewidth=0.9, label=label)
        line.plot(
            found.along, found.quality, color=style.INK, linewidth=2.0,
            label="their least: the quality Q(b)",
        )  # fmt: skip
        reached, level = found.along[found.reached], found.level
        line.axhline(level, color=style.VERMILION, linewidth=0.8)
        line.plot(
            reached[[0, -1]], [level, level], color=style.VERMILION, linewidth=4.0,
            solid_capstyle="butt", label="where it reaches a level: one interval",
        )  # fmt: skip
        margin = 0.12 * (high - low)
        line.set(xlabel="along a line of wrenches b", ylabel="quality [N]")
        line.set(xlim=(0.0, 1.0), ylim=(low - margin, high + 4.0 * margin))
        _draw_plane(figure, plane, found)
        below(figure, line, 1)
    return figure


def _draw_plane(figure: Figure, ax: Axes, found: Section) -> None:
    """Draw the contours of the quality over the plane, and the line in it."""
    values = found.plane.T
    side = np.linspace(0.0, 1.0, len(found.plane))
    image = ax.contourf(side, found.across, values, levels=LEVELS, cmap="cividis")
    ax.contour(
        side, found.across, values, levels=[found.level], colors=style.VERMILION, linewidths=1.6
    )
    ax.axhline(0.5, color="white", linewidth=1.0, linestyle=(0, (3, 2)))
    ax.set(xlabel="along the same line (dashed)", ylabel="across it")
    bar = figure.colorbar(image, ax=ax, shrink=0.85)
    bar.set_label("quality [N]")
