"""Robots as arrows, with the areas of all their forces, and their names."""

import itertools
import math
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgba
from matplotlib.lines import Line2D
from matplotlib.markers import MarkerStyle
from matplotlib.patches import Patch

from swarmgrasp.placement.room import body_corners
from swarmgrasp.plot import style
from swarmgrasp.plot.arrows import ArrowEntry, Arrows, draw_arrows, has_area
from swarmgrasp.plot.labels import Page
from swarmgrasp.plot.poses import HOLLOW
from swarmgrasp.swarm import Robot

MOST_LABELS: Final = 40
"""With more robots or named edges than this none is labelled."""

FEW: Final = 10
"""With more robots than this their names are smaller."""

LOOKS: Final = {
    "runner-up": (style.ORANGE, 0.011),
    "robot": (style.BLUE, 0.024),
    "thruster": (style.INK, 0.024),
    "newcomer": (style.VERMILION, 0.032),
}
"""Colour and width [in] of the arrows of each kind, in the order they are drawn."""

MARK: Final = 5.0
"""Breadth of the mark at a contact that labels keep clear of [pt]."""

LEAST: Final[dict[str, Any]] = {"markersize": 9.0, "markeredgewidth": 1.4, "linestyle": "none"}
"""The bar at a least force, with its length and width [pt]."""

HEAD: Final = 250.0
"""Breadth of an arrow that labels keep clear of [pt], over its width [in]: nearly its head's."""


def _kinds(arrows: Arrows, missing: frozenset[int]) -> dict[tuple[str, bool], list[Robot]]:
    """Return the robots of each kind in `LOOKS`, and whether those are missing."""
    kinds: dict[tuple[str, bool], list[Robot]] = {
        (kind, gone): [] for kind in LOOKS for gone in (False, True)
    }
    kinds["runner-up", False] += arrows.runners_up
    for index, robot in enumerate(arrows.robots + arrows.newcomers):
        kind = "thruster" if robot.mounted else "robot"
        kind = kind if index < len(arrows.robots) else "newcomer"
        kinds[kind, index in missing].append(robot)
    return {key: robots for key, robots in kinds.items() if robots}


def draw_rooms(page: Page, arrows: Arrows) -> None:
    """Draw the room that robots and newcomers take up."""
    for robots, colour in ((arrows.robots, style.BLUE), (arrows.newcomers, style.VERMILION)):
        shapes = [body_corners(arrows.outline, robot) for robot in robots if robot.body]
        for shape in shapes:
            for start, end in itertools.pairwise([*shape, shape[0]]):
                page.keep_clear(start, end)
        rooms = PolyCollection(
            shapes, facecolor=to_rgba(colour, 0.07), edgecolor=to_rgba(colour, 0.6),
            linewidth=0.6, zorder=1, gid="room",
        )  # fmt: skip
        page.ax.add_collection(rooms)


def draw_robots(page: Page, arrows: Arrows, missing: frozenset[int]) -> None:
    """Draw every arrow, and a mark at every contact: an arrow may be too short to see.

    Of robots that steer, or have friction or an envelope, the area of all their forces is drawn
    below the arrow. Robots that are missing have a hollow arrow, an empty area and a cross.
    """
    many = len(arrows.robots) > MOST_LABELS
    for (kind, gone), robots in _kinds(arrows, missing).items():
        colour, width = LOOKS[kind]
        wide = [robot for robot in robots if has_area(robot) and kind != "runner-up"]
        if wide:
            _draw_areas(page, arrows, wide, kind, gone)
        ends = [shaft for robot in robots for shaft in arrows.shafts(robot)]
        for tail, tip in ends:
            page.keep_clear(tail, tip, breadth=HEAD * width)
        for robot in wide:
            page.keep_clear(robot.contact, robot.contact, breadth=MARK)
        look = HOLLOW | {"edgecolor": colour} if gone else {"facecolor": colour}
        if kind == "newcomer" and not gone:
            look |= style.RIM
        width *= 0.6 if many else 1.0
        draw_arrows(page.ax, ends, **look, width=width, gid="missing" if gone else kind)
        _draw_leasts(page, arrows, [robot for robot in robots if robot.least], colour)
        marker = "X" if gone else "s" if kind == "thruster" else "o"
        size = 2.2 if many or kind == "runner-up" else 3.8
        page.ax.plot(
            *np.reshape([robot.contact for robot in robots], (-1, 2)).T,
            marker,
            markersize=1.7 * size if gone else size,
            color=colour,
            markeredgecolor="white",
            markeredgewidth=0.4,
            linestyle="none",
            zorder=5,
        )


def _draw_areas(page: Page, arrows: Arrows, robots: Sequence[Robot], kind: str, gone: bool) -> None:
    """Draw the areas of all forces of robots of a kind, those that are gone without a filling.

    Labels lie across the circles of azimuth thrusters, which often cover each other, where there is
    no other room.
    """
    areas = [(robot, area) for robot in robots for area in arrows.areas(robot)]
    look = _area_look(kind) | ({"facecolor": "none"} if gone else {})
    corners = [area for _, area in areas]
    page.ax.add_collection(PolyCollection(corners, **look, zorder=3.2, gid=f"{kind}-area"))
    for robot, area in areas:
        for start, end in itertools.pairwise(np.vstack([area, area[:1]])):
            page.keep_clear(start, end, is_faint=robot.steers >= math.pi)


def _area_look(kind: str) -> dict[str, Any]:
    """Return how the areas of all forces of robots of a kind look."""
    colour = LOOKS[kind][0]
    return {
        "facecolor": to_rgba(colour, 0.06 if kind == "thruster" else 0.16),
        "edgecolor": to_rgba(colour, 0.6),
        "linewidth": 0.7,
    }


def _draw_leasts(page: Page, arrows: Arrows, robots: Sequence[Robot], colour: str) -> None:
    """Draw a bar across the arrow of each robot that always exerts some force, at the least."""
    for robot in robots:
        tail, tip = arrows.ends(robot)
        contact = np.array(robot.contact)
        outer = tip if np.array_equal(contact, tail) else tail
        spot = contact + robot.least / robot.limit * (outer - contact)
        mark = MarkerStyle("|").rotated(rad=robot.direction)
        page.ax.plot(*spot, marker=mark, color=colour, **LEAST, zorder=4.1, gid="least")


def label_robots(page: Page, arrows: Arrows) -> None:
    """Write the name of every robot, unless there are too many."""
    if len(arrows.robots) > MOST_LABELS:
        return
    for robot in sorted(arrows.robots, key=lambda robot: -robot.limit):
        spots, bearing = outer_spots(arrows, robot)
        colour = LOOKS["thruster" if robot.mounted else "robot"][0]
        size = 8.0 if len(arrows.robots) <= FEW else 7.0
        page.label(robot.name, spots, bearing, fontsize=size, color=colour, gid="robot-label")


def outer_spots(arrows: Arrows, robot: Robot) -> tuple[list[Any], float]:
    """Return where a robot's label may sit, best first, and the bearing [rad] it prefers.

    The outer end of the arrow and its middle; a thruster's at the contact, off the arrow:
    inside the object the tip may be nearer to another thruster. Of arrows both ways beside them.
    """
    if robot.reverse_limit and not robot.steers:
        middles = [0.5 * (tail + tip) for tail, tip in arrows.shafts(robot)]
        return [np.array(robot.contact), *middles], robot.direction + 0.5 * math.pi
    if robot.mounted:
        return [np.array(robot.contact)], robot.direction + math.pi
    tail, tip = arrows.ends(robot)
    contact = np.array(robot.contact)
    outer = tip if np.array_equal(contact, tail) else tail
    way = outer - contact
    return [outer, 0.5 * (tail + tip)], math.atan2(way[1], way[0])


def robot_entries(arrows: Arrows, word: str = "robot") -> list[Any]:
    """Return the legend entries of what is drawn of robots, called by a word."""
    kinds = {kind: robots for (kind, _), robots in _kinds(arrows, frozenset()).items()}
    order = ("robot", "thruster", "newcomer", "runner-up")
    entries = [_robot_entry(arrows, kind, kinds[kind], word) for kind in order if kind in kinds]
    wide = [k for k in LOOKS if k != "runner-up" and any(map(has_area, kinds.get(k, ())))]
    if wide:
        entries.append(Patch(**_area_look(wide[0]), label="all its forces"))
    if any(robot.least for robot in arrows.robots + arrows.newcomers):
        look: dict[str, Any] = LEAST | {"color": style.INK, "label": "least force"}
        entries.append(Line2D([], [], marker="|", **look))
    return entries


def _robot_entry(arrows: Arrows, kind: str, robots: Sequence[Robot], word: str) -> Any:
    """Return the legend entry of a kind: an arrow, or a mark where none of them has an arrow."""
    look: dict[str, Any] = {"label": word if kind == "robot" else kind}
    colour = LOOKS[kind][0]
    if any(map(arrows.shafts, robots)):
        rim = style.RIM if kind == "newcomer" else {}
        return ArrowEntry(facecolor=colour, **rim, **look)
    marker = "s" if kind == "thruster" else "o"
    return Line2D([], [], marker=marker, markersize=3.8, linestyle="none", color=colour, **look)
