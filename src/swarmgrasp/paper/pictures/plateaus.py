"""A landscape whose summit is a plateau."""

import numpy as np
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from swarmgrasp.pages.statements import newtons, percent
from swarmgrasp.paper.draws import FREE, NEWCOMERS, Task, pulling
from swarmgrasp.paper.pictures.axes import chart
from swarmgrasp.paper.studies.plateaus import EQUAL, landscape
from swarmgrasp.placement import place
from swarmgrasp.plot import style

CELLS = (240, 180)


def plateau(task: Task) -> Figure:
    """Draw the quality with a newcomer over contact and direction, and where it is the best."""
    swarm = pulling(task)
    values, _ = landscape(swarm, CELLS)
    best = place(swarm, NEWCOMERS[FREE])
    top = values >= best.quality * (1.0 - EQUAL)
    with style.settings():
        figure, (ax,) = chart(height=3.3)
        ax.grid(False)
        box = (0.0, swarm.outline.perimeter, -180.0, 180.0)
        image = ax.imshow(values.T, origin="lower", aspect="auto", cmap="cividis", extent=box)
        painted = np.zeros((*top.T.shape, 4))
        painted[top.T] = to_rgba(style.VERMILION)
        ax.imshow(painted, origin="lower", aspect="auto", extent=box, interpolation="nearest")
        ax.set(xlabel="contact, along the boundary from the lower left corner [m]")
        ax.set(ylabel="direction of the force [°]", yticks=range(-180, 181, 90))
        for corner in swarm.outline.corner_arc_lengths[1:-1]:
            ax.axvline(corner, color="white", linewidth=0.7, linestyle=(0, (2, 2)))
        bar = figure.colorbar(image, ax=ax)
        bar.set_label(f"quality of {len(swarm)} + 1 robots [N]")
        share = percent(float(np.mean(top)))
        label = f"equally good: {share} of the map, all {newtons(best.quality)}"
        figure.legend(
            handles=[Patch(color=style.VERMILION, label=label)], loc="outside lower center"
        )
    return figure
