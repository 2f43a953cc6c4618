"""The largest wind that simulated robots hold, at every bearing, beside what statics says."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.capability import capability
from swarmgrasp.environment import Environment
from swarmgrasp.environment.limits import BEARING
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Told
from swarmgrasp.ranges import array_of, call_faults, items, kind_faults, number, shown
from swarmgrasp.simulation.plant import MOST_STEPS
from swarmgrasp.simulation.simulate import Course, RunProgress
from swarmgrasp.simulation.simulation import Simulation, seed_faults
from swarmgrasp.simulation.station import StationKeeping
from swarmgrasp.simulation.verdict import TURN_WITHIN, USUAL, USUAL_TURN, WITHIN
from swarmgrasp.simulation.weather import Mean, Weather, mean_of

Array = NDArray[np.float64]
BEARINGS_APART = math.radians(15.0)
"""Between the bearings looked at by default [rad]."""
TRIED = 8
"""Winds tried at once between the largest known to be held and the least known not to be."""
SPAN = (0.4, 1.3)
"""Winds tried at first, of what statics says."""
SAME = 1e-9
"""Part of a wind that is none."""
TOGETHER = 1000
"""Runs in one batch."""


@dataclass(frozen=True, eq=False)
class Limits(Frozen, Told):
    """The largest winds held, at every bearing.

    Attributes
    ----------
    simulation : Simulation
        Its events and its wind play no part.
    bearings : (m,) [rad]
        Where the wind comes from, clockwise from the bow.
    static : (m,) [m/s]
        By `capability`, without the dynamic factor.
    steady : (m,) [m/s]
        In a steady wind, with sensors that tell the truth.
    gusty : (seeds, m) [m/s]
        The mean wind in the simulation's own weather with its own sensors, for each seed.
    seeds : tuple of int
    within : float [m]
    within_turn : float [rad]
        Beyond them the object is not held.
    gap : float
        Of a limit, within which the simulated ones are found.
    """

    simulation: Simulation
    bearings: Array
    static: Array
    steady: Array
    gusty: Array
    seeds: tuple[int, ...]
    within: float
    within_turn: float
    gap: float

    def exceeds(self, speeds: Array) -> NDArray[np.bool_]:
        """Tell which limits (..., m) [m/s] are larger than told: every wind tried was held.

        The run is then too short to tell, or the object yields into a smaller load.
        """
        return np.asarray((speeds >= (1.0 - SAME) * SPAN[1] * self.static) & (self.static > 0.0))


def limits(
    simulation: Simulation,
    bearings: ArrayLike | None = None,
    *,
    seeds: Sequence[int] | None = None,
    within: float = USUAL,
    within_turn: float = USUAL_TURN,
    gap: float = 0.002,
    progress: RunProgress = None,
) -> Limits:
    """Find the largest wind that simulated robots hold the object against, at every bearing.

    A wind is held if the object stays where it is to be for the simulation's duration. Again and
    again some winds between one that is held and one that is not are tried at once, at all
    bearings. It is taken for granted that no wind is held that is stronger than one that is not.

    A short run flatters: what is a little too much has not yet moved a heavy object. No wind is
    tried beyond 1.3 times the one that statics allows. A current without a bearing of its own comes
    with the wind.

    Parameters
    ----------
    simulation : Simulation
    bearings : (m,) [rad], optional
        Every 15 degrees when left out.
    seeds : sequence of int, optional
        Of gusts and noise; the simulation's own when left out. With none only steady winds are
        tried.
    within : float [m]
    within_turn : float [rad]
        How far the object may be from where it is to be, and still be held.
    gap : float
        Of a limit, within which the simulated ones are found; within [1e-6, 0.5].
    progress : callable, optional
        Called with the part that is done, within [0, 1], now and then.

    Returns
    -------
    Limits

    Raises
    ------
    SimulationInvalid
        If something is not what it should be; all faults at once.
    """
    wanted = array_of(
        np.arange(0.0, math.tau - 1e-9, BEARINGS_APART) if bearings is None else bearings
    )
    faults = kind_faults(simulation, Simulation, "Simulation(problem, environment, hull)")
    if wanted is None or wanted.ndim != 1 or not len(wanted):
        faults.append(f"the bearings are {shown(bearings)}; they should be numbers (m,) [rad]")
        wanted = np.zeros(1)
    faults += [fault for b in wanted.tolist() for fault in BEARING.faults("bearing", b)]
    given = () if seeds is None else items(seeds)
    if given is None:
        faults.append(f"the seeds are {shown(seeds)}; they should be numbers in a row")
    faults += [fault for seed in given or () for fault in seed_faults(seed)]
    faults += WITHIN.faults("distance within", within)
    faults += TURN_WITHIN.faults("turn within", within_turn)
    if not 1e-6 <= number(gap) <= 0.5:
        faults.append(f"the gap is {shown(gap)}; it should be 1e-6 <= gap <= 0.5")
    faults += call_faults(progress)
    if faults:
        raise SimulationInvalid(faults)
    chosen = (simulation.seed,) if seeds is None else tuple(map(int, given or ()))
    return _Trials(simulation, wanted, chosen, within, within_turn, gap, progress).limits()


class _Trials:
    """Winds tried at all bearings at once."""

    def __init__(
        self, simulation: Simulation, bearings: Array, seeds: tuple[int, ...], within: float,
        within_turn: float, gap: float, progress: RunProgress,
    ) -> None:  # fmt: skip
        self._bearings, self._seeds = bearings, seeds
        self._within, self._within_turn, self._gap = within, within_turn, gap
        first = (SPAN[1] - SPAN[0]) / (TRIED - 1)
        self._rounds = 1 + max(0, math.ceil(math.log(first / gap) / math.log(TRIED + 1)))
        self._batches = [
            self._rounds * math.ceil(TRIED * len(bearings) * count / TOGETHER)
            for count in (1, len(seeds))
        ]
        self._progress, self._done = progress, 0
        environment = simulation.environment
        still = replace(environment.wind, speed=0.0, bearing=0.0)  # winds are said run by run
        self._told = simulation
        self._simulation = replace(
            simulation, events=(), weather=replace(simulation.weather, series=None),
            environment=replace(environment, wind=still, dynamic_factor=1.0),
        )  # fmt: skip

    def limits(self) -> Limits:
        """Return what is found."""
        gusty = self._simulation
        control = replace(gusty.control, position_noise=0.0, heading_noise=0.0)
        steady = replace(gusty, weather=Weather(), control=control)
        static = capability(gusty.problem.swarm, gusty.environment, self._bearings).intact
        return Limits(
            self._told, self._bearings, static, self._largest(steady, static, (0,))[0],
            self._largest(gusty, static, self._seeds), self._seeds, float(self._within),
            float(self._within_turn), float(self._gap),
        )  # fmt: skip

    def _largest(self, simulation: Simulation, static: Array, seeds: tuple[int, ...]) -> Array:
        """Return the largest winds (seeds, m) that are held."""
        shape = (len(seeds), len(self._bearings))
        low, high = np.zeros(shape), np.full(shape, SPAN[1])
        parts = np.linspace(*SPAN, TRIED)[:, None, None] * np.ones(shape)
        for _ in range(self._rounds):
            held = self._are_held(simulation, parts * static, seeds)
            count = np.minimum.accumulate(held, axis=0).sum(axis=0)  # up to the first that is not
            ends = np.concatenate([low[None], parts, high[None]])
            low, high = (np.take_along_axis(ends, k[None], axis=0)[0] for k in (count, count + 1))
            step = (high - low) / (TRIED + 1)
            parts = low + np.arange(1, TRIED + 1)[:, None, None] * step
        return np.asarray(low * static)

    def _are_held(
        self, simulation: Simulation, winds: Array, seeds: tuple[int, ...]
    ) -> NDArray[np.bool_]:
        """Tell which mean winds (k, seeds, m) [m/s] are held."""
        each = np.broadcast_to(np.array(seeds)[:, None], winds.shape).ravel().tolist()
        bearings = np.broadcast_to(self._bearings, winds.shape).ravel()
        speeds = winds.ravel()
        held: list[bool] = []
        for first in range(0, winds.size, TOGETHER):
            rows = slice(first, first + TOGETHER)
            mean = _mean_at(simulation.environment, speeds[rows], bearings[rows])
            course = Course(simulation, tuple(each[rows]), mean, StationKeeping(), MOST_STEPS)
            run = course.run(self._tell)
            if not run.is_whole:
                raise KeyboardInterrupt
            self._done += 1
            is_near = run.distances.max(axis=1) <= self._within
            held += (is_near & (run.turns.max(axis=1) <= self._within_turn)).tolist()
        return np.array(held, dtype=bool).reshape(winds.shape)

    def _tell(self, part: float) -> None:
        """Tell what part of all is done, when a part of one batch is."""
        if self._progress is not None:
            self._progress((self._done + part) / sum(self._batches))


def _mean_at(environment: Environment, speeds: Array, bearings: Array) -> Mean:
    """Return the mean weather of winds (runs,); a current without a bearing comes with them."""
    mean, current = mean_of(environment), environment.current
    if current is not None and current.bearing is None:
        mean = mean._replace(current_bearing=bearings)
    return mean._replace(wind_speed=speeds, wind_bearing=bearings)
