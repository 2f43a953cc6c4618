"""The wrench sets before and after, and the largest ball inside: the quality in 3-D."""

import itertools
import math
from typing import Any, Final, cast

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.path import Path
from matplotlib.text import Text
from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import Bbox
from mpl_toolkits.mplot3d import proj3d  # type: ignore[import-untyped]
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # type: ignore[import-untyped]
from mpl_toolkits.mplot3d.axes3d import Axes3D  # type: ignore[import-untyped]
from numpy.typing import NDArray

from swarmgrasp.plot import style
from swarmgrasp.plot.bodies import Body, body, split, unit_ball
from swarmgrasp.swarm import Swarm

ASIDE: Final = 38.0
"""How far the eye stands off the direction of the touching point [deg]: seen straight on,
ball and facet would hide one another."""

TILTS: Final = (18.0, 32.0)
"""Least and greatest elevation of the eye above or below the plane of forces [deg]."""

TURNS: Final = (25.0, 65.0)
"""Azimuth of the eye within its quadrant [deg]: no axis is seen end on."""

ROOM: Final = (0.03, 0.07, 0.97, 0.88)
"""Left, bottom, right and top of the part of the figure the 3-D box and its labels fill."""

LABEL_PADS: Final = tuple(np.arange(2.0, 22.0, 2.0))
"""Distances of the names of the axes from their axes [pt], the first that has room."""

SOLID: Final = "#C9CDD2"
WIRES_SEEN: Final[dict[str, Any]] = {"linewidth": 0.9, "zorder": 3}
WIRES_HIDDEN: Final[dict[str, Any]] = {"linewidth": 0.5, "alpha": 0.35, "zorder": 1}


def wrench_sets(
    before: Swarm, after: Swarm | None = None, *, eye: tuple[float, float] | None = None
) -> Figure:
    """Draw what a swarm can exert on the object, before and after a change.

    The axes are the metric's coordinates, force and torque over the characteristic
    length, so that the quality is the radius of a round ball: the largest about the
    origin that fits into the last of the two sets. The face it touches is the weakest.

    Parameters
    ----------
    before : Swarm
        Drawn solid.
    after : Swarm, optional
        Drawn as a wire frame, with the metric of `before`.
    eye : tuple of float [deg, deg], optional
        Elevation and azimuth to look from; by default the touching point faces the eye.

    Returns
    -------
    Figure

    Raises
    ------
    WrenchSetTooLarge
        If a set has too many faces to draw.
    """
    first = last = body(before)
    if after is not None:
        metric = before.characteristic_length, before.force_weights
        last = body(Swarm(after.outline, after.robots, *metric))
    factor, unit = style.force_unit(float(np.abs(last.vertices).max()))
    with style.settings():
        figure = Figure(figsize=(style.WIDTH, 4.3))
        ax = cast(
            Axes3D,
            figure.add_axes(
                (0.0, 0.0, 1.0, 1.0), projection="3d", computed_zorder=False, proj_type="ortho"
            ),
        )
        elevation, azimuth = _eye(last.weakest) if eye is None else eye
        ax.view_init(elevation, azimuth)
        towards = _towards(elevation, azimuth)
        if after is not None:
            _draw_wires(ax, last, factor, towards, front=False)
        _draw_solids(ax, first, last, factor, towards)
        if not first.faces:
            _draw_wires(ax, first, factor, towards, front=True, color=style.GREY)
        if after is not None:
            _draw_wires(ax, last, factor, towards, front=True)
        _draw_facet(ax, last, factor)
        _set_axes(ax, (first, last), factor, unit, before)
        _write_round(figure, before, after, (first, last))
        _fit(figure, ax)
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
    colours[:, 3] = 0.5 if last.radius > 0.0 else 0.9
    _add(ax, faces, factor, colours, mpl.colors.to_rgba(style.GREY, 0.9), zorder=2.2, gid="before")
    if last.radius > 0.0:
        patches, normals = unit_ball()
        shown = normals @ towards > -0.05
        patches, normals = last.radius * patches[shown], normals[shown]
        colours = _shade(normals, towards, style.SKY)
        for part, zorder in zip(split(patches, colours, first), (2.1, 2.3), strict=True):
            polygons, shades = [p for p, _ in part], [c for _, c in part]
            _add(ax, polygons, factor, shades, shades, zorder=zorder, gid="ball")


def _add(ax: Axes3D, polygons: Any, factor: float, colours: Any, edges: Any, **look: Any) -> None:
    """Add polygons [N] as one collection, with their own colours."""
    if len(polygons):
        scaled = [factor * np.asarray(polygon) for polygon in polygons]
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
    seen = {
        (min(pair), max(pair))
        for face, shown in zip(shape.faces, _front(shape, towards), strict=True)
        if shown
        for pair in zip(face, face[1:] + face[:1], strict=True)
    }
    edges = [edge for edge in shape.edges if (edge in seen) == front or not shape.faces]
    if not edges:
        return
    gaps = np.full((len(edges), 1, 3), np.nan)
    line = np.concatenate([shape.vertices[np.array(edges)] * factor, gaps], axis=1).reshape(-1, 3)
    depth = WIRES_SEEN if front else WIRES_HIDDEN
    ax.plot(*line.T, gid="wires", **({"color": style.VERMILION} | depth | look))


def _draw_facet(ax: Axes3D, shape: Body, factor: float) -> None:
    """Mark the weakest face, the point where the ball touches it, and the origin."""
    if shape.facet:
        look = {"linewidths": 1.2, "zorder": 4, "gid": "facet"}
        colour = mpl.colors.to_rgba(style.ORANGE, 0.45)
        _add(ax, [shape.vertices[list(shape.facet)]], factor, [colour], style.INK, **look)
    if shape.radius > 0.0:
        arm = np.vstack([np.zeros(3), shape.touching]) * factor
        ax.plot(*arm.T, color=style.INK, linewidth=1.0, linestyle=(0, (3, 2)), zorder=5)
        ax.plot(*arm[1:].T, "o", color=style.INK, markersize=4.5, zorder=6, gid="touching")
    ax.plot([0.0], [0.0], [0.0], "+", color=style.INK, markersize=7.0, zorder=6, gid="origin")


def _set_axes(
    ax: Axes3D, shapes: tuple[Body, Body], factor: float, unit: str, swarm: Swarm
) -> None:
    """Give all three axes the same scale, so that a ball is round, and name them."""
    corners = np.concatenate([*(s.vertices for s in shapes), np.zeros((1, 3))]) * factor
    low, high = corners.min(axis=0), corners.max(axis=0)
    size = float((high - low).max()) or 1.0
    thin = np.maximum(0.25 * size - (high - low), 0.0) / 2.0
    low, high = low - thin - 0.02 * size, high + thin + 0.02 * size
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set_box_aspect(tuple(high - low))
    roots = [f"√{a:g} · " if a != 1.0 else "" for a in swarm.force_weights]
    ax.set_xlabel(f"{roots[0]}surge force [{unit}]")
    ax.set_ylabel(f"{roots[1]}sway force [{unit}]")
    ax.set_zlabel(f"torque / {style.number(swarm.characteristic_length)} m [{unit}]")
    for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
        axis.set_pane_color((1.0, 1.0, 1.0, 0.0))
    ax.tick_params(pad=1.5)
    ax.locator_params(nbins=5)


def _fit(figure: Figure, ax: Axes3D) -> None:
    """Enlarge and move the 3-D box until it fills its room with all its labels.

    Labels keep their size, so a second look corrects what the first one estimated.
    """
    low, high = np.transpose([ax.get_xlim(), ax.get_ylim(), ax.get_zlim()])
    left, bottom, right, top = ROOM
    zoom = 1.0
    for _ in range(3):
        drawn = _drawn_box(figure, ax, low, high)
        zoom *= min((right - left) / drawn.width, (top - bottom) / drawn.height)
        place = ax.get_position()
        x = place.x0 + 0.5 * (left + right - drawn.x0 - drawn.x1)
        y = place.y0 + 0.5 * (bottom + top - drawn.y0 - drawn.y1)
        ax.set_position((x, y, place.width, place.height))
        ax.set_box_aspect(tuple(high - low), zoom=zoom)
    everything = [*ax.get_children(), *(axis.gridlines for axis in (ax.xaxis, ax.yaxis, ax.zaxis))]
    for artist in everything:  # the moved axes no longer cover the figure
        artist.set_clip_on(False)


def _clear_ticks(figure: Figure, ax: Axes3D) -> None:
    """Move the names of the axes outward until they clear all numbers and each other.

    Where the numbers of an axis touch, fewer are written.
    """
    axes = ax.xaxis, ax.yaxis, ax.zaxis
    for axis in axes:
        axis.labelpad = LABEL_PADS[0]
    for _ in LABEL_PADS[1:]:
        figure.draw_without_rendering()  # places the labels
        names = [text_area(axis.label) for axis in axes]
        rows = [
            [text_area(t.label1) for t in axis.get_major_ticks() if t.label1.get_text()]
            for axis in axes
        ]
        numbers = [number for row in rows for number in row]
        crowded = [
            any(name.intersects_path(other) for other in [*numbers, *names[:i], *names[i + 1 :]])
            for i, name in enumerate(names)
        ]
        tight = [any(a.intersects_path(b) for a, b in itertools.pairwise(row)) for row in rows]
        if not any(crowded + tight):
            return
        for axis, is_tight in zip(axes, tight, strict=True):
            if is_tight:
                axis.set_major_locator(MaxNLocator(3))
        for axis, is_crowded in zip(axes, crowded, strict=True):
            axis.labelpad += (LABEL_PADS[1] - LABEL_PADS[0]) * is_crowded
    figure.draw_without_rendering()


def text_area(text: Text) -> Path:
    """Return the turned box [px] a text fills."""
    turn = text.get_rotation()
    centre = text.get_window_extent().get_points().mean(axis=0)
    text.set_rotation(0.0)
    half = np.array(text.get_window_extent().size) / 2.0
    text.set_rotation(turn)
    corners = half * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)])
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    return Path(centre + corners @ np.array([[c, s], [-s, c]]), closed=True)


def _drawn_box(
    figure: Figure, ax: Axes3D, low: NDArray[np.float64], high: NDArray[np.float64]
) -> Bbox:
    """Return the box round the 3-D box and its labels, in shares of the figure."""
    _clear_ticks(figure, ax)
    renderer = FigureCanvasAgg(figure).get_renderer()  # type: ignore[no-untyped-call]
    corners = np.array(list(itertools.product(*zip(low, high, strict=True))))
    x, y, _ = proj3d.proj_transform(*corners.T, ax.get_proj())
    boxes = [Bbox.null()]
    boxes[0].update_from_data_xy(ax.transData.transform(np.column_stack([x, y])))
    boxes += [axis.get_tightbbox(renderer) for axis in (ax.xaxis, ax.yaxis, ax.zaxis)]
    return Bbox.union(boxes).transformed(figure.transFigure.inverted())


def _write_round(
    figure: Figure, before: Swarm, after: Swarm | None, shapes: tuple[Body, Body]
) -> None:
    """Write the legend above the picture and the metric below it."""
    largest = max(shape.radius for shape in shapes)
    texts = [
        f"{style.count(len(swarm))}, quality {style.force(shape.radius, largest)}"
        for swarm, shape in zip((before, after or before), shapes, strict=True)
    ]
    entries: list[Any] = [Patch(facecolor=SOLID, edgecolor=style.GREY, label=texts[0])]
    if after is not None:
        entries.append(Line2D([], [], color=style.VERMILION, linewidth=1.2, label=texts[1]))
    if shapes[1].radius > 0.0:
        look: dict[str, Any] = {"marker": "o", "linestyle": "none", "markersize": 8.0}
        label = "largest ball: its radius is the quality"
        entries.append(Line2D([], [], **look, color=style.SKY, label=label))
    if shapes[1].facet:
        label = "weakest face" if shapes[1].radius > 0.0 else "face through the origin"
        face: dict[str, Any] = {"facecolor": style.ORANGE, "alpha": 0.6, "edgecolor": style.INK}
        entries.append(Patch(**face, label=label))
    figure.legend(
        handles=entries, loc="upper center", ncols=2, columnspacing=2.0, handlelength=1.6,
        handletextpad=0.6, labelspacing=0.4,
    )  # fmt: skip
    small_print = f"Metric: {before.metric_sentence}."
    figure.text(0.03, 0.02, small_print, fontsize=7.0, color=style.GREY)
