"""Zones and no-go stretches as strips along the boundary, and zones in the legend."""

import itertools
import math
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.plot import style
from swarmgrasp.plot.areas import AREA, SPOT
from swarmgrasp.plot.labels import Page
from swarmgrasp.swarm import Zone

STRIP: Final[dict[str, Any]] = {
    "linewidth": 9.0,
    "solid_capstyle": "butt",
    "dash_capstyle": "butt",
    "solid_joinstyle": "miter",
    "zorder": 1.5,  # below the object, which covers the inner half
}
STRIPE: Final = 0.3
"""Breadth of a no-go stripe and of the gap to the next, relative to the strip's width."""

STRIPES: Final[dict[str, Any]] = {"color": style.INK, "linestyle": (0, (STRIPE, STRIPE))}

MOST_NAMES: Final = 16
"""With more bollards, or more strips, than this none is named."""

REACH: Final = 36.0
"""Farthest a name is written from a strip that is too short for it [pt]."""


def stretch_path(outline: Outline, stretch: Stretch) -> NDArray[np.float64]:
    """Return a stretch of the boundary as a line through its corners, (k, 2) [m, m]."""
    around = outline.perimeter
    span = stretch.end - stretch.start
    if span < 0.0:
        span += around
    ahead = np.sort((outline.corner_arc_lengths[:-1] - stretch.start) % around)
    passed = ahead[(ahead > outline.tolerance) & (ahead < span - outline.tolerance)]
    stops = [0.0, *passed, span]
    return np.array(
        [outline.at_arc_length(float((stretch.start + stop) % around)).point for stop in stops]
    )


def draw_strips(
    page: Page, outline: Outline, zones: Sequence[Stretch], no_go: Sequence[Stretch]
) -> None:
    """Draw zones green, bollards as dots and no-go stretches striped.

    Parameters
    ----------
    page : Page
    outline : Outline
    zones, no_go : sequence of Stretch
    """
    for kind, stretch in _kinds(zones, no_go):
        path = stretch_path(outline, stretch)
        if kind == "bollard":
            page.ax.plot(*path[0], **SPOT, zorder=4.5, gid=kind)
            page.keep_clear(path[0], path[0], breadth=SPOT["markersize"])
            continue
        for start, end in itertools.pairwise(path):
            page.keep_clear(start, end, breadth=STRIP["linewidth"])
        page.ax.plot(*path.T, **STRIP, color="white" if kind == "no-go" else style.GREEN, gid=kind)
        if kind == "no-go":
            page.ax.plot(*path.T, **STRIP, **_whole_stripes(page, path))


def name_bollards(page: Page, outline: Outline, zones: Sequence[Stretch]) -> None:
    """Name the zones that are points, unless there are too many.

    Parameters
    ----------
    page : Page
    outline : Outline
    zones : sequence of Stretch
    """
    named = [zone for zone in zones if zone.is_point and zone.name not in _edge_names(outline)]
    for zone in named if len(named) <= MOST_NAMES else []:
        contact = outline.at_arc_length(zone.start)
        look: dict[str, Any] = {"fontsize": 7.0, "color": style.GREEN, "gid": "bollard-label"}
        page.label(zone.name, [contact.point], contact.inward, **look)


def name_strips(
    page: Page, outline: Outline, zones: Sequence[Stretch], no_go: Sequence[Stretch]
) -> None:
    """Name no-go stretches, and zones that are not points, where there is room.

    A name stands along its strip, inside the object; one too long for that stands near by.
    Zones called after their edge go without: the edge has its own name.

    Parameters
    ----------
    page : Page
    outline : Outline
    zones, no_go : sequence of Stretch
    """
    edges = _edge_names(outline)
    kinds = [pair for pair in _kinds((), no_go) + _kinds(zones, ()) if pair[0] != "bollard"]
    named = [(kind, stretch) for kind, stretch in kinds if stretch.name not in edges]
    for kind, stretch in named if len(named) <= MOST_NAMES else []:
        path = stretch_path(outline, stretch)
        longest = int(np.argmax(np.hypot(*np.diff(path, axis=0).T)))
        start, end = path[longest : longest + 2]
        colour = style.INK if kind == "no-go" else style.GREEN
        look: dict[str, Any] = {"fontsize": 7.0, "color": colour, "gid": f"{kind}-label"}
        if page.label_along(stretch.name, (start, end), **look) is None:
            middle = 0.5 * (start + end)
            outward = outline.at_point(middle).inward + math.pi
            page.label(stretch.name, [middle], outward, optional=True, reach=REACH, **look)


def zone_entries(zones: Sequence[Zone], no_go: Sequence[Stretch]) -> list[Any]:
    """Return the legend entries of zones and no-go stretches."""
    strip: dict[str, Any] = STRIP | {"linewidth": 6.0}
    stretches = [zone.stretch for zone in zones if zone.stretch is not None]
    areas = [zone.area for zone in zones if zone.area is not None]
    entries: list[Any] = []
    if any(not stretch.is_point for stretch in stretches):
        entries.append(Line2D([], [], **strip, color=style.GREEN, label="zone"))
    if any(len(area) > 1 for area in areas):
        entries.append(Patch(**AREA, label="zone inside"))
    if any(stretch.is_point for stretch in stretches):
        entries.append(Line2D([], [], **SPOT, label="bollard"))
    if any(len(area) == 1 for area in areas):
        entries.append(Line2D([], [], **SPOT, label="spot inside"))
    if no_go:
        entries.append(Line2D([], [], **strip, **STRIPES, label="no-go"))
    return entries


def _edge_names(outline: Outline) -> set[str]:
    """Return the names that stretches of edges have when none is given, and no name."""
    return {"", *(outline.edge_label(edge) for edge in range(len(outline)))}


def _kinds(zones: Sequence[Stretch], no_go: Sequence[Stretch]) -> list[tuple[str, Stretch]]:
    """Return every stretch with its kind, "zone", "bollard" or "no-go"."""
    kinds = [("bollard" if zone.is_point else "zone", zone) for zone in zones]
    return kinds + [("no-go", stretch) for stretch in no_go]


def _whole_stripes(page: Page, path: NDArray[np.float64]) -> dict[str, Any]:
    """Return the look of stripes that begin and end with a whole one."""
    steps = np.diff(page.ax.transData.transform(path), axis=0)
    length = float(np.hypot(*steps.T).sum()) / page.point_size / STRIP["linewidth"]
    stripe = length / (2 * max(1, round(0.5 * length / STRIPE)) - 1)
    return STRIPES | {"linestyle": (0, (stripe, stripe))}
