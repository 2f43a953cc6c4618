"""Of robots as good as the best, the one that lifts the rest of h most (T17).

By a grid over the boxes where such robots may be, and finer ones around the best of it.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.quality.aim import Aim
from swarmgrasp.swarm import wrenches

Array = NDArray[np.float64]
CANDIDATES = 144
"""Places compared at a time."""
CHECKS = 12
"""Of them, those whose quality is computed."""
ZOOMS, SIDE, FINER = 3, 5, 0.4
"""Finer grids, their sides, and their steps beside those of the one before."""
DIRECTIONS, SOFTNESS, POWER, SCALE = 64, 0.5, 8, 0.25
"""Of the soft minimum: normals, what is added to H relative to its mean, the power, and the least
mean, as a share of the newcomer's generator where nothing turns."""
LEAST = 0.05
"""What H, relative to its mean, counts as where a load leaves less."""


class Spot(NamedTuple):
    """Where a newcomer may be.

    Attributes
    ----------
    piece : int
    share : float
        Of the way from the piece's first end to its last.
    direction : float [rad]
    """

    piece: int
    share: float
    direction: float


class SoftMinimum:
    """How far newcomers lift H over all directions (T17).

    Parameters
    ----------
    aim : Aim
        The base swarm's.
    limit : float [N]
        The newcomer's: of few robots, or none, it sets the scale.

    Attributes
    ----------
    normals : (m, 3)
        Spread evenly.
    """

    def __init__(self, aim: Aim, limit: float) -> None:
        k = np.arange(DIRECTIONS)
        z = 1.0 - (2.0 * k + 1.0) / DIRECTIONS
        across, turn = np.sqrt(1.0 - z * z), k * np.pi * (3.0 - np.sqrt(5.0))
        self.normals = np.column_stack([across * np.cos(turn), across * np.sin(turn), z])
        height = aim.levels(self.normals)[:, 0]
        self._mean = max(
            float(height.mean()), SCALE * limit * float(np.hypot(*aim.swarm.scale[:2]))
        )
        self._height = np.maximum(height / self._mean + SOFTNESS, LEAST)

    def scores(self, gains: Array) -> Array:
        """Return sums over directions (c,) for gains (c, m) [N]: less, the higher the minimum."""
        return np.asarray(((self._height + gains / self._mean) ** -POWER).sum(axis=1))


class Tie:
    """Robots that may be as good as the best.

    Parameters
    ----------
    aim : Aim
        The base swarm's.
    limits : tuple of float [N, N]
        The newcomer's, ahead and astern.
    rows : (k, 10)
        The pieces; see `Pieces`.
    normals : (n, 3)
        Those met, along which a robot must reach the target.
    target : float [N]
        The quality wanted.
    """

    def __init__(
        self, aim: Aim, limits: tuple[float, float], rows: Array, normals: Array, target: float
    ) -> None:
        self._limits, self._rows, self._scale = limits, rows, aim.swarm.scale
        self._normals, self._levels, self._target = normals, aim.levels(normals), target
        self._least = SoftMinimum(aim, limits[0])

    def best(
        self, boxes: Array, start: Spot | None, qualities: Callable[[Array], Array]
    ) -> Spot | None:
        """Return the robot that reaches the target and lifts the rest most.

        Parameters
        ----------
        boxes : (m, 5)
            Where to look: piece, shares of its first and last contact, first and last direction.
        start : Spot, optional
            One that is as good as the best.
        qualities : callable
            Returns those (c,) [N] with robots (c, 3): moment arms and directions.
        """
        spots, found, least = _grid(boxes), start, np.inf
        if start is not None:
            least = float(self._scores(np.array([start]))[0])
        for _ in range(ZOOMS + 1):
            scores = np.where(self._may_reach(spots), self._scores(spots), np.inf)
            order = np.argsort(scores, kind="stable")[:CHECKS]
            for k in order[scores[order] < least]:
                if qualities(self.robots(spots[k : k + 1]))[0] >= self._target:
                    least, found, at = float(scores[k]), _spot(spots[k]), spots[k]
                    break
            if found is start:
                break  # no candidate is better than the search's own
            spots = self._finer(at)
        return found

    def robots(self, spots: Array) -> Array:
        """Return moment arms and directions (c, 3) of spots."""
        ends, share = self._rows[spots[:, 0].astype(int)], spots[:, 1:2]
        return np.column_stack([ends[:, :2] + share * (ends[:, 2:4] - ends[:, :2]), spots[:, 2]])

    def _gains(self, spots: Array, normals: Array) -> Array:
        """Return what robots add along normals: (c, m) [N]."""
        robots = self.robots(spots)
        along = wrenches(robots[:, :2], robots[:, 2], 1.0) * self._scale @ normals.T
        ahead, astern = self._limits
        return np.maximum(ahead * along, -astern * along)

    def _may_reach(self, spots: Array) -> NDArray[np.bool_]:
        """Tell which robots reach the target along all normals met."""
        height, cap, extent = self._levels.T
        reached = np.minimum(height + self._gains(spots, self._normals), cap)
        return np.asarray((reached >= self._target * extent).all(axis=1))

    def _scores(self, spots: Array) -> Array:
        """Return what the soft minimum makes of spots: (c,)."""
        return self._least.scores(self._gains(spots, self._least.normals))

    def _finer(self, at: Array) -> Array:
        """Return a finer grid around a spot, with its steps."""
        side = np.linspace(-1.0, 1.0, SIDE)
        spots = np.tile(at, (SIDE * SIDE, 1))
        lo, hi = self._rows[int(at[0]), 4:6]
        spots[:, 1] = np.clip(at[1] + at[3] * np.repeat(side, SIDE), 0.0, 1.0)
        spots[:, 2] = np.clip(at[2] + at[4] * np.tile(side, SIDE), lo, hi)
        spots[:, 3:] *= FINER
        return spots


def _grid(boxes: Array) -> Array:
    """Return spots (c, 5) in boxes, the largest first, each with the steps to the next ones."""
    wide, high = boxes[:, 2] - boxes[:, 1], boxes[:, 4] - boxes[:, 3]
    chosen = np.argsort(-wide * high, kind="stable")[:CANDIDATES]
    side = max(1, int(np.sqrt(CANDIDATES / max(1, len(chosen)))))
    share = (np.arange(side) + 0.5) / side
    along, across = (part.ravel() for part in np.meshgrid(share, share))
    piece = np.repeat(boxes[chosen, 0], side * side)
    return np.column_stack(
        [
            piece,
            (boxes[chosen, 1, None] + wide[chosen, None] * along).ravel(),
            (boxes[chosen, 3, None] + high[chosen, None] * across).ravel(),
            np.repeat(wide[chosen] / side, side * side),
            np.repeat(high[chosen] / side, side * side),
        ]
    )


def _spot(row: Array) -> Spot:
    """Return a row as a spot."""
    return Spot(int(row[0]), float(row[1]), float(row[2]))
