"""The curve: final quality, and what is lost at one decision, against what is communicated."""

from typing import Any, Final

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swarmgrasp.agents.knowledge import Curve
from swarmgrasp.plot import style
from swarmgrasp.plot.figure import Drawn

KINDS: Final[dict[str, dict[str, Any]]] = {
    "push": {"color": style.BLUE, "marker": "o"},
    "free": {"color": style.ORANGE, "marker": "s"},
    "steer": {"color": style.GREEN, "marker": "^"},
}
"""How the median of each kind of robot is drawn."""
LINE = 0.24
"""Height of a line [in]."""


def knowledge_curve(curve: Curve) -> Figure:
    """Draw a line for each knowledge: what it is worth, and what T30 says that it costs.

    On the left the final quality as a share of that with everything known: the range from 10 to
    90 % of all swarms, their median, and those of each kind of robot. On the right how far a
    decision falls short of the best place, and how far it may at most, in the mean.

    Parameters
    ----------
    curve : Curve
    """
    lines = curve.every.lines[::-1]
    with style.settings():
        figure = Drawn(figsize=(style.WIDTH, LINE * len(lines) + 1.3), layout="constrained")
        left, right = figure.subplots(1, 2, sharey=True, width_ratios=(3, 2))
        for ax in (left, right):
            ax.spines[["top", "right", "left"]].set_visible(False)
            ax.grid(True, axis="x")
            ax.set_axisbelow(True)
            ax.tick_params(axis="y", length=0.0)
        left.set_yticks(range(len(lines)), [line.known for line in lines])
        _draw_shares(left, curve)
        _draw_bounds(right, curve)
        handles, labels = left.get_legend_handles_labels()
        more = right.get_legend_handles_labels()
        figure.legend(
            handles + more[0], labels + more[1], loc="outside lower center", ncols=3,
            columnspacing=1.4,
        )  # fmt: skip
    return figure


def _draw_shares(ax: Axes, curve: Curve) -> None:
    """Draw what each knowledge is worth."""
    lines = curve.every.lines[::-1]
    for row, line in enumerate(lines):
        label = "10 to 90 % of all swarms" if row == 0 else None
        ax.plot([line.low, line.high], [row, row], color="#C9CED3", linewidth=6.0,
                solid_capstyle="butt", label=label)  # fmt: skip
    rows = {line.known: row for row, line in enumerate(lines)}
    for kind in curve.kinds:
        ax.plot(
            [line.median for line in kind.lines], [rows[line.known] for line in kind.lines],
            linestyle="none", markersize=4.0, markeredgecolor="white", markeredgewidth=0.4,
            label=f"median, {kind.of}", **KINDS[kind.of],
        )  # fmt: skip
    medians = [line.median for line in lines]
    ax.plot(medians, range(len(lines)), linestyle="none", marker="|", markersize=9.0,
            markeredgewidth=1.6, color=style.INK, label="median of all")  # fmt: skip
    ax.axvline(1.0, color=style.GREY, linewidth=0.8)
    ax.set(xlabel="share of the quality\nwith everything known", xlim=(0.0, None))


def _draw_bounds(ax: Axes, curve: Curve) -> None:
    """Draw what a decision costs, and what it may."""
    judged = [(row, line) for row, line in enumerate(curve.every.lines[::-1]) if line.decisions]
    rows = [row for row, _ in judged]
    ax.plot([line.regret for _, line in judged], rows, linestyle="none", marker="o",
            markersize=4.0, color=style.VERMILION, label="short of the best place")  # fmt: skip
    ax.plot([line.bound for _, line in judged], rows, linestyle="none", marker="|",
            markersize=7.0, markeredgewidth=1.4, color=style.PURPLE,
            label="at most, by T30")  # fmt: skip
    ax.set(xlabel="one decision\n[N]", xlim=(0.0, None))
