"""How a file and its readers speak: their units, their frame, and what they call a robot.

Everything inside is in SI units and in one frame: metres, newtons, radians; x forward, y to port,
angles counter-clockwise. Here that becomes what a file's people write and read, and back.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import TermsInvalid, refuse
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import angles, is_flag, name_faults, shown
from swarmgrasp.units import ANGLES, FORCES, LENGTHS, SPEEDS
from swarmgrasp.words import plural

UNITS: Final = {"length": LENGTHS, "force": FORCES, "angle": ANGLES, "speed": SPEEDS}
"""The units in which answers are told, of each quantity."""


@dataclass(frozen=True)
class Frame(Plain):
    """The frame of a file: how its coordinates and directions lie in ours, and in the world.

    Ours has x forward, y to port and angles counter-clockwise. Both have the same point (0, 0).

    Attributes
    ----------
    bow : float [rad]
        Direction of the bow in the file's frame, in the file's sense of turning.
    mirrored : bool
        Whether the file's angles run clockwise, as with x forward and y to starboard.
    heading : float or None [rad]
        True bearing of the bow, clockwise from north; None where nothing is said of it.

    Raises
    ------
    TermsInvalid
        If a number is no angle, or a flag no flag.

    Examples
    --------
    Of a hull with y ahead and x to starboard, and of one with x ahead and y to starboard:

    >>> survey, marine = Frame(bow=math.pi / 2), Frame(mirrored=True)
    >>> survey.from_file((2.0, 30.0)).tolist(), marine.from_file((30.0, 2.0)).tolist()
    ([30.0, -2.0], [30.0, -2.0])
    >>> survey.to_file((30.0, -2.0)).tolist(), marine.wrench_to_file((1.0, 2.0, 3.0)).tolist()
    ([2.0, 30.0], [1.0, -2.0, -3.0])
    >>> marine.direction_to_file(0.5), survey.direction_from_file(math.pi / 2)
    (-0.5, 0.0)
    """

    bow: float = 0.0
    mirrored: bool = False
    heading: float | None = None

    def __post_init__(self) -> None:
        """Check the fields."""
        faults = [
            f"the {name} of the frame is {shown(value)}; it should be an angle in radians"
            for name, value in (("bow", self.bow), ("heading", self.heading or 0.0))
            if not angles(value)
        ]
        if not is_flag(self.mirrored):
            faults.append(f"mirrored is {shown(self.mirrored)}; it should be True or False")
        refuse((TermsInvalid, faults))

    @cached_property
    def _turn(self) -> NDArray[np.float64]:
        """Return the matrix (2, 2) that takes points of ours to the file's; its inverse is ^T."""
        quarters = self.bow / (0.5 * math.pi)
        cos, sin = math.cos(self.bow), math.sin(self.bow)
        if math.isclose(quarters, round(quarters), abs_tol=1e-12):  # no dust on straight hulls
            cos, sin = float(round(cos)), float(round(sin))
        side = -1.0 if self.mirrored else 1.0
        return np.array([[cos, -side * sin], [sin, side * cos]])

    def to_file(self, points: ArrayLike) -> NDArray[np.float64]:
        """Return points or forces (..., 2) of our frame in the file's."""
        return np.asarray(np.asarray(points, float) @ self._turn.T + 0.0)

    def from_file(self, points: ArrayLike) -> NDArray[np.float64]:
        """Return points or forces (..., 2) of the file's frame in ours."""
        return np.asarray(np.asarray(points, float) @ self._turn + 0.0)

    def direction_to_file(self, direction: float) -> float:
        """Return a direction [rad] of our frame in the file's, in its sense of turning."""
        return self.bow + (-direction if self.mirrored else direction)

    def direction_from_file(self, direction: float) -> float:
        """Return a direction [rad] of the file's frame in ours."""
        return (direction - self.bow) * (-1.0 if self.mirrored else 1.0) + 0.0

    def wrench_to_file(self, wrench: ArrayLike) -> NDArray[np.float64]:
        """Return wrenches (..., 3), force and torque, of our frame in the file's."""
        return self._wrench(wrench, self.to_file)

    def wrench_from_file(self, wrench: ArrayLike) -> NDArray[np.float64]:
        """Return wrenches (..., 3) of the file's frame in ours."""
        return self._wrench(wrench, self.from_file)

    def _wrench(self, wrench: ArrayLike, turned: Any) -> NDArray[np.float64]:
        """Return wrenches with their forces turned, and their torques mirrored as the frame is."""
        parts = np.asarray(wrench, float)
        torque = parts[..., 2:] * (-1.0 if self.mirrored else 1.0)
        return np.concatenate([turned(parts[..., :2]), torque], axis=-1) + 0.0

    def bearing(self, direction: float) -> float:
        """Return the bearing [rad] of a direction [rad] of ours, clockwise, within [0, 2 pi).

        It counts from north where the frame has a heading, and from the bow where it has none.

        Examples
        --------
        >>> math.degrees(Frame().bearing(math.pi / 2))
        270.0
        >>> round(math.degrees(Frame(heading=math.radians(30)).bearing(math.pi / 2)), 9)
        300.0
        >>> Frame().bearing(1e-17)
        0.0
        """
        return ((self.heading or 0.0) - direction) % math.tau % math.tau


OURS: Final = Frame()
"""The frame of everything inside, and of every answer file."""


@dataclass(frozen=True)
class Terms(Plain):
    """The terms in which a file is written and its answers are told.

    Attributes
    ----------
    length, force, angle, speed : str
        Names of units in `LENGTHS`, `FORCES`, `ANGLES` and `SPEEDS`. Forces in N are told with
        the prefix that suits them, and angles in degrees whatever the file's.
    frame : Frame
    robot : str
        What one robot is called: "robot", "tug".
    bearings : bool
        Whether directions are told as bearings clockwise: true ones where the frame has a heading,
        relative to the bow where it has none.

    Raises
    ------
    TermsInvalid
        If a unit is unknown, or what robots are called is no name.

    Examples
    --------
    >>> barge = Terms(length="ft", force="tf", speed="kn", robot="tug")
    >>> barge.robots(1), barge.robots(3), barge.several
    ('1 tug', '3 tugs', 'tugs')
    >>> Terms(force="stone")
    Traceback (most recent call last):
    swarmgrasp.errors.TermsInvalid: the unit of force is 'stone'; it should be one of N, kN, MN, \
kgf, tf, lbf, kip
    """

    length: str = "m"
    force: str = "N"
    angle: str = "deg"
    speed: str = "m/s"
    frame: Frame = OURS
    robot: str = "robot"
    bearings: bool = False

    def __post_init__(self) -> None:
        """Check the fields."""
        faults = [
            f"the unit of {quantity} is {shown(getattr(self, quantity))}; it should be one of "
            f"{', '.join(known)}"
            for quantity, known in UNITS.items()
            if getattr(self, quantity) not in known
        ]
        faults += [f"{fault}: what a robot is called" for fault in name_faults(self.robot)]
        if self.robot == "":
            faults.append("a robot is called ''; it should be a word, such as tug")
        refuse((TermsInvalid, faults))

    @property
    def several(self) -> str:
        """What several robots are called."""
        return plural(self.robot)

    def unit_of(self, measured: str) -> str:
        """Return the unit in which something is told that is measured; "" where it is SI's.

        Numbers are asked for in the same units.

        Examples
        --------
        >>> barge = Terms(length="ft", force="tf", speed="kn")
        >>> [barge.unit_of(each) for each in ("force", "torque", "area", "angle", "mass")]
        ['tf', 'tf ft', 'ft^2', 'deg', '']
        """
        units = {
            "length": self.length,
            "force": self.force,
            "angle": "deg",
            "speed": self.speed,
            "torque": f"{self.force} {self.length}",
            "area": f"{self.length}^2",
        }
        return units.get(measured, "")

    def robots(self, count: int) -> str:
        """Return a number of robots in the file's word."""
        return f"{count} {self.robot if count == 1 else self.several}"


SI: Final = Terms()
"""The terms of what says no others: SI units, our frame."""
