"""Arrows as arrows."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.legend import Legend
from matplotlib.legend_handler import HandlerPatch
from matplotlib.patches import FancyArrow, Patch
from numpy.typing import NDArray

from swarmgrasp.outline import Outline
from swarmgrasp.placement.room import body_corners
from swarmgrasp.swarm import Robot
from swarmgrasp.swarm.force_set import boundary_of, fans_of

Vector = NDArray[np.float64]

PROBE: Final = 1e-4
"""Step off a contact that tells inside from outside, relative to the extent: a hundred
times the boundary's own tolerance."""

SHARES: Final = (0.06, 0.2)
"""Length of the longest arrow relative to the extent: of many robots, and of a few."""


@dataclass(frozen=True)
class Arrows:
    """The robots whose forces one picture shows as arrows, and their common scale.

    Attributes
    ----------
    outline : Outline
    robots, newcomers, runners_up : tuple of Robot
    others : tuple of Robot
        Further poses of theirs.
    """

    outline: Outline
    robots: tuple[Robot, ...]
    newcomers: tuple[Robot, ...] = ()
    runners_up: tuple[Robot, ...] = ()
    others: tuple[Robot, ...] = ()

    @cached_property
    def strongest(self) -> float:
        """The largest limit [N], 0 without robots."""
        return max((r.limit for r in self.everyone if not r.lever), default=0.0)

    @cached_property
    def longest(self) -> float:
        """Length of the longest arrow [m]: the fuller the picture, the shorter."""
        count = len(self.robots) + len(self.newcomers)
        return float(np.clip(0.5 / math.sqrt(1 + count), *SHARES)) * self.outline.extent

    @cached_property
    def everyone(self) -> tuple[Robot, ...]:
        """Every robot with an arrow."""
        return (*self.robots, *self.newcomers, *self.runners_up, *self.others)

    def length(self, force: float) -> float:
        """Return the length [m] of the arrow of a force [N]."""
        return self.longest * force / self.strongest

    def ends(self, robot: Robot) -> tuple[Vector, Vector]:
        """Return tail and tip of a robot's arrow, each (2,) [m, m].

        A push ends at the contact, so that the arrow stays off the object wherever it can;
        a pull, a mounted thruster and what can do either start there.
        """
        contact = np.array(robot.contact)
        reach = self.length(1.0) * _largest(robot)
        return (contact - reach, contact) if self._pushes(robot) else (contact, contact + reach)

    def shafts(self, robot: Robot) -> list[tuple[Vector, Vector]]:
        """Return tails and tips of the arrows that show a robot's forces.

        Two for one that also pushes the other way, none for one that pushes any way, or in several
        sectors, and none for a couple.
        """
        if robot.steers >= math.pi or robot.sectors is not None or robot.lever:
            return []
        tail, tip = self.ends(robot)
        if robot.reverse_limit == 0.0:
            return [(tail, tip)]
        return [(tail, tip), (tail, tail - self.length(robot.reverse_limit) * _way(robot))]

    def areas(self, robot: Robot) -> list[Vector]:
        """Return the corners (k, 2) [m, m] around all forces of a robot, drawn at its contact.

        Every one is where the outer end of its arrow would be. Of sectors with gaps between there
        is an area for each.
        """
        reach = (-1.0 if self._pushes(robot) else 1.0) * self.length(1.0)
        return [np.array(robot.contact) + reach * fan for fan in fans_of(robot)]

    def force_ends(self, robot: Robot, force: Vector) -> tuple[Vector, Vector]:
        """Return tail and tip of the arrow of a force (2,) [N, N] that a robot exerts."""
        contact, reach = np.array(robot.contact), self.length(1.0) * force
        return (contact - reach, contact) if self._pushes(robot) else (contact, contact + reach)

    def _pushes(self, robot: Robot) -> bool:
        """Tell whether a robot's force along its direction goes into the object, and no other.

        At a corner a push along one side may point past the other: its tail is off the object.
        """
        is_any = robot.sectors is not None or robot.steers > 0.5 * math.pi
        if robot.mounted or robot.reverse_limit or is_any:
            return False
        contact, step = np.array(robot.contact), PROBE * self.outline.extent * _way(robot)
        return self.outline.contains(contact + step) or not self.outline.contains(contact - step)

    def box(self) -> tuple[Vector, Vector]:
        """Return the corners of the box round all that is drawn, each (2,) [m, m]."""
        pushing = (robot for robot in self.everyone if not robot.lever)
        areas = [area for robot in pushing for area in self.areas(robot)]
        bodies = [body_corners(self.outline, robot) for robot in self.everyone if robot.body]
        points = np.concatenate([self.outline.vertices, *areas, *bodies])
        return points.min(axis=0), points.max(axis=0)


def _way(robot: Robot) -> Vector:
    """Return the unit vector (2,) along a robot's direction."""
    return np.array([math.cos(robot.direction), math.sin(robot.direction)])


def _largest(robot: Robot) -> Vector:
    """Return the largest force (2,) [N] of a robot: along its direction, or of its envelope."""
    if robot.envelope is None:
        return robot.limit * _way(robot)
    corners = boundary_of(robot)
    return np.asarray(corners[np.argmax(np.hypot(*corners.T))])


def has_area(robot: Robot) -> bool:
    """Tell whether a robot's forces are more than those of a line."""
    return bool(robot.steers or robot.friction or robot.envelope or robot.sectors)


def draw_arrows(ax: Axes, ends: Sequence[tuple[Vector, Vector]], **look: Any) -> None:
    """Draw arrows between data points, as one collection.

    Parameters
    ----------
    ax : Axes
    ends : sequence of (tail, tip), each (2,) [m, m]
    **look
        `color`, `gid`, `width` [in] and whatever else `Axes.quiver` takes.
    """
    if not ends:
        return
    tails, tips = (np.array(side) for side in zip(*ends, strict=True))
    shape: dict[str, Any] = {
        "angles": "xy",
        "scale_units": "xy",
        "scale": 1.0,
        "units": "inches",
        "width": 0.024,
        "headwidth": 4.2,
        "headlength": 5.0,
        "headaxislength": 4.6,
        "minlength": 0.0,
        "zorder": 4,
    }
    ax.quiver(*tails.T, *(tips - tails).T, **(shape | look))


def draw_turn(
    ax: Axes, centre: Vector, radius: float, middle: float, sweep: float, **look: Any
) -> None:
    """Draw a curved arrow round a point: the sense of a torque.

    Parameters
    ----------
    ax : Axes
    centre : (2,) [m, m]
    radius : float [m]
    middle : float [rad]
        Bearing of the arc's middle.
    sweep : float [rad]
        Positive for counter-clockwise.
    **look
        `color`, `gid` and `linewidth` [pt].
    """
    angles = middle + np.linspace(-0.5, 0.5, 41) * sweep
    arc = centre + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    head = math.copysign(0.5, sweep)  # how far round the tip is ahead of the arc's end [rad]
    rim = np.array([0.68, 1.32, 1.0]) * radius
    turned = angles[-1] + np.array([0.0, 0.0, head])
    corners = centre + rim[:, None] * np.column_stack([np.cos(turned), np.sin(turned)])
    ax.plot(*arc.T, solid_capstyle="butt", zorder=5, **look)
    ax.fill(*corners.T, facecolor=look["color"], zorder=5, linewidth=0.0)


class ArrowEntry(Patch):
    """A legend entry to be drawn as an arrow.

    Parameters
    ----------
    breadth : float
        Of its shaft, relative to a robot's.
    **look
        `facecolor`, `label` and whatever else a patch takes.
    """

    def __init__(self, breadth: float = 1.0, **look: Any) -> None:
        super().__init__(**({"linewidth": 0.0} | look))
        self.breadth = breadth


class ArrowInLegend(HandlerPatch):
    """Draw an `ArrowEntry`."""

    def create_artists(
        self,
        legend: Legend,
        orig_handle: Any,
        xdescent: float,
        ydescent: float,
        width: float,
        height: float,
        fontsize: float,
        trans: Any,
    ) -> list[FancyArrow]:
        """Return the arrow; the arguments are those of matplotlib's own handlers."""
        del legend, fontsize
        shape = FancyArrow(
            -xdescent,
            0.5 * height - ydescent,
            width,
            0.0,
            width=0.26 * height * orig_handle.breadth,
            head_width=height * orig_handle.breadth**0.5,
            head_length=0.45 * width * orig_handle.breadth**0.5,
            length_includes_head=True,
        )
        shape.update_from(orig_handle)
        shape.set_transform(trans)
        return [shape]
