"""Thrust use: which part of its limit each robot needs in one wind, from all round."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.capability.asked import HELD, Array, asked_of
from swarmgrasp.environment import Environment
from swarmgrasp.environment.limits import SPEED
from swarmgrasp.environment.sea import sea_faults
from swarmgrasp.forces import forces_along
from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Answer, picked
from swarmgrasp.swarm import Swarm


@dataclass(frozen=True, eq=False)
class ThrustUse(Frozen, Answer):
    """How much of its limit each robot uses against one wind, from bearings all round.

    Attributes
    ----------
    swarm : Swarm
    environment : Environment
    speed : float [m/s]
        Of the wind.
    bearings : (m,) [rad]
        Where it comes from, clockwise from the bow.
    shares : (m, n)
        The robots' shares, each a force as a part of the limit that way, in their order: the
        largest is the least there can be. Where the weather is not held, those of the nearest
        wrench.
    shortfalls : (m,) [N]
        By how much the robots fall short of the weather, in the metric.
    held : (m,) of bool
        Whether they hold it.
    """

    swarm: Swarm
    environment: Environment
    speed: float
    bearings: Array
    shares: Array
    shortfalls: Array
    held: NDArray[np.bool_]

    kind = "thrust use"

    def to_data(self) -> dict[str, Any]:
        """Return question and answer as plain data; shares in the robots' order."""
        return picked(
            self, "swarm", "environment", "speed", "bearings", "shares", "shortfalls", "held"
        )

    @property
    def largest(self) -> Array:
        """(m,): the share of the busiest robot at each bearing."""
        return np.asarray(self.shares.max(axis=1, initial=0.0))

    @property
    def busiest(self) -> int:
        """Index of the bearing at which most is used, or missing."""
        if self.held.all():
            return int(np.argmax(self.largest >= self.largest.max() * (1.0 - 1e-9)))
        return int(self.shortfalls.argmax())

    def busiest_at(self, index: int) -> str:
        """Return the name of the busiest robot at a bearing; "" without robots."""
        row = self.shares[index]
        if not row.size:
            return ""
        return self.swarm.names[int(np.argmax(row >= row.max() * (1.0 - 1e-6)))]


def thrust_use(
    swarm: Swarm, environment: Environment, speed: float, bearings: ArrayLike | None = None
) -> ThrustUse:
    """Find which part of its limit each robot needs to hold the object in a wind from all round.

    The forces are those of `forces`: the largest share is made as small as it can be, and then the
    sum of their squares.

    Parameters
    ----------
    swarm : Swarm
    environment : Environment
        The wind's own speed and bearing play no part.
    speed : float [m/s]
        Of the wind.
    bearings : (m,) [rad], optional
        Where it comes from, clockwise from the bow; every 5 degrees when left out.

    Returns
    -------
    ThrustUse

    Raises
    ------
    EnvironmentInvalid
        If the environment is none, or the speed or a bearing is outside its range.
    SwarmInvalid
        If the swarm is no `Swarm`.

    Examples
    --------
    Half of what the wind may at most be takes a quarter of the limits:

    >>> import math
    >>> from swarmgrasp import Outline, Robot, Wind, WindCoefficients
    >>> barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    >>> ways = {(-40, 0): 0.0, (40, 0): math.pi, (0, -10): math.pi / 2, (0, 10): -math.pi / 2}
    >>> swarm = Swarm(barge, [Robot(contact, way, 60e3) for contact, way in ways.items()])
    >>> box = WindCoefficients(transverse=0.9, bow=0.7, stern=0.7)
    >>> found = thrust_use(swarm, Environment(Wind(150.0, 500.0, box)), 0.5 * 30.53, [0.0])
    >>> found.shares.round(3).tolist(), found.held.tolist()
    ([[0.25, 0.0, 0.0, 0.0]], [True])
    """
    faults = SPEED.faults("speed", speed)
    waves = environment.waves if isinstance(environment, Environment) else None
    if not faults and waves is not None and waves.goes_with_wind:
        faults += sea_faults("speed", speed)
    wanted = asked_of(swarm, environment, bearings, 0, False, (), faults).bearings
    loads = environment.load_in(swarm.outline, wanted, speed)
    found = forces_along(swarm, -loads)
    sizes = np.sqrt((np.square(loads * swarm.scale)).sum(axis=1))
    return ThrustUse(
        swarm=swarm,
        environment=environment,
        speed=float(speed),
        bearings=wanted,
        shares=found.shares,
        shortfalls=found.shortfalls,
        held=found.shortfalls <= HELD * sizes,
    )
