"""Axes and legends that the charts share."""

from typing import Any, Final

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swarmgrasp.paper.draws import FREE, NORMAL
from swarmgrasp.plot import style
from swarmgrasp.plot.figure import Drawn

COLOURS: Final = {5: style.ORANGE, 15: style.VERMILION, 25: style.BLUE}
"""Of each number of robots."""

DASHES: Final[dict[str, Any]] = {FREE: "-", NORMAL: (0, (4, 2))}
"""Of each kind of newcomer."""


def chart(panels: int = 1, height: float = 3.1) -> tuple[Figure, list[Axes]]:
    """Return a figure and its panels side by side, without frames above and to the right."""
    figure = Drawn(figsize=(style.WIDTH, height), layout="constrained")
    axes = [figure.add_subplot(1, panels, k + 1) for k in range(panels)]
    for ax in axes:
        ax.spines[["top", "right"]].set_visible(False)
        ax.grid(True)
        ax.set_axisbelow(True)
    return figure, axes


def below(figure: Figure, ax: Axes, columns: int) -> None:
    """Put the legend of one panel below all of them."""
    handles, labels = ax.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=columns, columnspacing=1.4)
