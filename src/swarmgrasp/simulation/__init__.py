"""A hull and its robots in weather: what becomes of them in time."""

from swarmgrasp.simulation.actuator import Actuator
from swarmgrasp.simulation.control import Control, Tuning
from swarmgrasp.simulation.events import Change, Event, Follow, Leave, Lose, Move, Send
from swarmgrasp.simulation.hull import Hull
from swarmgrasp.simulation.limits import Limits, limits
from swarmgrasp.simulation.motion import flow
from swarmgrasp.simulation.plant import Plant
from swarmgrasp.simulation.run import Happening, Run, Stint
from swarmgrasp.simulation.simulate import simulate
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.simulation.station import Controller, Known, Look, StationKeeping
from swarmgrasp.simulation.verdict import Circle, Verdict, verdict_of
from swarmgrasp.simulation.weather import Series, Weather

__all__ = [
    "Actuator",
    "Change",
    "Circle",
    "Control",
    "Controller",
    "Event",
    "Follow",
    "Happening",
    "Hull",
    "Known",
    "Leave",
    "Limits",
    "Look",
    "Lose",
    "Move",
    "Plant",
    "Run",
    "Send",
    "Series",
    "Simulation",
    "StationKeeping",
    "Stint",
    "Tuning",
    "Verdict",
    "Weather",
    "flow",
    "limits",
    "simulate",
    "verdict_of",
]
