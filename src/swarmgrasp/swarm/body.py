"""The room that a robot takes up beside the object."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import RobotInvalid
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import STRONGEST, number, shown


@dataclass(frozen=True)
class Body(Plain):
    """The room that a robot takes up, away from its contact: of one that pulls, its line too.

    It lies along the robot's force: behind the contact of one that pushes, ahead of the contact of
    one that pulls; it swings with one that steers, but with one that steers by more than a right
    angle, which lies along the normal. It widens from a point at the contact to its beam within
    half a beam, as a bow does.

    Attributes
    ----------
    length : float [m]
        From the contact; of a robot that pulls on a line, the line and the robot.
    beam : float [m]

    Raises
    ------
    RobotInvalid
        If a number is no length above 0; all faults at once.

    Examples
    --------
    A tug of 30 m by 10 m at the origin that pushes along +x, and lies behind:

    >>> from math import pi
    >>> Body(30.0, 10.0).corners([(0.0, 0.0)], [pi]).round(6).tolist()
    [[[0.0, 0.0], [-5.0, 5.0], [-30.0, 5.0], [-30.0, -5.0], [-5.0, -5.0]]]
    """

    length: float
    beam: float

    def __post_init__(self) -> None:
        """Check the values."""
        faults = [
            f"the {what} of a body is {shown(value)}; it should be a length above 0, at most "
            f"{STRONGEST:g} [m]"
            for what, value in (("length", self.length), ("beam", self.beam))
            if not 0.0 < number(value) <= STRONGEST
        ]
        if faults:
            raise RobotInvalid(faults)
        vars(self).update(length=float(self.length), beam=float(self.beam))

    def corners(
        self, contacts: ArrayLike, away: ArrayLike, widened: ArrayLike = 1.0
    ) -> NDArray[np.float64]:
        """Return the corners of the body, the contact first, counter-clockwise.

        Parameters
        ----------
        contacts : (n, 2) [m, m]
        away : (n,) [rad]
            Direction in which the body lies.
        widened : (n,) or float
            By which the body is stretched from its contact: 1 / cos(t) lets the hull of two that
            are 2 t apart cover all between.

        Returns
        -------
        (n, 5, 2) [m, m]
        """
        half, way = 0.5 * self.beam, np.asarray(away, dtype=float)
        waist, size = min(half, self.length), np.asarray(widened, dtype=float)
        along = np.array([0.0, waist, self.length, self.length, waist])
        across = half * np.array([0.0, -1.0, -1.0, 1.0, 1.0])
        c, s = (size * np.cos(way))[..., None], (size * np.sin(way))[..., None]
        found = np.stack([along * c - across * s, along * s + across * c], axis=-1)
        return np.asarray(np.asarray(contacts, dtype=float)[:, None] + found)
