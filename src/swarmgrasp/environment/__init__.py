"""Wind, current and waves: the loads they exert on the object."""

from swarmgrasp.environment.coefficients import (
    BLENDERMANN,
    CurrentCoefficients,
    WindCoefficients,
    vessel_type,
)
from swarmgrasp.environment.environment import Environment
from swarmgrasp.environment.loads import AIR, WATER, Current, Wind
from swarmgrasp.environment.sea import STEPS, STRONGEST_SEA, Step, sea_of
from swarmgrasp.environment.table import WindTable
from swarmgrasp.environment.waves import Waves
from swarmgrasp.units import KNOT, beaufort_number

__all__ = [
    "AIR",
    "BLENDERMANN",
    "KNOT",
    "STEPS",
    "STRONGEST_SEA",
    "WATER",
    "Current",
    "CurrentCoefficients",
    "Environment",
    "Step",
    "Waves",
    "Wind",
    "WindCoefficients",
    "WindTable",
    "beaufort_number",
    "sea_of",
    "vessel_type",
]
