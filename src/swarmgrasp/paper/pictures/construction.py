"""Fig. 2 in kind: a wrench set that grows by one robot's segment at a time."""

import math
from typing import Any, Final, cast

import numpy as np
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import (  # type: ignore[import-untyped]
    Line3DCollection,
    Poly3DCollection,
)
from mpl_toolkits.mplot3d.axes3d import Axes3D  # type: ignore[import-untyped]
from numpy.typing import NDArray

from swarmgrasp.plot import style, written
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.plot.polygons import masked
from swarmgrasp.quality import quality
from swarmgrasp.swarm import Swarm
from swarmgrasp.wrench_set import WrenchSet
from swarmgrasp.wrench_set.mesh import Mesh

Vectors = NDArray[np.float64]

COLUMNS: Final = 3
EYE: Final = (22.0, -62.0)
"""Elevation and azimuth [deg], the same for all panels."""
ZOOM: Final = 0.9


def construction(steps: list[Swarm]) -> Figure:
    """Draw the wrench sets of growing swarms, each in the next, and the largest ball inside.

    Parameters
    ----------
    steps : list of Swarm
        Each with one robot more than the one before.
    """
    meshes = [WrenchSet(step).mesh() for step in steps]
    scale = steps[-1].scale
    corners = np.vstack([meshes[-1].vertices * scale, np.zeros((1, 3))])
    low, high = corners.min(axis=0), corners.max(axis=0)
    rows = math.ceil(len(steps) / COLUMNS)
    with style.settings():
        figure = Drawn(figsize=(style.WIDTH, 1.75 * rows + 0.3))
        for k, step in enumerate(steps):
            look: dict[str, Any] = {"projection": "3d", "proj_type": "ortho"}
            ax = cast(
                Axes3D, figure.add_subplot(rows, COLUMNS, k + 1, computed_zorder=False, **look)
            )
            value = quality(step).value
            _draw_ball(ax, value)
            _draw_set(ax, meshes[k], meshes[max(k - 1, 0)], scale)
            arm = np.vstack([np.zeros(3), step.scaled_generators[-1]])
            ax.plot(*arm.T, color=style.VERMILION, linewidth=2.0, zorder=5)
            ax.plot([0.0], [0.0], [0.0], "+", color=style.INK, markersize=6.0, zorder=6)
            ax.view_init(*EYE)
            ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
            ax.set_box_aspect(tuple(high - low), zoom=ZOOM)
            ax.set_title(f"{written.count(k + 1)}: quality {written.number(value)} N", pad=-2.0)
            _frame(ax)
        figure.subplots_adjust(0.0, 0.05, 0.95, 0.94, 0.03, 0.06)
        metric = f"Metric: {steps[-1].metric_sentence}."
        figure.text(0.02, 0.012, metric, fontsize=7.0, color=style.GREY)
    return figure


def _frame(ax: Axes3D) -> None:
    """Leave of the axes only what tells the directions."""
    ax.patch.set_visible(False)  # it would cover the panel before
    for axis, name in ((ax.xaxis, "surge"), (ax.yaxis, "sway"), (ax.zaxis, "torque / L")):
        axis.set_pane_color((1.0, 1.0, 1.0, 0.0))
        axis.set_ticklabels([])
        axis.set_tick_params(length=0.0)
        axis.set_label_text(name, fontsize=7.0)
        axis.labelpad = -13.0


def _draw_ball(ax: Axes3D, radius: float) -> None:
    """Draw the largest ball about the origin, unless it is none."""
    if radius > 0.0:
        tilt, turn = np.meshgrid(np.linspace(0.0, math.pi, 25), np.linspace(0.0, math.tau, 49))
        ball = np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt)
        ax.plot_surface(*(radius * part for part in ball), color=style.SKY, linewidth=0.0, zorder=1)


def _draw_set(ax: Axes3D, mesh: Mesh, before: Mesh, scale: Vectors) -> None:
    """Draw a wrench set as glass, and the one before in it by its edges."""
    faces = [mesh.vertices[list(face)] * scale for face in mesh.faces]
    if faces:
        glass = {"facecolor": style.GREY, "alpha": 0.12, "edgecolor": "none", "zorder": 2}
        ax.add_collection3d(Poly3DCollection(masked(faces), **glass))
    for one, colour, width in ((mesh, style.GREY, 0.6), (before, style.INK, 0.9)):
        edges = [one.vertices[list(edge)] * scale for edge in one.edges]
        ax.add_collection3d(Line3DCollection(edges, colors=colour, linewidths=width, zorder=3))
