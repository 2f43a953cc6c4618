"""The wrench sets before and after, and the largest ball or task inside: the quality in 3-D."""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Final, cast

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # type: ignore[import-untyped]
from mpl_toolkits.mplot3d.axes3d import Axes3D  # type: ignore[import-untyped]
from numpy.typing import NDArray

from swarmgrasp.plot import style, written
from swarmgrasp.plot.bodies import Body, body, split
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.plot.fit import fit
from swarmgrasp.plot.polygons import masked
from swarmgrasp.plot.sheet import Caption
from swarmgrasp.quality import Criterion
from swarmgrasp.quality.criterion import NOMINAL
from swarmgrasp.swarm import Swarm
from swarmgrasp.terms import SI, Terms
from swarmgrasp.words import Unit

ASIDE: Final = 38.0
"""How far the eye stands off the direction of the touching point [deg]: seen straight on,
ball and facet would hide one another."""

TILTS: Final = (18.0, 32.0)
"""Least and greatest elevation of the eye above or below the plane of forces [deg]."""

TURNS: Final = (25.0, 65.0)
"""Azimuth of the eye within its quadrant [deg]: no axis is seen end on."""

SIDES: Final = (0.03, 0.97)
"""Left and right end of the 3-D box and its labels, in shares of the figure."""

BOX: Final = 3.48
"""Height of the 3-D box and its labels [in]."""

LEGEND: Final = (0.17, 0.173)
PRINT: Final = (0.17, 0.132)
WORDS: Final = 0.2
"""Heights of legend and small print, without and for each line, and of the words [in]."""

TWO_COLUMNS: Final = 4.6
"""Width [in] from which on the legend has two columns."""

SOLID: Final = "#C9CDD2"
LOAD: Final[dict[str, Any]] = {"color": style.PURPLE, "linewidth": 2.0, "marker": "D"}
TASK: Final[dict[str, Any]] = {"color": style.BLUE, "linewidth": 2.4}
OUTLINE: Final[dict[str, Any]] = {"color": style.GREY, "linewidth": 0.6, "zorder": 2.25}
WIRES_SEEN: Final[dict[str, Any]] = {"linewidth": 0.9, "zorder": 3}
WIRES_HIDDEN: Final[dict[str, Any]] = {"linewidth": 0.5, "alpha": 0.35, "zorder": 1}


def wrench_sets(
    before: Swarm,
    after: Swarm | None = None,
    *,
    criterion: Criterion = NOMINAL,
    eye: tuple[float, float] | None = None,
    terms: Terms = SI,
    title: str = "",
    width: float = style.WIDTH,
) -> Figure:
    """Draw what a swarm can exert on the object, before and after a change.

    The axes are the metric's coordinates, force and torque over the characteristic
    length, so that the quality is the radius of a round ball: the largest about the
    origin that fits into the last of the two sets. The face it touches is the weakest.
    By a criterion the sets are those of the worst case, moved by the load, and a task takes
    the place of the ball, scaled by the quality.

    Parameters
    ----------
    before : Swarm
        Drawn solid.
    after : Swarm, optional
        Drawn as a wire frame, with the metric of `before`. When left out, and the criterion
        loses robots, has failures or takes the worst poses, the wire frame is that of `before`
        as it stands.
    criterion : Criterion
        What quality means.
    eye : tuple of float [deg, deg], optional
        Elevation and azimuth to look from; by default the touching point faces the eye.
    terms : Terms
        The units and the words in which it is told.
    title : str
        Such as the name of the object.
    width : float [in]

    Returns
    -------
    Figure

    Raises
    ------
    WrenchSetTooLarge
        If a set has too many faces to draw.
    """
    first = last = body(before, criterion)
    wires = None
    if after is not None:
        metric = before.characteristic_length, before.force_weights
        wires = last = body(Swarm(after.outline, after.robots, *metric), criterion)
    elif criterion.is_of_worst:
        wires = body(before, replace(criterion, losing=0, worst_case=False, failures=()))
    shapes = (first, last) if wires is None else (first, last, wires)
    with style.settings(width, terms):
        unit = written.unit_of(*(float(np.abs(s.vertices).max()) for s in shapes))
        factor = 1.0 / unit.newtons
        load = factor * np.array(criterion.load) * before.scale
        entries = _legend_entries(first, last, wires, criterion)
        words = criterion.words(before, terms.robot)
        caption = Caption(
            title, "", f"quality {words}" if words else "", tuple(entries),
            tuple(_small_print(before, criterion)),
        )  # fmt: skip
        figure, room = _new_figure(caption)
        ax = cast(
            Axes3D,
            figure.add_axes(
                (0.0, 0.0, 1.0, 1.0), projection="3d", computed_zorder=False, proj_type="ortho"
            ),
        )
        elevation, azimuth = _eye(last.weakest) if eye is None else eye
        ax.view_init(elevation, azimuth)
        ax.autoscale(enable=False)  # from data limits that matplotlib has not set yet
        towards = _towards(elevation, azimuth)
        colour = {"color": style.VERMILION if after is not None else style.BLUE}
        if wires is not None:
            _draw_wires(ax, wires, factor, towards, front=False, **colour)
        _draw_solids(ax, first, last, factor, towards)
        if not first.faces:
            _draw_wires(ax, first, factor, towards, front=True, color=style.GREY)
        if wires is not None:
            _draw_wires(ax, wires, factor, towards, front=True, **colour)
        _draw_facet(ax, last, factor)
        if criterion.has_load:
            arm = np.vstack([np.zeros(3), load])
            ax.plot(*arm.T, **LOAD, markersize=4.5, markevery=[1], zorder=5.5, gid="load")
        _set_axes(ax, shapes, unit, before)
        fit(figure, ax, room)
    return figure


def _eye(weakest: NDArray[np.float64]) -> tuple[float, float]:
    """Return elevation and azimuth [deg] that show the ball touch the weakest face."""
    height = math.degrees(math.asin(float(np.clip(weakest[2], -1.0, 1.0))))
    elevation = float(
        np.clip(height, *TILTS) if height > -30.0 else np.clip(height, -TILTS[1], -TILTS[0])
    )
    azimuth = math.degrees(math.atan2(weakest[1], weakest[0])) + ASIDE
    quadrant = 90.0 * math.floor(azimuth / 90.0)
    return elevation, quadrant + float(np.clip(azimuth - quadrant, *TURNS))


def _towards(elevation: float, azimuth: float) -> NDArray[np.float64]:
    """Return the unit vector (3,) from the origin to the eye; angles in degrees."""
    e, a = math.radians(elevation), math.radians(azimuth)
    return np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])


def _front(shape: Body, towards: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell which faces (f,) of a convex body can be seen."""
    return shape.normals @ towards > 0.0


def _shade(normals: NDArray[np.float64], towards: NDArray[np.float64], colour: str) -> Any:
    """Return the colours (f, 4) of faces lit from the eye's upper left."""
    light = towards + np.cross([0.0, 0.0, 1.0], towards) * -0.5 + np.array([0.0, 0.0, 0.5])
    shine = np.clip(normals @ (light / np.linalg.norm(light)), 0.0, 1.0)[:, None]
    base = np.array(mpl.colors.to_rgb(colour))
    rgb = base * (0.62 + 0.38 * shine) + 0.12 * shine
    return np.column_stack([np.clip(rgb, 0.0, 1.0), np.full(len(normals), 1.0)])


def _draw_solids(
    ax: Axes3D, first: Body, last: Body, factor: float, towards: NDArray[np.float64]
) -> None:
    """Draw the set before, the part of the ball inside it, and the part that stands out.

    Bodies are convex, so drawing the faces towards the eye in this order hides what a
    solid would hide; matplotlib's own sorting of faces by depth does not.
    """
    seen = _front(first, towards)
    faces = [first.vertices[list(f)] for f, s in zip(first.faces, seen, strict=True) if s]
    colours = _shade(first.normals[seen], towards, SOLID)
    colours[:, 3] = 0.5 if last.quality > 0.0 else 0.9
    _add(ax, faces, factor, colours, "none", zorder=2.2, gid="before", linewidths=0.0)
    _draw_lines(ax, first, _lines(first, towards, front=True), factor, **OUTLINE)
    if last.quality > 0.0:
        held = last.held
        seen = held.normals @ towards > (1e-9 if held.is_angular else -0.05)
        patches = [patch for patch, shown in zip(held.patches, seen, strict=True) if shown]
        colours = _shade(held.normals[seen], towards, style.SKY)
        gid = "ball" if held.is_ball else "task"
        for part, zorder in zip(split(patches, colours, first), (2.1, 2.3), strict=True):
            polygons, shades = [p for p, _ in part], [c for _, c in part]
            _add(ax, polygons, factor, shades, shades, zorder=zorder, gid=gid)
        rims = [patch[[*range(len(patch)), 0]] for patch in patches if held.is_angular]
        for rim in rims:
            ax.plot(*(factor * rim).T, color=style.BLUE, linewidth=0.8, zorder=2.4)
        if held.segment is not None:
            ax.plot(*(factor * held.segment).T, **TASK, zorder=4.5, gid=gid)


def _add(ax: Axes3D, polygons: Any, factor: float, colours: Any, edges: Any, **look: Any) -> None:
    """Add polygons [N] as one collection, with their own colours."""
    if len(polygons):
        scaled = factor * masked(polygons)
        shape: dict[str, Any] = {"linewidths": 0.5}
        ax.add_collection3d(
            Poly3DCollection(scaled, facecolors=colours, edgecolors=edges, **(shape | look))
        )


def _draw_wires(
    ax: Axes3D,
    shape: Body,
    factor: float,
    towards: NDArray[np.float64],
    *,
    front: bool,
    **look: Any,
) -> None:
    """Draw the edges that can be seen, or faintly those that cannot, as one broken line."""
    depth = WIRES_SEEN if front else WIRES_HIDDEN
    look = {"color": style.VERMILION, "gid": "wires"} | depth | look
    _draw_lines(ax, shape, _lines(shape, towards, front=front), factor, **look)


def _lines(shape: Body, towards: NDArray[np.float64], *, front: bool) -> list[tuple[int, int]]:
    """Return the edges that can be seen, with the outline if round, or those that cannot."""
    sides = {
        pair
        for face, shown in zip(shape.faces, _front(shape, towards), strict=True)
        if shown
        for pair in zip(face, face[1:] + face[:1], strict=True)
    }
    if not front:
        return [(a, b) for a, b in shape.edges if (a, b) not in sides and (b, a) not in sides]
    rim = {(min(a, b), max(a, b)) for a, b in sides if (b, a) not in sides}
    seen = {(a, b) for a, b in shape.edges if (a, b) in sides or (b, a) in sides}
    return sorted(seen | rim) if shape.faces else list(shape.edges)


def _draw_lines(
    ax: Axes3D, shape: Body, edges: list[tuple[int, int]], factor: float, **look: Any
) -> None:
    """Draw edges as one broken line."""
    if edges:
        gaps = np.full((len(edges), 1, 3), np.nan)
        ends = shape.vertices[np.array(edges)] * factor
        ax.plot(*np.concatenate([ends, gaps], axis=1).reshape(-1, 3).T, **look)


def _draw_facet(ax: Axes3D, shape: Body, factor: float) -> None:
    """Mark the weakest face, the point where the ball touches it, and the origin."""
    if shape.facet:
        look = {"linewidths": 1.2, "zorder": 4, "gid": "facet"}
        colour = mpl.colors.to_rgba(style.ORANGE, 0.45)
        _add(ax, [shape.vertices[list(shape.facet)]], factor, [colour], style.INK, **look)
    if shape.quality > 0.0:
        arm = np.vstack([np.zeros(3), shape.touching]) * factor
        if shape.held.segment is None:
            ax.plot(*arm.T, color=style.INK, linewidth=1.0, linestyle=(0, (3, 2)), zorder=5)
        ax.plot(*arm[1:].T, "o", color=style.INK, markersize=4.5, zorder=6, gid="touching")
    ax.plot([0.0], [0.0], [0.0], "+", color=style.INK, markersize=7.0, zorder=6, gid="origin")


def _set_axes(ax: Axes3D, shapes: Sequence[Body], unit: Unit, swarm: Swarm) -> None:
    """Give all three axes the same scale, so that a ball is round, and name them."""
    corners = np.concatenate([*(s.vertices for s in shapes), np.zeros((1, 3))]) / unit.newtons
    low, high = corners.min(axis=0), corners.max(axis=0)
    size = float((high - low).max()) or 1.0
    thin = np.maximum(0.25 * size - (high - low), 0.0) / 2.0
    low, high = low - thin - 0.02 * size, high + thin + 0.02 * size
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set_box_aspect(tuple(high - low))
    roots = [f"√{a:g} · " if a != 1.0 else "" for a in swarm.force_weights]
    ax.set_xlabel(f"{roots[0]}surge ahead [{unit.name}]")
    ax.set_ylabel(f"{roots[1]}sway to port [{unit.name}]")
    ax.set_zlabel(f"yaw to port / {written.length(swarm.characteristic_length)} [{unit.name}]")
    for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
        axis.set_pane_color((1.0, 1.0, 1.0, 0.0))
    ax.tick_params(pad=1.5)
    ax.locator_params(nbins=5)


def _legend_entries(first: Body, last: Body, wires: Body | None, criterion: Criterion) -> list[Any]:
    """Return a legend entry for everything that is drawn."""
    entries: list[Any] = [
        Patch(facecolor=SOLID, edgecolor=style.GREY, label=_measured(first, last, criterion))
    ]
    if wires is last:
        look: dict[str, Any] = {"color": style.VERMILION, "linewidth": 1.2}
        entries.append(Line2D([], [], **look, label=_measured(last, first, criterion)))
    elif wires is not None:
        text = f"as they stand: {written.quality(wires.quality, criterion)}"
        entries.append(Line2D([], [], color=style.BLUE, linewidth=1.2, label=text))
    if last.quality > 0.0 and criterion.task is None:
        look = {"marker": "o", "linestyle": "none", "markersize": 8.0}
        label = "largest ball: its radius is the quality"
        entries.append(Line2D([], [], **look, color=style.SKY, label=label))
    elif last.quality > 0.0:
        label = "the task, times the quality"
        body_of_it = Patch(facecolor=style.SKY, edgecolor=style.BLUE, label=label)
        is_line = last.held.segment is not None
        entries.append(Line2D([], [], **TASK, label=label) if is_line else body_of_it)
    if last.facet:
        label = "weakest face"
        if last.quality == 0.0:
            label = "face the load is beyond" if last.is_beyond else "face through the origin"
        face: dict[str, Any] = {"facecolor": style.ORANGE, "alpha": 0.6, "edgecolor": style.INK}
        entries.append(Patch(**face, label=label))
    if criterion.has_load:
        entries.append(Line2D([], [], **LOAD, markersize=4.5, markevery=[1], label="load"))
    return entries


def _measured(shape: Body, other: Body, criterion: Criterion) -> str:
    """Write how good one of two swarms is."""
    largest = max(shape.quality, other.quality)
    found = written.quality(shape.quality, criterion, largest)
    crew = written.count(shape.robots)
    return f"{crew}, quality {found}" if criterion.task is None else f"{crew}: {found}"


def _small_print(swarm: Swarm, criterion: Criterion) -> list[str]:
    """Return what the picture's numbers mean, in lines."""
    lines = [f"Metric: {written.metric(swarm)}."]
    if criterion.has_load:
        lines.append(written.load_sentence(criterion.load, swarm))
    if criterion.is_of_worst:
        several = style.terms().several
        drawn = f"{several} left" if criterion.losing or criterion.failures else several
        where = " in their worst poses" if criterion.worst_case else ""
        lines.append(f"The quality is that of the {drawn}{where}, whose wrench set is drawn.")
    return lines


def _new_figure(caption: Caption) -> tuple[Figure, tuple[float, float, float, float]]:
    """Return a figure with all that is written round the 3-D box, and the room that is left."""
    columns = 2 if style.width() >= TWO_COLUMNS else 1
    rows = [*caption.headings, *caption.lines]
    head = WORDS * len(rows)
    above = head + LEGEND[0] + LEGEND[1] * math.ceil(len(caption.entries) / columns)
    below = PRINT[0] + PRINT[1] * len(caption.print_lines)
    height = below + BOX * min(1.0, style.width() / style.WIDTH) + above
    figure = Drawn(figsize=(style.width(), height))
    for row, line in enumerate(rows):
        look: dict[str, Any] = {"fontsize": style.text(8.0), "gid": "criterion"}
        if row < len(caption.headings):
            look = {"fontsize": style.text(10.0), "weight": "bold", "gid": "heading"}
        figure.text(SIDES[0], 1.0 - (0.18 + WORDS * row) / height, line, **look)
    figure.legend(
        handles=list(caption.entries), loc="upper center", ncols=columns, columnspacing=2.0,
        handlelength=1.6, handletextpad=0.6, labelspacing=0.4,
        bbox_to_anchor=(0.5, 1.0 - head / height),
    )  # fmt: skip
    figure.text(
        SIDES[0],
        0.086 / height,
        "\n".join(caption.print_lines),
        fontsize=style.text(7.0),
        color=style.GREY,
        linespacing=1.2,
        gid="small-print",
    )
    return figure, (SIDES[0], below / height, SIDES[1], 1.0 - above / height)
