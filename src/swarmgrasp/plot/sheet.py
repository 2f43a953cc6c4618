"""What surrounds a plan view: its frame, title, force key, legend and small print."""

import math
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swarmgrasp.plot import style
from swarmgrasp.plot.arrows import ArrowEntry, ArrowInLegend, Arrows, draw_arrows
from swarmgrasp.plot.labels import Page

MARGINS: Final = (0.60, 0.14, 0.32, 0.78)
"""Left, right, top and bottom of the axes [in], before the legend."""

HEIGHTS: Final = (1.9, 4.4)
"""Least and greatest height of the axes [in]."""

PADDING: Final = 24.0
"""Room for labels around what is drawn [pt]."""

LEGEND_ROW: Final = 0.17
LEGEND_COLUMNS: Final = 4


def new_axes(arrows: Arrows, entries: int) -> Axes:
    """Return an axes in a figure whose height suits what is to be drawn.

    Parameters
    ----------
    arrows : Arrows
    entries : int
        How many entries the legend will have.
    """
    low, high = arrows.box()
    left, right, top, bottom = MARGINS
    bottom += LEGEND_ROW * math.ceil(entries / LEGEND_COLUMNS)
    width = style.WIDTH - left - right
    room = 2.0 * PADDING / 72.0
    height = (width - room) * float((high - low)[1] / (high - low)[0]) + room
    height = float(np.clip(height, *HEIGHTS))
    total = height + top + bottom
    figure = Figure(figsize=(style.WIDTH, total))
    return figure.add_axes(
        (left / style.WIDTH, bottom / total, width / style.WIDTH, height / total)
    )


def frame(ax: Axes, arrows: Arrows) -> Page:
    """Set equal axes whose limits fill the axes' box and leave room for labels."""
    page = Page(ax)
    low, high = arrows.box()
    box = np.array([ax.bbox.width, ax.bbox.height])
    room = np.maximum(box - 2.0 * PADDING * page.point_size, 0.3 * box)
    half = 0.5 * box * float(np.max((high - low) / room))
    (left, bottom), (right, top) = 0.5 * (low + high) - half, 0.5 * (low + high) + half
    ax.set(xlim=(left, right), ylim=(bottom, top))
    ax.set_aspect("equal", adjustable="box")
    ax.set_xlabel("x [m]", labelpad=2.0)
    ax.set_ylabel("y [m]", labelpad=3.0)
    ax.spines[["top", "right"]].set_visible(False)
    ax.tick_params(length=3.0)
    ax.locator_params(axis="y", nbins=6)
    return page


def write_title(page: Page, title: str) -> None:
    """Write the line above the picture, on the left."""
    page.ax.annotate(
        title, (0.0, 1.0), xytext=(0.0, 9.0), xycoords="axes fraction",
        textcoords="offset points", va="baseline",
    )  # fmt: skip


def draw_force_key(page: Page, arrows: Arrows) -> None:
    """Draw the length of a round force above the picture, on the right."""
    if not arrows.strongest:
        return
    ax, inverse = page.ax, page.ax.transData.inverted()
    value = style.round_below(arrows.strongest)
    tip = inverse.transform((ax.bbox.x1, ax.bbox.y1 + 12.0 * page.point_size))
    tail = tip - [arrows.length(value), 0.0]
    draw_arrows(ax, [(tail, tip)], color=style.GREY, gid="key", clip_on=False)
    ax.annotate(
        style.force(value), (float(tail[0]), float(tail[1])),
        xytext=(-4.0, 0.0), textcoords="offset points", annotation_clip=False,
        ha="right", va="center", fontsize=8.0,
    )  # fmt: skip


def write_legend(page: Page, entries: Sequence[Any], small_print: str) -> None:
    """Write the legend below the picture, and the metric below the legend."""
    height = page.ax.bbox.height / page.point_size
    page.ax.legend(
        handles=list(entries),
        ncols=LEGEND_COLUMNS,
        loc="upper left",
        bbox_to_anchor=(0.0, -34.0 / height),
        handler_map={ArrowEntry: ArrowInLegend()},
        columnspacing=1.3,
        handlelength=1.8,
        handletextpad=0.6,
        labelspacing=0.35,
        borderaxespad=0.0,
        borderpad=0.0,
    )
    rows = math.ceil(len(entries) / LEGEND_COLUMNS)
    page.ax.annotate(
        small_print, (0.0, 0.0), xytext=(0.0, -40.0 - 72.0 * LEGEND_ROW * rows),
        xycoords="axes fraction", textcoords="offset points", va="top",
        fontsize=7.0, color=style.GREY,
    )  # fmt: skip
