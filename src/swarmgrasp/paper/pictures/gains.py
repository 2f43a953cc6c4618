"""Fig. 4 and Fig. 5 in kind: what the best newcomer brings, over many draws."""

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from swarmgrasp.paper.draws import FREE, NORMAL
from swarmgrasp.paper.pictures.axes import DASHES, below, chart
from swarmgrasp.paper.published import Example
from swarmgrasp.paper.studies.gains import Gains
from swarmgrasp.plot import style

PAPER: dict[str, Any] = {
    "marker": "*", "markersize": 13.0, "color": style.VERMILION, "markeredgecolor": "white",
    "linestyle": "none", "zorder": 5,
}  # fmt: skip
SHOWN: dict[str, Any] = {
    "marker": "o", "markersize": 9.0, "markerfacecolor": "none", "color": style.INK,
    "linestyle": "none", "zorder": 4,
}  # fmt: skip


def gains(found: Gains, example: Example) -> Figure:
    """Draw before and after of all draws, with the paper's example and the draw shown.

    Parameters
    ----------
    found : Gains
    example : Example
        With quality 0 before, only draws like it are counted.
    """
    with style.settings():
        return (_shares if example.before == 0.0 else _points)(found, example)


def _shares(found: Gains, example: Example) -> Figure:
    """Draw the share of the draws with quality 0 that a newcomer brings no further than so far."""
    figure, (ax,) = chart()
    none = found.before == 0.0
    share = np.arange(1, none.sum() + 1) / none.sum()
    for kind in (NORMAL, FREE):
        after = np.sort(found.after[kind][none])
        label = f"newcomer {kind}"
        ax.step(
            [0.0, *after], [0.0, *(100.0 * share)], where="post",
            color=style.BLUE, linestyle=DASHES[kind], label=label,
        )  # fmt: skip
    after = np.sort(found.after[NORMAL][none])
    height = 100.0 * float(np.mean(after <= example.after))
    label = f"{example.figure} of the paper: {example.before:g} → {example.after:g} N"
    ax.plot([example.after], [height], label=label, **PAPER)
    ax.set(xlabel="quality with the best newcomer, at most [N]", xlim=(-0.02, None))
    ax.set(ylabel=f"share of {none.sum()} such draws [%]", ylim=(0.0, 102.0))
    below(figure, ax, 2)
    return figure


def _points(found: Gains, example: Example) -> Figure:
    """Draw quality after over quality before, a point for each draw."""
    figure, (ax,) = chart(height=3.9)
    before, after = found.before, found.after[NORMAL]
    ax.plot(before, after, ".", color=style.BLUE, markersize=3.0, alpha=0.45, label="one draw")
    ends = np.array([0.0, max(after.max(), example.after)])
    ax.plot(ends, ends, color=style.GREY, linewidth=0.9, label="no gain")
    k = found.shown(example)
    label = f"shown below: {before[k]:.2f} → {after[k]:.2f} N"
    ax.plot([before[k]], [after[k]], label=label, **SHOWN)
    label = f"{example.figure} of the paper: {example.before:g} → {example.after:g} N"
    ax.plot([example.before], [example.after], label=label, **PAPER)
    ax.set(xlabel=f"quality of {found.robots} robots [N]")
    ax.set(ylabel="with the best newcomer along the normal [N]")
    below(figure, ax, 2)
    return figure
