"""Robots whose pose is not certain, and what becomes of all robots in the worst case."""

import itertools
import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from swarmgrasp.plot import style
from swarmgrasp.plot.arrows import ArrowEntry, Arrows, draw_arrows, has_area
from swarmgrasp.plot.labels import Page
from swarmgrasp.plot.newcomers import Newcomers
from swarmgrasp.quality import Quality, quality
from swarmgrasp.quality.poses import Poses, poses_at
from swarmgrasp.swarm import Robot, Swarm

BAND: Final[dict[str, Any]] = {"color": "#8CCBF0", "linewidth": 6.0}
"""The contacts of a robot; zorder: above the object, below its edge."""

WEDGE: Final[dict[str, Any]] = {"facecolor": "#CFE8F7", "edgecolor": "#8CCBF0", "linewidth": 0.6}
"""The directions of a robot."""

WORST: Final[dict[str, Any]] = {
    "facecolor": style.WINE, "width": 0.016, "edgecolor": "white", "linewidth": 0.35,
}  # fmt: skip
"""The arrow of a robot in its worst pose; its width [in]."""

HOLLOW: Final[dict[str, Any]] = {"facecolor": "white", "linewidth": 0.8}
"""The arrow of a robot that is not there in the worst case."""

STEPS: Final = math.radians(3.0)
"""Turn from one corner of a sector's arc to the next [rad]."""


@dataclass(frozen=True, eq=False)
class WorstCase:
    """What becomes of the robots in a picture.

    Attributes
    ----------
    spreads : tuple of (Robot, Poses)
        The robots that have a tolerance, as they are meant to be, and all their poses.
    poses : tuple of Robot
        They again, in the worst poses, but for those that are not there.
    lost, absent : frozenset of int
        Indices of the robots lost, and of those that may not have come; a newcomer counts
        on from the robots.
    """

    spreads: tuple[tuple[Robot, Poses], ...] = ()
    poses: tuple[Robot, ...] = ()
    lost: frozenset[int] = frozenset()
    absent: frozenset[int] = frozenset()

    @property
    def missing(self) -> frozenset[int]:
        """Indices of the robots that are not there."""
        return self.lost | self.absent

    @property
    def outermost(self) -> tuple[Robot, ...]:
        """Robots whose arrows reach as far as anything that is drawn of the poses."""
        sides = [
            Robot(robot.contact, angle, robot.limit, mounted=robot.mounted)
            for robot, spread in self.spreads
            for angle in (spread.lo, spread.hi)
        ]
        return (*self.poses, *sides)


def worst_case(swarm: Swarm, found: Quality | None, new: Newcomers | None) -> WorstCase:
    """Return the worst case of a quality, or with newcomers.

    Parameters
    ----------
    swarm : Swarm
        Without newcomers.
    found : Quality, optional
        Of this swarm; not looked at when there are newcomers.
    new : Newcomers, optional

    Returns
    -------
    WorstCase
        Empty where the criterion loses no robots, none fail, and poses are taken as known.
    """
    if new is not None and new.leaving:  # robots have other indices then
        return WorstCase()
    if new is not None:
        swarm, criterion = new.swarm_after, new.problem.criterion
        found = quality(swarm, **criterion.keywords) if criterion.is_of_worst else None
    if found is None or not found.criterion.is_of_worst:
        return WorstCase()
    gone = frozenset(map(swarm.index, found.gone))
    if not found.criterion.worst_case:
        return WorstCase(lost=gone)
    tolerances = swarm.tolerances
    absent = frozenset(i for i, known in tolerances.items() if known.may_be_absent)
    lost = gone - absent
    there = [i for i in range(len(swarm)) if i not in lost | absent]
    poses = dict(zip(there, found.worst_swarm.robots, strict=True))
    spreads = []
    for i, tolerance in sorted(tolerances.items()):
        robot = swarm.robots[i]
        pose = (robot.contact, robot.direction, robot.limit)
        spreads.append((robot, poses_at(swarm.outline, *pose, tolerance)))
    return WorstCase(
        tuple(spreads), tuple(poses[i] for i in sorted(tolerances) if i in poses), lost, absent
    )


def draw_poses(page: Page, arrows: Arrows, case: WorstCase) -> None:
    """Draw where robots may be, which way they may push, and their worst poses.

    Parameters
    ----------
    page : Page
    arrows : Arrows
        Of all robots.
    case : WorstCase
    """
    if not case.spreads:
        return
    bands = [part for _, spread in case.spreads for part in spread.parts if part[0] != part[1]]
    page.ax.add_collection(LineCollection(bands, **BAND, zorder=2.5, gid="contact-range"))
    for start, end in bands:
        page.keep_clear(start, end, breadth=BAND["linewidth"])
    wedges = [_sector(arrows, *pair) for pair in case.spreads if pair[1].hi > pair[1].lo]
    page.ax.add_collection(PolyCollection(wedges, **WEDGE, zorder=2.3, gid="direction-range"))
    for wedge in wedges:
        for start, end in itertools.pairwise(np.vstack([wedge, wedge[:1]])):
            page.keep_clear(start, end)
    ends = [shaft for robot in case.poses for shaft in arrows.shafts(robot)]
    draw_arrows(page.ax, ends, **WORST, zorder=4.2, gid="worst-pose")
    areas = [area for pose in case.poses if has_area(pose) for area in arrows.areas(pose)]
    look: dict[str, Any] = {"facecolor": "none", "edgecolor": style.WINE, "linewidth": 0.8}
    page.ax.add_collection(PolyCollection(areas, **look, zorder=3.4, gid="worst-area"))
    for tail, tip in ends:
        page.keep_clear(tail, tip)
    contacts = np.reshape([robot.contact for robot in case.poses], (-1, 2))
    mark: dict[str, Any] = {"markersize": 2.6, "color": style.WINE, "zorder": 5.1}
    page.ax.plot(*contacts.T, "o", **mark, markeredgecolor="white", markeredgewidth=0.3)


def pose_entries(case: WorstCase, *, has_left: bool = False) -> list[Any]:
    """Return a legend entry for everything that a worst case adds to a picture, or a move."""
    entries: list[Any] = []
    spreads = [spread for _, spread in case.spreads]
    if any(len(s.parts) > 1 or s.parts[0][0] != s.parts[0][1] for s in spreads):
        entries.append(Line2D([], [], **BAND, solid_capstyle="butt", label="contact range"))
    if any(s.hi > s.lo for s in spreads):
        entries.append(Patch(**WEDGE, label="direction range"))
    if case.poses:
        entries.append(ArrowEntry(0.5, facecolor=style.WINE, label="worst pose"))
    if case.missing:
        what = "lost" if not case.absent else "missing" if case.lost else "absent"
        label = f"{what} at worst"
        entries.append(ArrowEntry(**HOLLOW, edgecolor=style.INK, label=label))
    if has_left:
        entries.append(ArrowEntry(**HOLLOW, edgecolor=style.BLUE, label="before the move"))
    return entries


def _sector(arrows: Arrows, robot: Robot, spread: Poses) -> NDArray[np.float64]:
    """Return the corners (k, 2) [m, m] of what a robot's arrow sweeps as it turns."""
    tail, tip = arrows.ends(robot)
    contact = np.array(robot.contact)
    back = math.pi if np.array_equal(contact, tip) else 0.0
    steps = 2 + math.ceil((spread.hi - spread.lo) / STEPS)
    angles = np.linspace(spread.lo, spread.hi, steps) + back
    reach = float(np.hypot(*(tip - tail)))
    arc = contact + reach * np.column_stack([np.cos(angles), np.sin(angles)])
    return np.vstack([contact, arc])
