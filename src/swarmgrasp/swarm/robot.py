"""Robots in contact with the object, and the newcomer looking for a place."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, get_args

from swarmgrasp.callers import warn_caller
from swarmgrasp.errors import DirectionWarning, FrictionWarning, RobotInvalid, ZoneInvalid
from swarmgrasp.outline import Stretch
from swarmgrasp.outline.polygon import is_simple
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import (
    STRONGEST,
    WEAKEST,
    angles,
    flag_faults,
    is_flag,
    items,
    kind_faults,
    limit_faults,
    name_faults,
    number,
    numbers,
    shown,
)
from swarmgrasp.swarm.body import Body
from swarmgrasp.swarm.sectors import SAME_ANGLE, Sectors, joined, middle_of, sector_faults
from swarmgrasp.swarm.tolerance import Tolerance
from swarmgrasp.words import list_words

TURNED = 4.0 * math.pi
"""Largest direction [rad] that code comes to by turning what it has; more looks like degrees."""
Attachment = Literal["push", "pull", "free"]
"""How a robot may hold on: force into the object, out of it, or in any direction."""

RIGHT_ANGLE = math.pi / 2

MOST_FRICTION = 1e6
"""Largest coefficient of friction."""
ROUGHEST = 5.0
"""Coefficient of friction beyond anything real: rubber on dry stone has about 1."""
SHORTEST = 1e-9
"""Least lever of a couple [m], and 1 over the largest."""
SAME_SIZE = 1e-9
"""Relative difference of two forces that is rounding."""

Envelope = Sequence[tuple[float, float]]


@dataclass(frozen=True)
class Robot(Plain):
    """A robot in contact with the object, and the forces that it can exert there.

    Without more it pushes along one ray, from nothing to its limit. The forces of any robot are a
    convex set, the hull of what is said here (T20).

    Attributes
    ----------
    contact : tuple of float [m, m]
        Where it holds the object, in the frame of the outline's vertices.
    direction : float [rad]
        Direction of the force it exerts on the object, counter-clockwise from +x. With `sectors` it
        is the middle of the widest, and may be left out. More than two turns give a
        `DirectionWarning`: they look like degrees.
    limit : float [N]
        Largest force it can exert.
    name : str
        A label for messages and pictures.
    mounted : bool
        A vessel's own thruster: it may sit anywhere inside the outline.
    tolerance : Tolerance, optional
        How far it may be from all this; only a criterion of the worst case looks at it.
    reverse_limit : float [N]
        Largest force the other way, such as that of a propeller going astern.
    steers : float [rad]
        It turns its force at any time within so much either side of `direction`: a tug alongside;
        pi for an azimuth thruster, whose direction is then without meaning.
    friction : float, optional
        It is a finger whose normal force, along `direction`, is at most `limit`; the force across
        it is at most so many times the normal force. More than 5 gives a `FrictionWarning`.
    least : float [N]
        The force, along `direction`, that it always exerts at least: a cable that must stay taut.
        Of one that steers the hull of its forces counts, with less in its middle (T20).
    envelope : sequence of (float, float) [N, N], optional
        The corners of all forces it can exert, along `direction` and to the left of it, instead of
        all the above. `limit` is then that of the largest, and may be left out.
    group : str
        Robots of one group fail together: a switchboard's thrusters, the two lines of a tug.
    sectors : sequence of (float, float) [rad, rad], optional
        The directions that it may push in, with gaps between, as of a thruster that must not blow
        at its neighbour: each counter-clockwise from the first to the second, as `direction` is
        counted. They do not overlap; those that touch are one. At any time it pushes in one of
        them, and it may change between wrenches. One of half a turn or less is what `steers` says,
        and becomes that; one of a whole turn, an azimuth thruster. A single wider one stays: its
        gap is what is left of the turn.
    body : Body, optional
        The room that it takes up beside the object; none for a mounted one. Newcomers with a body
        keep theirs clear of it.
    lever : float [m]
        It turns the object instead of pushing it: it exerts a couple, two opposite forces up to
        `limit`, so far apart, counter-clockwise, or clockwise if negative; the other way up to
        `reverse_limit`. It is mounted, and its direction is without meaning.

    Raises
    ------
    RobotInvalid
        If a number is not finite or outside its range, or what it is said to be does not go
        together; all faults at once.

    Examples
    --------
    >>> Robot((2.0, 0.5), direction=3.14, limit=600e3, name="Ajax").limit
    600000.0

    A tug that steers 30 degrees either side, and a thruster that is weaker astern:

    >>> tug = Robot((2.0, 0.5), direction=3.14, limit=600e3, steers=0.52)
    >>> tunnel = Robot((1.0, 0.0), 1.57, limit=51e3, reverse_limit=40e3, mounted=True)
    >>> tug.is_ray, tunnel.is_ray
    (False, False)

    A thruster with a neighbour ahead and one astern, and one that steers after all:

    >>> round(Robot((1.0, 0.0), sectors=[(0.4, 2.7), (3.5, 5.9)]).direction, 6)
    -1.583185
    >>> round(Robot((1.0, 0.0), sectors=[(0.4, 1.0), (1.0, 1.4)]).steers, 6)
    0.5
    """

    contact: tuple[float, float]
    direction: float = math.nan
    limit: float = 1.0
    name: str = ""
    mounted: bool = False
    tolerance: Tolerance | None = None
    reverse_limit: float = 0.0
    steers: float = 0.0
    friction: float | None = None
    least: float = 0.0
    envelope: Envelope | None = None
    group: str = ""
    sectors: Sectors | None = None
    body: Body | None = None
    lever: float = 0.0

    def __post_init__(self) -> None:
        """Check the values."""
        faults = [] if self.sectors is None else self._take_sectors()
        faults += [] if self.lever == 0.0 else self._take_lever()
        corners = _corners(self.envelope)
        if corners:
            reach = max(math.hypot(*corner) for corner in corners)
            if self.limit != 1.0 and not abs(number(self.limit) - reach) <= SAME_SIZE * reach:
                faults.append(
                    f"the limit is {shown(self.limit)}; with an envelope it is the size of the "
                    f"largest force, {reach:.9g} [N], and may be left out"
                )
            vars(self).update(envelope=corners, limit=reach)
        point = numbers(self.contact)
        if len(point) != 2:
            faults.append(
                f"the contact is {shown(self.contact)}; it should be two finite numbers [m]"
            )
        if not angles((self.direction,)):
            faults.append(
                f"the direction is {shown(self.direction)}; it should be "
                "-1e6 <= direction <= 1e6 [rad]"
            )
        faults += limit_faults(self.limit) + name_faults(self.name)
        faults += tolerance_faults(self.tolerance, self.limit, self.mounted)
        faults += self._kind_faults()
        faults += [fault.replace("name", "group", 1) for fault in name_faults(self.group)]
        if not is_flag(self.mounted):
            faults += flag_faults(self.mounted, "mounted")
        faults += _body_faults(self.mounted, self.body)
        if faults:
            raise RobotInvalid(f"{_called(self.name, 'robot')}: {fault}" for fault in faults)
        if abs(self.direction) > TURNED:
            said = (
                f"{_called(self.name, 'robot')}: the direction {shown(self.direction)} rad is "
                f"{abs(self.direction) / math.tau:.3g} turns; for degrees, write math.radians(...)"
            )
            warn_caller(said, DirectionWarning, is_of_maker=True)
        if rough := _roughness(self.friction):
            said = f"{_called(self.name, 'robot')}: {rough}"
            warn_caller(said, FrictionWarning, is_of_maker=True)
        vars(self).update(
            contact=point,
            direction=float(self.direction),
            limit=float(self.limit),
            name=str(self.name),
            mounted=bool(self.mounted),
            reverse_limit=float(self.reverse_limit),
            steers=float(self.steers),
            friction=float(self.friction) if self.friction else None,
            least=float(self.least),
            group=str(self.group),
            lever=float(self.lever),
        )

    @property
    def is_ray(self) -> bool:
        """Whether it pushes along one ray only, from nothing to its limit."""
        more = (self.reverse_limit, self.steers, self.friction or 0.0, self.least)
        return self.envelope is None and self.sectors is None and not any(more)

    def _take_lever(self) -> list[str]:
        """Return what is wrong with a couple, whose direction is without meaning, and becomes 0."""
        faults = []
        if not SHORTEST <= abs(number(self.lever)) <= 1.0 / SHORTEST:
            faults.append(
                f"the lever is {shown(self.lever)}; it should be 0, or {SHORTEST:g} <= lever <= "
                f"{1.0 / SHORTEST:g} [m], or the negative of that"
            )
        said = {
            "what it steers": self.steers != 0.0,
            "the friction": bool(self.friction),
            "the envelope": self.envelope is not None,
            "the sectors": self.sectors is not None,
            "the least force": self.least != 0.0,
        }
        others = [what for what, is_said in said.items() if is_said]
        if others:
            faults.append(f"a couple is from nothing to a limit: leave out {list_words(others)}")
        if self.mounted is not True:
            faults.append("what exerts a couple is mounted: declare it so")
        if isinstance(self.tolerance, Tolerance) and self.tolerance.turns != (0.0, 0.0):
            faults.append("a couple has no direction: its tolerance can have none")
        vars(self).update(direction=0.0)
        return faults

    def _take_sectors(self) -> list[str]:
        """Keep the sectors in order, or steer if they leave no gap; return what is wrong."""
        faults = sector_faults(self.sectors)
        said = {
            "the reverse limit": self.reverse_limit != 0.0,
            "what it steers": self.steers != 0.0,
            "the friction": bool(self.friction),
            "the least force": self.least != 0.0,
            "the envelope": self.envelope is not None,
        }
        others = [what for what, is_said in said.items() if is_said]
        if others:
            faults.append(f"sectors say all its directions: leave out {list_words(others)}")
        if faults:
            vars(self).update(direction=0.0)  # no fault of its own
            return faults
        kept = joined(self.sectors)
        middle, (start, end) = middle_of(kept), kept[0]
        way = self.direction
        is_left_out = isinstance(way, float) and math.isnan(way)
        if not is_left_out and not _is_same_angle(number(way), middle):
            faults.append(
                f"the direction is {shown(way)}; with sectors it is the middle of the widest, "
                f"{middle:.9g} [rad], and may be left out"
            )
        vars(self).update(direction=middle, sectors=kept)
        if len(kept) == 1 and not math.pi + SAME_ANGLE < end - start < math.tau:
            vars(self).update(steers=min(0.5 * (end - start), math.pi), sectors=None)
        return faults

    def _kind_faults(self) -> list[str]:
        """Return what is wrong with what it can exert beside its limit."""
        more = (self.reverse_limit, self.steers, self.least)
        if self.envelope is None and self.friction is None and more == (0.0, 0.0, 0.0):
            return []
        faults = kind_of_force_faults(self.reverse_limit, self.friction)
        limit, least = number(self.limit), number(self.least)
        if not 0.0 <= number(self.steers) <= math.pi:
            faults.append(
                f"it steers {shown(self.steers)}; that should be 0 <= steers <= pi [rad], either "
                "side of its direction"
            )
        if least != 0.0 and not WEAKEST <= least <= limit:
            faults.append(
                f"the least force is {shown(self.least)}; it should be 0, or {WEAKEST:g} <= least "
                f"<= {shown(self.limit)}, the limit [N]"
            )
        said = {
            "a reverse limit": self.reverse_limit != 0.0,
            "steering": self.steers != 0.0,
            "friction": bool(self.friction),
            "a least force": self.least != 0.0,
        }
        together = [what for what, is_said in said.items() if is_said]
        if self.envelope is not None:
            if not _corners(self.envelope):
                faults.append(
                    f"the envelope is {shown(self.envelope)}; it should be two or more points of "
                    f"finite numbers, the largest of size {WEAKEST:g} to {STRONGEST:g} [N, N]"
                )
            if together:
                faults.append(f"an envelope says everything: leave out {' and '.join(together)}")
        elif said["friction"] and (said["a reverse limit"] or said["steering"]):
            faults.append("friction goes with neither steering nor a reverse limit")
        elif said["a least force"] and said["a reverse limit"]:
            faults.append("what exerts a least force always has no reverse limit")
        return faults


@dataclass(frozen=True)
class Newcomer(Plain):
    """The robot to place: how hard it can push and which way it may.

    Attributes
    ----------
    limit : float [N]
        Largest force it can exert.
    attachment : {"push", "pull", "free"}
        Force within `half_angle` of the inward normal, of the outward normal, or anywhere.
    half_angle : float [rad], optional
        Within [0, pi/2]; 0 means exactly along the normal, pi/2 (the default) any
        direction on that side. Refused with a free attachment.
    name : str
        A label for messages and pictures.
    tolerance : Tolerance, optional
        How far it may end up from the place it aims at; only a criterion of the worst case looks
        at it.
    steers : bool
        It keeps the whole sector of its attachment at all times, and only its contact is chosen; a
        free one is an azimuth thruster. Otherwise it pushes along the one direction that is best.
    reverse_limit : float [N]
        Largest force the other way.
    friction : float, optional
        It is a finger along the inward normal: see `Robot`. Its attachment is "push".
    mounted : bool
        It goes anywhere inside the outline, or on the areas of its zones.
    body : Body, optional
        The room that it takes up beside the object, kept clear of the object and of the bodies of
        the robots already there.

    Raises
    ------
    RobotInvalid
        If a value is outside its range; all faults at once.

    Examples
    --------
    A tug of 60 t that pushes within 30 degrees of square.

    >>> Newcomer(60 * 9806.65, "push", half_angle=0.52).attachment
    'push'
    """

    limit: float = 1.0
    attachment: Attachment = "free"
    half_angle: float | None = None
    name: str = ""
    tolerance: Tolerance | None = None
    steers: bool = False
    reverse_limit: float = 0.0
    friction: float | None = None
    mounted: bool = False
    body: Body | None = None

    def __post_init__(self) -> None:
        """Check the values."""
        faults = limit_faults(self.limit) + attachment_faults(self.attachment, self.half_angle)
        faults += name_faults(self.name)
        faults += tolerance_faults(self.tolerance, self.limit, self.mounted)
        faults += kind_of_force_faults(self.reverse_limit, self.friction)
        faults += flag_faults(self.steers, "steers") + flag_faults(self.mounted, "mounted")
        if self.friction and (self.steers is True or self.reverse_limit != 0.0):
            faults.append("friction goes with neither steering nor a reverse limit")
        if self.friction and self.attachment != "push":
            faults.append("a finger with friction pushes: its attachment should be push")
        if self.mounted is True and self.attachment != "free":
            faults.append("a mounted newcomer touches no edge: its attachment should be free")
        faults += _body_faults(self.mounted, self.body)
        if faults:
            raise RobotInvalid(f"{_called(self.name, 'newcomer')}: {fault}" for fault in faults)
        if rough := _roughness(self.friction):
            said = f"{_called(self.name, 'newcomer')}: {rough}"
            warn_caller(said, FrictionWarning, is_of_maker=True)
        vars(self).update(
            limit=float(self.limit),
            attachment=str(self.attachment),
            half_angle=None if self.half_angle is None else float(self.half_angle),
            name=str(self.name),
            steers=bool(self.steers),
            reverse_limit=float(self.reverse_limit),
            friction=float(self.friction) if self.friction else None,
            mounted=bool(self.mounted),
        )

    @property
    def keeps(self) -> bool:
        """Whether it keeps all it can exert: only its contact is chosen."""
        return bool(self.steers or self.friction)

    @property
    def is_ray(self) -> bool:
        """Whether it pushes along one ray only, from a place on the boundary."""
        return not (self.steers or self.reverse_limit or self.friction or self.mounted)


@dataclass(frozen=True)
class Zone(Plain):
    """Where a newcomer may attach, and how it may push there.

    Attributes
    ----------
    stretch : Stretch, optional
        Where: a stretch of the boundary, or a single point such as a bollard.
    attachment : {"push", "pull", "free"}, optional
        Overrides the newcomer's own attachment.
    half_angle : float [rad], optional
        Goes with `attachment`.
    directions : tuple of float [rad, rad], optional
        An absolute range of force directions, counter-clockwise from the first to the
        second; whole turns apart they mean any direction, equal ones just that one.
        Further limits whatever the attachment allows.
    area : sequence of (float, float) [m, m], optional
        Instead of a stretch, for a mounted newcomer: the corners, in order, of an area inside the
        outline; two are a line, and one is a spot.
    name : str
        A label for messages and pictures; that of the stretch, if there is one.

    Raises
    ------
    ZoneInvalid
        If a value is outside its range; all faults at once.

    Examples
    --------
    Pads to push on, a bollard to pull from, and a bay for a thruster.

    >>> pads = Zone(Stretch(10.0, 25.0, "pads"))
    >>> bollard = Zone(Stretch(4.0, 4.0, "bollard"), attachment="pull", half_angle=1.0)
    >>> bay = Zone(area=[(1.0, -0.5), (2.0, -0.5), (2.0, 0.5), (1.0, 0.5)], name="bay")
    """

    stretch: Stretch | None = None
    attachment: Attachment | None = None
    half_angle: float | None = None
    directions: tuple[float, float] | None = None
    area: Sequence[tuple[float, float]] | None = None
    name: str = ""

    def __post_init__(self) -> None:
        """Check the values."""
        faults = name_faults(self.name)
        corners: tuple[tuple[float, ...], ...] = ()
        if self.area is None:
            faults += kind_faults(self.stretch, Stretch, "Stretch(start, end) or Outline.stretch")
        else:
            corners = tuple(point for p in items(self.area) or () if len(point := numbers(p)) == 2)
            faults += self._area_faults(corners)
        if isinstance(self.stretch, Stretch) and self.name not in {"", self.stretch.name}:
            faults.append("a stretch has a name of its own: leave out the zone's")
        if self.attachment is not None:
            faults += attachment_faults(self.attachment, self.half_angle)
        elif self.half_angle is not None:
            faults.append("a half angle needs an attachment beside it")
        ends = self.directions
        if ends is not None and len(angles(ends)) != 2:
            faults.append(
                f"the directions are {shown(ends)}; they should be two angles within 1e6 [rad]"
            )
        name = getattr(self.stretch, "name", self.name)
        if faults:
            raise ZoneInvalid(f"zone {shown(name)}: {fault}" for fault in faults)
        vars(self).update(
            area=corners or None,
            name=str(name),
            attachment=None if self.attachment is None else str(self.attachment),
            half_angle=None if self.half_angle is None else float(self.half_angle),
            directions=None if ends is None else angles(ends),
        )

    def turns(self, middle: float) -> tuple[float, float]:
        """Return the range of all directions that the zone allows, the whole turn about one [rad].

        Examples
        --------
        >>> Zone(Stretch(0.0, 1.0), directions=(0.5, 2.0)).turns(0.0)
        (0.5, 2.0)
        """
        if self.directions is not None:
            first, last = self.directions
            width = (last - first) % math.tau
            if width > 0.0 or last == first:
                return first, first + width
        return middle - math.pi, middle + math.pi

    def _area_faults(self, corners: tuple[tuple[float, ...], ...]) -> list[str]:
        """Return what is wrong with an area of these corners, and with what goes with one."""
        faults = []
        if not corners or len(corners) < len(items(self.area) or ()):
            faults.append(
                f"the area is {shown(self.area)}; it should be one or more points of two finite "
                "numbers [m, m]"
            )
        elif not is_simple(corners):
            faults.append(
                "the area crosses itself or is flat: list its corners in order around it, or the "
                "two ends of a line"
            )
        if self.stretch is not None:
            faults.append("a zone has a stretch or an area, not both")
        if self.attachment is not None:
            faults.append("an area touches no edge: leave out the attachment")
        return faults

    def sectors(self, lo: float, hi: float) -> list[tuple[float, float]]:
        """Return the parts of a sector of directions [lo, hi] [rad] that the zone's range allows.

        Parameters
        ----------
        lo, hi : float [rad]
            ``0 <= hi - lo <= pi``.

        Examples
        --------
        >>> Zone(Stretch(0.0, 1.0), directions=(0.5, 2.0)).sectors(-1.0, 1.0)
        [(0.5, 1.0)]
        """
        if self.directions is None:
            return [(lo, hi)]
        first, last = self.directions
        width = (last - first) % math.tau
        if width == 0.0 and last != first:
            return [(lo, hi)]
        start = first + math.tau * math.floor((lo - first) / math.tau)
        parts = []
        for turn in (-math.tau, 0.0, math.tau):
            a, b = max(lo, start + turn), min(hi, start + turn + width)
            if a <= b:
                parts.append((a, b))
            elif a <= b + SAME_ANGLE:  # they touch, by rounding only just not
                parts.append((0.5 * (a + b),) * 2)
        return parts


def attachment_faults(attachment: object, half_angle: object) -> list[str]:
    """Return what is wrong with an attachment and its half angle [rad]."""
    faults = []
    is_known = isinstance(attachment, str) and attachment in get_args(Attachment)
    if not is_known:
        faults.append(f"the attachment is {shown(attachment)}; it should be push, pull or free")
    if half_angle is not None:
        if is_known and attachment == "free":
            faults.append("a free attachment takes no half angle: it pushes in any direction")
        if not 0.0 <= number(half_angle) <= RIGHT_ANGLE:
            faults.append(
                f"the half angle is {shown(half_angle)}; it should be 0 <= half angle <= pi/2 [rad]"
            )
    return faults


def kind_of_force_faults(reverse_limit: object, friction: object) -> list[str]:
    """Return what is wrong with a reverse limit [N] and a coefficient of friction."""
    faults = []
    if number(reverse_limit) != 0.0 and not WEAKEST <= number(reverse_limit) <= STRONGEST:
        faults.append(
            f"the reverse limit is {shown(reverse_limit)}; it should be 0, or {WEAKEST:g} <= "
            f"reverse limit <= {STRONGEST:g} [N]"
        )
    if friction is not None and not 0.0 <= number(friction) <= MOST_FRICTION:
        faults.append(
            f"the friction is {shown(friction)}; it should be 0 <= friction <= {MOST_FRICTION:g}"
        )
    return faults


def _roughness(friction: float | None) -> str:
    """Say that nothing has a coefficient of friction; "" if something has."""
    if friction is None or friction <= ROUGHEST:
        return ""
    said = f"the friction {shown(friction)} is beyond anything real"
    return f"{said}: rubber on dry stone has about 1"


def _corners(envelope: object) -> Envelope:
    """Return the corners of an envelope; nothing if it is none."""
    if envelope is None:
        return ()
    points = [numbers(point) for point in items(envelope) or ()]
    if len(points) < 2 or any(len(point) != 2 for point in points):
        return ()
    reach = max(math.hypot(*point) for point in points)
    return tuple((p[0], p[1]) for p in points) if WEAKEST <= reach <= STRONGEST else ()


def _is_same_angle(one: float, other: float) -> bool:
    """Tell whether two angles [rad], the first perhaps no number, are whole turns apart."""
    return math.isfinite(one) and abs(math.remainder(one - other, math.tau)) <= SAME_ANGLE


def tolerance_faults(tolerance: object, limit: object, mounted: object = False) -> list[str]:
    """Return what is wrong with a tolerance, of what has a limit [N] and perhaps is mounted."""
    if not isinstance(tolerance, Tolerance):
        return [] if tolerance is None else kind_faults(tolerance, Tolerance, "Tolerance(...)")
    faults, least = [], tolerance.least_limit
    if least is not None and least > number(limit):
        faults.append(
            f"the least limit is {least!r}; it should be <= {shown(limit)}, the limit [N]"
        )
    if tolerance.is_adrift and is_flag(mounted) and mounted:
        faults.append("a mounted robot stays where it is: its tolerance can have no contact")
    return faults


def _called(name: str, otherwise: str) -> str:
    """Return what messages call a robot, whose name may be at fault."""
    return otherwise if name_faults(name) else name or otherwise


def _body_faults(mounted: object, body: object) -> list[str]:
    """Return what is wrong with the room that a robot takes up."""
    if body is None:
        return []
    if mounted is True:
        return ["a mounted robot takes up no room beside the object: leave out its body"]
    return kind_faults(body, Body, "Body(length, beam)")
