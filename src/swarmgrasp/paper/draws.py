"""Random configurations of the paper's kind; its own are printed nowhere."""

import math
from functools import lru_cache

import numpy as np

from swarmgrasp.outline import Outline
from swarmgrasp.placement import Problem
from swarmgrasp.swarm import Newcomer, Robot, Swarm

LENGTH, BREADTH = 2.0, 1.0
"""Of the rectangle [m], a choice made here."""

NORMAL = "along the normal"
FREE = "in any direction"
NEWCOMERS = {NORMAL: Newcomer(1.0, "pull", 0.0), FREE: Newcomer(1.0, "free")}
"""What a newcomer of 1 N may do: as the robots of the paper's examples, or all a robot can."""

Task = tuple[int, int, int]
"""Seed, number of robots, and number of the draw."""


@lru_cache(maxsize=1)
def rectangle() -> Outline:
    """Return the object."""
    x, y = 0.5 * LENGTH, 0.5 * BREADTH
    return Outline([(-x, -y), (x, -y), (x, y), (-x, y)])


def generator(task: Task, purpose: int = 0) -> np.random.Generator:
    """Return the random numbers of a draw, of their own for each purpose."""
    return np.random.default_rng([*task, purpose])


def pulling(task: Task) -> Swarm:
    """Draw robots of 1 N, each anywhere on the rectangle, that pull along the outward normal.

    Examples
    --------
    >>> swarm = pulling((1, 5, 0))
    >>> len(swarm), swarm.limits.tolist() == [1.0] * 5
    (5, True)
    """
    outline = rectangle()
    shares = generator(task).random(task[1])
    contacts = [outline.at_arc_length(float(share) * outline.perimeter) for share in shares]
    return Swarm(outline, [Robot(c.point, c.inward + math.pi) for c in contacts])


def problem(task: Task, kind: str = FREE) -> Problem:
    """Return the question where a newcomer goes in such a draw."""
    return Problem(pulling(task), NEWCOMERS[kind])


def tasks(seed: int, robots: int, count: int) -> list[Task]:
    """Return the draws of a study."""
    return [(seed, robots, k) for k in range(count)]
