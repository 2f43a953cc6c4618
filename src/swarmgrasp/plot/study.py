"""What studies find."""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import AutoLocator, MaxNLocator, PercentFormatter

from swarmgrasp.plot import style, written
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.terms import SI, Terms
from swarmgrasp.units import LENGTHS

if TYPE_CHECKING:  # it needs the packages of an extra
    from swarmgrasp.simulation.study import Findings, Gathered

HEIGHT: Final = 2.9
"""Of a picture [in]."""
LINE: Final[dict[str, Any]] = {"marker": "o", "markersize": 3.5, "linewidth": 1.2}


def study_picture(
    found: "Gathered", *, title: str = "", terms: Terms = SI, width: float = style.WIDTH
) -> Figure:
    """Draw what a study has found, as its kind needs.

    Parameters
    ----------
    found : Gathered
    title : str
        Instead of the name of the study's scenario.
    terms : Terms
        The units in which it is told.
    width : float [in]
    """
    draw, panels = KINDS[found.plan.study.kind]
    with style.settings(width, terms):
        figure = Drawn(figsize=(style.width(), HEIGHT), layout="constrained")
        axes = figure.subplots(1, panels, squeeze=False)[0]
        for ax in axes:
            ax.spines[["top", "right"]].set_visible(False)
            ax.grid(True)
            ax.set_axisbelow(True)
            ax.xaxis.set_major_locator(MaxNLocator(integer=True))
        draw(axes, found.findings)
        handles, labels = axes[0].get_legend_handles_labels()
        if handles:
            figure.legend(handles, labels, loc="outside lower left", ncols=len(handles))
        figure.suptitle(
            f"{title or found.plan.name}, {found.runs} runs: {found.plan.study.words(terms)}",
            x=0.01, ha="left", fontsize=style.text(8.0), wrap=True, gid="title",
        )  # fmt: skip
    return figure


def _column(findings: "Findings", index: int) -> list[float]:
    """Return a column of what was found."""
    return [row[index] for row in findings.rows]


def _lengths(findings: "Findings", index: int) -> list[float]:
    """Return a column of lengths in the picture's unit."""
    return [value / LENGTHS[style.terms().length] for value in _column(findings, index)]


def _shares(ax: Axes, label: str) -> None:
    """Make an axis one of shares."""
    ax.set(ylim=(0.0, 1.02), ylabel=label)
    ax.yaxis.set_major_formatter(PercentFormatter(1.0))


def _draw_sizes(axes: Any, findings: "Findings") -> None:
    """Draw how many swarms have force closure, and how good they are."""
    left, right = axes
    robots = _column(findings, 0)
    left.plot(robots, _column(findings, 2), color=style.BLUE, **LINE)
    left.set(xlabel=style.terms().several)
    _shares(left, "with force closure")
    low, median, high = (_column(findings, index) for index in (3, 4, 5))
    unit = written.unit_of(*high)
    low, median, high = ([value / unit.newtons for value in row] for row in (low, median, high))
    right.fill_between(robots, low, high, color=style.SKY, alpha=0.3, linewidth=0.0,
                       label="10 to 90 %")  # fmt: skip
    right.plot(robots, median, color=style.BLUE, label="median", **LINE)
    right.set(xlabel=style.terms().several, ylabel=f"quality [{unit.name}]", ylim=(0.0, None))
    right.legend(loc="upper left")


def _draw_losses(axes: Any, findings: "Findings") -> None:
    """Draw how many swarms bear a loss, and what it leaves of those with force closure."""
    left, right = axes
    robots = _column(findings, 0)
    left.plot(robots, _column(findings, 2), color=style.BLUE, label="as they are", **LINE)
    left.plot(robots, _column(findings, 3), color=style.VERMILION, label="after any one loss",
              **LINE)  # fmt: skip
    left.set(xlabel=style.terms().several)
    _shares(left, "with force closure")
    right.plot(robots, _column(findings, 5), color=style.VERMILION, **LINE)
    right.set(xlabel=style.terms().several)
    _shares(right, "left of the quality, median")


def _draw_together(axes: Any, findings: "Findings") -> None:
    """Draw how often, and by how much, robots placed together are better."""
    left, right = axes
    robots = _column(findings, 0)
    left.plot(robots, _column(findings, 2), color=style.GREEN, label="better by 1 % or more",
              **LINE)  # fmt: skip
    left.plot(robots, _column(findings, 5), color=style.ORANGE,
              label="force closure only together", **LINE)  # fmt: skip
    left.set(xlabel=f"{style.terms().several} before")
    _shares(left, "of swarms")
    right.plot(robots, _column(findings, 3), color=style.GREEN, **LINE)
    right.set(
        xlabel=f"{style.terms().several} before", ylabel="then better by, median", ylim=(0.0, None)
    )
    right.yaxis.set_major_formatter(PercentFormatter(1.0))


def _draw_gusts(axes: Any, findings: "Findings") -> None:
    """Draw how many runs hold, and how far the object goes, by their margin over the spread."""
    left, right = axes
    ends = [
        f"{row[1]:g}".replace("-", "\N{MINUS SIGN}") if math.isfinite(row[1]) else ""
        for row in findings.rows
    ]
    places = [index + 0.5 for index in range(len(ends))]
    look: dict[str, Any] = {"width": 0.86, "color": style.BLUE}
    left.bar(places, _column(findings, 3), **look)
    _shares(left, "held")
    for column, label, more in ((5, "90 % of runs", {"color": style.SKY}), (4, "median", {})):
        right.bar(places, _lengths(findings, column), label=label, **look | more)
    right.set(yscale="log", ylabel=f"largest error [{style.terms().length}]")
    right.legend(loc="upper right")
    for ax in axes:
        ax.set_xticks([index + 1.0 for index in range(len(ends))], ends)
        ax.set(xlabel="margin over the gusts' spread", xlim=(0.0, len(ends)))
        ax.tick_params(axis="x", labelsize=style.text(6.5))  # room for minus signs
        ax.grid(False, axis="x")


def _draw_story(axes: Any, findings: "Findings") -> None:
    """Draw within what how many runs stay."""
    parts = _column(findings, 0)
    turns = [math.degrees(turn) for turn in _column(findings, 2)]
    for ax, values, label in zip(
        axes,
        (_lengths(findings, 1), turns),
        (f"position [{style.terms().length}]", "heading [°]"),
        strict=True,
    ):
        ax.plot(values, parts, color=style.BLUE, **LINE)
        ax.set(xlabel=f"largest error of {label}", xlim=(0.0, None))
        ax.xaxis.set_major_locator(AutoLocator())
        _shares(ax, "of runs within")


KINDS: Final[dict[str, tuple[Callable[[Any, "Findings"], None], int]]] = {
    "sizes": (_draw_sizes, 2),
    "losses": (_draw_losses, 2),
    "together": (_draw_together, 2),
    "gusts": (_draw_gusts, 2),
    "story": (_draw_story, 2),
}
"""How each kind of study is drawn, and in how many panels."""
