"""The plan view: who pushes where, where the next robot goes, and what is weakest."""

import itertools
import math
from collections.abc import Sequence
from functools import partial
from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.markers import MarkerStyle
from matplotlib.patches import Patch
from numpy.typing import NDArray

from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.placement import Placement
from swarmgrasp.plot import style
from swarmgrasp.plot.arrows import ArrowEntry, Arrows, draw_arrows, draw_turn, has_area
from swarmgrasp.plot.labels import Page
from swarmgrasp.plot.poses import HOLLOW, WorstCase, draw_poses, pose_entries, worst_case
from swarmgrasp.plot.sheet import Caption, draw_force_key, frame, new_axes, write_caption
from swarmgrasp.plot.strips import BOLLARD, STRIP, STRIPES, draw_strips, name_bollards, name_strips
from swarmgrasp.quality import Quality
from swarmgrasp.quality.criterion import NOMINAL
from swarmgrasp.swarm import Robot, Swarm, Zone
from swarmgrasp.words import TIMES

MOST_LABELS: Final = 40
"""With more robots or named edges than this none is labelled."""

MOST_RUNNERS_UP: Final = 8
"""The best runners-up of each newcomer that are labelled."""

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

LEAST_MARK: Final = 9.0
"""Length of the bar at a least force [pt]."""

EDGE_REACH: Final = 15.0
"""Farthest an edge's name stands from it [pt]: two heights of its text."""

HEAD: Final = 250.0
"""Breadth of an arrow that labels keep clear of [pt], over its width [in]: nearly its head's."""

LEAST_PART: Final = 0.02
"""Share of the weakest wrench below which its force or its torque is not drawn."""

WEAKEST_SIZES: Final = (38.0, 13.0)
"""Length of the weakest wrench's force and radius of its turn [pt]: it is a direction,
so its size follows the paper and not the object."""


def plan(
    swarm: Swarm,
    *,
    quality: Quality | None = None,
    placements: Sequence[Placement] = (),
    zones: Sequence[Zone] = (),
    no_go: Sequence[Stretch] = (),
    ax: Axes | None = None,
) -> Figure:
    """Draw the object from above with the robots that hold it.

    An arrow is the force a robot can exert on the object, its length in proportion to the
    robot's limit: a push ends at the contact, a pull starts there. What pushes both ways has an
    arrow each way. Round the arrow of a robot that steers, or has friction or an envelope, all its
    forces are drawn as an area, to the same scale: of an azimuth thruster a circle, of sectors with
    gaps between a fan for each.

    By a criterion of the worst case, robots that have a tolerance are drawn with all their
    contacts and directions and in their worst poses, and robots lost are drawn hollow: of the
    quality given, or with the newcomers of the placements.

    Parameters
    ----------
    swarm : Swarm
        The robots already there.
    quality : Quality, optional
        Of this swarm: draws the wrench it is weakest at, the force as an arrow from the
        origin, the torque as a turn about it.
    placements : sequence of Placement
        Newcomers, each with its runners-up as thin arrows.
    zones : sequence of Zone
        Where newcomers may attach; those of the first placement when left out.
    no_go : sequence of Stretch
        Where nobody may attach; those of the first placement when left out.
    ax : Axes, optional
        Draw here, at its present size, instead of in a figure of its own.

    Returns
    -------
    Figure
    """
    if placements:
        zones = zones or placements[0].problem.zones or ()
        no_go = no_go or placements[0].problem.no_go
    strips = [zone.stretch for zone in zones if zone.stretch is not None]
    case = worst_case(swarm, quality, placements)
    arrows = Arrows(
        swarm.outline,
        swarm.robots,
        tuple(p.robot for p in placements),
        tuple(runner.robot for p in placements for runner in p.runners_up),
        case.outermost,
    )
    with style.settings():
        limit = quality if len(swarm) and in_view(arrows) else None
        entries = _legend_entries(arrows, limit is not None, case, strips, no_go)
        caption = _caption(swarm, quality, placements, entries)
        ax = new_axes(arrows, caption) if ax is None else ax
        page = frame(ax, arrows)
        draw_object(page, swarm.outline)
        draw_strips(page, swarm.outline, strips, no_go)
        draw_poses(page, arrows, case)
        draw_robots(page, arrows, case.missing)
        if limit is not None:
            radius = _draw_wrench(page, swarm, limit)
        _label_newcomers(page, arrows, placements)
        name_bollards(page, swarm.outline, strips)
        if limit is not None:
            _label_wrench(page, swarm, limit, radius, " before" if placements else "")
        label_robots(page, arrows)
        name_strips(page, swarm.outline, strips, no_go)
        label_edges(page, swarm.outline)
        _label_runners_up(page, arrows, placements)
        draw_force_key(page, arrows)
        write_caption(page, caption)
        return cast(Figure, ax.get_figure(root=True))


def draw_object(page: Page, outline: Outline) -> None:
    """Draw the outline and the mark of its origin."""
    ax = page.ax
    ax.fill(*outline.vertices.T, facecolor=style.PALE, zorder=2, gid="object")
    corners = np.vstack([outline.vertices, outline.vertices[:1]])
    ax.plot(*corners.T, color=style.INK, linewidth=1.1, solid_joinstyle="miter", zorder=3)
    for start, end in itertools.pairwise(corners):
        page.keep_clear(start, end)
    for marker, size in (("o", 5.0), ("+", 9.0)):
        ax.plot(
            *outline.origin, marker, markersize=size, color=style.INK,
            markerfacecolor="none", markeredgewidth=0.8, zorder=3,
        )  # fmt: skip


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
        look = HOLLOW | {"edgecolor": colour} if gone else {"color": colour}
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

    Labels may lie across the circles of azimuth thrusters, which often cover each other.
    """
    areas = [(robot, area) for robot in robots for area in arrows.areas(robot)]
    look = _area_look(kind) | ({"facecolor": "none"} if gone else {})
    corners = [area for _, area in areas]
    page.ax.add_collection(PolyCollection(corners, **look, zorder=3.2, gid=f"{kind}-area"))
    for robot, area in areas:
        for start, end in itertools.pairwise(np.vstack([area, area[:1]])):
            if robot.steers < math.pi:
                page.keep_clear(start, end)


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
        page.ax.plot(
            *spot, marker=mark, color=colour, markersize=LEAST_MARK, markeredgewidth=1.4,
            linestyle="none", zorder=4.1, gid="least",
        )  # fmt: skip


def in_view(arrows: Arrows) -> bool:
    """Tell whether the origin is among what is drawn: moments may be taken about any point."""
    low, high = arrows.box()
    origin = arrows.outline.origin
    return bool(((low <= origin) & (origin <= high)).all())


def draw_weakest(page: Page, swarm: Swarm, quality: Quality, when: str) -> None:
    """Draw the wrench the swarm is weakest at, and say how weak it is or was."""
    _label_wrench(page, swarm, quality, _draw_wrench(page, swarm, quality), when)


def _draw_wrench(page: Page, swarm: Swarm, quality: Quality) -> float:
    """Draw the wrench the swarm is weakest at; return the radius [m] of its turn."""
    ax, origin = page.ax, swarm.outline.origin
    inverse = ax.transData.inverted()
    metres = page.point_size * float(np.ptp(inverse.transform([(0.0, 0.0), (1.0, 0.0)])[:, 0]))
    length, radius = (size * metres for size in WEAKEST_SIZES)
    wrench = _weakest(swarm, quality)
    force, torque = wrench[:2], float(wrench[2])
    way = force / swarm.scale[:2]
    bearing = math.atan2(way[1], way[0])
    if np.hypot(*force) > LEAST_PART:
        tip = origin + length * np.hypot(*force) * way / np.hypot(*way)
        draw_arrows(ax, [(origin, tip)], color=style.PURPLE, width=0.03, gid="weakest", zorder=5)
        page.keep_clear(origin, tip)
    if abs(torque) > LEAST_PART:
        sweep = math.copysign(0.6 + 4.0 * abs(torque), torque)
        look = {"color": style.PURPLE, "linewidth": 2.0, "gid": "weakest"}
        draw_turn(ax, origin, radius, bearing + math.pi, sweep, **look)
    for turn in np.linspace(0.0, math.pi, 9)[:-1]:
        reach = 1.3 * radius * np.array([math.cos(turn), math.sin(turn)])
        page.keep_clear(origin - reach, origin + reach)
    return radius


def _label_wrench(page: Page, swarm: Swarm, quality: Quality, radius: float, when: str) -> None:
    """Say beside the weakest wrench how weak the swarm is or was."""
    origin = swarm.outline.origin
    side = 1.0 if _weakest(swarm, quality)[1] < 0.0 else -1.0  # off the arrow
    bearings = np.array([side, -side, 0.0, 2.0]) * 0.5 * math.pi
    beside = origin + 1.4 * radius * np.column_stack([np.cos(bearings), np.sin(bearings)])
    text = _weakness(quality, when)
    page.label(text, beside, bearings, fontsize=8.0, color=style.WINE, gid="weakest-label")


def _weakest(swarm: Swarm, quality: Quality) -> NDArray[np.float64]:
    """Return the direction (3,) in the metric's coordinates of the wrench that is weakest.

    Of a ball it is the normal of the weakest facet; of a task the wrench that reaches it first.
    """
    task = quality.criterion.task
    if task is None:
        return np.asarray(quality.direction)
    farthest = task.farthest(quality.direction * swarm.scale) * swarm.scale
    size = float(np.linalg.norm(farthest))
    return np.asarray(farthest / size if size > 0.0 else quality.direction)


def _weakness(quality: Quality, when: str) -> str:
    """Say how weak a swarm is or was."""
    criterion = quality.criterion
    if quality.value > 0.0:
        return f"weakest{when}: {style.quality(quality.value, criterion)}"
    if criterion.has_load:
        return f"load not held{when}"
    return f"not force closed{when}" if criterion.task is None else f"task not possible{when}"


def _label_newcomers(page: Page, arrows: Arrows, placements: Sequence[Placement]) -> None:
    """Say what every newcomer brings."""
    for placement in placements:
        robot = placement.robot
        name = f"{robot.name}, "
        criterion = placement.problem.criterion
        gain = style.gain(placement.quality_before, placement.quality, criterion)
        text = f"{name}{style.force(robot.limit)}\n{gain}"
        spots, bearing = outer_spots(arrows, robot)
        page.label(text, spots, bearing, fontsize=8.0, color=style.VERMILION, gid="newcomer-label")


def _label_runners_up(page: Page, arrows: Arrows, placements: Sequence[Placement]) -> None:
    """Say what the best runners-up would have brought, where there is room."""
    for placement in placements:
        for runner in placement.runners_up[:MOST_RUNNERS_UP]:
            spots, bearing = outer_spots(arrows, runner.robot)
            text = style.quality(
                runner.quality, placement.problem.criterion, placement.quality
            ).removesuffix(f" {TIMES}")
            page.label(
                text, spots, bearing, optional=True,
                fontsize=7.0, color=style.GREY, gid="runner-up-label",
            )  # fmt: skip


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


def label_edges(page: Page, outline: Outline) -> None:
    """Write the names of edges just outside them, where each is nearest to its own."""
    named = [edge for edge, name in enumerate(outline.edge_names) if name]
    for edge in named if len(named) <= MOST_LABELS else []:
        p, q = outline.edge_ends(edge)
        spots = [p + share * (q - p) for share in (0.5, 0.35, 0.65, 0.2, 0.8)]
        outward = outline.inward_normal(edge) + math.pi
        look = {"fontsize": 7.0, "fontstyle": "italic", "color": style.GREY, "gid": "edge-label"}
        fits = partial(_is_beside, outline, edge)
        name = outline.edge_names[edge]
        page.label(name, spots, outward, optional=True, reach=EDGE_REACH, fits=fits, **look)


def _is_beside(outline: Outline, edge: int, point: Any) -> bool:
    """Tell whether an edge is the one nearest to a point."""
    nearest = float(outline.nearest(point)[1][0])
    start, end = outline.corner_arc_lengths[edge : edge + 2]
    return bool(start < nearest < end)


def _caption(
    swarm: Swarm,
    quality: Quality | None,
    placements: Sequence[Placement],
    entries: Sequence[Any],
) -> Caption:
    """Return what is written round the picture."""
    criterion = NOMINAL if quality is None else quality.criterion
    title = style.count(len(swarm))
    if placements:
        criterion = placements[0].problem.criterion
        ends = placements[0].quality_before, placements[-1].quality
        title += f" + {len(placements)}: {style.gain(*ends, criterion)}"
    elif quality is not None:
        title += f": quality {style.quality(quality.value, criterion)}"
    small_print = [f"Quality with {swarm.metric_sentence}."]
    if criterion.has_load:
        small_print.append(style.load_sentence(criterion.load))
    if placements and criterion.is_of_worst:
        small_print.append("The worst case is that with every newcomer there.")
    return Caption(title, criterion.words(swarm), tuple(entries), tuple(small_print))


def _robot_entry(arrows: Arrows, kind: str, robots: Sequence[Robot]) -> Any:
    """Return the legend entry of a kind: an arrow, or a mark where none of them has an arrow."""
    colour = LOOKS[kind][0]
    if any(map(arrows.shafts, robots)):
        return ArrowEntry(facecolor=colour, label=kind)
    marker = "s" if kind == "thruster" else "o"
    return Line2D([], [], marker=marker, markersize=3.8, linestyle="none", color=colour, label=kind)


def _legend_entries(
    arrows: Arrows,
    weakest: bool,
    case: WorstCase,
    zones: Sequence[Stretch],
    no_go: Sequence[Stretch],
) -> list[Any]:
    """Return a legend entry for everything that is drawn."""
    kinds = {kind: robots for (kind, _), robots in _kinds(arrows, frozenset()).items()}
    entries: list[Any] = [
        _robot_entry(arrows, kind, kinds[kind])
        for kind in ("robot", "thruster", "newcomer", "runner-up")
        if kind in kinds
    ]
    drawn = arrows.robots + arrows.newcomers
    wide = [k for k in LOOKS if k != "runner-up" and any(map(has_area, kinds.get(k, ())))]
    if wide:
        entries.append(Patch(**_area_look(wide[0]), label="all its forces"))
    if any(robot.least for robot in drawn):
        look: dict[str, Any] = {"markersize": LEAST_MARK, "markeredgewidth": 1.4}
        entries.append(
            Line2D(
                [], [], marker="|", linestyle="none", color=style.INK, **look, label="least force"
            )
        )
    entries += pose_entries(case)
    if weakest:
        entries.append(ArrowEntry(facecolor=style.PURPLE, label="weakest wrench"))
    strip = STRIP | {"linewidth": 6.0}
    if any(not z.is_point for z in zones):
        entries.append(Line2D([], [], **strip, color=style.GREEN, label="zone"))
    if any(z.is_point for z in zones):
        entries.append(Line2D([], [], **BOLLARD, label="bollard"))
    if no_go:
        entries.append(Line2D([], [], **strip, **STRIPES, label="no-go"))
    return entries
