"""Wind and current as they come and go: what a run has for weather."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.environment import Environment
from swarmgrasp.environment.limits import BEARING, SPEED
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import array_of, shown
from swarmgrasp.simulation.motion import flow

Kind = Literal["none", "npd"]
Array = NDArray[np.float64]

BANDS = (1.0 / 1200.0, 0.5)
"""Of the frequencies of gusts [Hz]: those of a storm, and those that a hull feels."""
WAVES = 80
TOGETHER = 64
"""Runs whose waves are summed at once: they fit into a core's own memory."""
CALM = 1e-3
"""The least mean wind [m/s] that has a spectrum: gusts of a calm are none."""
GUSTS, SENSORS = 0, 1
"""What a run draws from chance, each from a source of its own."""


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

    times: Array
    speeds: Array
    bearings: Array

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

    gusts: Kind = "none"
    series: Series | None = None

    def __post_init__(self) -> None:
        """Check the values."""
        faults = []
        if self.gusts not in get_args(Kind):
            known = " or ".join(map(repr, get_args(Kind)))
            faults.append(f"the gusts are {shown(self.gusts)}; they should be {known}")
        if self.series is not None and not isinstance(self.series, Series):
            faults.append(f"the series is {shown(self.series)}; make one with Series(...)")
        if faults:
            raise SimulationInvalid(f"weather: {fault}" for fault in faults)


class Mean(NamedTuple):
    """The mean weather: a number for all runs, or one for each, (1,) or (runs,)."""

    wind_speed: Array
    """[m/s]"""
    wind_bearing: Array
    """[rad]: where it comes from, clockwise from the bow at the start."""
    current_speed: Array
    current_bearing: Array

    def changed(self, said: Mapping[str, float]) -> "Mean":
        """Return the weather after some of it has changed, by name."""
        return self._replace(**{name: np.array([value]) for name, value in said.items()})


def mean_of(environment: Environment) -> Mean:
    """Return the mean weather that an environment says; a calm where it says none."""
    wind, current = environment.wind, environment.current
    from_wind = wind.bearing or 0.0
    speed, bearing = (0.0, None) if current is None else (current.speed, current.bearing)
    said = (wind.speed or 0.0, from_wind, speed, from_wind if bearing is None else bearing)
    return Mean(*(np.array([number]) for number in said))


class Streams:
    """The air and the water that pass the objects of some runs, instant by instant.

    Parameters
    ----------
    weather : Weather
    mean : Mean
    seeds : sequence of int
        One for each run. What a run has for weather depends on its own alone.
    period : float [s]
        Between two instants.
    """

    def __init__(self, weather: Weather, mean: Mean, seeds: Sequence[int], period: float) -> None:
        self.mean = mean
        self._weather, self._runs, self._period = weather, len(seeds), period
        self._gusts = Gusts(seeds) if weather.gusts == "npd" else None

    def change(self, said: Mapping[str, float]) -> None:
        """Change some of the mean weather, by name."""
        self.mean = self.mean.changed(said)

    def winds(self, times: Array) -> tuple[Array, Array]:
        """Return the mean wind's speeds [m/s] and bearings [rad] at times (m,), (1 or runs, m)."""
        series = self._weather.series
        if series is None:
            shape = (len(self.mean.wind_speed), len(times))
            return (
                np.broadcast_to(self.mean.wind_speed[:, None], shape),
                np.broadcast_to(self.mean.wind_bearing[:, None], shape),
            )
        speeds, bearings = (
            np.interp(times, series.times, row)[None] for row in (series.speeds, series.bearings)
        )
        return speeds, bearings

    def block(self, first: int, count: int) -> Array:
        """Return the velocities of air and water (count, runs, 4) [m/s] from an instant on.

        They are x and y of the air, then x and y of the water, in the earth's frame. Gusts have the
        spectrum of the mean wind at the first of these instants.
        """
        speeds, bearings = self.winds(np.arange(first, first + count, dtype=float) * self._period)
        found = np.empty((count, self._runs, 4))
        if self._gusts is not None:
            speeds = speeds + self._gusts.speeds(first, count, self._period, speeds[:, 0])
        found[..., :2] = flow(speeds, bearings).swapaxes(0, 1)
        found[..., 2:] = flow(self.mean.current_speed, self.mean.current_bearing)
        return found

    def steady(self, time: float) -> Array:
        """Return the mean velocities (1 or runs, 4) [m/s] at a time [s], as `block` has them."""
        speeds, bearings = self.winds(np.array([time]))
        air = flow(speeds[:, 0], bearings[:, 0])
        water = flow(self.mean.current_speed, self.mean.current_bearing)
        return np.concatenate(np.broadcast_arrays(air, water), axis=-1)

    def spread(self, time: float) -> Array:
        """Return the standard deviation (runs,) [m/s] of the wind's speed about its mean."""
        if self._gusts is None:
            return np.zeros(self._runs)
        speeds, _ = self.winds(np.array([time]))
        return self._gusts.spread(speeds[:, 0])


class Gusts:
    """Sums of waves of wind with random phases, of the spectrum that `npd_spectrum` gives.

    The waves' frequencies are drawn from 80 bands, equal in the logarithm, of 1/1200 to 0.5 Hz.
    """

    def __init__(self, seeds: Sequence[int]) -> None:
        edges = np.geomspace(*BANDS, WAVES + 1)
        draws = np.array([generator_of(seed, GUSTS).random((2, WAVES)) for seed in seeds])
        self._frequencies = edges[:-1] + draws[:, 0] * np.diff(edges)
        self._phases = 2.0 * math.pi * draws[:, 1]
        self._widths = np.diff(edges)

    def _sizes(self, mean: Array) -> Array:
        """Return the amplitudes (runs, 80) [m/s] of the waves in mean winds (1 or runs,)."""
        density = npd_spectrum(self._frequencies, mean[:, None])
        return np.asarray(np.sqrt(2.0 * self._widths * density))

    def spread(self, mean: Array) -> Array:
        """Return the standard deviation (runs,) [m/s] in mean winds (1 or runs,) [m/s]."""
        return np.asarray(np.sqrt(0.5 * np.sum(self._sizes(mean) ** 2, axis=1)))

    def speeds(self, first: int, count: int, period: float, mean: Array) -> Array:
        """Return what gusts add to mean winds (1 or runs,) [m/s], (runs, count) [m/s]."""
        turn = 2.0 * math.pi * self._frequencies * period
        start, sizes = self._phases + turn * first, self._sizes(mean)
        waves = sizes * np.cos(start), sizes * np.cos(start - turn), 2.0 * np.cos(turn)
        found = np.empty((len(turn), count))
        for row in range(0, len(turn), TOGETHER):
            now, before, twice = (part[row : row + TOGETHER] for part in waves)
            after = np.empty_like(now)
            for k in range(count):  # cos(a + t) = 2 cos(t) cos(a) - cos(a - t): no cosine for each
                np.sum(now, axis=1, out=found[row : row + TOGETHER, k])
                np.multiply(twice, now, out=after)
                after -= before
                before, now, after = now, after, before
        return found


def npd_spectrum(frequencies: Array, mean: Array) -> Array:
    """Return the power density [m^2/s] of gusts 10 m above the sea.

    The spectrum of the Norwegian Petroleum Directorate (NORSOK N-003, DNV-RP-C205), at 10 m:
    ``S = 320 (U / 10)^2 (1 + x^0.468)^(-5 / (3 * 0.468))``, ``x = 172 f (U / 10)^(-3/4)``.

    Parameters
    ----------
    frequencies : (...) [Hz]
    mean : (...) [m/s]
        U, the mean wind over an hour.
    """
    strength = np.maximum(mean, CALM) / 10.0
    x = 172.0 * frequencies * strength**-0.75
    return np.asarray(320.0 * strength**2 * (1.0 + x**0.468) ** (-5.0 / (3.0 * 0.468)))


def generator_of(seed: int, what: int) -> np.random.Generator:
    """Return the source of chance of one run for one thing, such as `GUSTS`."""
    return np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(what,)))
