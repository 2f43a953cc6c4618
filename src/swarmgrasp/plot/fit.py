"""A 3-D box that fills its room on the page, with all its labels."""

import itertools
import math
from typing import Final

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.path import Path
from matplotlib.text import Text
from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import Bbox
from mpl_toolkits.mplot3d import proj3d  # type: ignore[import-untyped]
from mpl_toolkits.mplot3d.axes3d import Axes3D  # type: ignore[import-untyped]
from numpy.typing import NDArray

Room = tuple[float, float, float, float]
"""Left, bottom, right and top, in shares of the figure."""

LABEL_PADS: Final = tuple(np.arange(2.0, 22.0, 2.0))
"""Distances of the names of the axes from their axes [pt], the first that has room."""


def fit(figure: Figure, ax: Axes3D, room: Room) -> None:
    """Enlarge and move the 3-D box until it fills its room with all its labels.

    Labels keep their size, so a second look corrects what the first one estimated.

    Parameters
    ----------
    figure : Figure
    ax : Axes3D
    room : tuple of float
        Left, bottom, right and top, in shares of the figure.
    """
    low, high = np.transpose([ax.get_xlim(), ax.get_ylim(), ax.get_zlim()])
    left, bottom, right, top = room
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
