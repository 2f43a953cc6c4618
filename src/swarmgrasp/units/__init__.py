"""The units that people write, and the numbers they stand for."""

from swarmgrasp.units.beaufort import beaufort_number, beaufort_speed
from swarmgrasp.units.compass import COMPASS, bearing, compass_point
from swarmgrasp.units.geographic import is_geographic, may_be_geographic
from swarmgrasp.units.quantity import in_unit, is_quantity, quantity, split, unit_size
from swarmgrasp.units.spellings import (
    ANGLES,
    BEAUFORT,
    FORCES,
    KNOT,
    LENGTHS,
    PLAIN,
    SPEEDS,
    canonical,
    size,
    spellings,
    unit_fault,
    unit_name,
)

__all__ = [
    "ANGLES",
    "BEAUFORT",
    "COMPASS",
    "FORCES",
    "KNOT",
    "LENGTHS",
    "PLAIN",
    "SPEEDS",
    "bearing",
    "beaufort_number",
    "beaufort_speed",
    "canonical",
    "compass_point",
    "in_unit",
    "is_geographic",
    "is_quantity",
    "may_be_geographic",
    "quantity",
    "size",
    "spellings",
    "split",
    "unit_fault",
    "unit_name",
    "unit_size",
]
