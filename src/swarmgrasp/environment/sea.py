"""The sea that goes with a wind, and the steps of weather by which capabilities are numbered."""

from typing import Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment.geometry import numbers_in
from swarmgrasp.environment.limits import Range
from swarmgrasp.ranges import number, shown


class Step(NamedTuple):
    """One step of weather: a wind, the sea it raises, and a current, all from one bearing.

    Attributes
    ----------
    wind : float [m/s]
        The mean 10 m above the sea.
    height : float [m]
        Significant height of the waves.
    period : float [s]
        Peak period of their spectrum.
    current : float [m/s]
    """

    wind: float
    height: float
    period: float
    current: float


STEPS: Final = (
    Step(0.0, 0.0, 3.5, 0.0),
    Step(1.5, 0.1, 3.5, 0.25),
    Step(3.4, 0.4, 4.5, 0.50),
    Step(5.4, 0.8, 5.5, 0.75),
    Step(7.9, 1.3, 6.5, 0.75),
    Step(10.7, 2.1, 7.5, 0.75),
    Step(13.8, 3.1, 8.5, 0.75),
    Step(17.1, 4.2, 9.0, 0.75),
    Step(20.7, 5.7, 10.0, 0.75),
    Step(24.4, 7.4, 10.5, 0.75),
    Step(28.4, 9.5, 11.5, 0.75),
    Step(32.6, 12.1, 12.0, 0.75),
)
"""From 0 to 11, by the Beaufort number of the wind: the environmental conditions of the DP
capability numbers of DNV-ST-0111, *Assessment of station keeping capability of dynamic positioning
vessels* (2021). A calm has no waves, and in the table no period; it is given that of the next step
here. Each wind is the strongest of its Beaufort number, but for step 2: the standard has 3.4 m/s,
which by the scale is the lightest of Beaufort 3."""

STRONGEST_SEA: Final = STEPS[-1].wind
"""The strongest wind [m/s] whose sea the table tells."""

_KNOWN = Range(0.0, STRONGEST_SEA, "m/s")


def sea_faults(name: str, speed: object) -> list[str]:
    """Return what is wrong with a wind [m/s] that its sea is to go with.

    Examples
    --------
    >>> sea_faults("speed", 40.0)
    ['the speed is 40.0; the sea that goes with a wind is known for 0 <= speed <= 32.6 [m/s]: give \
the waves a height and a period']
    """
    if _KNOWN.low <= number(speed) <= _KNOWN.high:
        return []
    return [
        f"the {name} is {shown(speed)}; the sea that goes with a wind is known for "
        f"{_KNOWN.low:g} <= speed <= {_KNOWN.high:g} [{_KNOWN.unit}]: give the waves a height and "
        "a period"
    ]


def sea_of(winds: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the sea that goes with winds, on straight lines between the `STEPS`.

    Parameters
    ----------
    winds : (...) [m/s]
        Up to the strongest of the table.

    Returns
    -------
    heights : (...) [m]
        Significant heights of the waves.
    periods : (...) [s]
        Peak periods.

    Raises
    ------
    EnvironmentInvalid
        If a wind is stronger.

    Examples
    --------
    >>> height, period = sea_of(9.3)
    >>> round(float(height), 9), float(period)
    (1.7, 7.0)
    """
    speeds = numbers_in(winds, "winds that a sea goes with", _KNOWN)
    known, heights, periods, _ = np.array(STEPS).T
    return np.interp(speeds, known, heights), np.interp(speeds, known, periods)
