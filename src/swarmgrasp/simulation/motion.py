"""How an object moves: what the kernel is told of it, and its doors."""

import math
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment import Current, Wind
from swarmgrasp.kernels import motion
from swarmgrasp.outline import Outline
from swarmgrasp.simulation.actuator import Actuator
from swarmgrasp.simulation.hull import Hull, inverse_of
from swarmgrasp.swarm import Swarm

Array = NDArray[np.float64]

BODY: Final = 6
"""Numbers of a state before those of the robots: x, y, psi, u, v, r."""
STREAM: Final = 4
"""Numbers of a stream: velocities x, y of air and x, y of water, in the earth's frame [m/s]."""
AT_ONCE: Final = 1e300
"""A rate [N/s, rad/s] that is no bound."""
FIXED, SECTOR, AROUND, FREE = range(4)
"""How a robot's angle follows orders, as `motion.h` counts."""


def flow(speeds: ArrayLike, bearings: ArrayLike) -> Array:
    """Return the velocity of a wind or a current.

    Parameters
    ----------
    speeds : (...) [m/s]
    bearings : (...) [rad]
        Where it comes from, clockwise from the bow of an object at heading 0.

    Returns
    -------
    (..., 2) [m/s]
        In the earth's frame: x forward and y to port of that object.

    Examples
    --------
    From ahead it goes astern, from starboard to port:

    >>> flow(2.0, [0.0, math.pi / 2]).round(9).tolist()
    [[-2.0, 0.0], [-0.0, 2.0]]
    """
    speed, bearing = np.broadcast_arrays(np.asarray(speeds, float), np.asarray(bearings, float))
    return np.stack([-speed * np.cos(bearing), speed * np.sin(bearing)], axis=-1)


def following_of(swarm: Swarm) -> NDArray[np.intp]:
    """Return how each robot's angle follows orders (n,): `FIXED`, `SECTOR`, `AROUND` or `FREE`."""
    one_way = (swarm.reverse_limits == 0.0) & (swarm.frictions == 0.0)
    found = np.where(one_way, np.where(swarm.steers < math.pi, SECTOR, AROUND), FREE)
    found[swarm.is_line] = FIXED
    found[list(swarm.rare.envelopes)] = FREE
    found[[*swarm.rare.gaps, *swarm.rare.hulls]] = AROUND
    return found.astype(np.intp)


def afloat_row(hull: Hull, outline: Outline, wind: Wind, current: Current) -> Array:
    """Return what the kernel is told of an object, (38,), as `Afloat` in `motion.h`."""
    corners = outline.vertices - outline.origin
    low, high = corners.min(axis=0), corners.max(axis=0)
    along = 0.5 * current.density
    shape, drag = wind.coefficients, current.coefficients
    return np.array([
        *inverse_of(hull.matrix).ravel(), hull.mass, *hull.centre, *hull.added[:2], *hull.added_at,
        *np.ravel(hull.damping), high[0] - low[0], *0.5 * (low + high),
        0.5 * wind.density, wind.frontal_area, wind.lateral_area * shape.transverse,
        shape.bow, shape.stern, shape.cross_force, wind.lateral_centroid,
        along * current.frontal_area * drag.surge, along * current.lateral_area * drag.sway,
        current.lateral_centroid,
    ])  # fmt: skip


def driver_rows(swarm: Swarm, actuators: tuple[Actuator, ...], headings: Array) -> Array:
    """Return what the kernel is told of robots, (n, 11), as `Driver` in `motion.h`."""
    rows = np.zeros((len(swarm), 11))
    rows[:, :2] = swarm.contacts - swarm.outline.origin
    for row, limit, actuator in zip(rows, swarm.limits.tolist(), actuators, strict=True):
        rate = limit / actuator.slew if actuator.slew > 0.0 else AT_ONCE
        row[2:5] = actuator.efficiency, actuator.lag, rate
        row[5:7] = actuator.turn_lag, actuator.turn_rate
        row[8] = actuator.follows == "earth"
    rows[:, 7] = following_of(swarm)
    rows[:, 9], rows[:, 10] = np.cos(headings), np.sin(headings)
    return rows


def advanced(
    afloat: Array, drivers: Array, states: Array, streams: Array, orders: Array, loads: Array,
    step: float, steps: int,
) -> Array:  # fmt: skip
    """Return states (runs, 6 + 2 n) some steps on."""
    found = motion.advance(afloat, drivers, states, streams, orders, loads, step, steps)
    return np.frombuffer(bytearray(found)).reshape(states.shape)


def exerted(afloat: Array, drivers: Array, states: Array, streams: Array) -> Array:
    """Return the wrenches (runs, 3, 3) [N, N, N m] of robots, wind and water on the object."""
    found = motion.exerted(afloat, drivers, states, streams)
    return np.frombuffer(bytearray(found)).reshape(-1, 3, 3)
