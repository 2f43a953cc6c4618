"""What surrounds a plan view: its frame, title, force key, legend and small print."""

import math
import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swarmgrasp.plot import style, written
from swarmgrasp.plot.arrows import ArrowEntry, ArrowInLegend, Arrows, draw_arrows
from swarmgrasp.plot.coordinates import tick_axes
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.plot.flows import Flow, draw_flows, height_of
from swarmgrasp.plot.labels import Page

MARGINS: Final = (0.65, 0.09, 0.32, 0.78)
"""Left, right, top and bottom of the axes [in], before the legend."""

HEIGHTS: Final = (1.9, 4.4)
"""Least and greatest height of the axes [in]."""

PADDING: Final = 24.0
"""Room for labels around what is drawn [pt]."""

LEGEND_ROW: Final = 0.17
LEGEND_COLUMNS: Final = (5, 4, 3, 2, 1)
LEGEND_WIDTHS: Final = (31.0, 4.65)
"""Width of an entry [pt]: of its picture and the gap to the next, and of a letter."""

WORDS_WIDTHS: Final = (3.9, 5.2, 3.7, 5.6)
"""Width of a letter [pt], on average: of the words below the title, the title, the small print and
the heading."""

KEY_WIDTH: Final = 100.0
"""Room of the force key on the right of the last line above the picture [pt]."""

HEADING_ROW: Final = 13.0
WORDS_ROW: Final = 10.5
PRINT_ROW: Final = 9.5
"""Heights of a line below the title and of the small print [pt]."""


@dataclass(frozen=True)
class Caption:
    """What is written round a plan view.

    Attributes
    ----------
    heading : str
        Such as the name of the object; may be empty.
    title : str
    words : str
        What the quality means, below the title; empty if it is the nominal one.
    entries : tuple
        Of the legend.
    small_print : tuple of str
        Its sentences.
    flows : tuple of Flow
        Wind, current and sea.
    """

    heading: str
    title: str
    words: str
    entries: tuple[Any, ...]
    small_print: tuple[str, ...]
    flows: tuple[Flow, ...] = ()

    @cached_property
    def lines(self) -> list[str]:
        """The title and the words in lines, the words broken between terms."""
        terms = [term.replace(" ", "\xa0") for term in self.words.split(", ")]
        words = textwrap.wrap(", ".join(terms), int(axes_width() / style.text(WORDS_WIDTHS[0])))
        return [*self._title_lines, *(line.replace("\xa0", " ") for line in words)]

    @property
    def title_lines(self) -> int:
        """How many of the lines are the title's."""
        return len(self._title_lines)

    @property
    def _title_lines(self) -> list[str]:
        """The title in lines."""
        return textwrap.wrap(self.title, int(axes_width() / style.text(WORDS_WIDTHS[1])))

    @property
    def foot(self) -> int:
        """Rows between the last line and the picture: one where the force key has no other room."""
        last = self.lines[-1] if self.lines else ""
        letter = style.text(WORDS_WIDTHS[len(self.lines) == self.title_lines])
        return int(len(last) * letter > axes_width() - KEY_WIDTH)

    @cached_property
    def headings(self) -> list[str]:
        """The heading in lines."""
        return textwrap.wrap(self.heading, int(axes_width() / style.text(WORDS_WIDTHS[3])))

    @cached_property
    def print_lines(self) -> list[str]:
        """The small print in lines."""
        width = int(axes_width() / style.text(WORDS_WIDTHS[2]))
        whole = [re.sub(r"(?<=\d) ", "\xa0", text) for text in self.small_print]  # number and unit
        lines = [line for text in whole for line in textwrap.wrap(text, width)]
        return [line.replace("\xa0", " ") for line in lines]

    @property
    def above(self) -> float:
        """Height of what is written above the picture [pt], but for one line."""
        rows = len(self.lines) + self.foot - 1
        return HEADING_ROW * len(self.headings) + WORDS_ROW * rows

    @cached_property
    def columns(self) -> int:
        """Columns of the legend, about as many as the page is wide enough for."""
        fixed, letter = LEGEND_WIDTHS
        lengths = np.array([len(entry.get_label()) for entry in self.entries])
        room = axes_width() + 72.0 * MARGINS[1]
        for columns in LEGEND_COLUMNS:
            parts = [part for part in np.array_split(lengths, columns) if len(part)]
            if sum(style.text(fixed + letter * part.max()) for part in parts) <= room:
                break
        return columns

    @property
    def rows(self) -> int:
        """Rows of the legend."""
        return math.ceil(len(self.entries) / self.columns)


def axes_width() -> float:
    """Return the width of the axes [pt]."""
    return 72.0 * (style.width() - MARGINS[0] - MARGINS[1])


def new_axes(arrows: Arrows, caption: Caption) -> Axes:
    """Return an axes in a figure whose height suits what is to be drawn and written."""
    low, high = arrows.box()
    left, right, top, bottom = MARGINS
    top += caption.above / 72.0
    bottom += style.text(LEGEND_ROW * caption.rows)
    bottom += style.text((len(caption.print_lines) - 1) * PRINT_ROW / 72.0)
    width = style.width() - left - right
    room = 2.0 * PADDING / 72.0
    height = (width - room) * float((high - low)[1] / (high - low)[0]) + room
    height = float(np.clip(height, *HEIGHTS)) + height_of(caption.flows) / 72.0
    total = height + top + bottom
    figure = Drawn(figsize=(style.width(), total))
    return figure.add_axes(
        (left / style.width(), bottom / total, width / style.width(), height / total)
    )


def frame(
    ax: Axes, arrows: Arrows, flows: tuple[Flow, ...] = (), *, has_table: bool = False
) -> Page:
    """Set equal axes whose limits fill the axes' box and leave room for labels and flows.

    With a table, labels without room become numbers; `write_caption` then makes room for it.
    """
    page = Page(ax, tags=[] if has_table else None)
    low, high = arrows.box()
    box = np.array([ax.bbox.width, ax.bbox.height])
    strip = np.array([0.0, height_of(flows) * page.point_size])
    room = np.maximum(box - strip - 2.0 * PADDING * page.point_size, 0.3 * box)
    metres = float(np.max((high - low) / room))
    middle = 0.5 * (low + high + strip * metres)
    (left, bottom), (right, top) = middle - 0.5 * metres * box, middle + 0.5 * metres * box
    ax.set(xlim=(left, right), ylim=(bottom, top))
    ax.set_aspect("equal", adjustable="box")
    tick_axes(ax, (max(3, round(axes_width() / 45.0)), 6))
    draw_flows(page, flows)
    return page


def write_caption(page: Page, caption: Caption) -> None:
    """Write title and words above the picture, on the left, legend and small print below it.

    The figure grows by what the table of the numbers takes that stand for labels.
    """
    tags = _table(page.tags or [])
    _grow(page.ax, style.text(len(tags) * PRINT_ROW / 72.0))
    look: dict[str, Any] = {"xycoords": "axes fraction", "textcoords": "offset points"}
    raised = 9.0 + WORDS_ROW * (len(caption.lines) + caption.foot - 1)
    for row, line in enumerate(caption.headings[::-1]):
        page.ax.annotate(
            line, (0.0, 1.0), xytext=(0.0, raised + HEADING_ROW * (row + 1)), va="baseline",
            fontsize=style.text(10.0), weight="bold", gid="heading", **look,
        )  # fmt: skip
    for row, line in enumerate(caption.lines):
        is_title = row < caption.title_lines
        size, colour = (9.0, style.INK) if is_title else (7.5, style.GREY)
        page.ax.annotate(
            line,
            (0.0, 1.0),
            xytext=(0.0, raised - WORDS_ROW * row),
            va="baseline",
            fontsize=style.text(size),
            color=colour,
            gid="title" if is_title else "criterion",
            **look,
        )
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
    below = -40.0 - style.text(72.0 * LEGEND_ROW * caption.rows)
    page.ax.annotate(
        "\n".join([*tags, *caption.print_lines]), (0.0, 0.0), xytext=(0.0, below), va="top",
        fontsize=style.text(7.0), color=style.GREY, linespacing=1.2, gid="small-print", **look,
    )  # fmt: skip


def _table(tags: Sequence[str]) -> list[str]:
    """Return what the numbers stand for, in lines."""
    entries = [f"{row + 1} {text}".replace(" ", "\xa0") for row, text in enumerate(tags)]
    width = int(axes_width() / style.text(WORDS_WIDTHS[2]))
    lines = textwrap.wrap("; ".join(entries), width, break_on_hyphens=False)
    return [line.replace("\xa0", " ") for line in lines]


def _grow(ax: Axes, more: float) -> None:
    """Make the figure higher [in] at the bottom, the axes as large as they are."""
    figure = cast(Figure, ax.get_figure(root=True))
    width, height = figure.get_size_inches()
    x, y, breadth, rise = ax.get_position().bounds
    figure.set_size_inches(width, height + more)
    share = height / (height + more)
    ax.set_position((x, 1.0 - share * (1.0 - y), breadth, share * rise))


def round_below(value: float) -> float:
    """Return the largest 1, 2 or 5 times a power of ten that is at most a positive value.

    Examples
    --------
    >>> round_below(37.0), round_below(0.6)
    (20.0, 0.5)
    """
    power = 10.0 ** math.floor(math.log10(value))
    return max(
        (m * power for m in (1.0, 2.0, 5.0) if m * power <= value * (1 + 1e-9)), default=power
    )


def draw_force_key(page: Page, arrows: Arrows) -> None:
    """Draw the length of a round force above the picture, on the right."""
    if not arrows.strongest:
        return
    ax, inverse = page.ax, page.ax.transData.inverted()
    unit = written.unit_of(arrows.strongest).newtons
    value = unit * round_below(arrows.strongest / unit)
    tip = inverse.transform((ax.bbox.x1, ax.bbox.y1 + 12.0 * page.point_size))
    tail = tip - [arrows.length(value), 0.0]
    draw_arrows(ax, [(tail, tip)], color=style.GREY, gid="key", clip_on=False)
    ax.annotate(
        written.force(value), (float(tail[0]), float(tail[1])),
        xytext=(-4.0, 0.0), textcoords="offset points", annotation_clip=False,
        ha="right", va="center", fontsize=style.text(8.0), gid="key-label",
    )  # fmt: skip
