"""The plan view of sensitivities: which way each robot should shift or turn."""

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from swarmgrasp.outline import Outline
from swarmgrasp.plot import style, written
from swarmgrasp.plot.arrows import ArrowEntry, Arrows
from swarmgrasp.plot.direction import Pointer
from swarmgrasp.plot.labels import Page
from swarmgrasp.plot.plan import draw_object, in_view, label_edges
from swarmgrasp.plot.robots import LOOKS, draw_robots, label_robots
from swarmgrasp.plot.sheet import Caption, draw_force_key, frame, new_axes, write_caption
from swarmgrasp.plot.weakest import label_weakest, weakest_pointer
from swarmgrasp.quality import Sensitivities
from swarmgrasp.swarm import Robot
from swarmgrasp.terms import SI, Terms
from swarmgrasp.units import LENGTHS

Vectors = NDArray[np.float64]

LONGEST: Final = 24.0
"""Length of the longest bar and of the longest arc [pt], of a few robots."""

FEW: Final = 8
"""With more robots than this the arcs are shorter, down to a half."""

BREADTH: Final = 3.2
"""Of bars and arcs [pt]."""

HEAD: Final = 1.5 * BREADTH
"""Length of a point [pt]."""

BEYOND: Final = 6.0
"""How far beyond an arrow's end an arc is drawn [pt]."""

APART: Final = 1.6
CLEAR: Final = 3.4
"""Between the two halves of an arc, and of a bar, for either [pt]."""

LANES: Final = 4
LANE: Final = 6.0
"""Bars and arcs that would meet others run in further lanes, so far apart [pt]."""

LEAST: Final = 0.01
"""Share of the longest below which a half is not drawn."""

COLOURS: Final = {True: style.GREEN, False: style.VERMILION}
"""Of halves by whether the quality rises that way."""

ROOM: Final = 0.05
"""For the arcs beyond the arrows' ends, relative to the picture's width."""


@dataclass(frozen=True)
class _Swung(Arrows):
    """Arrows with arcs beyond their outer ends."""

    beyond: float = 0.0
    """How far the labels stand from the arrows' ends [m]."""

    def ends(self, robot: Robot) -> tuple[Vectors, Vectors]:
        """Return tail and tip of an arrow, each (2,) [m, m], the outer one moved outward."""
        tail, tip = super().ends(robot)
        way = tip - tail
        way *= self.beyond / max(float(np.hypot(*way)), 1e-300)
        if np.array_equal(tip, robot.contact):
            return tail - way, tip
        return tail, tip + way

    def box(self) -> tuple[Vectors, Vectors]:
        """Return the corners of the box round all that is drawn, each (2,) [m, m]."""
        low, high = super().box()
        room = ROOM * float((high - low).max())
        return low - room, high + room


def sensitivity_plan(
    found: Sensitivities,
    *,
    terms: Terms = SI,
    title: str = "",
    width: float = style.WIDTH,
    ax: Axes | None = None,
) -> Figure:
    """Draw the object from above, and how the quality changes when one robot moves.

    Each robot has a bar along the boundary, half of it for a contact shifted the one way and
    half for the other, and an arc round the contact for a force turned the one way or the
    other. A half is as long as the quality changes per unit of length, or per degree; green and
    pointed where it rises.

    Parameters
    ----------
    found : Sensitivities
    terms : Terms
        The units, the frame and the words in which it is told.
    title : str
        Such as the name of the object.
    width : float [in]
        Of a figure of its own.
    ax : Axes, optional
        Draw here, at its present size, instead of in a figure of its own.

    Returns
    -------
    Figure
    """
    swarm = found.swarm
    arrows = _Swung(swarm.outline, swarm.robots)
    with style.settings(width, terms):
        limit = None
        if len(swarm) and in_view(arrows):
            limit = weakest_pointer(arrows, swarm, found.quality)
        caption = _caption(found, arrows, limit, title)
        alone = ax is None
        ax = new_axes(arrows, caption) if ax is None else ax
        page = frame(ax, arrows, has_table=alone)
        draw_object(page, swarm.outline)
        draw_robots(page, arrows, frozenset())
        _draw_bars(page, found)
        _draw_arcs(page, found, arrows)
        if limit is not None:
            label_weakest(page, swarm, found.quality, limit.draw(page, "weakest"))
        label_robots(page, replace(arrows, beyond=(BEYOND + BREADTH) * _metres(page)))
        label_edges(page, swarm.outline)
        draw_force_key(page, arrows)
        write_caption(page, caption)
        return cast(Figure, ax.get_figure(root=True))


def _draw_bars(page: Page, found: Sensitivities) -> None:
    """Draw the bars on the boundary, or a little inside it where they would meet."""
    outline, slopes, metres = found.swarm.outline, found.contact, _metres(page)
    arcs = outline.nearest(found.swarm.contacts)[1] if len(slopes) else np.zeros(0)
    taken: list[Vectors] = []
    for index, sizes in _sizes(slopes, _fitting(slopes, arcs / metres)).items():
        arc = float(arcs[index])
        lines = [
            _along(outline, arc, sign * metres * np.array([CLEAR, CLEAR + size]))
            for sign, size in zip((-1.0, 1.0), sizes, strict=True)
        ]
        step = metres * LANE * _bearing(outline.at_arc_length(arc).inward)

        def halves(lane: int, lines: list[Vectors] = lines, step: Vectors = step) -> list[Vectors]:
            """Return both halves of a bar, so many lanes further inside."""
            return [line + lane * step for line in lines]

        pair = _clear(halves, taken, metres)
        taken += [half for half, size in zip(pair, sizes, strict=True) if size > 0.0]
        _draw_pair(page, pair, slopes[index], sizes, "shift")


def _fitting(slopes: Vectors, arcs: Vectors) -> float:
    """Return the length of the longest bar [pt] with which they rather do not meet.

    Parameters
    ----------
    slopes : (n, 2)
    arcs : (n,) [pt]
        Arc lengths of the contacts.
    """
    sizes = np.abs(slopes) / (np.nanmax(np.abs(slopes), initial=0.0) or 1.0)
    order = [i for i in np.argsort(arcs) if sizes[i].sum() > 0.0]
    fits = [
        (arcs[j] - arcs[i] - 2.0 * CLEAR - LANE) / max(sizes[i, 1] + sizes[j, 0], LEAST)
        for i, j in itertools.pairwise(order)
    ]
    return float(np.clip(min(fits, default=LONGEST), 0.5 * LONGEST, LONGEST))


def _along(outline: Outline, arc: float, span: Vectors) -> Vectors:
    """Return the part (k, 2) [m, m] of the boundary that spans (2,) [m] from an arc length."""
    first, last = span.tolist()
    arcs = (arc + np.linspace(first, last, 25)) % outline.perimeter
    return np.array([outline.at_arc_length(float(s)).point for s in arcs])


def _draw_arcs(page: Page, found: Sensitivities, arrows: Arrows) -> None:
    """Draw the arcs, beyond the arrows' outer ends."""
    slopes, metres = found.direction_per_degree, _metres(page)
    shares = np.linspace(0.0, 1.0, 15)[:, None]
    shafts = [tail + shares * (tip - tail) for tail, tip in map(arrows.ends, arrows.robots)]
    drawn: list[Vectors] = []
    longest = LONGEST * min(1.0, max(FEW / max(1, len(slopes)), 0.5))
    for index, sizes in _sizes(slopes, longest).items():
        contact, middle, length = _swing(arrows, arrows.robots[index])

        def halves(
            lane: int,
            contact: Vectors = contact,
            middle: float = middle,
            length: float = length,
            sizes: Vectors = sizes,
        ) -> list[Vectors]:
            """Return both halves of an arc, so many lanes further out."""
            radius = length + metres * (BEYOND + LANE * lane)
            ends = [np.linspace(APART, APART + size, 15) * metres / radius for size in sizes]
            return [
                contact + radius * _bearing(middle + sign * turn)
                for sign, turn in zip((-1.0, 1.0), ends, strict=True)
            ]

        taken = drawn + shafts[:index] + shafts[index + 1 :]
        pair = _clear(halves, taken, metres)
        drawn += [half for half, size in zip(pair, sizes, strict=True) if size > 0.0]
        _draw_pair(page, pair, slopes[index], sizes, "turn")


def _bearing(angle: float | Vectors) -> Vectors:
    """Return unit vectors (..., 2) at angles [rad]."""
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def _sizes(slopes: Vectors, longest: float) -> dict[int, Vectors]:
    """Return the lengths (2,) [pt] of both halves, of those robots that have any."""
    sizes = np.nan_to_num(np.abs(slopes))
    sizes *= longest / (sizes.max(initial=0.0) or 1.0)
    sizes[sizes <= LEAST * longest] = 0.0
    return {int(index): sizes[index] for index in np.flatnonzero(sizes.any(axis=1))}


def _clear(
    halves: Callable[[int], list[Vectors]], taken: list[Vectors], metres: float
) -> list[Vectors]:
    """Return two halves in the first lane where they keep clear of lines (k, 2) [m, m]."""
    if not taken:
        return halves(0)
    others = np.concatenate(taken)
    gaps = []
    for lane in range(LANES):
        points = np.concatenate(halves(lane))
        gap = float(np.hypot(*(points[:, None] - others).T).min()) / metres
        if gap > 0.7 * LANE:
            return halves(lane)
        gaps.append(gap)
    return halves(int(np.argmax(gaps)))


def _draw_pair(page: Page, pair: list[Vectors], slopes: Vectors, sizes: Vectors, gid: str) -> None:
    """Draw the halves (k, 2) [m, m] of a bar or an arc."""
    for line, slope, size in zip(pair, slopes, sizes, strict=True):
        if size > 0.0:
            _draw_half(page, line, rises=bool(slope > 0.0), gid=gid)


def _draw_half(page: Page, line: Vectors, *, rises: bool, gid: str) -> None:
    """Draw a half (k, 2) [m, m], pointed at its end where the quality rises."""
    ax, colour = page.ax, COLOURS[rises]
    middle = line[len(line) // 2]
    page.keep_clear(line[0], middle, breadth=BREADTH)
    page.keep_clear(middle, line[-1], breadth=BREADTH)
    if rises:
        tip = line[-1]
        off = np.hypot(*(line - tip).T)
        shaft = line[off >= min(HEAD * _metres(page), 0.8 * off[0])]
        way = tip - shaft[-1]
        aside = BREADTH / HEAD * np.array([-way[1], way[0]])
        corners = np.array([shaft[-1] + aside, tip, shaft[-1] - aside])
        ax.fill(*corners.T, facecolor=colour, linewidth=0.0, zorder=4.5)
        line = np.vstack([shaft, shaft[-1] + 0.05 * way])
    gid = f"{gid}-{'rise' if rises else 'fall'}"
    ax.plot(*line.T, color=colour, linewidth=BREADTH, gid=gid, solid_capstyle="butt", zorder=4.5)


def _swing(arrows: Arrows, robot: Robot) -> tuple[Vectors, float, float]:
    """Return a contact (2,), and bearing [rad] and distance [m] of its arrow's outer end."""
    contact = np.array(robot.contact)
    tail, tip = arrows.ends(robot)
    way = (tip if np.array_equal(contact, tail) else tail) - contact
    return contact, math.atan2(way[1], way[0]), float(np.hypot(*way))


def _metres(page: Page) -> float:
    """Return the length of a typographic point [m]."""
    inverse = page.ax.transData.inverted()
    return page.point_size * float(np.ptp(inverse.transform([(0.0, 0.0), (1.0, 0.0)])[:, 0]))


def _caption(
    found: Sensitivities, arrows: Arrows, weakest: Pointer | None, heading: str
) -> Caption:
    """Return what is written round the picture."""
    swarm, criterion, terms = found.swarm, found.quality.criterion, style.terms()
    mounted = {robot.mounted for robot in arrows.robots}
    entries: list[Any] = [
        ArrowEntry(facecolor=LOOKS[kind][0], label=terms.robot if kind == "robot" else kind)
        for kind, is_mounted in (("robot", False), ("thruster", True))
        if is_mounted in mounted
    ]
    if weakest is not None:
        entries.append(weakest.entry())
    slopes = np.nan_to_num(np.concatenate([found.contact, found.direction]))
    for rises, label in ((True, "quality rises that way"), (False, "quality falls")):
        if not (slopes > 0.0 if rises else slopes < 0.0).any():
            continue
        look: dict[str, Any] = {
            "color": COLOURS[rises],
            "linewidth": BREADTH,
            "solid_capstyle": "butt",
        }
        entries.append(Line2D([], [], **look, label=label))
    longest = [
        f"{what}: {where}, the longest {_rate(slopes, found)} per {per}."
        for what, where, slopes, per in (
            (
                "Bars",
                "the contact shifted along the boundary",
                found.contact * LENGTHS[terms.length],
                terms.length,
            ),
            ("Arcs", "the force turned", found.direction_per_degree, "degree"),
        )
        if np.nan_to_num(slopes).any()
    ] or [f"No small move of one {terms.robot} changes the quality."]
    title = (
        f"{written.count(len(swarm))}: quality {written.quality(found.quality.value, criterion)}, "
        "and what changes it"
    )
    small_print = [*longest, f"Quality with {written.metric(swarm)}."]
    if criterion.has_load:
        small_print.append(written.load_sentence(criterion.load, swarm))
    small_print += written.frame_sentences()
    words = criterion.words(swarm, terms.robot)
    return Caption(heading, title, words, tuple(entries), tuple(small_print))


def _rate(slopes: Vectors, found: Sensitivities) -> str:
    """Write the largest of some slopes."""
    return written.quality(float(np.nanmax(np.abs(slopes))), found.quality.criterion)
