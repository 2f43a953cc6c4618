"""What is around an object: wind, current and waves."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment.geometry import numbers_in
from swarmgrasp.environment.limits import BEARING, DYNAMIC_FACTOR, SPEED
from swarmgrasp.environment.loads import Current, Wind
from swarmgrasp.environment.sea import sea_faults, sea_of
from swarmgrasp.environment.table import WindTable
from swarmgrasp.environment.waves import Waves
from swarmgrasp.errors import EnvironmentInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.outline.outline import check_outline
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import kind_faults

SAME: Final = 1e-9
"""Difference of a load from that of surroundings, relative, that counts as none."""


@dataclass(frozen=True)
class Environment(Plain):
    """Wind, current and waves around an object.

    Attributes
    ----------
    wind : Wind or WindTable
    current : Current, optional
        Still water when left out.
    dynamic_factor : float
        Multiplies all loads, an allowance for gusts and for what station keeping itself
        needs: 1.25 in DNV-ST-0111. At least 1, the default: no allowance.
    waves : Waves, optional
        A flat sea when left out.

    Raises
    ------
    EnvironmentInvalid
        If a part is not what it should be, or the sea goes with a wind stronger than those whose
        sea is known; all faults at once.

    Examples
    --------
    >>> from swarmgrasp import WindCoefficients
    >>> barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    >>> box = WindCoefficients(transverse=0.9, bow=0.7, stern=0.7)
    >>> weather = Environment(
    ...     Wind(150.0, 500.0, box, speed=15.0, bearing=0.0), Current(60.0, 240.0, speed=1.0)
    ... )
    >>> weather.load(barge).round(1).tolist()  # both from ahead
    [-16636.7, 0.0, 0.0]
    """

    wind: Wind | WindTable
    current: Current | None = None
    dynamic_factor: float = 1.0
    waves: Waves | None = None

    def __post_init__(self) -> None:
        """Check the values."""
        faults = DYNAMIC_FACTOR.faults("dynamic factor", self.dynamic_factor)
        if not isinstance(self.wind, WindTable):
            faults += kind_faults(self.wind, Wind, "Wind(...)")
        if self.current is not None:
            faults += kind_faults(self.current, Current, "Current(...)")
        if self.waves is not None:
            faults += kind_faults(self.waves, Waves, "Waves(...)")
        if faults:
            raise EnvironmentInvalid(faults)
        grows = self.waves is not None and self.waves.goes_with_wind
        if grows and (faults := sea_faults("wind's speed", self.wind.speed or 0.0)):
            raise EnvironmentInvalid(faults)
        vars(self)["dynamic_factor"] = float(self.dynamic_factor)

    @property
    def is_steady(self) -> bool:
        """Whether a steady wind is given, so that there is a steady load."""
        return self.wind.speed is not None

    def exerts(self, outline: Outline, load: ArrayLike) -> bool:
        """Tell whether a load is the steady one of these surroundings.

        Parameters
        ----------
        outline : Outline
        load : (3,) [N, N, N m]
        """
        return self.is_steady and bool(np.allclose(self.load(outline), load, rtol=SAME, atol=0.0))

    @property
    def grows_with_square(self) -> bool:
        """Whether loads grow with the square of the wind, but for those that are there anyway."""
        if self.waves is not None and self.waves.goes_with_wind:
            return False
        return isinstance(self.wind, Wind) or self.wind.grows_with_square

    def wind_load(
        self, outline: Outline, bearings: ArrayLike, speeds: ArrayLike
    ) -> NDArray[np.float64]:
        """Compute the wrench of winds on the object.

        Parameters
        ----------
        outline : Outline
        bearings : (...) [rad]
            Where the wind comes from, clockwise from the bow.
        speeds : (...) [m/s]

        Returns
        -------
        (..., 3) [N, N, N m]
        """
        return self.dynamic_factor * self.wind.load(outline, bearings, speeds)

    def current_load(self, outline: Outline, bearings: ArrayLike) -> NDArray[np.float64]:
        """Compute the wrench of the current on the object.

        Parameters
        ----------
        outline : Outline
        bearings : (...) [rad]
            Where the wind comes from, clockwise from the bow: the current comes from there
            too, unless it has a bearing of its own.

        Returns
        -------
        (..., 3) [N, N, N m]
        """
        check_outline(outline)
        wind = numbers_in(bearings, "bearings", BEARING)
        current = self.current
        if current is None:
            return np.zeros((*wind.shape, 3))
        own = wind if current.bearing is None else np.full_like(wind, current.bearing)
        return self.dynamic_factor * current.load(outline, own, current.speed)

    def wave_load(
        self, outline: Outline, bearings: ArrayLike, speeds: ArrayLike
    ) -> NDArray[np.float64]:
        """Compute the wrench of the mean wave drift on the object, in winds.

        Parameters
        ----------
        outline : Outline
        bearings : (...) [rad]
            Where the wind comes from, clockwise from the bow: the waves come from there too, unless
            they have a bearing of their own.
        speeds : (...) [m/s]
            Of the wind; they play no part where the sea does not go with it.

        Returns
        -------
        (..., 3) [N, N, N m]

        Raises
        ------
        EnvironmentInvalid
            If the sea goes with the wind, and the wind is stronger than those whose sea is known.
        """
        check_outline(outline)
        winds, bearing = np.broadcast_arrays(
            numbers_in(speeds, "speeds", SPEED), numbers_in(bearings, "bearings", BEARING)
        )
        waves = self.waves
        if waves is None:
            return np.zeros((*winds.shape, 3))
        own = bearing if waves.bearing is None else np.full_like(bearing, waves.bearing)
        if waves.height is None or waves.period is None:
            heights, periods = sea_of(winds)
        else:
            heights, periods = (np.full_like(winds, one) for one in (waves.height, waves.period))
        return self.dynamic_factor * waves.load(outline, own, heights, periods)

    def load_in(
        self, outline: Outline, bearings: ArrayLike, speeds: ArrayLike
    ) -> NDArray[np.float64]:
        """Compute the wrench of everything in winds: of them, of the current and of the waves.

        Parameters
        ----------
        outline : Outline
        bearings : (...) [rad]
            Where the wind comes from, clockwise from the bow.
        speeds : (...) [m/s]
            Of the wind.

        Returns
        -------
        (..., 3) [N, N, N m]
        """
        wind = self.wind_load(outline, bearings, speeds)
        waves = self.wave_load(outline, bearings, speeds)
        return wind + waves + self.current_load(outline, bearings)

    def load(self, outline: Outline) -> NDArray[np.float64]:
        """Compute the steady load: the wrench of the wind that is given, of current and waves.

        It is the `load` of `quality` and `place`.

        Parameters
        ----------
        outline : Outline

        Returns
        -------
        (3,) [N, N, N m]

        Raises
        ------
        EnvironmentInvalid
            If the wind has no speed and bearing.
        """
        if self.wind.speed is None or self.wind.bearing is None:
            raise EnvironmentInvalid("the wind has no speed and bearing; a steady load needs both")
        return self.load_in(outline, self.wind.bearing, self.wind.speed)
