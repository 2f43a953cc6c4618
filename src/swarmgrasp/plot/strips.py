"""Zones and no-go stretches as strips along the boundary."""

import itertools
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.plot import style
from swarmgrasp.plot.labels import Page

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
BOLLARD: Final[dict[str, Any]] = {
    "marker": "o",
    "linestyle": "none",
    "markersize": 6.5,
    "color": style.GREEN,
    "markeredgecolor": "white",
    "markeredgewidth": 0.8,
}
BARRED: Final[dict[str, Any]] = BOLLARD | {
    "marker": "X",
    "color": style.INK,
}

MOST_NAMES: Final = 16
"""With more bollards than this none is named."""


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
    """Draw zones green, no-go stretches striped, points as marks, and name the bollards.

    Parameters
    ----------
    page : Page
    outline : Outline
    zones, no_go : sequence of Stretch
    """
    for stretch in zones:
        path = stretch_path(outline, stretch)
        if stretch.is_point:
            page.ax.plot(*path[0], **BOLLARD, zorder=4.5, gid="bollard")
        else:
            _take(page, path)
            page.ax.plot(*path.T, **STRIP, color=style.GREEN, gid="zone")
    for stretch in no_go:
        path = stretch_path(outline, stretch)
        if stretch.is_point:
            page.ax.plot(*path[0], **BARRED, zorder=4.6, gid="no-go")
        else:
            _take(page, path)
            page.ax.plot(*path.T, **STRIP, color="white")
            page.ax.plot(*path.T, **STRIP, **_whole_stripes(page, path), gid="no-go")
    named = [z for z in zones if z.is_point and z.name and z.name not in outline.edge_names]
    for stretch in named if len(named) <= MOST_NAMES else []:
        point = stretch_path(outline, stretch)[0]
        inward = outline.at_point(point).inward
        page.label(stretch.name, [point], inward, fontsize=7.0, color=style.GREEN)


def _take(page: Page, path: NDArray[np.float64]) -> None:
    """Keep labels off a strip."""
    for start, end in itertools.pairwise(path):
        page.keep_clear(start, end, breadth=STRIP["linewidth"])


def _whole_stripes(page: Page, path: NDArray[np.float64]) -> dict[str, Any]:
    """Return the look of stripes that begin and end with a whole one."""
    steps = np.diff(page.ax.transData.transform(path), axis=0)
    length = float(np.hypot(*steps.T).sum()) / page.point_size / STRIP["linewidth"]
    stripe = length / (2 * max(1, round(0.5 * length / STRIPE)) - 1)
    return STRIPES | {"linestyle": (0, (stripe, stripe))}
