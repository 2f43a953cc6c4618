"""The units and the frame of a scenario file; everything behind the file is in SI and in ours."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from swarmgrasp.terms import OURS, Frame
from swarmgrasp.units import ANGLES, FORCES, LENGTHS, SPEEDS

NAMED = ("length", "force", "angle", "speed")
"""What a file names its units of."""
Pair = tuple[float, float]


@dataclass(frozen=True)
class Units:
    """The units of one file, and its frame.

    Attributes
    ----------
    length, force, angle, speed : str
        Names of units, as `swarmgrasp.units` has them.
    frame : Frame
        How its coordinates and directions lie in ours.

    Examples
    --------
    >>> file = Units(length="ft", force="tf", angle="deg")
    >>> file.metres(250), file.newtons(2), file.radians(90) == math.pi / 2
    (76.2, 19613.3, True)
    >>> file.of("torque"), file.of("area"), file.of("mass")
    ('tf ft', 'ft^2', '')

    With y to starboard, all that turns turns the other way:

    >>> ned = Units(angle="deg", frame=Frame(mirrored=True))
    >>> ned.point([3, 4]), ned.span([0, 180]), ned.wrench([1, 2, 3])
    ((3.0, -4.0), (-3.141592653589793, 0.0), (1.0, -2.0, -3.0))
    """

    length: str = "m"
    force: str = "N"
    angle: str = "rad"
    speed: str = "m/s"
    frame: Frame = OURS

    def of(self, measured: str) -> str:
        """Return the unit of a number that has none, by what it measures; "" where it is SI's."""
        units = {
            "length": self.length,
            "force": self.force,
            "angle": self.angle,
            "speed": self.speed,
            "area": f"{self.length}^2",
            "torque": f"{self.force} {self.length}",
            "turn rate": f"{self.angle}/s",
        }
        return units.get(measured, "")

    # -- sizes --------------------------------------------------------------------------

    def metres(self, length: float) -> float:
        """Convert a length to metres."""
        return length * LENGTHS[self.length]

    def newtons(self, force: float) -> float:
        """Convert a force to newtons."""
        return force * FORCES[self.force]

    def radians(self, angle: float) -> float:
        """Convert an angle without a sense of turning, or of the file's frame, to radians."""
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

    # -- what has a frame ---------------------------------------------------------------

    def point(self, written: Sequence[float]) -> Pair:
        """Return a point or an offset [file units] in our frame [m, m]."""
        x, y = map(self.metres, written)
        if self.frame == OURS:
            return x, y
        x, y = self.frame.from_file((x, y)).tolist()
        return x, y

    def direction(self, angle: float) -> float:
        """Return a direction [file units] in our frame [rad]."""
        return self.frame.direction_from_file(self.radians(angle))

    def span(self, written: Sequence[float]) -> Pair:
        """Return directions from one to another [file units] as ours, counter-clockwise [rad]."""
        first, last = map(self.direction, written)
        return (last, first) if self.frame.mirrored else (first, last)

    def turned(self, angle: float) -> float:
        """Return an angle turned by [file units], counter-clockwise [rad]."""
        return self.radians(-angle if self.frame.mirrored else angle)

    def either_way(self, ends: Pair) -> Pair:
        """Return two offsets along the boundary, or of a direction, as ours run."""
        return (-ends[1], -ends[0]) if self.frame.mirrored else ends

    def wrench(self, written: Sequence[float]) -> tuple[float, float, float]:
        """Return a wrench [file units] in our frame [N, N, N m]."""
        surge, sway, yaw = map(self.newtons, written)
        yaw = self.metres(yaw)
        if self.frame == OURS:
            return surge, sway, yaw
        surge, sway, yaw = self.frame.wrench_from_file((surge, sway, yaw)).tolist()
        return surge, sway, yaw
