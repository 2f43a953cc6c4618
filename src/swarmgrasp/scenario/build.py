"""Build a scenario from a checked document, and find the faults that geometry has."""

import math

from swarmgrasp.errors import OutlineInvalid, SwarmGraspError
from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.robot import Newcomer, Robot, Zone
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.locate import Locator, Place
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.schema import NewcomerSection, RobotSection, ZoneSection
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.swarm import Swarm

SMALLEST_EXTENT = 1e-6
"""Least diagonal of an outline's bounding box, in the file's unit."""


def build(checked: Checked, default_name: str) -> Scenario:
    """Build the scenario.

    Parameters
    ----------
    checked : Checked
    default_name : str
        For a file that gives no name.

    Returns
    -------
    Scenario

    Raises
    ------
    ScenarioInvalid
        If the document has faults, found here or before; all of them are told.
    """
    file = checked.file
    units = Units(**file.units.model_dump())
    _check_names(checked)
    newcomer = _newcomer(checked, units)
    locator = _locator(checked, units)
    if locator is None:
        raise checked.faults.error()
    robots, zones, no_go = _robots(locator), _zones(locator), _no_go(locator)
    if checked.faults:
        raise checked.faults.error()
    length = file.metric.characteristic_length
    a1, a2 = file.metric.force_weights
    try:
        swarm = Swarm(locator.si, robots, length and units.metres(length), (a1, a2))
    except SwarmGraspError as error:  # by rounding only: all of it is checked above
        checked.fault((), "; ".join(error.faults), got=False)
        raise checked.faults.error() from error
    return Scenario(
        name=file.name or default_name,
        description=file.description,
        swarm=swarm,
        newcomer=newcomer,
        zones=zones if file.zones is not None else None,
        no_go=no_go,
        spacing=units.metres(file.spacing),
    )


# -- the outline --------------------------------------------------------------------------


def _locator(checked: Checked, units: Units) -> Locator | None:
    """Return the outline in the file's units and in metres, or None if it has faults."""
    section = checked.file.outline
    if not all(checked.is_sound("outline", key) for key in ("vertices", "edges", "origin")):
        return None
    path: Path = ("outline", "vertices")
    try:
        plain = Outline(section.vertices)
        if plain.extent < SMALLEST_EXTENT:
            raise OutlineInvalid(
                f"the outline is {plain.extent:.3g} {units.length} across; it should be at least "
                f"{SMALLEST_EXTENT:g} {units.length}"
            )
        path = ("outline", "edges")
        names = section.edges if section.edges is not None else [""] * len(plain)
        labels = [name or f"edge {i}" for i, name in enumerate(names)]
        origin = None if section.origin == "centroid" else section.origin
        outline = Outline(section.vertices, origin, labels)
        # a clockwise file counts its edges the other way than Outline: name them all
        kept = names if outline.edge_names[0] == labels[0] else labels
        si = Outline(
            [[units.metres(x), units.metres(y)] for x, y in section.vertices],
            [units.metres(float(v)) for v in outline.origin],
            kept,
        )
    except OutlineInvalid as error:
        for sentence in error.faults:  # Outline speaks of metres
            checked.fault(path, sentence.replace(") m:", f") {units.length}:"), got=False)
        return None
    return Locator(outline, si, labels, units, checked)


# -- robots -------------------------------------------------------------------------------


def _check_names(checked: Checked) -> None:
    """Note a fault for every name that two robots share."""
    seen: dict[str, int] = {}
    for i, robot in enumerate(checked.file.robots):
        first = seen.setdefault(robot.name, i)
        if robot.name and first != i:
            said = f"is the name of robots.{first} too; names should differ"
            checked.fault(("robots", i, "name"), said)


def _robots(locator: Locator) -> list[Robot]:
    """Return the robots, a two-way one as two."""
    robots = []
    for i, section in enumerate(locator.checked.file.robots):
        path: Path = ("robots", i)
        place = _robot_place(section, path, locator)
        direction = _direction(section, path, place, locator)
        if place is None or direction is None:
            continue
        signs = {"": 0.0}
        if section.two_way:
            signs = {f"{'' if section.name else f'robot {i}'} {s}": t for s, t in _BOTH_WAYS}
        for sign, turn in signs.items():
            robots.append(
                Robot(
                    contact=(
                        locator.units.metres(place.point[0]),
                        locator.units.metres(place.point[1]),
                    ),
                    direction=direction + turn,
                    limit=locator.units.newtons(section.limit),
                    name=section.name + sign,
                    mounted=section.mounted,
                )
            )
    return robots


_BOTH_WAYS = (("+", 0.0), ("-", math.pi))


def _robot_place(section: RobotSection, path: Path, locator: Locator) -> Place | None:
    """Return where a robot is, or None after noting what is wrong with it."""
    checked = locator.checked
    sound = checked.is_known(*path) and checked.is_sound(*path, "mounted")
    if not sound or not locator.has_one_way(path, point=True, stretch=False):
        return None
    if not section.mounted:
        return locator.place(section, path)
    if not checked.has(*path, "contact"):
        said = "a mounted robot is given by its contact [x, y]"
        checked.fault((*path, "mounted"), said, got=False)
        return None
    if section.contact is None:
        return None
    return locator.inside(section.contact, (*path, "contact"))


def _direction(
    section: RobotSection, path: Path, place: Place | None, locator: Locator
) -> float | None:
    """Return the direction of a robot's force [rad], or None after noting a fault."""
    wanted, path = section.direction, (*path, "direction")
    if not isinstance(wanted, str):
        return locator.units.radians(wanted)
    if section.mounted:
        said = "a mounted robot touches no edge and has no normal; give an angle"
        locator.checked.fault(path, said)
    elif place is not None and place.inward is None:
        said = (
            "the normal is ambiguous at a corner; give the contact by edge and along, or an angle"
        )
        locator.checked.fault(path, said)
    elif place is not None and place.inward is not None:
        turn = 0.0 if wanted == "inward" else math.pi
        return math.remainder(place.inward + turn, 2.0 * math.pi)
    return None


def _newcomer(checked: Checked, units: Units) -> Newcomer | None:
    """Return the robot to place, if the file has one."""
    section, path = checked.file.newcomer, ("newcomer",)
    if section is None:
        return None
    return Newcomer(
        limit=units.newtons(section.limit),
        attachment=section.attachment,
        half_angle=_half_angle(section, path, checked, units),
        name=section.name,
    )


def _half_angle(
    section: NewcomerSection | ZoneSection, path: Path, checked: Checked, units: Units
) -> float | None:
    """Return a half angle [rad], or None if there is none or it has faults."""
    half_angle, path_here = section.half_angle, (*path, "half_angle")
    if half_angle is None:
        return None
    right_angle = units.turn(0.25)
    if not 0.0 <= half_angle <= right_angle and checked.is_sound("units"):
        checked.fault(path_here, f"should lie in [0, {right_angle:.9g}] {units.angle}")
        return None
    if section.attachment in ("push", "pull"):
        return min(units.radians(half_angle), math.pi / 2.0)
    if checked.is_sound(*path, "attachment"):
        said = "goes with attachment: push or pull only; a free one pushes in any direction"
        checked.fault(path_here, said)
    return None


# -- zones --------------------------------------------------------------------------------


def _zones(locator: Locator) -> tuple[Zone, ...]:
    """Return the zones that have no faults."""
    checked, zones = locator.checked, []
    for i, section in enumerate(checked.file.zones or []):
        path: Path = ("zones", i)
        half_angle = _half_angle(section, path, checked, locator.units)
        directions = _directions(section, path, checked, locator.units)
        stretch = _zone_stretch(section, path, locator)
        if stretch is not None:
            zones.append(Zone(stretch, section.attachment, half_angle, directions))
    return tuple(zones)


def _zone_stretch(section: ZoneSection, path: Path, locator: Locator) -> Stretch | None:
    """Return a zone's stretch or point [m], or None after noting a fault."""
    checked = locator.checked
    if not checked.is_known(*path) or not locator.has_one_way(path, point=True, stretch=True):
        return None
    is_point = any(checked.has(*path, key) for key in ("contact", "theta", "at", "along"))
    if not is_point:
        return locator.stretch(section, path)
    place = locator.place(section, path)
    if place is None:
        return None
    arc = locator.metres(place.arc_length)
    return Stretch(arc, arc, section.name)


def _no_go(locator: Locator) -> tuple[Stretch, ...]:
    """Return the no-go stretches that have no faults."""
    checked, stretches = locator.checked, []
    for i, section in enumerate(checked.file.no_go):
        path: Path = ("no_go", i)
        if checked.is_known(*path) and locator.has_one_way(path, point=False, stretch=True):
            stretches.append(locator.stretch(section, path))
    return tuple(stretch for stretch in stretches if stretch is not None)


def _directions(
    section: ZoneSection, path: Path, checked: Checked, units: Units
) -> tuple[float, float] | None:
    """Return a zone's range of directions [rad, rad], or None if there is none."""
    if section.directions is None:
        return None
    first, last = section.directions
    if abs(last - first) >= units.turn(1.0) and checked.is_sound("units"):
        said = "spans a full turn, which limits nothing; leave it out"
        checked.fault((*path, "directions"), said)
    return units.radians(first), units.radians(last)
