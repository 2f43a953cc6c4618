"""What a newcomer adds that keeps all it can exert: it steers, or has friction (T20, T22)."""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement.pieces import halves_of
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.ties import SoftMinimum
from swarmgrasp.quality.aim import Aim
from swarmgrasp.swarm import Newcomer, Robot

Array = NDArray[np.float64]
TRIED, CHECKED = 160, 12
"""Contacts that are compared, and those of them whose quality is computed."""


class Kept:
    """A newcomer that keeps its force set, beside a swarm.

    Parameters
    ----------
    aim : Aim
        The swarm's.
    problem : Problem
    """

    def __init__(self, aim: Aim, problem: Problem) -> None:
        self._aim, self._problem, self._limit = aim, problem, problem.certain_limit

    def gains(self, arms: Array, sectors: Array, normals: Array) -> Array:
        """Return what it adds at moment arms (c, 2) along normals (m, 3): (c, m) [N].

        It keeps the sectors (c, 2) [rad] there, as far as that is certain.
        """
        newcomer, sectors = self._problem.newcomer, self._problem.certain_sectors(sectors)
        u, v, turn = (normals * self._aim.swarm.scale).T
        px, py = u - turn * arms[:, 1:], v + turn * arms[:, :1]
        middle, half = sectors.mean(axis=1)[:, None], halves_of(sectors)[:, None]
        limits = self._limit, newcomer.reverse_limit
        return support(px, py, middle, half, limits, newcomer.friction or 0.0)

    def scores(self, arms: Array, sectors: Array) -> Array:
        """Return what the soft minimum makes of it at moment arms and in sectors (c, 2): (c,)."""
        least = SoftMinimum(self._aim, self._limit)
        return least.scores(self.gains(arms, sectors, least.normals))


def support(
    px: Array, py: Array, middle: Array, half: Array, limits: tuple[float, float], friction: float
) -> Array:
    """Return what forces are worth along p (...), the parts of it (T20): those of a sector.

    Parameters
    ----------
    px, py : (...)
    middle, half : (...) [rad]
        The sector's middle, and how far it reaches to both sides.
    limits : tuple of float [N, N]
        Ahead and astern.
    friction : float
        Of a finger along the middle; 0 for what is none.

    Returns
    -------
    (...) [N]
    """
    c, s = np.cos(middle), np.sin(middle)
    ahead, side = px * c + py * s, np.abs(px * s - py * c)
    if friction:
        return np.asarray(limits[0] * np.maximum(ahead + friction * side, 0.0))
    size, c, s = np.hypot(px, py), np.cos(half), np.sin(half)
    worths = [
        most * np.where(way >= size * c, size, np.maximum(way * c + side * s, 0.0))
        for most, way in zip(limits, (ahead, -ahead), strict=True)
        if most > 0.0
    ]
    return np.asarray(np.maximum.reduce(worths))


def kept_robot(
    newcomer: Newcomer, contact: tuple[float, float], lo: float, hi: float, name: str = ""
) -> Robot:
    """Return a newcomer in contact that keeps its force set in a sector [rad]."""
    steers = 0.0 if newcomer.friction else float(halves_of(np.array([lo, hi])))
    return Robot(
        contact, math.remainder(0.5 * (lo + hi), math.tau), newcomer.limit, name,
        newcomer.mounted, newcomer.tolerance, newcomer.reverse_limit, steers, newcomer.friction,
        body=newcomer.body,
    )  # fmt: skip
