"""Robots in contact with the object, and the newcomer looking for a place."""

import math
from dataclasses import dataclass
from typing import Literal, get_args

from swarmgrasp.errors import RobotInvalid, ZoneInvalid
from swarmgrasp.outline import Stretch

Attachment = Literal["push", "pull", "free"]
"""How a robot may hold on: force into the object, out of it, or in any direction."""

RIGHT_ANGLE = math.pi / 2
WEAKEST, STRONGEST = 1e-100, 1e100
"""Range of force limits [N] whose squares and cubes are still numbers."""


@dataclass(frozen=True)
class Robot:
    """A robot that pushes one way, and only so hard.

    Attributes
    ----------
    contact : tuple of float [m, m]
        Where it holds the object, in the frame of the outline's vertices.
    direction : float [rad]
        Direction of the force it exerts on the object, counter-clockwise from +x.
    limit : float [N]
        Largest force it can exert.
    name : str
        A label for messages and pictures.
    mounted : bool
        A vessel's own thruster: it may sit anywhere inside the outline.

    Raises
    ------
    RobotInvalid
        If a number is not finite or the limit is not positive; all faults at once.
    """

    contact: tuple[float, float]
    direction: float
    limit: float = 1.0
    name: str = ""
    mounted: bool = False

    def __post_init__(self) -> None:
        """Check the values."""
        faults = []
        point = tuple(float(v) for v in self.contact)
        if len(point) != 2 or not all(map(math.isfinite, point)):
            faults.append(f"the contact is {self.contact!r}; it should be two finite numbers [m]")
        if not math.isfinite(self.direction):
            faults.append(f"the direction is {self.direction!r}; it should be finite [rad]")
        faults += limit_faults(self.limit)
        if faults:
            raise RobotInvalid(f"{self.name or 'robot'}: {fault}" for fault in faults)
        object.__setattr__(self, "contact", point)
        object.__setattr__(self, "direction", float(self.direction))
        object.__setattr__(self, "limit", float(self.limit))


@dataclass(frozen=True)
class Newcomer:
    """The robot to place: how hard it can push and which way it may.

    Attributes
    ----------
    limit : float [N]
        Largest force it can exert.
    attachment : {"push", "pull", "free"}
        Force within `half_angle` of the inward normal, of the outward normal, or anywhere.
    half_angle : float [rad], optional
        Within [0, pi/2]; 0 means exactly along the normal, pi/2 (the default) any
        direction on that side. Not used by a free attachment.
    name : str
        A label for messages and pictures.

    Raises
    ------
    RobotInvalid
        If a value is outside its range; all faults at once.
    """

    limit: float = 1.0
    attachment: Attachment = "free"
    half_angle: float | None = None
    name: str = ""

    def __post_init__(self) -> None:
        """Check the values."""
        faults = limit_faults(self.limit) + attachment_faults(self.attachment, self.half_angle)
        if faults:
            raise RobotInvalid(f"{self.name or 'newcomer'}: {fault}" for fault in faults)


@dataclass(frozen=True)
class Zone:
    """A part of the boundary where a newcomer may attach, and how it may push there.

    Attributes
    ----------
    stretch : Stretch
        Where: a stretch of the boundary, or a single point such as a bollard.
    attachment : {"push", "pull", "free"}, optional
        Overrides the newcomer's own attachment.
    half_angle : float [rad], optional
        Goes with `attachment`.
    directions : tuple of float [rad, rad], optional
        An absolute range of force directions, counter-clockwise from the first to the
        second; whole turns apart they mean any direction, equal ones just that one.
        Further limits whatever the attachment allows.

    Raises
    ------
    ZoneInvalid
        If a value is outside its range; all faults at once.
    """

    stretch: Stretch
    attachment: Attachment | None = None
    half_angle: float | None = None
    directions: tuple[float, float] | None = None

    def __post_init__(self) -> None:
        """Check the values."""
        faults = []
        if not (math.isfinite(self.stretch.start) and math.isfinite(self.stretch.end)):
            faults.append(
                f"the stretch is {self.stretch.start} to {self.stretch.end}; it should be finite"
            )
        if self.attachment is not None:
            faults += attachment_faults(self.attachment, self.half_angle)
        elif self.half_angle is not None:
            faults.append("a half angle needs an attachment beside it")
        ends = self.directions
        if ends is not None and (len(ends) != 2 or not all(map(math.isfinite, ends))):
            faults.append(f"the directions are {ends}; they should be two finite angles [rad]")
        if faults:
            raise ZoneInvalid(f"zone {self.stretch.name!r}: {fault}" for fault in faults)

    def sectors(self, lo: float, hi: float) -> list[tuple[float, float]]:
        """Return the parts of a sector of directions [lo, hi] [rad] that the zone's range allows.

        Parameters
        ----------
        lo, hi : float [rad]
            ``0 <= hi - lo <= pi``.
        """
        if self.directions is None:
            return [(lo, hi)]
        first, last = self.directions
        width = (last - first) % math.tau
        if width == 0.0 and last != first:
            return [(lo, hi)]
        start = first + math.tau * math.floor((lo - first) / math.tau)
        ranges = [(start, start + width), (start + math.tau, start + math.tau + width)]
        return [(max(lo, a), min(hi, b)) for a, b in ranges if max(lo, a) <= min(hi, b)]


def limit_faults(limit: float) -> list[str]:
    """Return what is wrong with a force limit [N]."""
    if WEAKEST <= limit <= STRONGEST:
        return []
    return [f"the limit is {limit!r}; it should be {WEAKEST:g} <= limit <= {STRONGEST:g} [N]"]


def attachment_faults(attachment: str, half_angle: float | None) -> list[str]:
    """Return what is wrong with an attachment and its half angle [rad]."""
    faults = []
    if attachment not in get_args(Attachment):
        faults.append(f"the attachment is {attachment!r}; it should be push, pull or free")
    if half_angle is not None:
        if attachment == "free":
            faults.append("a free attachment takes no half angle: it pushes in any direction")
        if not 0.0 <= half_angle <= RIGHT_ANGLE:
            faults.append(
                f"the half angle is {half_angle!r}; it should be 0 <= half angle <= pi/2 [rad]"
            )
    return faults
