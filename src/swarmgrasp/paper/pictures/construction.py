"""Fig. 2 in kind: a wrench set that grows by one robot's segment at a time."""

import itertools
import math
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray
from shapely import MultiPoint

from swarmgrasp.plot import style, written
from swarmgrasp.plot.bodies import Body, body
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.swarm import Swarm

Vectors = NDArray[np.float64]

COLUMNS: Final = 3
TILTS: Final = (20.0, 30.0, 40.0)
TURNS: Final = tuple(range(-170, 180, 10))
"""Elevations and azimuths [deg] of the eye, of which the one is taken that sees most."""
RIM: Final = 0.02
"""Round the largest set, relative to it."""
GAP: Final = 0.1
"""Between panels [in]."""
HEAD: Final = 0.2
"""Above each [in]."""
FOOT: Final = 0.22
"""Of the small print [in]."""
KEY: Final = 0.42
"""Height of the key [in]."""
ARROW: Final = {"arrowstyle": "-|>", "linewidth": 0.9, "shrinkA": 0.0, "shrinkB": 0.0}
AXES: Final = ("surge", "sway", "torque / L")


def construction(steps: list[Swarm]) -> Figure:
    """Draw the wrench sets of growing swarms, each with the one before, and the largest ball.

    All are to one scale and seen from one side, along parallel lines.

    Parameters
    ----------
    steps : list of Swarm
        Each with one robot more than the one before.
    """
    shapes, scale = [body(step) for step in steps], steps[-1].scale
    seen = _view(shapes)
    flat = shapes[-1].vertices @ seen[:2].T
    rim = RIM * float(np.ptp(flat, axis=0).max())
    low, high = flat.min(axis=0) - rim, flat.max(axis=0) + rim
    rows = math.ceil(len(steps) / COLUMNS)
    with style.settings():
        room = (style.width() - GAP * (COLUMNS + 1)) / COLUMNS
        inches = room / float((high - low)[0])
        tall = inches * float((high - low)[1])
        total = rows * (tall + HEAD + GAP) + KEY + FOOT
        figure = Drawn(figsize=(style.width(), total))
        for k, step in enumerate(steps):
            row, column = divmod(k, COLUMNS)
            left = GAP + column * (room + GAP)
            bottom = total - (row + 1) * (tall + HEAD + GAP)
            ax = figure.add_axes(
                (left / style.width(), bottom / total, room / style.width(), tall / total)
            )
            _draw(ax, shapes[k], shapes[k - 1] if k else None, seen)
            arm = np.outer([0.0, 1.0], seen[:2] @ (step.generators[-1] * scale))
            ax.plot(*arm.T, color=style.VERMILION, linewidth=2.2, zorder=6)
            ax.plot(0.0, 0.0, "+", color=style.INK, markersize=6.0, zorder=7)
            ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
            ax.set_axis_off()
            ax.set_title(
                f"{written.count(k + 1)}: quality {written.number(shapes[k].quality)} N",
                pad=4.0,
                fontsize=8.0,
            )
        _draw_key(figure, seen, total)
        metric = f"Metric: {steps[-1].metric_sentence}."
        figure.text(0.02, 0.05 / total, metric, fontsize=7.0, color=style.GREY)
    return figure


def _view(shapes: list[Body]) -> Vectors:
    """Return the axes (3, 3) to the right, up, and to the eye that sees most of all sets."""

    def breadth(view: Vectors) -> float:
        """Return how broad the sets are, those that are flat too."""
        return sum(math.sqrt(_hull(shape.vertices @ view[:2].T).area) for shape in shapes)

    return max((_axes(*turn) for turn in itertools.product(TILTS, TURNS)), key=breadth)


def _axes(tilt: float, turn: float) -> Vectors:
    """Return the axes (3, 3) to the right, up, and to an eye [deg, deg]."""
    e, a = math.radians(tilt), math.radians(turn)
    towards = np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])
    right = np.array([-math.sin(a), math.cos(a), 0.0])
    return np.stack([right, np.cross(towards, right), towards])


def _hull(points: Vectors) -> Any:
    """Return the convex hull of points (k, 2)."""
    return MultiPoint(points).convex_hull


def _draw(ax: Axes, shape: Body, before: Body | None, seen: Vectors) -> None:
    """Draw a set as glass, with the one before it and the largest ball inside."""
    _fill(ax, shape, seen, style.PALE, 1.0)
    _draw_edges(ax, shape, seen, front=False, color=style.GREY, linewidth=0.4, alpha=0.5, zorder=2)
    if before is not None:
        _fill(ax, before, seen, style.GREY, 2.1)
        _draw_edges(ax, before, seen, front=True, color=style.INK, linewidth=0.7, zorder=4)
    if shape.quality > 0.0:
        turn = np.linspace(0.0, math.tau, 97)
        ring = shape.quality * np.column_stack([np.cos(turn), np.sin(turn)])
        ax.fill(*ring.T, color=style.SKY, alpha=0.75, linewidth=0.0, zorder=3)
    _draw_edges(ax, shape, seen, front=True, color=style.GREY, linewidth=0.8, zorder=5)


def _fill(ax: Axes, shape: Body, seen: Vectors, colour: str, zorder: float) -> None:
    """Fill what is seen of a set."""
    hull = _hull(np.vstack([shape.vertices @ seen[:2].T, np.zeros((1, 2))]))
    if hull.geom_type == "Polygon":
        alpha = 1.0 if colour == style.PALE else 0.25
        ax.fill(*hull.exterior.xy, color=colour, alpha=alpha, linewidth=0.0, zorder=zorder)


def _draw_edges(ax: Axes, shape: Body, seen: Vectors, *, front: bool, **look: Any) -> None:
    """Draw the edges of the faces that can be seen, or those that cannot; of flat sets all."""
    sides = {
        frozenset(pair)
        for face, normal in zip(shape.faces, shape.normals, strict=True)
        if float(normal @ seen[2]) > 0.0
        for pair in itertools.pairwise([*face, face[0]])
    }
    shown = [e for e in shape.edges if (not shape.faces or frozenset(e) in sides) == front]
    flat = shape.vertices @ seen[:2].T
    for edge in shown:
        ax.plot(*flat[list(edge)].T, **look)


def _draw_key(figure: Figure, seen: Vectors, total: float) -> None:
    """Draw which way the three axes point, below the sets."""
    ax = figure.add_axes((0.0, FOOT / total, 1.0, KEY / total))
    ax.set(xlim=(0.0, style.width()), ylim=(0.0, KEY))  # in inches
    ax.set_axis_off()
    longest = float(np.linalg.norm(seen[:2], axis=0).max())
    for k, name in enumerate(AXES):
        half = 0.45 * KEY / longest * seen[:2, k]
        centre = np.array([0.5 + 1.2 * k, 0.5 * KEY])
        start, end = centre - half, centre + half
        ax.annotate("", tuple(end), tuple(start), arrowprops={**ARROW, "color": style.INK})
        ax.text(0.75 + 1.2 * k, 0.5 * KEY, name, va="center", fontsize=7.0)
