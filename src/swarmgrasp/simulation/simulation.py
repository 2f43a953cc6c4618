"""The question of a run: which object, robots, weather and events."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from swarmgrasp.environment import Environment, WindTable
from swarmgrasp.environment.limits import Range
from swarmgrasp.errors import SimulationInvalid, SwarmGraspError
from swarmgrasp.frozen import Frozen
from swarmgrasp.placement import Problem
from swarmgrasp.placement.problem import check_newcomer
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import MOST_SEED, is_whole, items, kind_faults, shown
from swarmgrasp.simulation.actuator import Actuator
from swarmgrasp.simulation.control import PERIOD, Control, Tuning, loop_faults
from swarmgrasp.simulation.events import (
    KINDS,
    Change,
    Event,
    Send,
    event_faults,
    in_order,
    joining_names,
)
from swarmgrasp.simulation.hull import Hull
from swarmgrasp.simulation.weather import Weather

DURATION = Range(1e-3, 1e6, "s")


@dataclass(frozen=True, eq=False)
class Simulation(Frozen, Plain):
    """An object in weather, the robots that hold it, and what happens to them.

    Attributes
    ----------
    problem : Problem
        The swarm at the start; newcomers that are sent join where it lets them.
    environment : Environment
        What the object shows to wind and current, and their means. The dynamic factor plays no
        part: it allows for what is simulated here.
    hull : Hull
    actuator : Actuator
        How the robots answer to orders.
    actuators : tuple of (str, Actuator)
        Of some robots, by name, instead of that.
    weather : Weather
    control : Control
    events : tuple of Event
        Kept in the order of time.
    duration : float [s]
    step : float [s], optional
        The longest that motion is worked out over at once; a period of control when left out.
    seed : int
        Of gusts and of the sensors' noise, unless `simulate` is given others.

    Raises
    ------
    SimulationInvalid
        If something is not what it should be, or events contradict each other; all faults at once.
    """

    problem: Problem
    environment: Environment
    hull: Hull
    actuator: Actuator = field(default_factory=Actuator)
    actuators: Sequence[tuple[str, Actuator]] = ()
    weather: Weather = field(default_factory=Weather)
    control: Control = field(default_factory=Control)
    events: Sequence[Event] = ()
    duration: float = 600.0
    step: float | None = None
    seed: int = 0

    def __post_init__(self) -> None:
        """Check the values."""
        faults = self._kind_faults()
        faults += DURATION.faults("duration", self.duration)
        if self.step is not None:
            faults += PERIOD.faults("step", self.step)
        faults += seed_faults(self.seed)
        if faults:
            raise SimulationInvalid(faults)
        vars(self).update(
            actuators=tuple(map(tuple, self.actuators)),
            events=in_order(self.events),
            duration=float(self.duration),
            step=None if self.step is None else float(self.step),
            seed=int(self.seed),
        )
        faults = [*self._robot_faults(), *self._weather_faults()]
        faults += [fault for _, fault in loop_faults(self.control, self._lag, self.duration)]
        problem = self.problem
        swarm, newcomer = problem.swarm, problem.newcomer
        contradictions = event_faults(
            swarm.names, swarm.groups, self.events, newcomer, self.duration
        )
        faults += [fault for _, fault in contradictions]
        if faults:
            raise SimulationInvalid(faults)
        self._freeze()

    def _kind_faults(self) -> list[str]:
        """Return what is not of the kind that it should be."""
        faults = kind_faults(self.problem, Problem, "Problem(swarm, newcomer)")
        faults += kind_faults(self.environment, Environment, "Environment(wind)")
        faults += kind_faults(self.hull, Hull, "Hull.afloat(outline)")
        faults += kind_faults(self.actuator, Actuator, "Actuator()")
        faults += kind_faults(self.weather, Weather, "Weather()")
        faults += kind_faults(self.control, Control, "Control()")
        pairs = items(self.actuators)
        if pairs is None or any(len(items(pair) or ()) != 2 for pair in pairs):
            faults.append(f"the actuators are {shown(self.actuators)}; they should be pairs of a "
                          "robot's name and an Actuator")  # fmt: skip
        else:
            faults += [f for _, one in pairs for f in kind_faults(one, Actuator, "Actuator()")]
        events = items(self.events)
        if events is None:
            faults.append(f"the events are {shown(self.events)}; they should be a list of events")
        names = ", ".join(kind.__name__ for kind in KINDS)
        wrong = [event for event in events or () if not isinstance(event, KINDS)]
        return faults + [f"{shown(event)} is no event: these are {names}" for event in wrong]

    def _robot_faults(self) -> list[str]:
        """Return which actuators are of nobody, or of one robot twice."""
        known = (*self.problem.swarm.names, *self.joining)
        named = [name for name, _ in self.actuators]
        faults = [
            f"an actuator is of {shown(name)}; there is no robot of that name, and none is sent"
            for name in dict.fromkeys(named)
            if name not in known
        ]
        twice = dict.fromkeys(name for name in named if named.count(name) > 1)
        faults += [f"{shown(name)} has two actuators; leave out one" for name in twice]
        faults += [
            f"{self.problem.swarm.names[i]} exerts a couple, and a run in time knows none: "
            "leave it out of this question"
            for i in self.problem.swarm.rare.couples
        ]
        return faults + [fault for event in self.events for fault in self._sent_faults(event)]

    def _sent_faults(self, event: Event) -> list[str]:
        """Return why the newcomer of an event has no place, wherever the others are."""
        if not isinstance(event, Send):
            return []
        newcomer = event.newcomer or self.problem.newcomer
        try:
            check_newcomer(replace(self.problem, newcomer=newcomer))
        except SwarmGraspError as error:
            return [f"{event.does} at {event.at:g} s: {fault}" for fault in error.faults]
        return []

    def _weather_faults(self) -> list[str]:
        """Return what is missing of the mean weather, or said twice."""
        faults = []
        series, changes = self.weather.series, [e for e in self.events if isinstance(e, Change)]
        if self.environment.current is None:
            faults.append(
                "the environment has no current, and so nothing tells the drag of the water; give "
                "it Current(frontal_area, lateral_area): its speed may be 0"
            )
        if isinstance(self.environment.wind, WindTable):
            faults.append(
                "the environment has a table of wind loads, and a run in time knows none; give it "
                "Wind(frontal_area, lateral_area, coefficients)"
            )
        if self.environment.waves is not None:
            faults.append(
                "the environment has waves, and a run in time has none; leave them out of it"
            )
        if series is None and not self.environment.is_steady:
            faults.append(
                "the wind has no speed and bearing, and there is no series of winds; give the "
                "environment both, a speed of 0 for a calm"
            )
        if series and any(name.startswith("wind") for event in changes for name in event.said):
            faults.append("a series says the wind, and an event changes it; leave out one of them")
        return faults

    @property
    def joining(self) -> tuple[str, ...]:
        """The names of the newcomers that are sent, in the order of time."""
        problem = self.problem
        return joining_names(problem.swarm.names, self.events, problem.newcomer)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all robots that ever take part: those at the start, then newcomers."""
        return (*self.problem.swarm.names, *self.joining)

    def actuator_of(self, name: str) -> Actuator:
        """Return how a robot answers to orders."""
        return dict(self.actuators).get(name, self.actuator)

    @property
    def tuning(self) -> Tuning:
        """How station keeping is set, for all robots that ever take part."""
        return self.control.settled(
            self._lag, float(np.ptp(self.problem.swarm.outline.vertices[:, 0]))
        )

    @property
    def _lag(self) -> float:
        """The largest lag [s] of any robot that ever takes part."""
        return max([self.actuator_of(name).lag for name in self.names], default=self.actuator.lag)

    @property
    def steps(self) -> int:
        """How many steps motion takes in a period of control."""
        return 1 if self.step is None else math.ceil(self.tuning.period / self.step - 1e-9)


def seed_faults(seed: object) -> list[str]:
    """Return what is wrong with a seed."""
    if is_whole(seed) and 0 <= seed <= MOST_SEED:
        return []
    return [f"the seed is {shown(seed)}; it should be a whole number from 0 to {MOST_SEED}"]
