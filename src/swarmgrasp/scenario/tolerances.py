"""Build the tolerances of a scenario, and find the faults its schema does not see."""

import math

from swarmgrasp.scenario.edges import comparable, length_name
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.force_sets import largest
from swarmgrasp.scenario.newcomer_schema import NewcomerSection
from swarmgrasp.scenario.schema import RobotSection
from swarmgrasp.scenario.tolerance_schema import ToleranceSection
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.swarm import Tolerance

DEFAULT: Path = ("tolerance",)
"""Where a file gives the tolerance of every robot that has none of its own."""


def check_tolerances(checked: Checked, units: Units) -> None:
    """Note what is wrong with the tolerances of a document, whatever its outline is."""
    file = checked.file
    if file.tolerance is not None:
        _check_offsets(file.tolerance, DEFAULT, checked, units)
        _check_default(file.tolerance, checked, units)
    for section, path in holders(checked):
        if section.tolerance is not None:
            _check_offsets(section.tolerance, (*path, "tolerance"), checked, units)
            _check_own(section, path, checked, units)


def check_reaches(checked: Checked, units: Units, perimeter: float) -> None:
    """Note every contact that may lie on more than a whole boundary, given its length [m]."""
    given = {
        (*path, "tolerance", "contact"): section.tolerance for section, path in holders(checked)
    }
    given[*DEFAULT, "contact"] = checked.file.tolerance
    for path in comparable(given, checked):
        tolerance = given[path]
        first, last = _ends(None if tolerance is None else tolerance.contact)
        if units.metres(last) - units.metres(first) > perimeter:
            unit = length_name(checked, units)
            checked.fault(path, f"spans {last - first:.9g} {unit}, the whole boundary and more")


def tolerance_of(
    section: RobotSection | NewcomerSection, checked: Checked, units: Units
) -> Tolerance | None:
    """Return the tolerance of a robot or of the newcomer, in SI units: its own or the file's.

    Of the file's, what is mounted leaves out the contact, a couple the direction, and the newcomer
    that it may be absent.

    Returns
    -------
    Tolerance or None
        None if it is exactly as the file says.

    Raises
    ------
    RobotInvalid
        If the least limit is too small to compute with.
    """
    is_own = section.tolerance is not None
    given = section.tolerance or checked.file.tolerance
    if given is None:
        return None
    is_robot = isinstance(section, RobotSection)
    has_lever = isinstance(section, RobotSection) and section.lever is not None
    first, last = (0.0, 0.0) if section.mounted else units.either_way(_ends(given.contact))
    least = given.least_limit
    found = Tolerance(
        contact=(units.metres(first), units.metres(last)),
        direction=(0.0, 0.0) if has_lever and not is_own else _radians(given.direction, units),
        least_limit=None if least is None else units.newtons(least),
        may_be_absent=given.may_be_absent and (is_own or is_robot),
    )
    return None if found == Tolerance() else found


# -- parts --------------------------------------------------------------------------------


def holders(checked: Checked) -> list[tuple[RobotSection | NewcomerSection, Path]]:
    """Return the robots and the newcomers, each with its path."""
    file = checked.file
    robots: list[tuple[RobotSection | NewcomerSection, Path]] = []
    robots += [(robot, ("robots", i)) for i, robot in enumerate(file.robots)]
    return [*robots, *checked.newcomers()]


def _ends(given: float | list[float] | None) -> tuple[float, float]:
    """Return the two offsets of a contact or a direction."""
    if isinstance(given, list):
        return given[0], given[1]
    return -(given or 0.0), given or 0.0


def _radians(given: float | list[float] | None, units: Units) -> tuple[float, float]:
    """Return the two offsets of a direction [rad]."""
    first, last = map(units.radians, units.either_way(_ends(given)))
    return max(first, -math.pi), min(last, math.pi)  # half a turn, rounding aside


def _check_offsets(section: ToleranceSection, path: Path, checked: Checked, units: Units) -> None:
    """Note offsets on the wrong side, and directions more than half a turn off."""
    most = {"contact": math.inf}
    if checked.is_sound("units", "angle"):
        most["direction"] = units.turn(0.5)
    for key, far in most.items():
        given, here = getattr(section, key), (*path, key)
        ranges = [(given or 0.0, here, 0.0, far)]
        if isinstance(given, list):
            ranges = [(given[0], (*here, 0), -far, 0.0), (given[1], (*here, 1), 0.0, far)]
        for offset, spot, lo, hi in ranges:
            said = f"should lie in [{lo:.9g}, {hi:.9g}] {units.angle}"
            if far == math.inf:
                said = "should be at least 0" if hi else "should be at most 0"
            if not lo <= offset <= hi:
                checked.fault(spot, said)


def _check_own(
    section: RobotSection | NewcomerSection, path: Path, checked: Checked, units: Units
) -> None:
    """Note what of its own tolerance does not go with a robot."""
    own = section.tolerance
    here: Path = (*path, "tolerance")
    if section.mounted and checked.is_sound(*path, "mounted") and checked.has(*here, "contact"):
        said = "a mounted robot stays where it is; leave the contact out"
        checked.fault((*here, "contact"), said)
    least = None if own is None else own.least_limit
    limit = largest(section)
    if least is not None and least > limit and checked.is_sound(*path, "limit"):
        said = f"should be at most {limit:.9g} {units.force}, the limit"
        checked.fault((*here, "least_limit"), said)


def _check_default(default: ToleranceSection, checked: Checked, units: Units) -> None:
    """Note a default least limit that is more than a robot's limit."""
    asked = [
        (largest(section), path)
        for section, path in holders(checked)
        if not checked.has(*path, "tolerance") and checked.is_sound(*path, "limit")
    ]
    if default.least_limit is None or not asked:
        return
    limit, path = min(asked, key=lambda one: one[0])
    if default.least_limit > limit:
        whose = ".".join(map(str, path))
        said = f"should be at most {limit:.9g} {units.force}, the limit of {whose}"
        checked.fault((*DEFAULT, "least_limit"), said)
