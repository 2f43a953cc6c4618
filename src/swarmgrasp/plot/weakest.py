"""The wrench a swarm is weakest at."""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.plot import style, written
from swarmgrasp.plot.arrows import Arrows
from swarmgrasp.plot.direction import Pointer
from swarmgrasp.plot.labels import Page
from swarmgrasp.quality import Quality
from swarmgrasp.swarm import Swarm


def weakest_pointer(arrows: Arrows, swarm: Swarm, quality: Quality) -> Pointer:
    """Return the wrench the swarm is weakest at, as large as it is held; a direction if not held.

    Parameters
    ----------
    arrows : Arrows
    swarm : Swarm
    quality : Quality
        Of the swarm.
    """
    size = quality.value if quality.value > 0.0 else 1.0
    wrench = size * _weakest(quality, swarm)
    return Pointer(arrows, swarm, wrench, "weakest wrench", is_measured=quality.value > 0.0)


def label_weakest(
    page: Page, swarm: Swarm, quality: Quality, radius: float, when: str = ""
) -> None:
    """Say beside the weakest wrench how weak the swarm is or was."""
    origin = swarm.outline.origin
    side = 1.0 if _weakest(quality, swarm)[1] < 0.0 else -1.0  # off the arrow
    bearings = np.array([side, -side, 0.0, 2.0]) * 0.5 * math.pi
    beside = origin + 1.4 * radius * np.column_stack([np.cos(bearings), np.sin(bearings)])
    text = _weakness(quality, when)
    page.label(text, beside, bearings, fontsize=8.0, color=style.WINE, gid="weakest-label")


def _weakest(quality: Quality, swarm: Swarm) -> NDArray[np.float64]:
    """Return the wrench (3,) [N, N, N m] that is weakest, for a quality of 1.

    Of a ball it is the normal of the weakest facet; of a task the wrench that reaches it first.
    """
    task = quality.criterion.task
    ball = np.asarray(quality.direction / swarm.scale)
    if task is None:
        return ball
    farthest = np.asarray(task.farthest(quality.direction * swarm.scale))
    return farthest if farthest.any() else ball


def _weakness(quality: Quality, when: str) -> str:
    """Say how weak a swarm is or was."""
    criterion = quality.criterion
    if quality.value > 0.0:
        return f"weakest{when}: {written.quality(quality.value, criterion)}"
    if criterion.has_load:
        return f"load not held{when}"
    return f"not force closed{when}" if criterion.task is None else f"task not possible{when}"
