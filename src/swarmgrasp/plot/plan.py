"""The plan view: who pushes where, where the next robot goes, and what is weakest."""

import itertools
import math
from collections.abc import Sequence
from functools import partial
from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swarmgrasp.environment import Environment
from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.placement import Move, Problem, Together
from swarmgrasp.plot import style, written
from swarmgrasp.plot.areas import draw_areas, name_areas
from swarmgrasp.plot.arrows import Arrows
from swarmgrasp.plot.direction import Pointer, load_pointer
from swarmgrasp.plot.flows import Flow, flows_of
from swarmgrasp.plot.labels import Page
from swarmgrasp.plot.newcomers import Answer, Newcomers, newcomers_of
from swarmgrasp.plot.poses import WorstCase, draw_poses, pose_entries, worst_case
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
from swarmgrasp.plot.weakest import label_weakest, weakest_pointer
from swarmgrasp.quality import Quality
from swarmgrasp.quality.criterion import NOMINAL
from swarmgrasp.swarm import Swarm, Zone
from swarmgrasp.terms import SI, Terms

EDGE_REACH: Final = 15.0
"""Farthest an edge's name stands from it [pt]: two heights of its text."""


def plan(
    swarm: Swarm,
    *,
    quality: Quality | None = None,
    placements: Answer = (),
    zones: Sequence[Zone] = (),
    no_go: Sequence[Stretch] = (),
    environment: Environment | None = None,
    terms: Terms = SI,
    title: str = "",
    width: float = style.WIDTH,
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

    The wrench that is weakest and a load on the object have the scale of the arrows where they are
    then neither too long nor too short; hollow arrows, and turns, only show a direction.

    Parameters
    ----------
    swarm : Swarm
        The robots already there.
    quality : Quality, optional
        Of this swarm: draws the wrench it is weakest at, the force as an arrow from the
        origin, the torque as a turn about it.
    placements : sequence of Placement, Together or swarmgrasp.Move
        Newcomers, each with its runners-up as thin arrows. A robot that moves is hollow where it is
        now, and a newcomer where it had better be.
    zones : sequence of Zone
        Where newcomers may attach; those of the first placement when left out.
    no_go : sequence of Stretch
        Where nobody may attach; those of the first placement when left out.
    environment : Environment, optional
        Draws wind, current and sea, if the load of the quality is theirs.
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
    if (asked := _problem_of(placements)) is not None:
        zones, no_go = zones or asked.zones or (), no_go or asked.no_go
    strips = [zone.stretch for zone in zones if zone.stretch is not None]
    areas = [zone for zone in zones if zone.area is not None]
    with style.settings(width, terms):
        new = newcomers_of(placements)
        case = worst_case(swarm, quality, new)
        arrows = _arrows(swarm, new, case)
        pointers = _pointers(arrows, swarm, quality)
        leaving = frozenset() if new is None else new.leaving
        entries = robot_entries(arrows, terms.robot) + pose_entries(case, has_left=bool(leaving))
        entries += [pointer.entry() for pointer in pointers.values()]
        entries += zone_entries(zones, no_go)
        load = (0.0, 0.0, 0.0) if quality is None else quality.criterion.load
        flows = flows_of(environment, swarm.outline, load)
        caption = _caption(swarm, quality, new, entries, flows, title, terms)
        alone = ax is None
        ax = new_axes(arrows, caption) if ax is None else ax
        page = frame(ax, arrows, flows, has_table=alone)
        draw_object(page, swarm.outline)
        draw_areas(page, areas)
        draw_strips(page, swarm.outline, strips, no_go)
        draw_rooms(page, arrows)
        draw_poses(page, arrows, case)
        draw_robots(page, arrows, case.missing | leaving)
        radii = {gid: p.draw(page, gid, pointers.values()) for gid, p in pointers.items()}
        _label_newcomers(page, arrows, new)
        name_bollards(page, swarm.outline, strips)
        if quality is not None and "weakest" in radii:
            when = " before" if new is not None else ""
            label_weakest(page, swarm, quality, radii["weakest"], when)
        label_robots(page, arrows)
        name_areas(page, areas)
        name_strips(page, swarm.outline, strips, no_go)
        label_edges(page, swarm.outline)
        _label_runners_up(page, arrows, new)
        draw_force_key(page, arrows)
        write_caption(page, caption)
        return cast(Figure, ax.get_figure(root=True))


def _problem_of(answer: Answer) -> Problem | None:
    """Return the question of an answer, if there is one."""
    if isinstance(answer, (Together, Move)):
        return answer.problem
    return answer[0].problem if answer else None


def _arrows(swarm: Swarm, new: Newcomers | None, case: WorstCase) -> Arrows:
    """Return the robots that are drawn."""
    if new is None:
        return Arrows(swarm.outline, swarm.robots, others=case.outermost)
    runners_up = tuple(robot for robot, _ in new.runners_up)
    return Arrows(swarm.outline, swarm.robots, new.robots, runners_up, case.outermost)


def _pointers(arrows: Arrows, swarm: Swarm, quality: Quality | None) -> dict[str, Pointer]:
    """Return the wrenches that are drawn at the origin, if that is in view."""
    if quality is None or not in_view(arrows):
        return {}
    found = {}
    if len(swarm):
        found["weakest"] = weakest_pointer(arrows, swarm, quality)
    if quality.criterion.has_load:
        load = load_pointer(arrows, swarm, quality.criterion.load)
        found |= {"load": load} if load.has_force else {}
    return found


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


def _label_newcomers(page: Page, arrows: Arrows, new: Newcomers | None) -> None:
    """Say what every newcomer brings."""
    if new is None:
        return
    for robot, words in zip(new.robots, new.words, strict=True):
        text = f"{robot.name}, {written.force(robot.limit)}\n{words}".rstrip()
        spots, bearing = outer_spots(arrows, robot)
        page.label(text, spots, bearing, fontsize=8.0, color=style.VERMILION, gid="newcomer-label")


def _label_runners_up(page: Page, arrows: Arrows, new: Newcomers | None) -> None:
    """Say what the best runners-up would have brought, where there is room."""
    for robot, text in () if new is None else new.runners_up:
        if not text:
            continue
        spots, bearing = outer_spots(arrows, robot)
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
    new: Newcomers | None,
    entries: Sequence[Any],
    flows: tuple[Flow, ...],
    heading: str,
    terms: Terms,
) -> Caption:
    """Return what is written round the picture."""
    criterion = NOMINAL if quality is None else quality.criterion
    is_outline = quality is None and new is None and not len(swarm)
    title = "" if is_outline else written.count(len(swarm))
    if new is not None:
        criterion = new.problem.criterion
        more = "one moves" if new.leaving else f"+ {len(new.robots)}"
        title += f"{',' * bool(new.leaving)} {more}: {new.gain}"
    elif quality is not None:
        title += f": quality {written.quality(quality.value, criterion)}"
    small_print = [] if is_outline else [f"Quality with {written.metric(swarm)}."]
    if criterion.has_load:
        small_print.append(written.load_sentence(criterion.load, swarm))
    if new is not None and criterion.is_of_worst:
        small_print.append("The worst case is that with every newcomer there.")
    small_print += written.frame_sentences()
    words = criterion.words(swarm, terms.robot)
    return Caption(heading, title, words, tuple(entries), tuple(small_print), flows)
