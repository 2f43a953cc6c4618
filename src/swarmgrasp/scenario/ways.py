"""How robots, zones and no-go stretches are said: the checks that need no outline.

They run whatever is wrong with the outline, so that its faults hide no others.
"""

from swarmgrasp.scenario.edges import comparable, length_name
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.newcomer_schema import NewcomerSection
from swarmgrasp.scenario.schema import RobotSection, StretchSection, ZoneSection
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.swarm import Body
from swarmgrasp.swarm.names import filled

POINT_KEYS = ("contact", "theta", "at", "edge")
ONE_POINT = "contact, theta, at, or edge with along"
NO_LENGTH = "the stretch has no length; a single point is given by contact, theta, at or along"
NO_WIDTH = "a single point forbids nothing, as the ends of a stretch are allowed; give it a width"


def well_said(checked: Checked, units: Units) -> frozenset[Path]:
    """Check how a document says what it says; note every fault.

    Returns
    -------
    frozenset of Path
        The robots, zones and no-go stretches whose place can be looked for.
    """
    file = checked.file
    _check_names(checked)
    _check_edge_names(checked)
    for section, path in checked.newcomers():
        _check_half_angle(section, path, checked, units)
        _check_body(path, checked)
    found = []
    for i, robot in enumerate(file.robots):
        _check_body(("robots", i), checked)
        if _is_robot_said(robot, ("robots", i), checked):
            found.append(("robots", i))
    for i, zone in enumerate(file.zones or []):
        _check_half_angle(zone, ("zones", i), checked, units)
        _check_directions(zone, ("zones", i), checked, units)
        if _is_stretch_said(zone, ("zones", i), checked, units):
            found.append(("zones", i))
    for i, stretch in enumerate(file.no_go):
        if _is_stretch_said(stretch, ("no_go", i), checked, units):
            found.append(("no_go", i))
    return frozenset(found)


# -- names --------------------------------------------------------------------------------


def _check_names(checked: Checked) -> None:
    """Note a fault for every name used twice: of robots with the newcomer, and of zones."""
    seen: dict[str, int] = {}
    for i, name in enumerate(filled([robot.name for robot in checked.file.robots])):
        first = seen.setdefault(name, i)
        if first != i:
            said = f"is the name of robots.{first} too; names should differ"
            checked.fault(("robots", i, "name"), said)
    newcomer = checked.file.newcomer
    if newcomer is not None:
        name = newcomer.name or "newcomer"
        if name in seen and checked.is_known("newcomer"):
            said = f"is the name of robots.{seen[name]} too; names should differ"
            if newcomer.name:
                checked.fault(("newcomer", "name"), said)
            else:
                checked.fault(("newcomer",), f"is called {name!r}, which {said}", got=False)
    zones: dict[str, int] = {}
    for i, zone in enumerate(checked.file.zones or []):
        first = zones.setdefault(zone.name, i)
        if zone.name and first != i:
            said = f"is the name of zones.{first} too; names should differ"
            checked.fault(("zones", i, "name"), said)


def _check_edge_names(checked: Checked) -> None:
    """Note a fault for every edge name used twice."""
    section = checked.file.outline
    if section.edges is None or not checked.is_sound("outline", "edges"):
        return
    seen: dict[str, int] = {}
    for i, name in enumerate(section.edges):
        first = seen.setdefault(name, i)
        if name and first != i:
            said = f"is the name of edges.{first} too; names should differ"
            checked.fault(("outline", "edges", i), said)


# -- bodies -------------------------------------------------------------------------------


def body_of(section: RobotSection | NewcomerSection, units: Units) -> Body | None:
    """Return the room that a robot takes up, None if it says none."""
    if section.length is None or section.beam is None:
        return None
    return Body(units.metres(section.length), units.metres(section.beam))


def _check_body(path: Path, checked: Checked) -> None:
    """Note a fault for half a body, and for that of what is inside."""
    if not checked.is_known(*path):
        return
    for key, other in (("length", "beam"), ("beam", "length")):
        if checked.has(*path, key) and not checked.has(*path, other):
            checked.fault((*path, key), f"goes with {other}; give both or neither")
        if checked.has(*path, key) and checked.has(*path, "mounted"):
            checked.fault((*path, key), "what is mounted takes up no room beside the object")


# -- places -------------------------------------------------------------------------------


def _is_robot_said(section: RobotSection, path: Path, checked: Checked) -> bool:
    """Tell whether a robot says where it is and which way it pushes as a robot can."""
    if not checked.is_known(*path):
        return False
    is_mounted = section.mounted and checked.is_sound(*path, "mounted")
    if is_mounted and isinstance(section.direction, str):
        said = "a mounted robot touches no edge and has no normal; give an angle"
        checked.fault((*path, "direction"), said)
    if not _has_one_way(path, checked, point=True, stretch=False):
        return False
    if is_mounted and not checked.has(*path, "contact"):
        said = "a mounted robot is given by its contact [x, y]"
        checked.fault((*path, "mounted"), said, got=False)
        return False
    return checked.is_sound(*path, "mounted")


def _is_stretch_said(section: StretchSection, path: Path, checked: Checked, units: Units) -> bool:
    """Tell whether a zone or a no-go stretch says in one way where it is."""
    is_zone = isinstance(section, ZoneSection)
    if not checked.is_known(*path):
        return False
    if checked.has(*path, "area"):
        return _is_area_said(path, checked)
    if not _has_one_way(path, checked, point=is_zone, stretch=True):
        return False
    sound = all(checked.is_sound(*path, key) for key in ("from", "to"))
    if not sound or section.start is None or section.end is None:
        return True  # noted already, or an end is the edge's own
    if section.start == section.end:
        checked.fault((*path, "to"), NO_LENGTH if is_zone else NO_WIDTH)
        return False
    is_turned = section.edge is not None and section.start > section.end
    if is_turned and comparable([path], checked):
        said = f"should be less than to, which is {section.end:.9g} {length_name(checked, units)}"
        checked.fault((*path, "from"), said)
        return False
    return True


def _is_area_said(path: Path, checked: Checked) -> bool:
    """Tell whether a zone inside the outline says nothing else of where, or of how it is held."""
    others = [key for key in (*POINT_KEYS, "along", "from", "to") if checked.has(*path, key)]
    if others:
        said = f"{' and '.join([*others, 'area'])} each say where; keep one"
        checked.fault(path, said, got=False)
    if checked.has(*path, "attachment"):
        said = "an area touches no edge; leave the attachment out"
        checked.fault((*path, "attachment"), said)
    return not others and checked.is_sound(*path, "area")


def _has_one_way(path: Path, checked: Checked, *, point: bool, stretch: bool) -> bool:
    """Tell whether exactly one way of saying where is used; note a fault otherwise."""
    keys = POINT_KEYS if point else ("edge",)
    given = [key for key in keys if checked.has(*path, key)]
    ends = [key for key in ("from", "to") if stretch and checked.has(*path, key)]
    along = point and checked.has(*path, "along")
    ways = [ONE_POINT] if point else []
    ways += ["edge, or from and to"] if stretch else []
    if along and "edge" not in given:
        said = "along is a distance on an edge; give the edge too"
    elif along and ends:
        said = "along makes a point, from and to a stretch; give one or the other"
    elif len(given) > 1 or (ends and given not in ([], ["edge"])):
        said = f"{' and '.join(given + ends)} each say where; keep one"
    elif not given and len(ends) < 2:
        said = f"should say where, by {'; or a stretch by '.join(ways)}"
    elif given == ["edge"] and not along and not stretch:
        said = "edge needs along, the distance on it"
    else:
        return True
    checked.fault(path, said, got=False)
    return False


# -- angles -------------------------------------------------------------------------------


def _check_half_angle(
    section: NewcomerSection | ZoneSection, path: Path, checked: Checked, units: Units
) -> None:
    """Note what is wrong with a half angle."""
    half_angle, here = section.half_angle, (*path, "half_angle")
    if half_angle is None:
        return
    right_angle = units.turn(0.25)
    if not 0.0 <= half_angle <= right_angle and checked.is_sound("units", "angle"):
        checked.fault(here, f"should lie in [0, {right_angle:.9g}] {units.angle}")
    elif section.attachment not in ("push", "pull") and checked.is_sound(*path, "attachment"):
        said = "goes with attachment: push or pull only; a free one pushes in any direction"
        checked.fault(here, said)


def _check_directions(section: ZoneSection, path: Path, checked: Checked, units: Units) -> None:
    """Note a range of directions that spans a full turn."""
    if section.directions is None or not checked.is_sound("units", "angle"):
        return
    first, last = section.directions
    if abs(last - first) >= units.turn(1.0):
        said = "spans a full turn, which limits nothing; leave it out"
        checked.fault((*path, "directions"), said)
