"""What diagrams of weather from all round share: the object in the middle, curves, their names."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from swarmgrasp.capability import AllRound
from swarmgrasp.environment import Environment, WindTable, vessel_type
from swarmgrasp.plot import polar, style, written
from swarmgrasp.plot.arrows import Arrows, draw_arrows, has_area
from swarmgrasp.plot.labels import Page
from swarmgrasp.units import LENGTHS

Vector = NDArray[np.float64]

MOST_AVOIDED: Final = 40
"""With more robots than this, labels do not keep clear of their arrows, which are thinner."""
HULL: Final = 0.56
"""Length of the hull's silhouette over the outer ring's radius."""
COLUMNS: Final = (0.5, 1.66, 2.38, 2.98, 3.56, 4.02)
"""Where the columns of the caption's table begin [in]."""
LONGEST_NAME: Final = 20
"""Letters of the robots lost that fit into the table."""

INTACT: Final[dict[str, Any]] = {"color": style.BLUE, "linewidth": 1.8, "linestyle": "-"}
AFTER_LOSS: Final[dict[str, Any]] = {
    "color": style.VERMILION,
    "linewidth": 1.5,
    "linestyle": (0, (4, 2)),
}


@dataclass(frozen=True)
class Curve:
    """One curve of a diagram.

    Attributes
    ----------
    radii : (m,)
        At the bearings, in units of the rings.
    look : dict
        Of the line.
    gid : str
    name : str
        Written beside it.
    inside : bool
        Whether the name goes inside.
    """

    radii: Vector
    look: dict[str, Any]
    gid: str
    name: str
    inside: bool = False


def draw_hull(page: Page, found: AllRound, top: float, newcomer: str = "") -> None:
    """Draw the object in the middle, bow up, with the robots' forces; who is lost at worst, apart.

    Parameters
    ----------
    page : Page
    found : AllRound
    top : float
        Radius of the outer ring.
    newcomer : str
        Name of a robot that stands out as one that joins.
    """
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
    kinds = {r.name: "lost" if (r.group or r.name) in lost else "robot" for r in swarm}
    if newcomer:
        kinds[newcomer] = "newcomer"
    taken: list[Vector] = []
    colours = {"robot": style.INK, "lost": style.VERMILION, "newcomer": style.GREEN}
    for gid, colour in colours.items():
        chosen = [r for r in swarm if kinds[r.name] == gid]
        ends = [(*placed(np.array(shaft)),) for r in chosen for shaft in arrows.shafts(r)]
        draw_arrows(ax, ends, color=colour, width=0.008 if many else 0.014, gid=gid)
        areas = [placed(area) for r in chosen if has_area(r) for area in arrows.areas(r)]
        shade: dict[str, Any] = {"facecolor": to_rgba(colour, 0.1), "edgecolor": colour}
        ax.add_collection(
            PolyCollection(areas, **shade, linewidth=0.6, zorder=3.5, gid=f"{gid}-area")
        )
        taken += [] if many else [*map(np.array, ends), *areas]
    corners = placed(np.vstack([outline.vertices, outline.vertices[:1]]))
    taken += [share * corners for share in (1.0, 0.75, 0.5, 0.25)]  # and what it hides
    broken = [np.vstack([line, np.full((1, 2), np.nan)]) for line in taken]
    page.keep_clear_of(np.vstack(broken))


def draw_curve(page: Page, bearings: Vector, curve: Curve, top: float, *, fill: bool) -> None:
    """Draw a curve, and nothing where it is cut at the radius `top`; mark its least point."""
    line = polar.closed(bearings, curve.radii, top)
    if fill:
        page.ax.fill(*line.T, facecolor=style.SKY, alpha=0.14, linewidth=0.0, zorder=2)
    shown = polar.within(line, top)
    page.ax.plot(*shown.T, **curve.look, solid_joinstyle="round", zorder=5, gid=curve.gid)
    page.keep_clear_of(shown)


def mark(page: Page, bearing: float, radius: float, colour: str) -> None:
    """Mark where the least is held."""
    spot = polar.points(np.array([bearing]), np.array([radius]))
    page.ax.plot(
        *spot.T, "o", markersize=4.5, color=colour, markeredgecolor="white", markeredgewidth=0.6,
        zorder=6, gid="worst",
    )  # fmt: skip
    page.keep_clear(spot[0], spot[0], 8.0)


def name_curve(page: Page, bearings: Vector, curve: Curve, top: float) -> None:
    """Write the name of a curve beside it, where it is not cut; nothing if it is all round."""
    shown = polar.within(polar.closed(bearings, curve.radii, top)[:-1], top)
    chosen = shown[np.isfinite(shown).all(axis=1)]
    if not len(chosen):
        return
    spots = chosen[:: max(1, len(chosen) // 12)]
    ways = np.arctan2(spots[:, 1], spots[:, 0]) + math.pi * curve.inside
    page.label(
        curve.name, spots, ways, fontsize=8.0, color=curve.look["color"], gid="envelope",
        path_effects=[withStroke(linewidth=2.0, foreground="white")],
    )  # fmt: skip


def write_caption(
    ax: Axes, title: str, said: str, headings: Sequence[str],
    rows: Sequence[tuple[dict[str, Any], Sequence[str]]], small_print: Sequence[str],
) -> None:  # fmt: skip
    """Write a title and what is drawn above, a table of the curves and small print below.

    Parameters
    ----------
    ax : Axes
    title : str
    said : str
        What the radius is.
    headings : sequence of str
        Of the table's columns.
    rows : sequence of tuple
        The look of a curve, and its cells.
    small_print : sequence of str
    """
    figure = cast(Figure, ax.get_figure(root=True))
    height = figure.get_size_inches()[1]
    top = height - 0.22
    polar.write(
        figure, polar.cut(title, polar.LONGEST_TITLE) or "Capability", 0.12, top, size=10.0,
        weight="bold", gid="heading",
    )  # fmt: skip
    polar.write(figure, said, 0.12, top - 0.17, size=9.0, color=style.GREY, gid="title")
    y = below(len(rows), len(small_print)) - 0.14
    for x, text in zip(COLUMNS, headings, strict=True):
        polar.write(figure, text, x, y, size=7.0, color=style.GREY)
    for look, cells in rows:
        y -= 0.17
        ends = [polar.across(0.12), polar.across(0.42)], [(y + 0.035) / height] * 2
        figure.add_artist(Line2D(*ends, transform=figure.transFigure, **look))
        for x, text in zip(COLUMNS, cells, strict=True):
            polar.write(figure, text, x, y, size=8.0)
    y -= 0.05
    for text in small_print:
        y -= 0.15
        polar.write(figure, text, 0.12, y, size=7.0, color=style.GREY)


def below(rows: int, lines: int) -> float:
    """Return the height [in] of a caption with so many rows and lines of small print."""
    return 0.27 + 0.17 * rows + 0.15 * lines


def drag_words(environment: Environment) -> str:
    """Say by which coefficients and areas the wind loads the object."""
    wind = environment.wind
    if isinstance(wind, WindTable):
        return f"Wind drag: by a table of loads from {len(wind.bearings)} bearings."
    vessel = vessel_type(wind.coefficients)
    drag = f"Blendermann (1994), {vessel}" if vessel else "Blendermann (1994), own coefficients"
    name = style.terms().length
    ahead, abeam = (
        f"{written.number(area / LENGTHS[name] ** 2)} {name}²"
        for area in (wind.frontal_area, wind.lateral_area)
    )
    return f"Wind drag: {drag}; {ahead} ahead, {abeam} abeam."


def water_words(environment: Environment) -> str:
    """Say what current and what waves there are."""
    current, waves = environment.current, environment.waves
    said = "Still water"
    if current is not None and current.speed > 0.0:
        way = "with the wind" if current.bearing is None else written.from_words(current.bearing)
        said = f"Current {written.speed(current.speed)} {way}"
    if waves is None:
        return f"{said}; no waves"
    way = "" if waves.bearing is None else f" {written.from_words(waves.bearing)}"
    if waves.height is None or waves.period is None:
        return f"{said}; drift of the wind's sea (DNV-ST-0111){way}"
    sea = f"{written.length(waves.height)}, {written.number(waves.period)} s"
    return f"{said}; drift of a sea of {sea}{way}"


def degrees(bearing: float) -> str:
    """Return a bearing [rad], clockwise from the bow, in degrees as it is told."""
    return f"{written.telling().from_degrees(bearing):.4g}°"
