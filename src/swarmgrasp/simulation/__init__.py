"""A hull and its robots in weather: what becomes of them in time."""

from swarmgrasp.simulation.actuator import Actuator
from swarmgrasp.simulation.hull import Hull
from swarmgrasp.simulation.motion import flow
from swarmgrasp.simulation.plant import Plant

__all__ = ["Actuator", "Hull", "Plant", "flow"]
