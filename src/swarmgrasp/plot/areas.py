"""Zones that are areas inside the object, for mounted newcomers."""

import itertools
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from matplotlib.colors import to_rgba
from matplotlib.patches import Polygon

from swarmgrasp.plot import style
from swarmgrasp.plot.labels import Page
from swarmgrasp.swarm import Zone

AREA: Final[dict[str, Any]] = {
    "facecolor": to_rgba(style.GREEN, 0.22),
    "edgecolor": style.GREEN,
    "linewidth": 1.4,
}
"""An area; one of two corners is a line."""

SPOT: Final[dict[str, Any]] = {
    "marker": "o",
    "linestyle": "none",
    "markersize": 6.5,
    "color": style.GREEN,
    "markeredgecolor": "white",
    "markeredgewidth": 0.8,
}
"""An area of one corner, or a bollard."""


def draw_areas(page: Page, zones: Sequence[Zone]) -> None:
    """Draw areas green, and those that are single spots as dots.

    Parameters
    ----------
    page : Page
    zones : sequence of Zone
        That have an area.
    """
    for corners in (np.array(zone.area) for zone in zones):
        if len(corners) == 1:
            page.ax.plot(*corners[0], **SPOT, zorder=4.5, gid="spot")
            page.keep_clear(corners[0], corners[0], breadth=SPOT["markersize"])
            continue
        page.ax.add_patch(Polygon(corners, **AREA, zorder=2.5, gid="area"))
        for start, end in itertools.pairwise(np.vstack([corners, corners[:1]])):
            page.keep_clear(start, end)


def name_areas(page: Page, zones: Sequence[Zone]) -> None:
    """Name areas, in them or beside them, where there is room.

    Parameters
    ----------
    page : Page
    zones : sequence of Zone
        That have an area.
    """
    look: dict[str, Any] = {"fontsize": 7.0, "color": style.GREEN, "gid": "area-label"}
    for zone in zones:
        corners = np.array(zone.area)
        spots = np.vstack([corners.mean(axis=0), corners])
        if zone.name:
            page.label(zone.name, spots, np.pi / 2, optional=True, **look)
