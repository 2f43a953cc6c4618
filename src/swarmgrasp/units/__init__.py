"""The units that people write, and the numbers they stand for."""

from swarmgrasp.units.beaufort import beaufort, beaufort_speed
from swarmgrasp.units.compass import COMPASS, compass_point
from swarmgrasp.units.quantity import is_quantity, quantity
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
    "beaufort",
    "beaufort_speed",
    "canonical",
    "compass_point",
    "is_quantity",
    "quantity",
    "size",
    "spellings",
]
