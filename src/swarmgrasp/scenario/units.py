"""The units a scenario file may use; everything behind the file is in SI."""

import math
from dataclasses import dataclass

from swarmgrasp.environment import KNOT

LENGTHS = {"m": 1.0, "ft": 0.3048}
"""Metres per unit of length."""

FORCES = {"N": 1.0, "kN": 1000.0, "tonne-force": 9806.65}
"""Newtons per unit of force."""

ANGLES = {"rad": 1.0, "deg": math.pi / 180.0}
"""Radians per unit of angle."""

SPEEDS = {"m/s": 1.0, "knot": KNOT}
"""Metres per second per unit of speed."""


@dataclass(frozen=True)
class Units:
    """The units of one file.

    Attributes
    ----------
    length, force, angle, speed : str
        Names of units, for messages.

    Examples
    --------
    >>> file = Units(length="ft", force="tonne-force", angle="deg")
    >>> file.metres(250), file.newtons(2), file.radians(90) == math.pi / 2
    (76.2, 19613.3, True)
    """

    length: str = "m"
    force: str = "N"
    angle: str = "rad"
    speed: str = "m/s"

    def metres(self, length: float) -> float:
        """Convert a length to metres."""
        return length * LENGTHS[self.length]

    def newtons(self, force: float) -> float:
        """Convert a force to newtons."""
        return force * FORCES[self.force]

    def radians(self, angle: float) -> float:
        """Convert an angle to radians."""
        return angle * ANGLES[self.angle]

    def square_metres(self, area: float) -> float:
        """Convert an area to square metres."""
        return area * LENGTHS[self.length] ** 2

    def metres_per_second(self, speed: float) -> float:
        """Convert a speed to metres per second."""
        return speed * SPEEDS[self.speed]

    def turn(self, fraction: float) -> float:
        """Return a fraction of a full turn in this file's unit of angle."""
        return 360.0 * fraction if self.angle == "deg" else 2.0 * math.pi * fraction
