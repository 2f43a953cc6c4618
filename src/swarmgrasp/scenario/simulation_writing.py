"""Write a simulation by the keys of a scenario file."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from swarmgrasp.plain import plain
from swarmgrasp.scenario.file_keys import unusual
from swarmgrasp.simulation.actuator import Actuator
from swarmgrasp.simulation.control import Control
from swarmgrasp.simulation.events import Change, Event, Follow, Leave, Lose, Move, Send
from swarmgrasp.simulation.hull import NO_DAMPING, Hull
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.simulation.weather import Weather
from swarmgrasp.swarm import Newcomer

Angle = Callable[[float], float]
"""Writes an angle [rad] in the file's unit."""
Kind = Callable[[Newcomer], dict[str, Any]]
"""Writes a newcomer by the keys of a file."""


def simulation_keys(simulation: Simulation, angle: Angle, kind: Kind) -> dict[str, Any]:
    """Return a simulation by the keys of a file in SI units but for its angles.

    Parameters
    ----------
    simulation : Simulation
    angle : callable
        Writes an angle [rad] in the file's unit.
    kind : callable
        Writes a newcomer by the keys of a file.
    """
    usual = simulation.problem.newcomer
    return {
        "hull": _hull(simulation.hull),
        "duration": simulation.duration,
        **({} if simulation.step is None else {"step": simulation.step}),
        "seed": simulation.seed,
        "robots": _robots(simulation, angle),
        "weather": _weather(simulation.weather, angle),
        "control": _control(simulation.control, angle),
        "events": [_event(event, usual, angle, kind) for event in simulation.events],
    }


def _hull(hull: Hull) -> dict[str, Any]:
    """Return what the object weighs, outright: the draught it came from is not kept."""
    told = hull.to_data()
    return told if hull.damping != NO_DAMPING else {k: v for k, v in told.items() if k != "damping"}


def _robots(simulation: Simulation, angle: Angle) -> dict[str, Any]:
    """Return how robots answer to orders."""
    told = _actuator(simulation.actuator, Actuator(), angle)
    others = [
        {"name": name, **_actuator(actuator, simulation.actuator, angle)}
        for name, actuator in simulation.actuators
    ]
    return {**told, "except": others} if others else told


def _actuator(actuator: Actuator, usual: Actuator, angle: Angle) -> dict[str, Any]:
    """Return in what an actuator is not as usual."""
    told = actuator.to_data()
    told = {key: value for key, value in told.items() if value != getattr(usual, key)}
    if "turn_rate" in told:
        told["turn_rate"] = angle(actuator.turn_rate)
    return told


def _weather(weather: Weather, angle: Angle) -> dict[str, Any]:
    """Return how the wind comes and goes."""
    told: dict[str, Any] = {"gusts": weather.gusts}
    if weather.series is not None:
        columns = (weather.series.times, weather.series.speeds, weather.series.bearings)
        rows = zip(*(column.tolist() for column in columns), strict=True)
        told["series"] = [[time, speed, angle(bearing)] for time, speed, bearing in rows]
    return told


def _control(control: Control, angle: Angle) -> dict[str, Any]:
    """Return how the object is kept."""
    told = unusual(control)
    if "heading_noise" in told:
        told["heading_noise"] = angle(control.heading_noise)
    return told


def _event(event: Event, usual: Newcomer, angle: Angle, kind: Kind) -> dict[str, Any]:
    """Return what happens at an instant."""
    if isinstance(event, Lose):
        told: dict[str, Any] = {"lose": event.robot, "noticed": event.noticed}
    elif isinstance(event, Leave):
        told = {"leave": event.robot}
    elif isinstance(event, Send):
        told = {**_sent(event.newcomer, usual, kind), **unusual(event)}
        told.pop("newcomer", None)
        if "bearing" in told:
            told["from"] = angle(told.pop("bearing"))
    elif isinstance(event, Move):
        told = {"move": [event.x, event.y, angle(event.heading)]}
    elif isinstance(event, Follow):
        told = {"follow": plain(event.path), "speed": event.speed}
    else:
        told = _change(event, angle)
    return {"at": event.at, **{key: value for key, value in told.items() if key != "at"}}


def _sent(newcomer: Newcomer | None, usual: Newcomer, kind: Kind) -> dict[str, Any]:
    """Return who is sent: the file's newcomer, another one like it, or another kind."""
    if newcomer is None:
        return {"send": "newcomer"}
    if newcomer.name and newcomer == replace(usual, name=newcomer.name):
        return {"send": "newcomer", "as": newcomer.name}
    return {"send": kind(newcomer)}


def _change(event: Change, angle: Angle) -> dict[str, Any]:
    """Return new weather."""
    told: dict[str, dict[str, float]] = {}
    for name, value in event.said.items():
        stream, what = name.split("_")
        held = told.setdefault(stream, {})
        held.update({"from": angle(value)} if what == "bearing" else {what: value})
    return told
