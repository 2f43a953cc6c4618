"""The ranges of the numbers of a simulation, by the keys of the file."""

from typing import Final

from swarmgrasp.environment.limits import SPEED
from swarmgrasp.scenario.in_range import Keys
from swarmgrasp.simulation.actuator import TURN_RATE
from swarmgrasp.simulation.control import FREQUENCY, NOISE, PERIOD, TURN_NOISE
from swarmgrasp.simulation.events import AWAY, FAR, PACE
from swarmgrasp.simulation.hull import ADDED, ADDED_INERTIA, DEPTH, INERTIA, MASS
from swarmgrasp.simulation.simulation import DURATION

RUN: Final[Keys] = {"duration": (DURATION, "time"), "step": (PERIOD, "time")}
HULL: Final[Keys] = {
    "draught": (DEPTH, "length"),
    "mass": (MASS, "mass"),
    "inertia": (INERTIA, "inertia"),
    "added": [(ADDED, "mass"), (ADDED, "mass"), (ADDED_INERTIA, "inertia")],
}
ACTUATOR: Final[Keys] = {"turn_rate": (TURN_RATE, "turn rate")}
WEATHER: Final[Keys] = {"series": [None, (SPEED, "speed"), None]}
CONTROL: Final[Keys] = {
    "period": (PERIOD, "time"),
    "frequency": (FREQUENCY, ""),
    "observer": (FREQUENCY, ""),
    "position_noise": (NOISE, "length"),
    "heading_noise": (TURN_NOISE, "angle"),
}
EVENT: Final[Keys] = {
    "away": (AWAY, "length"),
    "speed": (PACE, "speed"),
    "move": [(FAR, "length"), (FAR, "length"), None],
    "follow": (FAR, "length"),
}
STREAM: Final[Keys] = {"speed": (SPEED, "speed")}
