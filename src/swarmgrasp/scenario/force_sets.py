"""What robots can exert, as a scenario says it, and the faults that its schema does not see."""

import math
from typing import TypedDict

from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.force_schema import BothWaysSection
from swarmgrasp.scenario.newcomer_schema import NewcomerSection
from swarmgrasp.scenario.schema import RobotSection
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.swarm.robot import SHORTEST
from swarmgrasp.swarm.sectors import Sectors, sector_faults

ON_BOUNDARY = ("edge", "along", "from", "to", "at", "theta", "contact")
"""What says where on the boundary a zone is."""


class Forces(TypedDict, total=False):
    """The limits [N] and the friction of a robot or a newcomer, as its keywords."""

    limit: float
    reverse_limit: float
    friction: float | None


class OwnForces(TypedDict, total=False):
    """What else a robot can exert, as its keywords; a newcomer has none of these."""

    least: float
    steers: float
    envelope: tuple[tuple[float, float], ...] | None
    sectors: Sectors | None
    lever: float


def check_force_sets(checked: Checked, units: Units) -> None:
    """Note what does not go together in the forces of the robots and of newcomers."""
    for i, robot in enumerate(checked.file.robots):
        path: Path = ("robots", i)
        if checked.is_known(*path):
            _check_robot(robot, path, checked, units)
    for section, path in checked.newcomers():
        _check_newcomer(section, path, checked)
    newcomer = checked.file.newcomer
    if newcomer is not None and checked.is_sound("newcomer", "mounted"):
        _check_where(newcomer.mounted, checked)


def largest(section: RobotSection | NewcomerSection) -> float:
    """Return the largest force that is said along a direction, in the file's unit."""
    limit = section.limit
    if isinstance(limit, BothWaysSection):
        return limit.ahead
    if isinstance(limit, list):
        return limit[1]
    if limit is None:
        corners = section.envelope if isinstance(section, RobotSection) else None
        return max((math.hypot(*corner) for corner in corners or ()), default=math.inf)
    return limit


def forces_of(section: RobotSection | NewcomerSection, units: Units) -> Forces:
    """Return the limits and the friction of a robot, or of the newcomer."""
    found = Forces(limit=units.newtons(largest(section)), friction=section.friction)
    if isinstance(section.limit, BothWaysSection):
        found["reverse_limit"] = units.newtons(section.limit.astern)
    elif section.two_way:
        found["reverse_limit"] = found["limit"]
    return found


def own_forces_of(section: RobotSection, units: Units) -> OwnForces:
    """Return what else a robot can exert."""
    found = OwnForces(steers=_steers(section, units))
    if isinstance(section.limit, list):
        found["least"] = units.newtons(section.limit[0])
    if section.envelope is not None:
        side = -1.0 if units.frame.mirrored else 1.0
        corners = tuple((units.newtons(x), side * units.newtons(y)) for x, y in section.envelope)
        found["envelope"] = corners
    if section.sectors is not None:
        found["sectors"] = _sectors(section.sectors, units)
    if section.lever is not None:
        side = -1.0 if units.frame.mirrored else 1.0
        found["lever"] = side * units.metres(section.lever)
    return found


# -- parts --------------------------------------------------------------------------------


def _steers(section: RobotSection, units: Units) -> float:
    """Return how far a robot steers either side of its direction [rad]."""
    if section.steers == "any":
        return math.pi
    return min(units.radians(section.steers or 0.0), math.pi)  # half a turn, rounding aside


def _sectors(written: list[list[float]], units: Units) -> Sectors:
    """Return sectors [rad]."""
    return tuple(map(units.span, written))


def _check_robot(section: RobotSection, path: Path, checked: Checked, units: Units) -> None:
    """Note what is wrong with the forces of a robot."""
    _check_envelope(section, path, checked)
    _check_both_ways(section, path, checked)
    _check_sectors(section, path, checked, units)
    _check_lever(section, path, checked)
    steers, half = section.steers, units.turn(0.5)
    if isinstance(steers, float) and steers > half and checked.is_sound("units", "angle"):
        said = f"should lie in [0, {half:.9g}] {units.angle}, or be any"
        checked.fault((*path, "steers"), said)
    limit = section.limit
    if isinstance(limit, list) and limit[0] > limit[1]:
        checked.fault((*path, "limit"), "should be the least force, then the largest")
    if isinstance(limit, list) and section.two_way:
        said = "goes with one limit; what always exerts some force has no other way"
        checked.fault((*path, "two_way"), said)
    is_finger = checked.has(*path, "friction") and not section.mounted
    needs_none = section.steers == "any" or is_finger or not checked.is_sound(*path, "steers")
    needs_none |= checked.has(*path, "sectors") or checked.has(*path, "lever")
    if not needs_none and not checked.has(*path, "direction"):
        normals = "" if section.mounted else ", inward or outward"
        said = f"is missing; give the direction of the force: an angle{normals}"
        checked.fault((*path, "direction"), said, got=False)


def _check_envelope(section: RobotSection, path: Path, checked: Checked) -> None:
    """Note an envelope beside what it already says, or nothing that says how strong a robot is."""
    is_given, corners = checked.has(*path, "envelope"), section.envelope
    if not is_given and not checked.has(*path, "limit"):
        checked.fault((*path, "limit"), "is missing; give the largest force", got=False)
    if corners is not None and not any(value for corner in corners for value in corner):
        checked.fault((*path, "envelope"), "should hold a force that is not zero")
    for key in ("limit", "steers", "friction", "two_way"):
        if is_given and checked.has(*path, key):
            checked.fault((*path, key), "the envelope tells all forces already; keep one")


def _check_lever(section: RobotSection, path: Path, checked: Checked) -> None:
    """Note what does not go with a couple, and one of no lever."""
    if not checked.has(*path, "lever"):
        return
    for key in ("direction", "steers", "friction", "envelope", "sectors"):
        if checked.has(*path, key):
            checked.fault((*path, key), "with a lever it turns the object, and has no direction")
    if isinstance(section.limit, list):
        checked.fault((*path, "limit"), "should be one limit, or ahead and astern, beside a lever")
    if section.lever is not None and abs(section.lever) < SHORTEST:
        said = f"should be at least {SHORTEST:g} in size; leave it out for what pushes"
        checked.fault((*path, "lever"), said)
    if not section.mounted and checked.is_sound(*path, "mounted"):
        said = "is on board: say mounted: true, and where by contact"
        checked.fault((*path, "lever"), f"what turns the object {said}", got=False)


def _check_sectors(section: RobotSection, path: Path, checked: Checked, units: Units) -> None:
    """Note sectors that overlap, and what they say already or do not go with."""
    if not checked.has(*path, "sectors"):
        return
    for key in ("direction", "steers", "friction", "two_way", "envelope"):
        if checked.has(*path, key):
            said = "the sectors tell all directions already; leave it out"
            checked.fault((*path, key), said)
    if not isinstance(section.limit, float | None):
        checked.fault((*path, "limit"), "should be one limit beside sectors, the same in all")
    if section.sectors is not None and checked.is_sound("units", "angle"):
        for fault in sector_faults(_sectors(section.sectors, units)):
            said = f"{fault.partition(', ')[0]}; say them as one"
            checked.fault((*path, "sectors"), said, got=False)


def _check_both_ways(section: RobotSection | NewcomerSection, path: Path, checked: Checked) -> None:
    """Note who is said twice to push both ways, and fingers that do."""
    is_both = isinstance(section.limit, BothWaysSection)
    if section.two_way and is_both:
        said = "the limits ahead and astern say so already; leave it out"
        checked.fault((*path, "two_way"), said)
    if section.friction is not None and (section.two_way or is_both or section.steers):
        said = "a finger with friction only pushes: it neither steers nor pushes both ways"
        checked.fault((*path, "friction"), said)


def _check_newcomer(section: NewcomerSection, path: Path, checked: Checked) -> None:
    """Note what of the newcomer's forces does not go with its attachment."""
    _check_both_ways(section, path, checked)
    if not checked.is_sound(*path, "attachment"):
        return
    if section.friction is not None and section.attachment != "push":
        said = "goes with attachment: push only; a finger pushes along the normal"
        checked.fault((*path, "friction"), said)
    if section.mounted and section.attachment != "free":
        said = "a mounted newcomer touches no edge; leave the attachment out, or make it free"
        checked.fault((*path, "mounted"), said)


def _check_where(is_mounted: bool, checked: Checked) -> None:
    """Note zones where the newcomer does not go, and what one inside is not asked."""
    for i in range(len(checked.file.zones or ())):
        path: Path = ("zones", i)
        if not checked.is_known(*path):
            continue
        has_area = checked.has(*path, "area")
        if has_area and not is_mounted:
            said = "is for a mounted newcomer; give a stretch of the boundary instead"
            checked.fault((*path, "area"), said, got=False)
        elif is_mounted and not has_area and any(checked.has(*path, key) for key in ON_BOUNDARY):
            said = "is on the boundary, and a mounted newcomer goes inside; give an area instead"
            checked.fault(path, said, got=False)
    if is_mounted and checked.file.no_go:
        checked.fault(("no_go",), "is for a newcomer on the boundary; leave it out", got=False)
    if is_mounted and checked.file.spacing:
        checked.fault(("spacing",), "a mounted newcomer keeps no distance; leave it out")
