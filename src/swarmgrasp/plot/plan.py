"""The plan view: who pushes where, where the next robot goes, and what is weakest."""

import itertools
import math
from collections.abc import Sequence
from functools import partial
from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.placement import Placement
from swarmgrasp.plot import style
from swarmgrasp.plot.areas import draw_areas, name_areas
from swarmgrasp.plot.arrows import ArrowEntry, Arrows
from swarmgrasp.plot.labels import Page
from swarmgrasp.plot.poses import draw_poses, pose_entries, worst_case
from swarmgrasp.plot.robots import (
    MOST_LABELS,
    draw_robots,
    draw_rooms,
    label_robots,
    outer_spots,
    robot_entries,
)
from swarmgrasp.plot.sheet import Caption, draw_force_key, frame, new_axes, write_caption
from swarmgrasp.plot.strips import draw_strips, name_bollards, name_strips, zone_entries
from swarmgrasp.plot.weakest import draw_wrench, label_wrench
from swarmgrasp.quality import Quality
from swarmgrasp.quality.criterion import NOMINAL
from swarmgrasp.swarm import Swarm, Zone
from swarmgrasp.words import TIMES

MOST_RUNNERS_UP: Final = 8
"""The best runners-up of each newcomer that are labelled."""

EDGE_REACH: Final = 15.0
"""Farthest an edge's name stands from it [pt]: two heights of its text."""


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
    areas = [zone for zone in zones if zone.area is not None]
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
        entries = robot_entries(arrows) + pose_entries(case)
        if limit is not None:
            entries.append(ArrowEntry(facecolor=style.PURPLE, label="weakest wrench"))
        entries += zone_entries(zones, no_go)
        caption = _caption(swarm, quality, placements, entries)
        ax = new_axes(arrows, caption) if ax is None else ax
        page = frame(ax, arrows)
        draw_object(page, swarm.outline)
        draw_areas(page, areas)
        draw_strips(page, swarm.outline, strips, no_go)
        draw_rooms(page, arrows)
        draw_poses(page, arrows, case)
        draw_robots(page, arrows, case.missing)
        if limit is not None:
            radius = draw_wrench(page, swarm, limit)
        _label_newcomers(page, arrows, placements)
        name_bollards(page, swarm.outline, strips)
        if limit is not None:
            label_wrench(page, swarm, limit, radius, " before" if placements else "")
        label_robots(page, arrows)
        name_areas(page, areas)
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


def in_view(arrows: Arrows) -> bool:
    """Tell whether the origin is among what is drawn: moments may be taken about any point."""
    low, high = arrows.box()
    origin = arrows.outline.origin
    return bool(((low <= origin) & (origin <= high)).all())


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
