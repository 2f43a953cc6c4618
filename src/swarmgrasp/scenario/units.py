"""The units of a scenario file; everything behind the file is in SI."""

import math
from dataclasses import dataclass

from swarmgrasp.units import ANGLES, FORCES, LENGTHS, SPEEDS


@dataclass(frozen=True)
class Units:
    """The units of one file.

    Attributes
    ----------
    length, force, angle, speed : str
        Names of units, as `swarmgrasp.units` has them.

    Examples
    --------
    >>> file = Units(length="ft", force="tf", angle="deg")
    >>> file.metres(250), file.newtons(2), file.radians(90) == math.pi / 2
    (76.2, 19613.3, True)
    >>> file.of("torque"), file.of("area"), file.of("mass")
    ('tf ft', 'ft^2', '')
    """

    length: str = "m"
    force: str = "N"
    angle: str = "rad"
    speed: str = "m/s"

    def of(self, measured: str) -> str:
        """Return the unit of a number that has none, by what it measures; "" where it is SI's."""
        units = {
            **vars(self),
            "area": f"{self.length}^2",
            "torque": f"{self.force} {self.length}",
            "turn rate": f"{self.angle}/s",
        }
        return str(units.get(measured, ""))

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
