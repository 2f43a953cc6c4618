"""What surrounds a plan view: its frame, title, force key, legend and small print."""

import math
import textwrap
from dataclasses import dataclass
from functools import cached_property
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
LEGEND_COLUMNS: Final = (4, 3, 2)
LEGEND_WIDTHS: Final = (31.0, 4.65)
"""Width of an entry [pt]: of its picture and the gap to the next, and of a letter."""

WORDS_WIDTHS: Final = (76, 46)
"""Letters in a line below the title, and in the last one: the force key stands on its right."""

WORDS_ROW: Final = 10.5
PRINT_ROW: Final = 9.5
"""Heights of a line below the title and of the small print [pt]."""


@dataclass(frozen=True)
class Caption:
    """What is written round a plan view.

    Attributes
    ----------
    title : str
    words : str
        What the quality means, below the title; empty if it is the nominal one.
    entries : tuple
        Of the legend.
    small_print : tuple of str
        Its lines.
    """

    title: str
    words: str
    entries: tuple[Any, ...]
    small_print: tuple[str, ...]

    @cached_property
    def lines(self) -> list[str]:
        """The words in lines, broken between terms; the last one ends before the force key."""
        terms = [term.replace(" ", "\xa0") for term in self.words.split(", ")]
        lines = textwrap.wrap(", ".join(terms), WORDS_WIDTHS[0])
        return [*lines, ""] if lines and len(lines[-1]) > WORDS_WIDTHS[1] else lines

    @cached_property
    def columns(self) -> int:
        """Columns of the legend, about as many as the page is wide enough for."""
        fixed, letter = LEGEND_WIDTHS
        lengths = np.array([len(entry.get_label()) for entry in self.entries])
        room = 72.0 * (style.WIDTH - MARGINS[0])
        for columns in LEGEND_COLUMNS:
            parts = [part for part in np.array_split(lengths, columns) if len(part)]
            if sum(fixed + letter * part.max() for part in parts) <= room:
                break
        return columns

    @property
    def rows(self) -> int:
        """Rows of the legend."""
        return math.ceil(len(self.entries) / self.columns)


def new_axes(arrows: Arrows, caption: Caption) -> Axes:
    """Return an axes in a figure whose height suits what is to be drawn and written."""
    low, high = arrows.box()
    left, right, top, bottom = MARGINS
    top += len(caption.lines) * WORDS_ROW / 72.0
    bottom += LEGEND_ROW * caption.rows + (len(caption.small_print) - 1) * PRINT_ROW / 72.0
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
    size = style.RC["axes.labelsize"]  # axes of others have their own settings
    ax.set_xlabel("x [m]", labelpad=2.0, fontsize=size)
    ax.set_ylabel("y [m]", labelpad=3.0, fontsize=size)
    ax.spines[["top", "right"]].set_visible(False)
    ax.tick_params(length=3.0, labelsize=style.RC["xtick.labelsize"])
    ax.locator_params(axis="y", nbins=6)
    return page


def write_caption(page: Page, caption: Caption) -> None:
    """Write title and words above the picture, on the left, legend and small print below it."""
    look: dict[str, Any] = {"xycoords": "axes fraction", "textcoords": "offset points"}
    words = "\n".join(caption.lines)
    raised = 9.0 + WORDS_ROW * len(caption.lines)
    page.ax.annotate(caption.title, (0.0, 1.0), xytext=(0.0, raised), va="baseline", **look)
    page.ax.annotate(
        words, (0.0, 1.0), xytext=(0.0, raised - 4.0), va="top", linespacing=1.2,
        fontsize=7.5, color=style.GREY, gid="criterion", **look,
    )  # fmt: skip
    height = page.ax.bbox.height / page.point_size
    page.ax.legend(
        handles=list(caption.entries),
        ncols=caption.columns,
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
    below = -40.0 - 72.0 * LEGEND_ROW * caption.rows
    page.ax.annotate(
        "\n".join(caption.small_print), (0.0, 0.0), xytext=(0.0, below), va="top",
        fontsize=7.0, color=style.GREY, linespacing=1.2, **look,
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
