"""The loads of wind and current, as functions of where they come from and how fast.

A bearing here is where something comes FROM, clockwise from the bow (+x), as seamen count:
0 is ahead, pi/2 on the starboard beam. All other angles of this package are counter-clockwise.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment.coefficients import SHIP, CurrentCoefficients, WindCoefficients
from swarmgrasp.environment.geometry import folded_of, keep_floats, length_of, numbers_in, wrench_of
from swarmgrasp.environment.limits import AREA, BEARING, DENSITY, OFFSET, SPEED
from swarmgrasp.errors import EnvironmentInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.outline.outline import check_outline
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import shown

AIR, WATER = 1.226, 1026.0
"""Densities [kg/m^3] of air and sea water, those of DNV-ST-0111."""


@dataclass(frozen=True)
class Wind(Plain):
    """What the object shows to the wind, and perhaps a wind.

    Attributes
    ----------
    frontal_area, lateral_area : float [m^2]
        A_F and A_L: what is above the water, seen from ahead and from the side.
    coefficients : WindCoefficients
        See `BLENDERMANN`, by type of vessel.
    lateral_centroid : float [m]
        s_L: how far the centre of the lateral area is forward of midship, the middle of the
        outline's extent.
    speed : float [m/s], optional
        Of a steady wind, the mean 10 m above the sea; goes with `bearing`.
    bearing : float [rad], optional
        Where that wind comes from, clockwise from the bow.
    density : float [kg/m^3]
        Of the air.

    Raises
    ------
    EnvironmentInvalid
        If a number is outside its range, or speed and bearing do not go together; all
        faults at once.

    Examples
    --------
    A barge of 80 m with deck cargo in a beam wind of 20 m/s from starboard is pushed to port:

    >>> barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    >>> wind = Wind(150.0, 500.0, WindCoefficients(transverse=0.9, bow=0.7, stern=0.7))
    >>> surge, sway, yaw = wind.load(barge, math.pi / 2, 20.0)
    >>> round(sway)
    110340
    """

    frontal_area: float
    lateral_area: float
    coefficients: WindCoefficients
    lateral_centroid: float = 0.0
    speed: float | None = None
    bearing: float | None = None
    density: float = AIR

    def __post_init__(self) -> None:
        """Check the values."""
        faults = _hull_faults(self)
        if not isinstance(self.coefficients, WindCoefficients):
            faults.append(
                f"the coefficients are {shown(self.coefficients)}; they should be "
                "WindCoefficients, such as BLENDERMANN['tender']"
            )
        if (self.speed is None) != (self.bearing is None):
            faults.append("the speed and the bearing of a wind go together; give both or neither")
        if faults:
            raise EnvironmentInvalid(f"wind: {fault}" for fault in faults)
        keep_floats(self)

    def load(self, outline: Outline, bearings: ArrayLike, speeds: ArrayLike) -> NDArray[np.float64]:
        """Compute the wrench that a wind exerts on the object, by Blendermann's formulas.

        With CD_l = CD_l,AF A_F / A_L and D = 1 - (delta / 2) (1 - CD_l / CD_t) sin^2(2 g),

            X = -q A_F CD_l,AF cos g / D,    Y = q A_L CD_t sin g / D,
            N = Y (s_L - 0.18 (g - pi/2) L)  about midship,    q = density speed^2 / 2

        for a bearing g of 0 to pi; from port, Y and N change sign.

        Parameters
        ----------
        outline : Outline
            Gives the length L, midship, and the origin that moments are taken about.
        bearings : (...) [rad]
            Where the wind comes from, clockwise from the bow.
        speeds : (...) [m/s]

        Returns
        -------
        (..., 3) [N, N, N m]
        """
        check_outline(outline)
        bearing, folded = folded_of(bearings)
        c = self.coefficients
        along = np.where(folded <= 0.5 * math.pi, c.bow, c.stern)
        share = along * self.frontal_area / (self.lateral_area * c.transverse)  # CD_l / CD_t
        excess = 1.0 - 0.5 * c.cross_force * (1.0 - share) * np.sin(2.0 * folded) ** 2
        surge = -self.frontal_area * along * np.cos(folded) / excess
        sway = self.lateral_area * c.transverse * np.sin(bearing) / excess
        arm = self.lateral_centroid - 0.18 * (folded - 0.5 * math.pi) * length_of(outline)
        pressure = 0.5 * self.density * numbers_in(speeds, "speeds", SPEED) ** 2
        return wrench_of(outline, pressure * surge, pressure * sway, arm)


@dataclass(frozen=True)
class Current(Plain):
    """What the object shows to the current, and the current.

    Attributes
    ----------
    frontal_area, lateral_area : float [m^2]
        What is under water, seen from ahead (about beam times draught) and from the side
        (about length times draught).
    speed : float [m/s]
        Uniform over the draught.
    bearing : float [rad], optional
        Where the current comes from, clockwise from the bow; alongside the wind, from where
        the wind comes, when left out.
    coefficients : CurrentCoefficients
    lateral_centroid : float [m]
        How far the centre of the lateral area is forward of midship.
    density : float [kg/m^3]
        Of the water.

    Raises
    ------
    EnvironmentInvalid
        If a number is outside its range; all faults at once.
    """

    frontal_area: float
    lateral_area: float
    speed: float = 0.0
    bearing: float | None = None
    coefficients: CurrentCoefficients = SHIP
    lateral_centroid: float = 0.0
    density: float = WATER

    def __post_init__(self) -> None:
        """Check the values."""
        faults = _hull_faults(self)
        if not isinstance(self.coefficients, CurrentCoefficients):
            faults.append(
                f"the coefficients are {shown(self.coefficients)}; they should be "
                "CurrentCoefficients"
            )
        if self.speed is None:
            faults.append("the speed is None; it should be a number [m/s], 0 for still water")
        if faults:
            raise EnvironmentInvalid(f"current: {fault}" for fault in faults)
        keep_floats(self)

    def load(self, outline: Outline, bearings: ArrayLike, speeds: ArrayLike) -> NDArray[np.float64]:
        """Compute the wrench that a current exerts on the object, as DNV-ST-0111 does for ships.

            X = -q A_F C_X cos g,    Y = q A_L C_Y sin g,
            N = Y (x_L + max(-0.2, min(0.25, 0.4 (1 - 2 g / pi))) L)  about midship

        with q = density speed^2 / 2, for a bearing g of 0 to pi; from port, Y and N change
        sign.

        Parameters
        ----------
        outline : Outline
            Gives the length L, midship, and the origin that moments are taken about.
        bearings : (...) [rad]
            Where the current comes from, clockwise from the bow.
        speeds : (...) [m/s]

        Returns
        -------
        (..., 3) [N, N, N m]
        """
        check_outline(outline)
        bearing, folded = folded_of(bearings)
        surge = -self.frontal_area * self.coefficients.surge * np.cos(folded)
        sway = self.lateral_area * self.coefficients.sway * np.sin(bearing)
        shift = np.clip(0.4 * (1.0 - 2.0 * folded / math.pi), -0.2, 0.25)
        arm = self.lateral_centroid + shift * length_of(outline)
        pressure = 0.5 * self.density * numbers_in(speeds, "speeds", SPEED) ** 2
        return wrench_of(outline, pressure * surge, pressure * sway, arm)


def _hull_faults(part: Wind | Current) -> list[str]:
    """Return what is wrong with the numbers that wind and current have in common."""
    faults = [
        *AREA.faults("frontal area", part.frontal_area),
        *AREA.faults("lateral area", part.lateral_area),
        *OFFSET.faults("lateral centroid", part.lateral_centroid),
        *DENSITY.faults("density", part.density),
    ]
    if part.speed is not None:
        faults += SPEED.faults("speed", part.speed)
    if part.bearing is not None:
        faults += BEARING.faults("bearing", part.bearing)
    return faults
