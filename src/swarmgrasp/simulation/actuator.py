"""How a robot's force follows its orders."""

import math
from dataclasses import dataclass
from typing import Literal, get_args

from swarmgrasp.environment.limits import Range
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import shown

Follows = Literal["hull", "earth"]
"""What a force keeps its direction to, until it is turned."""

LAG = Range(0.0, 1e6, "s")
TURN_RATE = Range(1e-6, 1e6, "rad/s")
EFFICIENCY = Range(0.0, 1.0, "1")
ATTACHED = Range(0.0, 1e12, "kg")


@dataclass(frozen=True)
class Actuator(Plain):
    """How a robot's force follows its orders, and what comes of it.

    A force F ordered to be f changes at (f - F) / lag, but by no more than its limit in `slew`; an
    angle does the same. The least force of a robot is that of its force set.

    The defaults are assumptions about a harbour tug. At model scale everything is quicker: time
    goes with the square root of length.

    Attributes
    ----------
    lag : float [s]
        Time constant of the force.
    slew : float [s]
        From idle to the limit, at the quickest; 0 for no such bound.
    turn_rate : float [rad/s]
        How quickly the force turns, at most. Only for robots that steer: see `Plant`.
    turn_lag : float [s]
        Time constant of the angle.
    efficiency : float
        Part of the force that arrives at the object, within [0, 1]: what is left after wash on the
        hull, waves, and the wind and water on the robot itself.
    mass : float [kg]
        What a robot that is rigidly attached adds to the object; 0 for one on a line.
    follows : {"hull", "earth"}
        Whether the force turns with the object, or keeps its direction to the earth as that of a
        tug on a long line does.

    Raises
    ------
    SimulationInvalid
        If a value is outside its range, or a robot on a line has a mass; all faults at once.

    Examples
    --------
    >>> Actuator(lag=0.3, slew=1.0).efficiency
    1.0
    >>> Actuator(lag=-1.0, efficiency=2.0)
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.SimulationInvalid: actuator: the lag is -1.0; it should be 0 <= lag <= ...
    actuator: the efficiency is 2.0; it should be 0 <= efficiency <= 1 [1]
    """

    lag: float = 5.0
    slew: float = 10.0
    turn_rate: float = math.radians(12.0)
    turn_lag: float = 3.0
    efficiency: float = 1.0
    mass: float = 0.0
    follows: Follows = "hull"

    def __post_init__(self) -> None:
        """Check the values."""
        faults = [
            *LAG.faults("lag", self.lag),
            *LAG.faults("slew", self.slew),
            *TURN_RATE.faults("turn rate", self.turn_rate),
            *LAG.faults("turn lag", self.turn_lag),
            *EFFICIENCY.faults("efficiency", self.efficiency),
            *ATTACHED.faults("mass", self.mass),
        ]
        if self.follows not in get_args(Follows):
            known = " or ".join(map(repr, get_args(Follows)))
            faults.append(f"it follows {shown(self.follows)}; that should be {known}")
        if not faults and self.follows == "earth" and self.mass > 0.0:
            faults.append(
                f"the mass is {shown(self.mass)} of a robot whose force follows the earth; such a "
                "robot is on a line and moves by itself: its mass should be 0 [kg]"
            )
        if faults:
            raise SimulationInvalid(f"actuator: {fault}" for fault in faults)
        numbers = {name: float(value) for name, value in vars(self).items() if name != "follows"}
        vars(self).update(numbers)
