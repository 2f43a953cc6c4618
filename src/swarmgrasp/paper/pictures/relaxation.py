"""What the paper's relaxation promises in vain, and what its last step loses."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from swarmgrasp.paper.draws import NEWCOMERS
from swarmgrasp.paper.pictures.axes import COLOURS, DASHES, below, chart
from swarmgrasp.paper.studies.relaxation import Relaxations
from swarmgrasp.plot import style


def relaxation(found: Relaxations) -> Figure:
    """Draw, over the draws in order, the gain promised in vain and the gain lost."""
    with style.settings():
        figure, (promised, lost) = chart(2, height=3.6)
        for robots, kinds in found.items():
            for kind in NEWCOMERS:
                label = f"{robots} robots, {kind}"
                look = {"color": COLOURS[robots], "linestyle": DASHES[kind], "label": label}
                _draw(promised, kinds[kind].phantom, look)
                _draw(lost, kinds[kind].lost, look)
        promised.set(ylabel="gain promised in vain [%]")
        lost.set(ylabel="gain lost in the end [%]")
        for ax in (promised, lost):
            ax.set(xlabel="share of the draws [%]", xlim=(0, 100), ylim=(0, 102))
        below(figure, promised, 2)
    return figure


def _draw(ax: Axes, shares: NDArray[np.float64], look: dict[str, Any]) -> None:
    """Draw shares from the largest to the smallest."""
    order = np.sort(shares)[::-1]
    part = 100.0 * np.arange(len(order) + 1) / len(order)
    ax.step(part, 100.0 * np.append(order, order[-1]), where="post", linewidth=1.3, **look)
