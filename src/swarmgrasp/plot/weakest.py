"""The wrench a swarm is weakest at."""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.plot import style
from swarmgrasp.plot.direction import draw_direction
from swarmgrasp.plot.labels import Page
from swarmgrasp.quality import Quality
from swarmgrasp.swarm import Swarm


def draw_weakest(page: Page, swarm: Swarm, quality: Quality, when: str) -> None:
    """Draw the wrench the swarm is weakest at, and say how weak it is or was."""
    label_wrench(page, swarm, quality, draw_wrench(page, swarm, quality), when)


def draw_wrench(page: Page, swarm: Swarm, quality: Quality) -> float:
    """Draw the wrench the swarm is weakest at; return the radius [m] of its turn."""
    return draw_direction(page, swarm, _weakest(swarm, quality), "weakest")


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
