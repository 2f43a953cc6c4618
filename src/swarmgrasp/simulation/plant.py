"""An object in wind and water, pushed by robots: what moves, and how."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment import Current, Environment, Wind
from swarmgrasp.environment.limits import BEARING, Range
from swarmgrasp.errors import SimulationInvalid, SwarmInvalid, refuse
from swarmgrasp.frozen import Frozen, read_only
from swarmgrasp.ranges import is_whole, kind_faults, nearest_name, shown
from swarmgrasp.simulation.actuator import Actuator
from swarmgrasp.simulation.hull import Hull
from swarmgrasp.simulation.motion import (
    BODY,
    FIXED,
    SECTOR,
    STREAM,
    advanced,
    afloat_row,
    driver_rows,
    exerted,
    following_of,
)
from swarmgrasp.swarm import Swarm

Array = NDArray[np.float64]

STEP = Range(1e-9, 1e6, "s")
MOST_STEPS = 10**9
"""That one call takes."""
MOST_ROWS = 10**6


@dataclass(frozen=True, eq=False)
class Plant(Frozen):
    """An object in wind and water, pushed by robots that answer to orders.

    Its state is a row of 6 + 2 n numbers: the pose x, y [m], psi [rad] of the outline's origin in
    the earth's frame, which is the object's at pose 0; its velocity u, v [m/s], r [rad/s] relative
    to the water, in the object's frame; the forces [N] of the n robots, each along its angle and
    negative the other way; and these angles [rad], in the object's frame. Runs are rows: what
    becomes of one does not depend on the others, to the last bit.

    A robot that pushes along a line keeps its angle. One that steers turns within its sector, an
    azimuth thruster the shorter way around, and so does one with gaps between its sectors. Of the
    others, fingers with friction, envelopes and robots that both steer and reverse, the force goes
    straight from the one there is to the one ordered, and stays in its convex set.

    The loads are those of the environment's wind and current at rest, without its dynamic factor,
    which allows for what is simulated here.

    Parameters
    ----------
    swarm : Swarm
    hull : Hull
        Of the object alone: the masses of the robots' actuators are added here.
    environment : Environment
        With a current, of any speed: its areas tell the drag of the water. Winds and currents that
        blow are in the streams.
    actuator : Actuator
        Of all robots that have none of their own.
    actuators : mapping of str to Actuator
        By robots' names.
    headings : mapping of str to float [rad]
        By the names of robots whose force follows the earth: the heading at which each was made
        fast, and at which its angle in the object's frame is what its direction says; 0 by default.

    Raises
    ------
    SwarmInvalid, SimulationInvalid
        If something is not of its kind, a name is of no robot, or there is no current; all faults
        at once.

    Examples
    --------
    A barge of 80 m is pushed ahead for a minute, in still air and water:

    >>> from swarmgrasp import Outline, Robot, Wind, WindCoefficients
    >>> barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    >>> wind = Wind(150.0, 500.0, WindCoefficients(transverse=0.9, bow=0.7, stern=0.7))
    >>> sea = Environment(wind, Current(50.0, 200.0))
    >>> swarm = Swarm(barge, [Robot((-40, 0), 0.0, 300e3, "Ajax")])
    >>> plant = Plant(swarm, Hull.afloat(barge, sea), sea)
    >>> state, still = plant.rest(), np.zeros((1, 4))
    >>> orders = plant.orders(np.array([[[300e3, 0.0]]]))
    >>> plant.advance(state, orders, still, None, 0.1, 600)[0].round(2).tolist()
    [95.13, 0.0, 0.0, 3.46, 0.0, 0.0, 299997.49, 0.0]
    """

    swarm: Swarm
    hull: Hull
    environment: Environment
    actuator: Actuator = field(default_factory=Actuator)
    actuators: Mapping[str, Actuator] = field(default_factory=dict)
    headings: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Check the values."""
        swarm = kind_faults(self.swarm, Swarm, "Swarm(outline, robots)")
        faults = kind_faults(self.hull, Hull, "Hull.afloat(outline, draught=...)")
        faults += self._environment_faults()
        faults += kind_faults(self.actuator, Actuator, "Actuator()")
        for called, given in (("actuator", self.actuators), ("heading", self.headings)):
            if not isinstance(given, Mapping):
                faults.append(f"the {called}s are {shown(given)}; they should be by robots' names")
            elif not swarm:
                faults += [
                    f"there is no robot called {shown(name)} to have this {called}"
                    f"{nearest_name(str(name), [*self.swarm.names][:1000])}"
                    for name in given
                    if name not in self.swarm
                ]
        if isinstance(self.actuators, Mapping):
            for one in self.actuators.values():
                faults += kind_faults(one, Actuator, "Actuator()")
        if isinstance(self.headings, Mapping):
            for heading in self.headings.values():
                faults += BEARING.faults("heading", heading)
        refuse((SwarmInvalid, swarm), (SimulationInvalid, faults))
        vars(self).update(actuators=dict(self.actuators), headings=dict(self.headings))
        self._freeze()

    def _environment_faults(self) -> list[str]:
        """Return what is missing of the environment."""
        faults = kind_faults(self.environment, Environment, "Environment(wind, current)")
        if faults:
            return faults
        if self.environment.current is None:
            faults.append(
                "the environment has no current, and so nothing tells the drag of the water; give "
                "it Current(frontal_area, lateral_area), beam and length times draught: the speed "
                "may be 0"
            )
        if self.environment.waves is not None:
            faults.append(
                "the environment has waves, and a run in time has none; leave them out of it"
            )
        return faults

    def __len__(self) -> int:
        """Return the number of robots."""
        return len(self.swarm)

    @cached_property
    def whole(self) -> Hull:
        """The hull with the masses of all robots that are attached."""
        masses = [one.mass for one in self.each_actuator]
        if not any(masses):
            return self.hull
        return self.hull.with_robots(masses, self.swarm.contacts - self.swarm.outline.origin)

    @property
    def matrix(self) -> Array:
        """(3, 3) [kg, kg m, kg m^2]: all that is moved, robots and water too, about the origin."""
        return self.whole.matrix

    @cached_property
    def each_actuator(self) -> tuple[Actuator, ...]:
        """The actuators, one for each robot, in the swarm's order."""
        return tuple(self.actuators.get(name, self.actuator) for name in self.swarm.names)

    @cached_property
    def _afloat(self) -> Array:
        """What the kernel is told of the object."""
        wind, current = self.environment.wind, self.environment.current
        assert isinstance(current, Current)
        assert isinstance(wind, Wind)
        return read_only(afloat_row(self.whole, self.swarm.outline, wind, current))

    @cached_property
    def _drivers(self) -> Array:
        """What the kernel is told of the robots."""
        headings = [self.headings.get(name, 0.0) for name in self.swarm.names]
        return read_only(driver_rows(self.swarm, self.each_actuator, np.array(headings)))

    def rest(self, runs: int = 1, streams: ArrayLike | None = None) -> Array:
        """Return states at pose 0, at rest, with idle robots.

        Parameters
        ----------
        runs : int
        streams : (runs, 4) [m/s], optional
            Where they are given the object is at rest over the ground, and otherwise in the water.

        Returns
        -------
        (runs, 6 + 2 n)
            Idle robots exert their least force, 0 for most, in their own direction.
        """
        if not (is_whole(runs) and 1 <= runs <= MOST_ROWS):
            raise SimulationInvalid(
                f"the number of runs is {shown(runs)}; it should be a whole number from 1 to "
                f"{MOST_ROWS}"
            )
        count = len(self)
        states = np.zeros((runs, BODY + 2 * count))
        states[:, BODY : BODY + count] = self.swarm.leasts
        states[:, BODY + count :] = self.swarm.directions
        if streams is not None:
            faults: list[str] = []
            flows = _rows(streams, (runs, STREAM), "streams", faults)
            refuse((SimulationInvalid, faults))
            states[:, 3:5] = -flows[:, 2:]
        return states

    def orders(self, vectors: ArrayLike) -> Array:
        """Return the orders that make forces, such as those of `forces_along`.

        Parameters
        ----------
        vectors : (runs, n, 2) [N, N]
            In the object's frame.

        Returns
        -------
        (runs, n, 2) [N, rad]
            A force and its angle. A robot that pushes along a line has its own angle, and what the
            force is along it; one that is to exert nothing turns to its own direction.
        """
        faults: list[str] = []
        wanted = _rows(vectors, (None, len(self), 2), "forces", faults)
        refuse((SimulationInvalid, faults))
        found, (cos, sin) = np.empty_like(wanted), self._ways
        found[..., 0] = wanted[..., 0] * cos + wanted[..., 1] * sin
        found[..., 1] = self.swarm.directions
        rows = np.flatnonzero(self._following != FIXED)
        if len(rows):
            found[:, rows] = self._turning_orders(rows, wanted[:, rows])
        return found

    def _turning_orders(self, rows: NDArray[np.intp], wanted: Array) -> Array:
        """Return the orders (runs, k, 2) of some robots whose forces turn."""
        own, steers = self.swarm.directions[rows], self.swarm.steers[rows]
        sizes = np.hypot(wanted[..., 0], wanted[..., 1])
        turns = np.arctan2(wanted[..., 1], wanted[..., 0]) - own
        turns -= 2.0 * np.pi * np.round(turns / (2.0 * np.pi))
        turns = np.where(self._following[rows] == SECTOR, np.clip(turns, -steers, steers), turns)
        return np.stack([sizes, own + np.where(sizes == 0.0, 0.0, turns)], axis=-1)

    @cached_property
    def _ways(self) -> Array:
        """(2, n): the unit vectors along the robots' own directions."""
        own = self.swarm.directions
        return read_only(np.array([np.cos(own), np.sin(own)]))

    @cached_property
    def _following(self) -> NDArray[np.intp]:
        """How each robot's angle follows orders."""
        return read_only(following_of(self.swarm))

    def advance(
        self, state: ArrayLike, orders: ArrayLike, stream: ArrayLike, load: ArrayLike | None,
        step: float, steps: int = 1,
    ) -> Array:  # fmt: skip
        """Return the states some steps on.

        Parameters
        ----------
        state : (runs, 6 + 2 n)
        orders : (runs, n, 2) [N, rad]
            A force and an angle for each robot, as `orders` gives them.
        stream : (runs, 4) [m/s]
            Velocities x, y of the air and x, y of the water, in the earth's frame.
        load : (runs, 3) [N, N, N m], optional
            What else acts on the object, in its frame.
        step : float [s]
        steps : int
            Of that length; orders, streams and loads stay for all of them.

        Returns
        -------
        (runs, 6 + 2 n)

        Raises
        ------
        SimulationInvalid
            If arrays are not of these shapes or not finite, or the step is so long that the motion
            is no longer; all faults at once.
        """
        faults = STEP.faults("step", step)
        if not (is_whole(steps) and 0 <= steps <= MOST_STEPS):
            faults.append(
                f"the steps are {shown(steps)}; they should be a whole number, 0 <= steps <= "
                f"{MOST_STEPS:g}"
            )
        states = _rows(state, (None, BODY + 2 * len(self)), "states", faults)
        runs = len(states) if states.size else None
        wanted = _rows(orders, (runs, len(self), 2), "orders", faults)
        flows = _rows(stream, (runs, STREAM), "streams", faults)
        loads = (
            np.zeros((len(states), 3)) if load is None else _rows(load, (runs, 3), "loads", faults)
        )
        refuse((SimulationInvalid, faults))
        found = advanced(
            self._afloat, self._drivers, states, flows, wanted.reshape(len(states), -1), loads,
            float(step), int(steps),
        )  # fmt: skip
        if not np.isfinite(found.sum()):
            raise SimulationInvalid(
                f"in steps of {step:g} s the motion grows beyond all numbers; take shorter steps"
            )
        return found

    def given(self, state: ArrayLike) -> Array:
        """Return the wrenches (runs, 3) [N, N, N m] of the robots on the object, in its frame.

        Parameters
        ----------
        state : (runs, 6 + 2 n)
        """
        return self._exerted(state, None)[:, 0]

    def load(self, state: ArrayLike, stream: ArrayLike) -> Array:
        """Return the wrenches (runs, 3) [N, N, N m] of wind and water, in the object's frame.

        Parameters
        ----------
        state : (runs, 6 + 2 n)
        stream : (runs, 4) [m/s]
        """
        found = self._exerted(state, stream)
        return found[:, 1] + found[:, 2]

    def wind(self, state: ArrayLike, stream: ArrayLike) -> Array:
        """Return the wrenches (runs, 3) [N, N, N m] of the wind alone, in the object's frame.

        Parameters
        ----------
        state : (runs, 6 + 2 n)
        stream : (runs, 4) [m/s]
        """
        return self._exerted(state, stream)[:, 1]

    def _exerted(self, state: ArrayLike, stream: ArrayLike | None) -> Array:
        """Return the wrenches (runs, 3, 3) of robots, wind and water; calm without a stream."""
        faults: list[str] = []
        states = _rows(state, (None, BODY + 2 * len(self)), "states", faults)
        flows = np.zeros((len(states), STREAM))
        if stream is not None:
            flows = _rows(stream, flows.shape, "streams", faults)
        refuse((SimulationInvalid, faults))
        return exerted(self._afloat, self._drivers, states, flows)


def _rows(
    values: ArrayLike, shape: tuple[int | None, ...], called: str, faults: list[str]
) -> Array:
    """Return values as an array of a shape, None for any number; note what is wrong with them."""
    try:
        found = np.ascontiguousarray(values, dtype=float)
    except (TypeError, ValueError):
        faults.append(f"the {called} are {shown(values)}; they should be numbers")
        return np.zeros(tuple(size or 0 for size in shape))
    first = 1 if shape[0] is None else 0
    if found.ndim != len(shape) or found.shape[first:] != shape[first:]:
        wanted = ", ".join("runs" if size is None else str(size) for size in shape)
        faults.append(f"the {called} have shape {found.shape}; it should be ({wanted})")
        return np.zeros(tuple(size or 0 for size in shape))
    if not np.isfinite(found.sum()) and not np.isfinite(found).all():
        row = np.argwhere(~np.isfinite(found))[0].tolist()
        faults.append(f"of the {called}, that at {row} is {found[tuple(row)]}; it should be finite")
    return found
