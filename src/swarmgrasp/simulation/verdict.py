"""What a run says: held or not, within what, and whether the numbers foretold it."""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.environment.limits import Range
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.forces import forces
from swarmgrasp.frozen import Frozen
from swarmgrasp.outline import Outline
from swarmgrasp.plain import Told
from swarmgrasp.ranges import kind_faults
from swarmgrasp.simulation.crew import plant_of
from swarmgrasp.simulation.hull import inverse_of
from swarmgrasp.simulation.run import Happening, Run
from swarmgrasp.simulation.schedule import resting
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.simulation.weather import Streams, mean_of

Array = NDArray[np.float64]

WITHIN = Range(1e-9, 1e9, "m")
TURN_WITHIN = Range(1e-9, 2.0 * math.pi, "rad")
USUAL, USUAL_TURN = 5.0, math.radians(5.0)
"""How far [m] and turned [rad] an object may be, and be held, unless told otherwise."""
SMALL = 15.0
"""Into so many parts the extent of a small object goes, of which it may be off by one."""
MOST = 0.95
"""Part of the instants that a watch circle holds beside the largest error."""


@dataclass(frozen=True, eq=False)
class Circle(Frozen, Told):
    """How far the object was from where it was to be, between two happenings.

    Attributes
    ----------
    start, end : float [s]
    distance, turn : (runs,) [m], [rad]
        The largest errors of position and heading.
    usual_distance, usual_turn : (runs,) [m], [rad]
        Those that 95 % of the instants kept stay within.
    """

    start: float
    end: float
    distance: Array
    turn: Array
    usual_distance: Array
    usual_turn: Array


@dataclass(frozen=True, eq=False)
class Verdict(Frozen, Told):
    """What became of the runs.

    Attributes
    ----------
    within : float [m]
    within_turn : float [rad]
        Beyond them the object is not held.
    held : (runs,) of bool
    left_at : (runs,) [s]
        The first instant kept at which it is not; nan where it is held.
    circles : tuple of Circle
        One for each happening, from it to the next one.
    foretold : tuple of float [s]
        For each happening, how long the mean load takes from there to move the object beyond these
        limits, if it starts at rest where it is to be; infinity where the robots hold it.
    spreads : (runs,) [N]
        Standard deviation, in the metric, of the load of the gusts about the mean at the start.
    margins_over_spread : (runs,)
        The margin at the start over that, which foretells whether it is held; infinity without
        gusts.
    largest_share : (runs,)
        Of any robot at any instant kept.
    activity : (runs,) [1/s]
        How much the robots' forces change, of their limits in a second, at the mean of the robots.
    use : (runs,)
        The mean share of the robots.
    least_excess : float
        The smallest excess of the load over what is held, as a part of it, that a run so long can
        tell: one that is smaller has not yet moved the object beyond the limits.
    """

    within: float
    within_turn: float
    held: NDArray[np.bool_]
    left_at: Array
    circles: tuple[Circle, ...]
    foretold: tuple[float, ...]
    spreads: Array
    margins_over_spread: Array
    largest_share: Array
    activity: Array
    use: Array
    least_excess: float


def usual_within(outline: Outline) -> float:
    """Return how far [m] an object may be from where it is to be, unless told otherwise.

    Examples
    --------
    >>> usual_within(Outline([(0, 0), (200, 0), (200, 30)]))
    5.0
    >>> round(usual_within(Outline([(0, 0), (3, 0), (3, 0.1)])), 3)
    0.2
    """
    return min(USUAL, outline.extent / SMALL)


def verdict_of(run: Run, within: float = USUAL, within_turn: float = USUAL_TURN) -> Verdict:
    """Tell what a run says.

    Parameters
    ----------
    run : Run
    within : float [m]
    within_turn : float [rad]
        How far the object may be from where it is to be, and still be held.

    Returns
    -------
    Verdict

    Raises
    ------
    SimulationInvalid
        If something is not what it should be; all faults at once.
    """
    faults = kind_faults(run, Run, "simulate(simulation)")
    faults += WITHIN.faults("distance within", within)
    faults += TURN_WITHIN.faults("turn within", within_turn)
    if faults:
        raise SimulationInvalid(faults)
    beyond = (run.distances > within) | (run.turns > within_turn)
    held = np.asarray(~beyond.any(axis=1))
    left_at = np.where(held, np.nan, run.times[beyond.argmax(axis=1)])
    spreads = _spreads(run)
    margin = run.happenings[0].margin
    over = np.divide(margin, spreads, out=np.full(len(run), np.inf), where=spreads > 0.0)
    shares = run.shares.astype(float)
    limits = np.array([_limit_of(run, name) for name in run.names])
    span = max(float(run.times[-1] - run.times[0]), 1e-300)
    steps = np.abs(np.diff(run.forces.astype(float), axis=1)) / limits
    return Verdict(
        float(within),
        float(within_turn),
        held,
        left_at,
        _circles(run),
        tuple(time_to_leave(run, at, within, within_turn) for at in run.happenings),
        spreads,
        over,
        shares.max(axis=(1, 2), initial=0.0),
        steps.sum(axis=1).mean(axis=1) / span if len(limits) else np.zeros(len(run)),
        shares.mean(axis=(1, 2)) if len(limits) else np.zeros(len(run)),
        _least_excess(run, within, within_turn),
    )


def time_to_leave(run: Run, at: Happening, within: float, within_turn: float) -> float:
    """Return how long [s] the mean load takes after a happening to move the object beyond limits.

    What is missing of the wrench that would hold it, over the mass, is its acceleration.

    Parameters
    ----------
    run : Run
    at : Happening
    within : float [m]
    within_turn : float [rad]

    Returns
    -------
    float
        Infinity if the robots hold the load.
    """
    missing = forces(at.swarm, np.zeros(3), load=at.load)
    if not missing.is_degraded:
        return math.inf
    x, y, turn = _acceleration(run, at, missing.missing)
    times = (
        math.sqrt(2.0 * limit / rate) if rate > 0.0 else math.inf
        for limit, rate in ((within, math.hypot(x, y)), (within_turn, abs(turn)))
    )
    return min(times)


def _acceleration(run: Run, at: Happening, wrench: Array) -> tuple[float, float, float]:
    """Return the acceleration (3,) [m/s^2, m/s^2, rad/s^2] that a wrench then gives the object."""
    x, y, turn = (inverse_of(plant_of(run.simulation, at.swarm).matrix) @ wrench).tolist()
    return x, y, turn


def _least_excess(run: Run, within: float, within_turn: float) -> float:
    """Return the least part of the mean load whose push moves the object beyond limits in time."""
    start, end = run.happenings[0], float(run.times[-1])
    if not start.load.any() or end <= 0.0:
        return math.inf
    x, y, turn = _acceleration(run, start, start.load)
    moved = 0.5 * end * end
    parts = (
        limit / (rate * moved) if rate > 0.0 else math.inf
        for limit, rate in ((within, math.hypot(x, y)), (within_turn, abs(turn)))
    )
    return min(parts)


def _circles(run: Run) -> tuple[Circle, ...]:
    """Return how far the object was from where it was to be, between happenings."""
    starts = [at.time for at in run.happenings]
    found = []
    for start, end in zip(starts, [*starts[1:], float(run.times[-1])], strict=True):
        kept = (run.times > start) & (run.times <= end) if start else run.times <= end
        if not kept.any():
            kept = run.times == run.times[np.abs(run.times - start).argmin()]
        distances, turns = run.distances[:, kept], run.turns[:, kept]
        found.append(
            Circle(
                start, end, distances.max(axis=1), turns.max(axis=1),
                np.quantile(distances, MOST, axis=1), np.quantile(turns, MOST, axis=1),
            )
        )  # fmt: skip
    return tuple(found)


def _spreads(run: Run) -> Array:
    """Return the standard deviation (runs,) [N] of the gusts' load: it goes with speed squared."""
    simulation, swarm = run.simulation, run.happenings[0].swarm
    plant, steady = plant_of(simulation, swarm), _steady(simulation)
    load = plant.wind(resting(plant, steady, 0.0), steady)[0] * swarm.scale
    speed = float(np.hypot(steady[0, 0], steady[0, 1]))
    if speed == 0.0:
        return np.zeros(len(run))
    return np.asarray(2.0 * float(np.linalg.norm(load)) / speed * run.gusts)


def _steady(simulation: Simulation) -> Array:
    """Return the mean velocities (1, 4) [m/s] of air and water at the start."""
    calm = replace(simulation.weather, gusts="none")
    return Streams(calm, mean_of(simulation.environment), (0,), 1.0).steady(0.0)


def _limit_of(run: Run, name: str) -> float:
    """Return the limit [N] of a robot that took part."""
    swarm = next((one.swarm for one in reversed(run.stints) if name in one.swarm), None)
    return math.inf if swarm is None else swarm[name].limit
