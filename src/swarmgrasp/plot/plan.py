"""The plan view: who pushes where, where the next robot goes, and what is weakest."""

import itertools
import math
from collections.abc import Sequence
from typing import Any, Final, cast

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.placement import Placement
from swarmgrasp.plot import style
from swarmgrasp.plot.arrows import ArrowEntry, Forces, draw_arrows, draw_turn
from swarmgrasp.plot.labels import Page
from swarmgrasp.plot.sheet import draw_force_key, frame, new_axes, write_legend, write_title
from swarmgrasp.plot.strips import BARRED, BOLLARD, STRIP, STRIPES, draw_strips
from swarmgrasp.quality import Quality
from swarmgrasp.robot import Robot, Zone
from swarmgrasp.swarm import Swarm

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
    zones: Sequence[Zone | None] = (),
    no_go: Sequence[Stretch] = (),
    ax: Axes | None = None,
) -> Figure:
    """Draw the object from above with the robots that hold it.

    An arrow is the force a robot can exert on the object, its length in proportion to the
    robot's limit: a push ends at the contact, a pull starts there.

    Parameters
    ----------
    swarm : Swarm
        The robots already there.
    quality : Quality, optional
        Of this swarm: draws the wrench it is weakest at, the force as an arrow from the
        origin, the torque as a turn about it.
    placements : sequence of Placement
        Newcomers, each with its runners-up as thin arrows.
    zones : sequence of Zone or None
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
    strips = [zone.stretch for zone in zones if zone is not None]
    forces = Forces(
        swarm.outline,
        swarm.robots,
        tuple(p.robot for p in placements),
        tuple(runner.robot for p in placements for runner in p.runners_up),
    )
    with mpl.rc_context(style.RC):
        entries = _legend_entries(forces, bool(quality and len(swarm)), strips, no_go)
        ax = new_axes(forces, len(entries)) if ax is None else ax
        page = frame(ax, forces)
        _draw_object(page, swarm.outline)
        draw_strips(page, swarm.outline, strips, no_go)
        _draw_forces(page, forces)
        if quality is not None and len(swarm):
            _draw_weakest(page, swarm, quality)
        _label_newcomers(page, forces, placements)
        _label_robots(page, forces)
        _label_edges(page, swarm.outline)
        write_title(page, _title(swarm, quality, placements))
        draw_force_key(page, forces)
        write_legend(page, entries, f"Quality with {swarm.metric_sentence}.")
        return cast(Figure, ax.get_figure(root=True))


def _draw_object(page: Page, outline: Outline) -> None:
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


def _kinds(forces: Forces) -> dict[str, list[Robot]]:
    """Return the robots of each kind in `LOOKS`."""
    return {
        "runner-up": list(forces.runners_up),
        "robot": [r for r in forces.robots if not r.mounted],
        "thruster": [r for r in forces.robots if r.mounted],
        "newcomer": list(forces.newcomers),
    }


def _draw_forces(page: Page, forces: Forces) -> None:
    """Draw every arrow, and a mark at every contact: an arrow may be too short to see."""
    many = len(forces.robots) > MOST_LABELS
    for kind, robots in _kinds(forces).items():
        colour, width = LOOKS[kind]
        ends = [forces.ends(robot) for robot in robots]
        draw_arrows(page.ax, ends, color=colour, width=0.6 * width if many else width, gid=kind)
        for tail, tip in ends:
            page.keep_clear(tail, tip)
        page.ax.plot(
            *np.reshape([robot.contact for robot in robots], (-1, 2)).T,
            "s" if kind == "thruster" else "o",
            markersize=2.2 if many or kind == "runner-up" else 3.8,
            color=colour,
            markeredgecolor="white",
            markeredgewidth=0.4,
            zorder=5,
        )


def _draw_weakest(page: Page, swarm: Swarm, quality: Quality) -> None:
    """Draw the wrench the swarm is weakest at, and say how weak."""
    ax, origin = page.ax, swarm.outline.origin
    inverse = ax.transData.inverted()
    metres = page.point_size * float(np.ptp(inverse.transform([(0.0, 0.0), (1.0, 0.0)])[:, 0]))
    length, radius = (size * metres for size in WEAKEST_SIZES)
    force, torque = np.asarray(quality.direction[:2]), float(quality.direction[2])
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
    for turn in np.linspace(0.0, math.pi, 6)[:-1]:
        reach = 1.3 * radius * np.array([math.cos(turn), math.sin(turn)])
        page.keep_clear(origin - reach, origin + reach)
    text = f"weakest: {style.force(quality.value)}" if quality.value > 0.0 else "not force closed"
    beside = [origin + 1.4 * radius * np.array(d) for d in ((0, -1), (0, 1), (1, 0), (-1, 0))]
    page.label(text, beside, -0.5 * math.pi, fontsize=8.0, color=style.WINE, gid="weakest-label")


def _label_newcomers(page: Page, forces: Forces, placements: Sequence[Placement]) -> None:
    """Say what every newcomer brings, and what its runners-up would have brought."""
    for placement in placements:
        robot = placement.robot
        name = f"{robot.name}, " if robot.name else "+"
        gain = style.gain(placement.quality_before, placement.quality)
        text = f"{name}{style.force(robot.limit)}\n{gain}"
        spots, bearing = _outer_spots(forces, robot)
        page.label(text, spots, bearing, fontsize=8.0, color=style.VERMILION, gid="newcomer-label")
        for runner in placement.runners_up:
            spots, bearing = _outer_spots(forces, runner.robot)
            text = style.force(runner.quality, placement.quality)
            page.label(text, spots, bearing, fontsize=7.0, color=style.GREY, gid="runner-up-label")


def _label_robots(page: Page, forces: Forces) -> None:
    """Write the name of every robot, or its number, unless there are too many.

    The two halves of a thruster that pushes either way, "bow +" and "bow -" at one
    contact, share a label.
    """
    if len(forces.robots) > MOST_LABELS:
        return
    done = set()
    for index, robot in enumerate(forces.robots):
        name = robot.name or str(index)
        stem = name.removesuffix(" +").removesuffix(" -")
        halves = [r for r in forces.robots if r.contact == robot.contact]
        if len(halves) == 2 and all(r.name in (f"{stem} +", f"{stem} -") for r in halves):
            name = stem
        if (name, robot.contact) in done:
            continue
        done.add((name, robot.contact))
        spots, bearing = _outer_spots(forces, robot)
        colour = LOOKS["thruster" if robot.mounted else "robot"][0]
        size = 8.0 if len(forces.robots) <= FEW else 7.0
        page.label(name, spots, bearing, fontsize=size, color=colour, gid="robot-label")


def _outer_spots(forces: Forces, robot: Robot) -> tuple[list[Any], float]:
    """Return where a robot's label may sit, best first, and the bearing [rad] it prefers."""
    tail, tip = forces.ends(robot)
    contact = np.array(robot.contact)
    outer = tip if np.array_equal(contact, tail) else tail
    way = outer - contact
    return [outer, 0.5 * (tail + tip)], math.atan2(way[1], way[0])


def _label_edges(page: Page, outline: Outline) -> None:
    """Write the names of edges just outside them."""
    named = [edge for edge, name in enumerate(outline.edge_names) if name]
    for edge in named if len(named) <= MOST_LABELS else []:
        p, q = outline.edge_ends(edge)
        spots = [p + share * (q - p) for share in (0.5, 0.35, 0.65, 0.2, 0.8)]
        outward = outline.inward_normal(edge) + math.pi
        look = {"fontsize": 7.0, "fontstyle": "italic", "color": style.GREY, "gid": "edge-label"}
        page.label(outline.edge_names[edge], spots, outward, optional=True, **look)


def _title(swarm: Swarm, quality: Quality | None, placements: Sequence[Placement]) -> str:
    """Return the picture in a line."""
    crew = style.count(len(swarm))
    if placements:
        gain = style.gain(placements[0].quality_before, placements[-1].quality)
        return f"{crew} + {len(placements)}: {gain}"
    return crew if quality is None else f"{crew}: quality {style.force(quality.value)}"


def _legend_entries(
    forces: Forces, weakest: bool, zones: Sequence[Stretch], no_go: Sequence[Stretch]
) -> list[Any]:
    """Return a legend entry for everything that is drawn."""
    kinds = _kinds(forces)
    entries: list[Any] = [
        ArrowEntry(color=LOOKS[kind][0], label=kind, linewidth=0.0)
        for kind in ("robot", "thruster", "newcomer", "runner-up")
        if kinds[kind]
    ]
    if weakest:
        entries.append(ArrowEntry(color=style.PURPLE, label="weakest wrench", linewidth=0.0))
    strip = STRIP | {"linewidth": 6.0}
    if any(not z.is_point for z in zones):
        entries.append(Line2D([], [], **strip, color=style.GREEN, label="zone"))
    if any(z.is_point for z in zones):
        entries.append(Line2D([], [], **BOLLARD, label="bollard"))
    if any(not s.is_point for s in no_go):
        entries.append(Line2D([], [], **strip, **STRIPES, label="no-go"))
    elif no_go:
        entries.append(Line2D([], [], **BARRED, label="no-go"))
    return entries
