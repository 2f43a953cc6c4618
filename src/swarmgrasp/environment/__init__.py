"""Wind and current: the loads they exert on the object."""

from swarmgrasp.environment.coefficients import (
    BLENDERMANN,
    CurrentCoefficients,
    WindCoefficients,
    vessel_type,
)
from swarmgrasp.environment.loads import AIR, WATER, Current, Environment, Wind
from swarmgrasp.units import KNOT, beaufort

__all__ = [
    "AIR",
    "BLENDERMANN",
    "KNOT",
    "WATER",
    "Current",
    "CurrentCoefficients",
    "Environment",
    "Wind",
    "WindCoefficients",
    "beaufort",
    "vessel_type",
]
