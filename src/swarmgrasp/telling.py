"""How one answer is told: in one unit for each quantity, in the frame of its file."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from swarmgrasp.terms import SI, Frame, Terms
from swarmgrasp.units import FORCES, LENGTHS, SPEEDS
from swarmgrasp.words import Lengths, Unit, machine_words, trimmed, turned

SPELT: Final = {"tf": "tonne-force (tf)", "kn": "knots", "ft": "feet", "in": "inches"}
"""Units whose names are short, spelt out."""
SIDES: Final = {(1, 0): "forward", (-1, 0): "aft", (0, 1): "to port", (0, -1): "to starboard"}
"""What directions of our frame are called."""
STRAIGHT: Final = 1e-9
"""Difference of a component from a whole number that counts as none."""


@dataclass(frozen=True)
class Telling:
    """How one answer is told.

    All forces of an answer come in one unit, and all lengths in one, so that its numbers can be
    compared as they stand.

    Attributes
    ----------
    terms : Terms
    force : Unit
    length : Lengths

    Examples
    --------
    >>> barge = Telling.of(Terms("ft", "tf", speed="kn", robot="tug"), 76.2, [590e3])
    >>> barge.force.text(196133.0), barge.point((-12.192, 10.9728)), barge.degrees(math.pi / 2)
    ('20.000 tf', '(-40.00, 36.00) ft', '90.0')
    >>> marine = Telling.of(Terms(frame=Frame(mirrored=True)), 76.2, [590e3])
    >>> marine.point((-12.192, 10.9728)), marine.sector((0.0, math.pi / 6))
    ('(-12.192, -10.973) m', '330 to 0 deg')
    """

    terms: Terms
    force: Unit
    length: Lengths

    @classmethod
    def of(cls, terms: Terms, extent: float, forces: Sequence[float]) -> "Telling":
        """Choose how to tell an answer.

        Parameters
        ----------
        terms : Terms
        extent : float [m]
            Of the object.
        forces : sequence of float [N]
            That are told; the largest chooses the prefix where the terms leave it open.
        """
        metres = LENGTHS[terms.length]
        length = Lengths.for_extent(extent, metres, terms.length)
        unit = Unit.for_size(*forces) if terms.force == "N" else Unit(
            FORCES[terms.force], terms.force
        )  # fmt: skip
        return cls(terms, replace(unit, metres=metres, arm=terms.length), length)

    # -- quantities ------------------------------------------------------------------------

    def area(self, square_metres: float) -> str:
        """Return an area [m2] with its unit."""
        return f"{trimmed(square_metres / self.length.metres**2, 4)} {self.length.name}2"

    def speed(self, speed: float) -> str:
        """Return a speed [m/s] with its unit.

        Examples
        --------
        >>> Telling.of(Terms(speed="kn"), 1.0, []).speed(12.861)
        '25 kn'
        """
        value = speed / SPEEDS[self.terms.speed]
        return f"{trimmed(value, 3)} {self.terms.speed}"

    def wrench(self, wrench: Sequence[float], length: float) -> tuple[str, str, str]:
        """Return the parts of a wrench (3,) [N, N, N m] along the axes of the file.

        Parameters
        ----------
        wrench : (3,) [N, N, N m]
        length : float [m]
            By which its torque counts beside its force.
        """
        return self.force.wrench(self.terms.frame.wrench_to_file(wrench).tolist(), length)

    def room(self, length: float, beam: float) -> str:
        """Say how much room a body of some length and beam [m] takes up.

        Examples
        --------
        >>> Telling.of(Terms("ft"), 76.2, []).room(30.48, 9.144)
        'needs 100 ft by 30 ft of room'
        """
        return f"needs {self.length.short(length)} by {self.length.short(beam)} of room"

    # -- where and which way ---------------------------------------------------------------

    def xy(self, point: Sequence[float]) -> list[str]:
        """Return the coordinates [m, m] of a point in the file's frame, without their unit."""
        return [self.length.number(v) for v in self.terms.frame.to_file(point).tolist()]

    def point(self, point: Sequence[float]) -> str:
        """Return a point [m, m] in the file's frame."""
        return self.length.point(self.terms.frame.to_file(point).tolist())

    def arc(self, arc_length: float, perimeter: float) -> float:
        """Return an arc length [m] as the file counts it, from the first vertex its way round.

        Examples
        --------
        >>> frames = Frame(), Frame(mirrored=True)
        >>> [Telling.of(Terms(frame=frame), 9.0, []).arc(5.0, 12.0) for frame in frames]
        [5.0, 7.0]
        """
        return perimeter - arc_length if self.terms.frame.mirrored and arc_length else arc_length

    def along(self) -> str:
        """Return the small print on arc lengths."""
        return f"Along the outline: {_sense(self.terms.frame)} from its first vertex."

    def degrees(self, direction: float) -> str:
        """Return a direction [rad] in the file's frame in degrees, or as a bearing, never -0."""
        if self.terms.bearings:
            return f"{round(math.degrees(self.terms.frame.bearing(direction)), 1) % 360.0:.1f}"
        return f"{round(turned(self.terms.frame.direction_to_file(direction)), 1) + 0.0:.1f}"

    def short(self, direction: float) -> str:
        """Return a direction [rad] as short as it can be: 90 for 90.0."""
        return f"{float(self.degrees(direction)):g}"

    def direction(self, direction: float) -> str:
        """Return a direction [rad] in words: with its unit, and that it is a bearing if it is."""
        said = f"{self.degrees(direction)} deg"
        return f"bearing {said}" if self.terms.bearings else said

    @property
    def way(self) -> str:
        """The heading of a column of directions."""
        return "bearing [deg]" if self.terms.bearings else "to [deg]"

    def sector(self, sector: Sequence[float]) -> str:
        """Say between which directions [rad] a sector lies, in the sense in which they count."""
        is_clockwise = self.terms.bearings or self.terms.frame.mirrored
        ends = reversed(sector) if is_clockwise else sector
        first, last = (f"{float(self.degrees(angle)) % 360.0:g}" for angle in ends)
        return f"{first} to {last} deg" if sector[0] != sector[1] else f"{first} deg"

    def from_words(self, bearing: float) -> str:
        """Say where wind or current comes from.

        Parameters
        ----------
        bearing : float [rad]
            Clockwise from the bow. It is told so, or as a true one where the frame has a heading.

        Examples
        --------
        >>> Telling.of(Terms(), 1.0, []).from_words(math.pi / 3)
        'from 60 deg'
        """
        true = "" if self.terms.frame.heading is None else " true"
        return f"from {round(self.from_degrees(bearing), 1) % 360.0:g} deg{true}"

    def from_degrees(self, bearing: float) -> float:
        """Return where wind or current comes from as it is told, in degrees within [0, 360).

        Parameters
        ----------
        bearing : float [rad]
            Clockwise from the bow.

        Examples
        --------
        >>> due_east = Terms(frame=Frame(heading=math.pi / 2))
        >>> Telling.of(due_east, 1.0, []).from_degrees(math.pi / 3)
        150.0
        """
        return round(math.degrees(self.terms.frame.bearing(-bearing)), 9) % 360.0

    # -- words -----------------------------------------------------------------------------

    def machines(self, count: int, has_groups: bool) -> str:
        """Return what so many of that which fails at once are called."""
        return machine_words(count, has_groups, self.terms.robot)

    @property
    def frame_words(self) -> str:
        """Say how the frame of the file lies on the object."""
        frame = self.terms.frame
        x, y = (_side(frame, axis) for axis in ((1.0, 0.0), (0.0, 1.0)))
        return f"x {x}, y {y}" if x and y else f"the bow towards {_bow(frame)}"

    def notes(self) -> list[str]:
        """Return the small print: what the units and the frame are."""
        terms, frame = self.terms, self.terms.frame
        units = [terms.length, self.force.name, terms.speed, "degrees"]
        said = f"Units: {', '.join(SPELT.get(unit, unit) for unit in units)}"
        if (terms.length, terms.force, terms.speed) == (SI.length, SI.force, SI.speed):
            said = "Units: SI with degrees"
        radians = " for the file's radians" * (terms.angle == "rad")
        sense = _sense(frame)
        ways = f"degrees {sense} from +x"
        if terms.bearings:
            from_ = "north" if frame.heading is not None else "the bow"
            ways = f"bearings, degrees clockwise from {from_}"
        torques = f"; torques {sense}" if frame.mirrored else ""
        return [
            f"{said}{radians}. Frame: {self.frame_words}, as in the file{torques}.",
            f"Directions: {ways}, the way the force acts on the object.",
        ]


def _side(frame: Frame, axis: tuple[float, float]) -> str:
    """Return where an axis of a file points on the object; nothing if that is askew."""
    x, y = frame.from_file(axis).tolist()
    nearest = (round(x), round(y))
    off = max(abs(x - nearest[0]), abs(y - nearest[1]))
    return SIDES.get(nearest, "") if off <= STRAIGHT else ""


def _bow(frame: Frame) -> str:
    """Return the direction of the bow in a file's frame."""
    return f"{math.degrees(frame.bow):.4g} deg {_sense(frame)} from +x"


def _sense(frame: Frame) -> str:
    """Return which way a file's angles turn."""
    return "clockwise" if frame.mirrored else "counter-clockwise"
