"""Who holds the object, who is believed to, and who is on the way."""

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import NowhereToAttach
from swarmgrasp.placement import place
from swarmgrasp.simulation.events import Send
from swarmgrasp.simulation.motion import BODY
from swarmgrasp.simulation.plant import Plant
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.swarm import Robot, Swarm

Array = NDArray[np.float64]
NO_HEADINGS: Mapping[str, float] = MappingProxyType({})


class Crew:
    """The robots of a simulation as they come and go.

    Parameters
    ----------
    simulation : Simulation

    Attributes
    ----------
    there : Plant
        The object with those that hold it.
    believed : Plant
        The same with those that are believed to.
    """

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation
        self._headings: dict[str, float] = {}
        self._coming: dict[str, Robot] = {}
        self.there = self.believed = self._plant(simulation.problem.swarm)

    def _plant(self, swarm: Swarm) -> Plant:
        """Return the object with some robots."""
        return plant_of(self._simulation, swarm, self._headings)

    def is_coming(self, name: str) -> bool:
        """Tell whether a robot is on its way."""
        return name in self._coming

    def lose(self, name: str) -> None:
        """Let a robot exert nothing any more, which nobody knows yet."""
        if self._coming.pop(name, None) is None:
            self.there = self._plant(self.there.swarm.without(name))

    def forget(self, name: str) -> None:
        """Let all know that a robot is gone."""
        if name in self.believed.swarm:
            self.believed = self._plant(self.believed.swarm.without(name))
        if _are_same(self.believed.swarm, self.there.swarm):
            self.believed = self.there

    def send(self, event: Send, name: str, load: Array) -> Robot | None:
        """Send a newcomer to the best place beside a load (3,) [N, N, N m]; None without any."""
        problem, (x, y, turn) = self._simulation.problem, load.tolist()
        planned = self.believed.swarm
        for robot in self._coming.values():
            planned = planned.with_robot(robot)
        asked = replace(
            problem,
            swarm=planned,
            newcomer=event.newcomer or problem.newcomer,
            criterion=replace(problem.criterion, load=(x, y, turn)),
        )
        try:
            found = replace(place(asked).robot, name=name)
        except NowhereToAttach:
            return None
        self._coming[name] = found
        return found

    def join(self, name: str, heading: float) -> None:
        """Let a robot that has come make fast, at a heading [rad] of the object."""
        robot = self._coming.pop(name)
        self._headings[name] = heading
        is_known = self.believed is self.there
        self.there = self._plant(self.there.swarm.with_robot(robot))
        self.believed = (
            self.there if is_known else self._plant(self.believed.swarm.with_robot(robot))
        )


def plant_of(
    simulation: Simulation, swarm: Swarm, headings: Mapping[str, float] = NO_HEADINGS
) -> Plant:
    """Return the object of a simulation with some robots.

    Parameters
    ----------
    simulation : Simulation
    swarm : Swarm
    headings : mapping of str to float [rad]
        Of the object when robots were made fast, by name; 0 for those that are not there.
    """
    own = {name: one for name, one in simulation.actuators if name in swarm}
    fast = {name: turn for name, turn in headings.items() if name in swarm}
    return Plant(swarm, simulation.hull, simulation.environment, simulation.actuator, own, fast)


def way_to(simulation: Simulation, event: Send, contact: tuple[float, float]) -> float:
    """Return how far [m] a newcomer travels to a contact [m, m].

    Straight to the nearest point of the outline, and along it the shorter way.

    Parameters
    ----------
    simulation : Simulation
    event : Send
    contact : tuple of float [m, m]
        In the frame of the outline's vertices.
    """
    outline = simulation.problem.swarm.outline
    way = np.array([np.cos(event.bearing), -np.sin(event.bearing)])
    (straight, _), (first, last) = outline.nearest(
        np.array([outline.origin + event.away * way, contact])
    )
    round_it = abs(float(last - first))
    return float(straight) + min(round_it, outline.perimeter - round_it)


def state_of(old: Swarm, new: Plant, state: Array) -> Array:
    """Return states (runs, 6 + 2 n) of other robots: some stay as they are, new ones idle."""
    found = new.rest(len(state))
    found[:, :BODY] = state[:, :BODY]
    stayed = [(i, old.index(name)) for i, name in enumerate(new.swarm.names) if name in old]
    for now, before in stayed:
        for first, last in ((BODY, BODY), (BODY + len(new), BODY + len(old))):
            found[:, first + now] = state[:, last + before]
    return found


def vectors_of(old: Swarm, new: Swarm, vectors: Array) -> Array:
    """Return forces (runs, n, 2) of other robots: some stay as they are, new ones are 0."""
    found = np.zeros((len(vectors), len(new), 2))
    for i, name in enumerate(new.names):
        if name in old:
            found[:, i] = vectors[:, old.index(name)]
    return found


def _are_same(one: Swarm, other: Swarm) -> bool:
    """Tell whether the same robots are in two swarms."""
    return sorted(one.names) == sorted(other.names)
