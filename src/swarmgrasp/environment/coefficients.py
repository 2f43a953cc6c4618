"""Published drag coefficients: Blendermann's for wind, DNV's for current."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from swarmgrasp.environment.limits import COEFFICIENT, CROSS_FORCE
from swarmgrasp.errors import EnvironmentInvalid
from swarmgrasp.plain import Plain


@dataclass(frozen=True)
class WindCoefficients(Plain):
    """Blendermann's coefficients of what a vessel shows to the wind.

    Attributes
    ----------
    transverse : float
        CD_t, of the lateral area in a beam wind.
    bow, stern : float
        CD_l,AF(0) and CD_l,AF(pi), of the frontal area in a head wind and a stern wind.
    cross_force : float
        The parameter delta, within [0, 1]: how much an oblique wind pushes more than its
        components do.

    Raises
    ------
    EnvironmentInvalid
        If a number is outside its range; all faults at once.

    Examples
    --------
    >>> BLENDERMANN["offshore supply vessel"]
    WindCoefficients(transverse=0.9, bow=0.55, stern=0.8, cross_force=0.55)
    """

    transverse: float
    bow: float
    stern: float
    cross_force: float = 0.0

    def __post_init__(self) -> None:
        """Check the values."""
        faults = [
            *COEFFICIENT.faults("transverse coefficient", self.transverse),
            *COEFFICIENT.faults("bow coefficient", self.bow),
            *COEFFICIENT.faults("stern coefficient", self.stern),
            *CROSS_FORCE.faults("cross-force parameter", self.cross_force),
        ]
        if faults:
            raise EnvironmentInvalid(faults)
        vars(self).update({name: float(value) for name, value in vars(self).items()})


@dataclass(frozen=True)
class CurrentCoefficients(Plain):
    """Drag coefficients of the underwater hull; those of DNV-ST-0111 for a ship by default.

    Attributes
    ----------
    surge : float
        Of the frontal underwater area in a current along the hull.
    sway : float
        Of the lateral underwater area in a current across it.

    Raises
    ------
    EnvironmentInvalid
        If a number is outside its range; all faults at once.
    """

    surge: float = 0.07
    sway: float = 0.6

    def __post_init__(self) -> None:
        """Check the values."""
        faults = [
            *COEFFICIENT.faults("surge coefficient", self.surge),
            *COEFFICIENT.faults("sway coefficient", self.sway),
        ]
        if faults:
            raise EnvironmentInvalid(faults)
        vars(self).update({name: float(value) for name, value in vars(self).items()})


SHIP: Final = CurrentCoefficients()
"""The coefficients of DNV-ST-0111, *Assessment of station keeping capability of dynamic positioning
vessels* (2021), section 3.6, for ship-shaped hulls."""

BLENDERMANN: Final[Mapping[str, WindCoefficients]] = MappingProxyType({
    "car carrier": WindCoefficients(0.95, 0.55, 0.60, 0.80),
    "cargo vessel, loaded": WindCoefficients(0.85, 0.65, 0.55, 0.40),
    "cargo vessel, container on deck": WindCoefficients(0.85, 0.55, 0.50, 0.40),
    "container ship, loaded": WindCoefficients(0.90, 0.55, 0.55, 0.40),
    "destroyer": WindCoefficients(0.85, 0.60, 0.65, 0.65),
    "diving support vessel": WindCoefficients(0.90, 0.60, 0.80, 0.55),
    "drilling vessel": WindCoefficients(1.00, 0.85, 0.925, 0.10),  # middles of 0.70-1.00, 0.75-1.10
    "ferry": WindCoefficients(0.90, 0.45, 0.50, 0.80),
    "fishing vessel": WindCoefficients(0.95, 0.70, 0.70, 0.40),
    "liquefied natural gas tanker": WindCoefficients(0.70, 0.60, 0.65, 0.50),
    "offshore supply vessel": WindCoefficients(0.90, 0.55, 0.80, 0.55),
    "passenger liner": WindCoefficients(0.90, 0.40, 0.40, 0.80),
    "research vessel": WindCoefficients(0.85, 0.55, 0.65, 0.60),
    "speed boat": WindCoefficients(0.90, 0.55, 0.60, 0.60),
    "tanker, loaded": WindCoefficients(0.70, 0.90, 0.55, 0.40),
    "tanker, in ballast": WindCoefficients(0.70, 0.75, 0.55, 0.40),
    "tender": WindCoefficients(0.85, 0.55, 0.55, 0.65),
})  # fmt: skip
"""Wind coefficients by type of vessel.

W. Blendermann, *Parameter identification of wind loads on ships*, Journal of Wind Engineering and
Industrial Aerodynamics 51 (1994), 339-351, table 1; printed in T. I. Fossen, *Handbook of Marine
Craft Hydrodynamics and Motion Control* (2011, table 8.1; 2021, section 10.1). Where a range is
printed, for drilling vessels, its middle is taken.
"""


def vessel_type(coefficients: WindCoefficients) -> str | None:
    """Return the type of vessel that coefficients are of, None for coefficients of one's own.

    Examples
    --------
    >>> vessel_type(BLENDERMANN["ferry"]), vessel_type(WindCoefficients(1.0, 1.0, 1.0))
    ('ferry', None)
    """
    return next((name for name, known in BLENDERMANN.items() if known == coefficients), None)
