"""The wrench a swarm is weakest at."""

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.plot import style
from swarmgrasp.plot.arrows import draw_arrows, draw_turn
from swarmgrasp.plot.labels import Page
from swarmgrasp.quality import Quality
from swarmgrasp.swarm import Swarm

LEAST_PART: Final = 0.02
"""Share of the weakest wrench below which its force or its torque is not drawn."""

WEAKEST_SIZES: Final = (38.0, 13.0)
"""Length of the weakest wrench's force and radius of its turn [pt]: it is a direction,
so its size follows the paper and not the object."""


def draw_weakest(page: Page, swarm: Swarm, quality: Quality, when: str) -> None:
    """Draw the wrench the swarm is weakest at, and say how weak it is or was."""
    label_wrench(page, swarm, quality, draw_wrench(page, swarm, quality), when)


def draw_wrench(page: Page, swarm: Swarm, quality: Quality) -> float:
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


def label_wrench(page: Page, swarm: Swarm, quality: Quality, radius: float, when: str) -> None:
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
