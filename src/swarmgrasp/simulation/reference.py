"""Where the object is to be: set points and paths, made smooth enough to be followed."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Target(NamedTuple):
    """Where the object is to be, moved as it pleases: to a point, or along a path.

    Attributes
    ----------
    corners : (k, 2) [m, m]
        The first is where it begins, and one is enough.
    heading : float [rad]
    start : float [s]
        When it begins.
    speed : float [m/s]
        Along the path.
    """

    corners: Array
    heading: float
    start: float = 0.0
    speed: float = 0.0

    def at(self, time: float) -> Array:
        """Return the pose (3,) [m, m, rad] at a time [s]; at the end of the path it stays.

        Examples
        --------
        >>> Target(np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]]), 0.5, 10.0, 2.0).at(12.5).tolist()
        [4.0, 1.0, 0.5]
        """
        if len(self.corners) == 1:
            return np.array([*self.corners[0], self.heading])
        steps = np.hypot(*np.diff(self.corners, axis=0).T)
        along = np.concatenate([[0.0], np.cumsum(steps)])
        gone = self.speed * max(0.0, time - self.start)
        x, y = (float(np.interp(gone, along, column)) for column in self.corners.T)
        return np.array([x, y, self.heading])


class Point(NamedTuple):
    """A pose (3,) [m, m, rad], its velocity and its acceleration, in the earth's frame."""

    pose: Array
    velocity: Array
    acceleration: Array


class Reference:
    """What the object is to do, which goes to its target as a critically damped spring would.

    ``x'' = w^2 (target - x) - 2 w x'``, exactly for a target that stays for a period. A path is
    followed 2 / w behind, and its corners are rounded.

    Parameters
    ----------
    frequency : float [rad/s]
        w.
    """

    def __init__(self, frequency: float) -> None:
        self._frequency = frequency
        self._target = Target(np.zeros((1, 2)), 0.0)
        self._pose, self._velocity = np.zeros(3), np.zeros(3)

    def move(self, place: Sequence[float], heading: float) -> None:
        """Aim at another place [m, m] and heading [rad]."""
        self._target = Target(np.array([place], dtype=float), heading)

    def follow(self, path: Sequence[Sequence[float]], speed: float, time: float) -> None:
        """Aim along a path from the place aimed at, from a time [s] on at a speed [m/s]."""
        x, y, heading = self._target.at(time).tolist()
        self._target = Target(np.array([(x, y), *path], dtype=float), heading, time, speed)

    def at(self, time: float) -> Point:
        """Return the reference now, at a time [s]."""
        w, off = self._frequency, self._target.at(time) - self._pose
        return Point(self._pose, self._velocity, w * w * off - 2.0 * w * self._velocity)

    def advance(self, time: float, period: float) -> None:
        """Go on from a time [s] for a period [s]."""
        w, target = self._frequency, self._target.at(time)
        off, decay = self._pose - target, math.exp(-w * period)
        push = self._velocity + w * off
        self._pose = target + (off + push * period) * decay
        self._velocity = (self._velocity - w * push * period) * decay

    @property
    def heading(self) -> float:
        """The heading [rad] that the object is to have now."""
        return float(self._pose[2])

    @property
    def goal(self) -> dict[str, float]:
        """Where it is to go in the end: `x` and `y` [m], and `heading` [rad]."""
        x, y = self._target.corners[-1].tolist()
        return {"x": x, "y": y, "heading": self._target.heading}
