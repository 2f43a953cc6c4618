"""Polar diagrams of winds: the bow up, bearings clockwise, the radius a speed.

Bearings are true ones where the file has a heading, and else count from the bow.
"""

import math
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from matplotlib.text import Text
from numpy.typing import NDArray

from swarmgrasp.environment import KNOT
from swarmgrasp.plot import style, written
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.plot.labels import Page

Vector = NDArray[np.float64]

MOST_SHOWN: Final = 100.0
"""Radius of the largest diagram [kn]: what is more is cut there, as is usual."""
MOST_RINGS: Final = 5
FINE: Final = 12
"""Points from one bearing to the next, for the cut at the outer ring to be round."""
LONGEST_TITLE: Final = 56
"""Letters of a title."""
ABOVE: Final = 0.36
"""Height of the title [in]."""
SIDE: Final = 4.5
"""Width and height of the axes [in]."""
SMALLEST: Final = 0.7
"""Size of the text in narrow figures over that in others."""
ROOM: Final = 1.16
"""Half width of the axes over the outer ring's radius: bearings are written outside the ring."""
SPOKES: Final = range(0, 360, 30)
KNOTS_AT: Final = 45.0
OTHERS_AT: Final = 315.0
"""Bearings [deg] near which the rings are labelled."""
TRIED: Final = tuple(float(sign * off) for off in range(0, 73, 4) for sign in (1, -1))
"""Degrees off them that are tried."""
OUTSIDE: Final = 3.0
"""Distance [pt] of the bearings from the outer ring."""
SIDEWAYS: Final = 0.75
"""Component to the side from which on long words are written along the ring."""
CLEAR: Final = 1.5
"""Distance [pt] of the labels from curves."""
QUARTERS: Final = {0: "bow", 90: "starboard", 180: "stern", 270: "port"}
COMPASS: Final = {0: "N", 90: "E", 180: "S", 270: "W"}
"""What bearings are called from the bow, and true ones."""


def new_axes(below: float) -> Axes:
    """Return square axes in a figure with room for a title, and for a caption of a height [in]."""
    width = style.width()
    side = SIDE * min(1.0, width / style.WIDTH)
    height = ABOVE + side + below
    figure = Drawn(figsize=(width, height))
    left = 0.5 * (width - side)
    return figure.add_axes((left / width, below / height, side / width, side / height))


def frame(ax: Axes, top: float) -> Page:
    """Set axes in knots, the bow up and starboard on the right."""
    reach = ROOM * top
    ax.set(xlim=(-reach, reach), ylim=(-reach, reach))
    ax.set_aspect("equal", adjustable="box")
    ax.set_axis_off()
    return Page(ax)


def rings(fastest: float) -> tuple[float, float]:
    """Return the distance of the rings and the radius of the outer one [kn], for a wind [m/s]."""
    most = min(MOST_SHOWN, fastest / KNOT) or 1.0
    step = next(
        factor * 10.0**power
        for power in range(math.floor(math.log10(most)) - 1, 3)
        for factor in (1.0, 2.0, 5.0)
        if most <= MOST_RINGS * factor * 10.0**power * (1.0 + 1e-9)
    )
    return step, step * math.ceil(most / step * (1.0 - 1e-9))


def points(bearings: Vector, knots: Vector) -> Vector:
    """Return where bearings [rad] and speeds [kn] are drawn, (m, 2)."""
    return np.column_stack([knots * np.sin(bearings), knots * np.cos(bearings)])


def draw_rings(page: Page, step: float, top: float) -> None:
    """Draw rings of equal wind and spokes of equal bearing, and write the bearings."""
    ax = page.ax
    for radius in np.arange(step, top + 0.5 * step, step):
        last = radius > top - 0.5 * step
        colour, width = (style.GREY, 0.8) if last else ("#CFCFCF", 0.6)
        ax.add_patch(
            Circle((0.0, 0.0), radius, fill=False, color=colour, linewidth=width, zorder=1)
        )
    bow, words = quarters()
    for bearing in SPOKES:
        way = points(np.radians([bearing - bow]), np.ones(1))[0]
        ax.plot(*np.outer(way, [0.0, top]), color="#DADADA", linewidth=0.5, zorder=1)
        word = words.get(bearing)
        text = f"{bearing}°" if word is None else f"{bearing}° {word}"
        is_long = word is not None and words is QUARTERS
        beside = math.copysign(90.0, -way[0]) if is_long and abs(way[0]) > SIDEWAYS else 0.0
        artist = ax.annotate(
            text, top * way, (0.0, 0.0), textcoords="offset points", ha="center", va="center",
            rotation=beside, fontsize=small(8.0), color=style.INK if word else style.GREY,
            annotation_clip=False, gid="bearing",
        )  # fmt: skip
        half = 0.5 * np.array(artist.get_window_extent().size) / page.point_size
        artist.xyann = ((OUTSIDE + np.abs(way) @ half) * way).tolist()
        page.boxes.append(artist.get_window_extent().extents)


def quarters() -> tuple[float, dict[int, str]]:
    """Return the bearing of the bow [deg] as bearings are told, and what four of them are called.

    Examples
    --------
    >>> quarters()
    (0.0, {0: 'bow', 90: 'starboard', 180: 'stern', 270: 'port'})
    """
    is_true = style.terms().frame.heading is not None
    return written.telling().from_degrees(0.0), COMPASS if is_true else QUARTERS


def from_words() -> str:
    """Say how bearings are told.

    Examples
    --------
    >>> from swarmgrasp.terms import Frame, Terms
    >>> from_words()
    'clockwise from the bow'
    >>> with style.settings(terms=Terms(frame=Frame(heading=math.pi / 6))):
    ...     from_words()
    'true; bow up, at 30°'
    """
    bow, words = quarters()
    return f"true; bow up, at {bow:.4g}°" if words is COMPASS else "clockwise from the bow"


def label_rings(page: Page, step: float, top: float) -> None:
    """Write the speeds on the rings: knots right of the bow, the other unit left of it."""
    size, name = written.other_speed()
    for radius in np.arange(step, top + 0.5 * step, step).tolist():
        write_ring(page, radius, f"{radius:g} kn", KNOTS_AT, "left")
        write_ring(
            page, radius, f"{written.number(radius * KNOT / size)} {name}", OTHERS_AT, "right"
        )


def write_ring(page: Page, radius: float, text: str, bearing: float, side: str) -> None:
    """Write on a ring what it stands for, near a bearing [deg], if it is clear of curves there."""
    back = {"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.8}
    artist = page.ax.text(
        0.0, 0.0, text, ha=side, va="center", fontsize=small(7.0), color=style.GREY, bbox=back,
        zorder=2.5, gid="ring",
    )  # fmt: skip
    prices = []
    for off in TRIED:
        artist.set_position(_on_ring(radius, bearing + off))
        prices.append(_hidden(page, artist) + 1e-3 * abs(off))
    if min(prices) >= 1.0:  # the other rings tell, being as far apart
        artist.remove()
        return
    artist.set_position(_on_ring(radius, bearing + TRIED[int(np.argmin(prices))]))
    page.boxes.append(artist.get_window_extent().extents)


def _on_ring(radius: float, bearing: float) -> tuple[float, float]:
    """Return where on a ring a bearing [deg] is."""
    x, y = points(np.radians([bearing]), np.array([radius]))[0].tolist()
    return x, y


def _hidden(page: Page, artist: Text) -> float:
    """Return how much of what is drawn a text would hide: samples of lines, and other labels."""
    left, low, right, high = artist.get_window_extent().extents
    room = CLEAR * page.point_size
    found = 0.0
    for line in page.points:
        x, y = line.T
        is_in = (x > left - room) & (x < right + room) & (y > low - room) & (y < high + room)
        found += float(is_in.sum())
    return found + 10.0 * sum(
        left < box[2] and box[0] < right and low < box[3] and box[1] < high for box in page.boxes
    )


def envelope(bearings: Vector, speeds: Vector, top: float) -> Vector:
    """Return an envelope as a closed line (k, 2) [kn], straight between bearings, cut at `top`."""
    return closed(bearings, speeds / KNOT, top)


def closed(bearings: Vector, radii: Vector, top: float) -> Vector:
    """Return radii at bearings [rad] as a closed line (k, 2), straight between, cut at `top`."""
    bearings, at = np.unique(np.mod(bearings, 2.0 * math.pi), return_index=True)
    corners = points(bearings, radii[at])
    shares = np.linspace(0.0, 1.0, FINE, endpoint=False)[:, None]
    sides = zip(corners, np.roll(corners, -1, axis=0), strict=True)
    line = np.concatenate([*(p + shares * (q - p) for p, q in sides), corners[:1]])
    reached = np.maximum(np.hypot(*line.T), 1e-12 * top)
    return np.asarray(line * np.minimum(1.0, top / reached)[:, None])


def within(line: Vector, top: float) -> Vector:
    """Return a line with nothing where it was cut at `top`: there no limit is known."""
    is_cut = np.hypot(*line.T) >= top * (1.0 - 1e-9)
    return np.where(is_cut[:, None], np.nan, line)


def write(figure: Figure, text: str, x: float, y: float, **look: Any) -> None:
    """Write text at a place [in] of a page, nearer to the left on one that is narrow."""
    height = figure.get_size_inches()[1]
    look |= {"size": small(look["size"])}
    figure.text(across(x), y / height, text, va="baseline", **look)


def across(x: float) -> float:
    """Return a place [in] on a page of the usual width as a share of the present one's."""
    return x / max(style.WIDTH, style.width())


def small(size: float) -> float:
    """Return a size of text [pt] in columns of the present width."""
    return size * max(SMALLEST, min(1.0, style.width() / style.WIDTH))


def cut(text: str, most: int) -> str:
    """Cut text to so many letters."""
    return text if len(text) <= most else f"{text[: most - 1]}…"
