"""Build a scenario from a checked document, and find the faults that geometry has."""

import math
from dataclasses import replace

from swarmgrasp.errors import OutlineInvalid, RobotInvalid, SwarmGraspError, ZoneInvalid
from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.ranges import plain_name
from swarmgrasp.scenario.allocation import allocated
from swarmgrasp.scenario.criteria import check_criterion, criterion_of
from swarmgrasp.scenario.edges import VERTICES, check_edges, comparable, length_name
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.force_sets import check_force_sets, forces_of, own_forces_of
from swarmgrasp.scenario.locate import Locator, Place
from swarmgrasp.scenario.newcomer import half_angle_of, newcomer_of
from swarmgrasp.scenario.quantities import precision_of
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.schema import RobotSection, ZoneSection
from swarmgrasp.scenario.slips import slips_of
from swarmgrasp.scenario.speech import frame_of, terms_of
from swarmgrasp.scenario.tolerances import check_reaches, check_tolerances, tolerance_of
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.scenario.ways import NO_LENGTH, NO_WIDTH, body_of, well_said
from swarmgrasp.scenario.weather import check_weather, environment_of
from swarmgrasp.swarm import Robot, Swarm, Zone
from swarmgrasp.swarm.names import filled

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
    units = Units(**file.units.model_dump(), frame=frame_of(file))
    said = well_said(checked, units)
    check_force_sets(checked, units)
    check_tolerances(checked, units)
    check_criterion(checked)
    check_weather(checked, units)
    _check_simulation(checked, units)
    locator = _locator(checked, units)
    found = frozenset() if locator is None else comparable(said, checked)
    if found != said:
        check_edges(checked, units, said - found)
    if locator is None:
        raise checked.faults.error()
    check_reaches(checked, units, locator.si.perimeter)
    said = found
    robots, zones = _robots(locator, said), _zones(locator, said)
    robots += _allocated(locator)
    no_go = _no_go(locator, said)
    if checked.faults:
        raise checked.faults.error()
    length = file.metric.characteristic_length
    a1, a2 = file.metric.force_weights
    try:
        swarm = Swarm(locator.si, robots, length and units.metres(length), (a1, a2))
    except SwarmGraspError as error:  # by rounding only: all of it is checked above
        checked.fault((), "; ".join(error.faults), got=False)
        raise checked.faults.error() from error
    environment, own = environment_of(checked, units), file.newcomer
    scenario = Scenario(
        name=file.name or plain_name(default_name),
        description=file.description,
        swarm=swarm,
        newcomer=None if own is None else newcomer_of(own, ("newcomer",), checked, units),
        zones=zones if file.zones is not None else None,
        no_go=no_go,
        spacing=units.metres(file.spacing),
        environment=environment,
        criterion=criterion_of(checked, units, swarm.outline, environment),
        terms=terms_of(file, units),
    )
    scenario = replace(scenario, slips=slips_of(checked, units, scenario))
    return _with_simulation(scenario, checked, units)


# -- the simulation: what runs in time is loaded only for a file that has one ----------------


def _check_simulation(checked: Checked, units: Units) -> None:
    """Note what is wrong with how a document says its simulation."""
    section = checked.file.simulation
    if section is not None and checked.is_known("simulation"):
        from swarmgrasp.scenario.simulation import check_simulation

        check_simulation(section, units, checked)


def _with_simulation(scenario: Scenario, checked: Checked, units: Units) -> Scenario:
    """Return a scenario with what becomes of it in time, if its document says so."""
    section, environment = checked.file.simulation, scenario.environment
    if section is None or environment is None:
        return scenario
    from swarmgrasp.scenario.simulation import simulation_of

    problem = scenario.problem()
    return replace(
        scenario, simulation=simulation_of(section, units, problem, environment, checked)
    )


# -- the outline --------------------------------------------------------------------------


def _locator(checked: Checked, units: Units) -> Locator | None:
    """Return the outline in the file's units and in metres, or None if it has faults.

    Names of edges and an origin with faults, noted before, do not keep points from being
    located: edges then go by their numbers, and rays and nothing else need the origin.
    """
    section, path = checked.file.outline, VERTICES
    if not (checked.is_sound(*path) and comparable([path], checked)):
        return None
    unit = length_name(checked, units)
    try:
        precision = section.precision
        if precision is None:
            precision = precision_of(checked.root.find(path), units)
        plain = Outline(section.vertices, precision=precision)
        if plain.extent < SMALLEST_EXTENT:
            raise OutlineInvalid(
                f"the outline is {plain.extent:.3g} {unit} across; it should be at least "
                f"{SMALLEST_EXTENT:g} {unit}"
            )
        path = ("outline", "edges")
        names = _edge_names(checked, len(plain))
        labels = [name or f"edge {i}" for i, name in enumerate(names)]
        origin = None if section.origin == "centroid" else section.origin
        outline = Outline(section.vertices, origin, labels)
        # what runs clockwise counts its edges the other way than Outline: name them all
        is_kept = (outline.edge_names[0] == labels[0]) != units.frame.mirrored
        kept = names if is_kept else labels
        si = Outline(
            list(map(units.point, section.vertices)),
            units.point(outline.origin.tolist()),
            kept,
            units.metres(plain.precision),
        )
    except OutlineInvalid as error:
        for sentence in error.faults:  # Outline speaks of metres
            checked.fault(path, sentence.replace(") m:", f") {unit}:"), got=False)
        return None
    return Locator(outline, si, labels, unit, units, checked)


def _edge_names(checked: Checked, count: int) -> list[str]:
    """Return the name of each edge, in the order of the file: "" where it has none, or a fault."""
    written = checked.file.outline.edges
    if written is None or not checked.is_sound("outline", "edges"):
        return [""] * count
    if len(written) != count:
        said = f"there are {len(written)} edge names for {count} edges; give one per edge"
        checked.fault(("outline", "edges"), said, got=False)
        return [""] * count
    seen = {"": 0}
    return [name if seen.setdefault(name, i) == i else "" for i, name in enumerate(written)]


# -- robots -------------------------------------------------------------------------------


def _robots(locator: Locator, said: frozenset[Path]) -> list[Robot]:
    """Return the robots; none of them once there are faults."""
    checked, found = locator.checked, []
    for i, section in enumerate(checked.file.robots):
        path: Path = ("robots", i)
        place = _robot_place(section, path, locator) if path in said else None
        direction = _direction(section, path, place, locator)
        if place is not None and direction is not None:
            found.append((section, i, place, direction))
    robots = []
    names = filled([section.name for section in checked.file.robots])
    for section, i, place, direction in [] if checked.faults else found:
        try:
            robots.append(_robot(section, names[i], place, direction, locator))
        except RobotInvalid as error:  # numbers next to zero only
            checked.fault(("robots", i), "; ".join(error.faults), got=False)
    return robots


def _allocated(locator: Locator) -> list[Robot]:
    """Return the thrusters of an allocation matrix, if the file has one without faults."""
    checked, units = locator.checked, locator.units
    section = checked.file.allocation
    if section is None or not checked.is_sound("allocation") or not checked.is_sound("units"):
        return []
    try:
        return allocated(
            section, units.metres(1.0), units.newtons(1.0), checked.file.frame, locator.si
        )
    except RobotInvalid as error:
        for fault in error.faults:
            checked.fault(("allocation",), fault, got=False)
        return []


def _robot(
    section: RobotSection, name: str, place: Place, direction: float, locator: Locator
) -> Robot:
    """Return a robot."""
    units = locator.units
    return Robot(
        units.point(place.point),
        direction,
        name=name,
        mounted=section.mounted,
        tolerance=tolerance_of(section, locator.checked, units),
        group=section.group,
        body=body_of(section, units),
        **forces_of(section, units),
        **own_forces_of(section, units),
    )


def _robot_place(section: RobotSection, path: Path, locator: Locator) -> Place | None:
    """Return where a robot is, or None after noting what is wrong with it."""
    if not section.mounted:
        return locator.place(section, path)
    if section.contact is None:
        return None
    return locator.inside(section.contact, (*path, "contact"))


def _direction(
    section: RobotSection, path: Path, place: Place | None, locator: Locator
) -> float | None:
    """Return the direction of a robot's force [rad], or None after noting a fault."""
    wanted = section.direction
    if section.sectors is not None:
        return math.nan  # they tell it
    if wanted is None and section.friction is not None:
        wanted = "inward"
    if not isinstance(wanted, str):
        return locator.units.direction(wanted or 0.0)  # of what steers any way
    if section.mounted or place is None:
        return None  # noted already
    if place.inward is None:
        said = (
            "the normal is ambiguous at a corner; give the contact by edge and along, or an angle"
        )
        got = section.direction is not None
        locator.checked.fault((*path, "direction"), said, got=got)
        return None
    turn = 0.0 if wanted == "inward" else math.pi
    inward = locator.units.frame.direction_from_file(place.inward)
    return math.remainder(inward + turn, 2.0 * math.pi)


# -- zones --------------------------------------------------------------------------------


def _zones(locator: Locator, said: frozenset[Path]) -> tuple[Zone, ...]:
    """Return the zones; none of them once there are faults."""
    sections = [
        (section, ("zones", i))
        for i, section in enumerate(locator.checked.file.zones or [])
        if ("zones", i) in said
    ]
    found = [_zone(section, path, locator) for section, path in sections]
    return tuple(zone for zone in found if zone is not None)


def _zone(section: ZoneSection, path: Path, locator: Locator) -> Zone | None:
    """Return a zone, or None after noting a fault."""
    units, directions = locator.units, section.directions
    range_ = units.span(directions) if directions else None
    if section.area is not None:
        return _area(section, (*path, "area"), range_, locator)
    stretch = _zone_stretch(section, path, locator)
    if stretch is None or locator.checked.faults:
        return None
    return Zone(stretch, section.attachment, half_angle_of(section, units), range_)


def _area(
    section: ZoneSection, path: Path, directions: tuple[float, float] | None, locator: Locator
) -> Zone | None:
    """Return a zone inside the outline, or None after noting a fault."""
    units, corners = locator.units, section.area or []
    inside = [locator.inside(corner, (*path, k)) for k, corner in enumerate(corners)]
    if None in inside:
        return None
    area = tuple(map(units.point, corners))
    try:
        return Zone(directions=directions, area=area, name=section.name)
    except ZoneInvalid as error:  # corners that are not in order around it
        for fault in error.faults:
            locator.checked.fault(path, fault.partition(": ")[2], got=False)
        return None


def _zone_stretch(section: ZoneSection, path: Path, locator: Locator) -> Stretch | None:
    """Return a zone's stretch or point [m], or None after noting a fault."""
    is_point = any(locator.checked.has(*path, key) for key in ("contact", "theta", "at", "along"))
    if not is_point:
        return locator.stretch(section, path, NO_LENGTH)
    place = locator.place(section, path)
    if place is None:
        return None
    arc = locator.metres(place.arc_length)
    return Stretch(arc, arc, section.name)


def _no_go(locator: Locator, said: frozenset[Path]) -> tuple[Stretch, ...]:
    """Return the no-go stretches that have no faults."""
    found = [
        locator.stretch(section, ("no_go", i), NO_WIDTH)
        for i, section in enumerate(locator.checked.file.no_go)
        if ("no_go", i) in said
    ]
    return tuple(stretch for stretch in found if stretch is not None)
