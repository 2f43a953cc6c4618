"""The capability diagram, as for dynamic positioning: the wind held at every bearing."""

import itertools
import math
from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from swarmgrasp.capability import Capability
from swarmgrasp.environment import KNOT, beaufort, vessel_type
from swarmgrasp.plot import polar, style
from swarmgrasp.plot.arrows import Arrows, draw_arrows, has_area
from swarmgrasp.plot.labels import Page

Vector = NDArray[np.float64]

MOST_AVOIDED: Final = 40
"""With more robots than this, labels do not keep clear of their arrows, which are thinner."""

COLUMNS: Final = (0.5, 1.66, 2.38, 2.98, 3.56, 4.02)
"""Where the columns of the caption's table begin [in]."""

LONGEST_NAME: Final = 20
"""Letters of the robots lost that fit into the table."""

HULL: Final = 0.56
"""Length of the hull's silhouette over the outer ring's radius."""

BELOW: Final = 1.21
"""Height of the caption [in]."""

INTACT: Final[dict[str, Any]] = {"color": style.BLUE, "linewidth": 1.8, "linestyle": "-"}
AFTER_LOSS: Final[dict[str, Any]] = {
    "color": style.VERMILION,
    "linewidth": 1.5,
    "linestyle": (0, (4, 2)),
}


def capability_diagram(found: Capability, title: str = "", *, ax: Axes | None = None) -> Figure:
    """Draw a capability as a polar diagram, bow up, bearings clockwise.

    The radius is the largest wind from that bearing that the robots hold beside the current:
    all of them (solid), and those left after the worst loss (dashed). In the middle lies the
    object, its robots' forces as arrows.

    Parameters
    ----------
    found : Capability
    title : str
        Such as the vessel's name.
    ax : Axes, optional
        Draw here, at its present size, instead of in a figure of its own; then without caption.

    Returns
    -------
    Figure
    """
    with style.settings():
        alone = ax is None
        ax = polar.new_axes(BELOW) if ax is None else ax
        step, top = polar.rings(float(found.intact.max()))
        page = polar.frame(ax, top)
        polar.draw_rings(page, step, top)
        _draw_hull(page, found, top)
        _draw_envelopes(page, found, top)
        polar.label_rings(page, step, top)
        _label_envelopes(page, found, top)
        if alone:
            _write_caption(ax, found, title)
        return cast(Figure, ax.get_figure(root=True))


def _draw_hull(page: Page, found: Capability, top: float) -> None:
    """Draw the object in the middle, bow up, with the robots' forces."""
    ax, swarm = page.ax, found.swarm
    outline = swarm.outline
    low, high = outline.vertices.min(axis=0), outline.vertices.max(axis=0)
    scale = HULL * top / float((high - low).max())

    def placed(points: Vector) -> Vector:
        """Turn points (m, 2) [m, m] by a quarter and shrink them."""
        x, y = (np.reshape(points, (-1, 2)) - 0.5 * (low + high)).T * scale
        return np.column_stack([-y, x])

    ax.fill(
        *placed(outline.vertices).T, facecolor=style.PALE, edgecolor=style.INK, linewidth=0.8,
        zorder=3, gid="hull",
    )  # fmt: skip
    arrows = Arrows(outline, swarm.robots)
    lost = set(found.worst_losses[found.worst_after_loss])
    many = len(swarm) > MOST_AVOIDED
    for gone, colour, gid in ((False, style.INK, "robot"), (True, style.VERMILION, "lost")):
        chosen = [r for r in swarm if ((r.group or r.name) in lost) == gone]
        ends = [(*placed(np.array(shaft)),) for r in chosen for shaft in arrows.shafts(r)]
        draw_arrows(ax, ends, color=colour, width=0.008 if many else 0.014, gid=gid)
        areas = [placed(area) for r in chosen if has_area(r) for area in arrows.areas(r)]
        shade: dict[str, Any] = {"facecolor": to_rgba(colour, 0.1), "edgecolor": colour}
        ax.add_collection(
            PolyCollection(areas, **shade, linewidth=0.6, zorder=3.5, gid=f"{gid}-area")
        )
        for tail, tip in () if many else ends:
            page.keep_clear(tail, tip)
    corners = placed(np.vstack([outline.vertices, outline.vertices[:1]]))
    for start, end in itertools.pairwise(corners):
        page.keep_clear(start, end)


def _draw_envelopes(page: Page, found: Capability, top: float) -> None:
    """Draw what is held by all robots, and after the worst loss."""
    ax = page.ax
    intact, after = (
        polar.envelope(found.bearings, v, top) for v in (found.intact, found.after_loss)
    )
    for line in (intact, after):
        ax.fill(*line.T, facecolor=style.SKY, alpha=0.14, linewidth=0.0, zorder=2)
    ax.plot(*intact.T, **INTACT, solid_joinstyle="round", zorder=5, gid="intact")
    ax.plot(*after.T, **AFTER_LOSS, zorder=5, gid="after-loss")
    for line in (intact, after):
        for start, end in itertools.pairwise(line[:: polar.FINE]):
            page.keep_clear(start, end)
    for index, line, look in (
        (found.worst, found.intact, INTACT), (found.worst_after_loss, found.after_loss, AFTER_LOSS)
    ):  # fmt: skip
        spot = polar.points(found.bearings[[index]], np.minimum(line[[index]] / KNOT, top))
        ax.plot(
            *spot.T, "o", markersize=4.5, color=look["color"], markeredgecolor="white",
            markeredgewidth=0.6, zorder=6, gid="worst",
        )  # fmt: skip


def _label_envelopes(page: Page, found: Capability, top: float) -> None:
    """Name both envelopes beside their lines."""
    less = found.less_by if found.failures else f"loss of {found.loss_words()}"
    for text, speeds, look, side in (
        ("all robots", found.intact, INTACT, 0.0),
        (f"after the worst\n{less}", found.after_loss, AFTER_LOSS, math.pi),
    ):
        text = text if speeds.any() else f"no wind held\n{text}"
        line = polar.envelope(found.bearings, speeds, top)[:-1]
        is_cut = np.hypot(*line.T) > top * (1.0 - 1e-9)
        chosen = line if is_cut.all() else line[~is_cut]
        spots = chosen[:: max(1, len(chosen) // 12)]
        ways = np.arctan2(spots[:, 1], spots[:, 0]) + side
        page.label(
            text, spots, ways, fontsize=8.0, color=look["color"], gid="envelope",
            path_effects=[withStroke(linewidth=2.0, foreground="white")],
        )  # fmt: skip


def _write_caption(ax: Axes, found: Capability, title: str) -> None:
    """Write the title above, and below what the lines are and what was taken into account."""
    figure = cast(Figure, ax.get_figure(root=True))
    top = figure.get_size_inches()[1] - 0.22
    polar.write(
        figure,
        polar.cut(title, polar.LONGEST_TITLE) or "Capability",
        0.12,
        top,
        size=10.0,
        weight="bold",
    )
    said = "The largest wind held, by where it comes from, clockwise from the bow"
    polar.write(figure, said, 0.12, top - 0.17, size=9.0, color=style.GREY)
    y = _write_table(figure, found, BELOW - 0.14) - 0.05
    for text in _small_print(found):
        y -= 0.15
        polar.write(figure, text, 0.12, y, size=7.0, color=style.GREY)


def _write_table(figure: Figure, found: Capability, y: float) -> float:
    """Write the least winds held, from a height [in] of the page down; return where it ends."""
    width, height = figure.get_size_inches()
    lost = found.lost_words(found.worst_after_loss, most=1)
    headings = ("", "least wind held", "", "Beaufort", "from", "lost")
    for x, text in zip(COLUMNS, headings, strict=True):
        polar.write(figure, text, x, y, size=7.0, color=style.GREY)
    for look, *cells in (
        (INTACT, "all robots", *_least(found, found.intact, found.worst), ""),
        (
            AFTER_LOSS, "worst failure" if found.failures else f"worst loss of {found.losing}",
            *_least(found, found.after_loss, found.worst_after_loss), polar.cut(lost, LONGEST_NAME),
        ),
    ):  # fmt: skip
        y -= 0.17
        ends = [0.12 / width, 0.42 / width], [(y + 0.035) / height] * 2
        figure.add_artist(Line2D(*ends, transform=figure.transFigure, **look))
        for x, text in zip(COLUMNS, cells, strict=True):
            polar.write(figure, text, x, y, size=8.0)
    return y


def _least(found: Capability, speeds: Vector, index: int) -> tuple[str, str, str, str]:
    """Write the least of some speeds [m/s]: in knots, in m/s, as Beaufort, and its bearing."""
    speed = float(speeds[index])
    bearing = f"{math.degrees(found.bearings[index]) % 360.0:.4g}°"
    if speed == 0.0:
        return ("none", "", "", bearing if speeds.any() else "any")
    knots = f"{speed / KNOT:.3g} kn" if speed < polar.MOST_SHOWN * KNOT else "over 100 kn"
    return (knots, f"{speed:.3g} m/s", f"{beaufort(speed)}", bearing)


def _small_print(found: Capability) -> list[str]:
    """Say what was taken into account."""
    wind, current = found.environment.wind, found.environment.current
    vessel = vessel_type(wind.coefficients)
    drag = f"Blendermann (1994), {vessel}" if vessel else "Blendermann (1994), own coefficients"
    areas = (
        f"{style.number(wind.frontal_area)} m² ahead, {style.number(wind.lateral_area)} m² abeam"
    )
    water = "Still water"
    if current is not None and current.speed > 0.0:
        way = "with the wind"
        if current.bearing is not None:
            way = f"from {math.degrees(current.bearing) % 360.0:.4g}°"
        knots, metres = style.number(current.speed / KNOT), style.number(current.speed)
        water = f"Current {knots} kn ({metres} m/s) {way}"
    factor = found.environment.dynamic_factor
    allowance = f"loads times {factor:g}" if factor != 1.0 else "steady loads"
    poses = "; worst poses" if found.worst_case else ""
    return [
        f"Wind drag: {drag}; {areas}.",
        f"{water}; {allowance}{poses}.",
        _sea_words(found),
    ]


def _sea_words(found: Capability) -> str:
    """Say what of waves was taken into account."""
    waves = found.environment.waves
    if waves is None:
        return "No waves."
    way = "with the wind"
    if waves.bearing is not None:
        way = f"from {math.degrees(waves.bearing) % 360.0:.4g}°"
    if waves.height is None or waves.period is None:
        return f"Mean drift of the sea that goes with the wind (steps of DNV-ST-0111), {way}."
    sea = f"{style.number(waves.height)} m, {style.number(waves.period)} s"
    return f"Mean drift of a given sea, {sea}, {way}."
