"""Wind and current as they come and go: what a run has for weather."""

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.environment.limits import BEARING, SPEED
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import array_of, shown

Gusts = Literal["none", "npd"]


@dataclass(frozen=True, eq=False)
class Series(Frozen, Plain):
    """A mean wind in time, as measured; straight lines between, and constant beyond the ends.

    Attributes
    ----------
    times : (k,) [s]
        Increasing.
    speeds : (k,) [m/s]
    bearings : (k,) [rad]
        Where it comes from, clockwise from the bow at the start. Between two of them the wind turns
        through the angles between, not the shorter way.

    Raises
    ------
    SimulationInvalid
        If these are no numbers of one length in their ranges; all faults at once.
    """

    times: NDArray[np.float64]
    speeds: NDArray[np.float64]
    bearings: NDArray[np.float64]

    def __post_init__(self) -> None:
        """Check the values."""
        faults, found = [], {}
        for name in ("times", "speeds", "bearings"):
            array = array_of(getattr(self, name))
            if array is None or array.ndim != 1 or not len(array) or not np.isfinite(array).all():
                given = shown(getattr(self, name))
                faults.append(f"the {name} are {given}; they should be finite numbers (k,)")
            else:
                found[name] = array
        lengths = {name: len(array) for name, array in found.items()}
        if len(set(lengths.values())) > 1:
            faults.append(f"of a series there are {lengths}; there should be as many of each")
        if "times" in found and not (np.diff(found["times"]) > 0.0).all():
            faults.append("the times of a series should increase")
        for name, known in (("speeds", SPEED), ("bearings", BEARING)):
            ends = (found[name].min(), found[name].max()) if name in found else ()
            faults += dict.fromkeys(f for end in ends for f in known.faults(name[:-1], float(end)))
        if faults:
            raise SimulationInvalid(f"weather: {fault}" for fault in faults)
        vars(self).update(found)
        self._freeze()


@dataclass(frozen=True, eq=False)
class Weather(Frozen, Plain):
    """How wind comes and goes about its mean, which the environment gives.

    Attributes
    ----------
    gusts : {"none", "npd"}
        Of the wind's speed along its mean: none, or those of the spectrum of the Norwegian
        Petroleum Directorate, 10 m above the sea (NORSOK N-003, DNV-RP-C205).
    series : Series, optional
        Of the mean wind, instead of the environment's.

    Raises
    ------
    SimulationInvalid
        If a value is not what it should be; all faults at once.
    """

    gusts: Gusts = "none"
    series: Series | None = None

    def __post_init__(self) -> None:
        """Check the values."""
        faults = []
        if self.gusts not in get_args(Gusts):
            known = " or ".join(map(repr, get_args(Gusts)))
            faults.append(f"the gusts are {shown(self.gusts)}; they should be {known}")
        if self.series is not None and not isinstance(self.series, Series):
            faults.append(f"the series is {shown(self.series)}; make one with Series(...)")
        if faults:
            raise SimulationInvalid(f"weather: {fault}" for fault in faults)
