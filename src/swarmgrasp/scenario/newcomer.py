"""Build a newcomer of a scenario: the one to place, or one that is sent."""

import math

from swarmgrasp.errors import RobotInvalid
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.force_sets import forces_of
from swarmgrasp.scenario.newcomer_schema import NewcomerSection
from swarmgrasp.scenario.schema import ZoneSection
from swarmgrasp.scenario.tolerances import tolerance_of
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.scenario.ways import body_of
from swarmgrasp.swarm import Newcomer


def newcomer_of(section: NewcomerSection, path: Path, checked: Checked, units: Units) -> Newcomer:
    """Return a newcomer of a document without faults.

    Raises
    ------
    ScenarioInvalid
        If a number is too small to compute with.
    """
    try:
        return Newcomer(
            attachment=section.attachment,
            half_angle=half_angle_of(section, units),
            name=section.name,
            tolerance=tolerance_of(section, checked, units),
            steers=section.steers,
            mounted=section.mounted,
            body=body_of(section, units),
            **forces_of(section, units),
        )
    except RobotInvalid as error:  # numbers next to zero only
        checked.fault(path, "; ".join(error.faults), got=False)
        raise checked.faults.error() from error


def half_angle_of(section: NewcomerSection | ZoneSection, units: Units) -> float | None:
    """Return a half angle [rad], or None if there is none."""
    if section.half_angle is None:
        return None
    return min(units.radians(section.half_angle), math.pi / 2.0)  # 90 deg, rounding aside
