"""Events as they fall due, what they do, and what is told of them."""

from collections.abc import Callable, Iterable
from functools import partial
from heapq import heappop, heappush

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.forces import forces
from swarmgrasp.quality import quality
from swarmgrasp.simulation.crew import Crew, way_to
from swarmgrasp.simulation.events import Change, Event, Follow, Leave, Lose, Send
from swarmgrasp.simulation.frames import Headings
from swarmgrasp.simulation.motion import BODY
from swarmgrasp.simulation.plant import Plant
from swarmgrasp.simulation.reference import Reference
from swarmgrasp.simulation.run import Happening, Stint
from swarmgrasp.simulation.sentences import sentence
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.simulation.weather import Streams
from swarmgrasp.telling import Telling
from swarmgrasp.terms import SI
from swarmgrasp.words import list_words

Array = NDArray[np.float64]


class Schedule:
    """What is to happen, to whom it happens, and what has happened.

    Parameters
    ----------
    simulation : Simulation
    crew : Crew
    reference : Reference
    streams : Streams

    Attributes
    ----------
    happenings : list of Happening
    """

    def __init__(
        self, simulation: Simulation, crew: Crew, reference: Reference, streams: Streams
    ) -> None:
        self._simulation, self._crew = simulation, crew
        self._reference, self._streams = reference, streams
        self._names = iter(simulation.joining)
        self._due: list[tuple[float, bool, int, Callable[[float], None]]] = []
        self._count = 0
        self._nowhere: set[str] = set()
        self.happenings: list[Happening] = []
        self._stints = [(0.0, crew.there)]
        for event in simulation.events:
            self._add(event.at, partial(self._happen, event), is_event=True)
        self._note(0.0, "start", "", "the run begins")

    @property
    def next(self) -> float:
        """When the next event falls due [s]; infinity if none does."""
        return self._due[0][0] if self._due else np.inf

    def pass_to(self, time: float, until: float) -> None:
        """Let everything happen at a time [s] that falls due until another."""
        while self.next <= until:
            heappop(self._due)[-1](time)
            if self._stints[-1][1] is not self._crew.there:
                self._stints.append((time, self._crew.there))

    def stints(self, end: float) -> tuple[Stint, ...]:
        """Return who held the object when, up to an end [s]."""
        begun = [stint for stint in self._stints if stint[0] <= end]
        ends = [*(start for start, _ in begun[1:]), end]
        rows = zip(begun, ends, strict=True)
        return tuple(Stint(start, last, plant.swarm) for (start, plant), last in rows)

    def load_at(self, time: float) -> Array:
        """Return the mean loads (1 or runs, 3) [N, N, N m] on the object where it is to be."""
        steady = self._streams.steady(time)
        return self._crew.there.load(resting(self._crew.there, steady, self._heading), steady)

    @property
    def _heading(self) -> float:
        """The heading [rad] that the object is to have."""
        return self._reference.heading

    def _add(self, time: float, act: Callable[[float], None], is_event: bool = False) -> None:
        """Let something happen at a time [s]: what comes of earlier events first."""
        heappush(self._due, (time, is_event, self._count, act))
        self._count += 1

    def _note(self, time: float, kind: str, robot: str, said: str | dict[str, float]) -> None:
        """Keep what has happened, in words or in numbers, and what the robots are then worth."""
        swarm, load = self._crew.there.swarm, self.load_at(time)[0]
        x, y, turn = load.tolist()
        words, numbers = (said, {}) if isinstance(said, str) else ("", said)
        if numbers:
            words = sentence(kind, robot, numbers, Telling.of(SI, swarm.outline.extent, []))
        self.happenings.append(
            Happening(
                time, kind, robot, words, swarm, load,
                quality(swarm).value,
                max(0.0, quality(swarm, load=(x, y, turn)).value),
                forces(swarm, np.zeros(3), load=load).shortfall,
                numbers,
            )
        )  # fmt: skip

    def _happen(self, event: Event, time: float) -> None:
        """Let an event happen."""
        if isinstance(event, Lose):
            self._lose(event, time)
        elif isinstance(event, Leave):
            self._leave(event.robot, time)
        elif isinstance(event, Send):
            self._send(event, next(self._names), time)
        elif isinstance(event, Change):
            self._streams.change(event.said)
            self._note(time, "weather", "", event.said)
        elif isinstance(event, Follow):
            self._reference.follow(event.path, event.speed, time)
            self._note(time, "aim", "", {**self._reference.goal, "speed": event.speed})
        else:
            self._reference.move((event.x, event.y), event.heading)
            self._note(time, "aim", "", self._reference.goal)

    def _lose(self, event: Lose, time: float) -> None:
        """Lose a robot, now or on its way, or those of a group that are there."""
        name = event.robot
        if name in self._nowhere:
            self._note(time, "lost", name, f"{name}, which had no place, is lost")
            return
        there = self._crew.there.swarm
        members = [each for each in there.groups.get(name, ()) if each in there]
        are, comes = ("are" if len(members) > 1 else "is"), self._crew.is_coming(name)
        lost = f"{list_words(members)} of {name} {are} lost" if members else f"{name} is lost"
        members = members or [name]
        for each in members:
            self._crew.lose(each)
        if comes:
            self._note(time, "lost", name, f"{lost} on its way")
        elif event.noticed > 0.0:
            self._note(time, "lost", name, f"{lost}, which nobody knows yet")
            self._add(event.at + event.noticed, partial(self._notice, name, members, lost))
        else:
            self._forget(members)
            self._note(time, "lost", name, lost)

    def _forget(self, names: Iterable[str]) -> None:
        """Let all know that robots are gone."""
        for name in names:
            self._crew.forget(name)

    def _notice(self, name: str, members: Iterable[str], lost: str, time: float) -> None:
        """Let all know of a loss."""
        self._forget(members)
        self._note(time, "noticed", name, f"it is noticed that {lost}")

    def _leave(self, name: str, time: float) -> None:
        """Let a robot go."""
        if name in self._nowhere:
            self._note(time, "left", name, f"{name}, which had no place, turns back")
            return
        was_coming = self._crew.is_coming(name)
        self._crew.lose(name)
        self._crew.forget(name)
        words = "turns back on its way" if was_coming else "leaves"
        self._note(time, "left", name, f"{name} {words}")

    def _send(self, event: Send, name: str, time: float) -> None:
        """Send a newcomer on its way."""
        robot = self._crew.send(event, name, self.load_at(time)[0])
        if robot is None:
            self._nowhere.add(name)
            self._note(time, "sent", name, f"there is no place left for {name}")
            return
        far = way_to(self._simulation, event, robot.contact)
        comes = event.at + far / event.speed + event.make_fast
        x, y = robot.contact
        told = {"x": float(x), "y": float(y), "away": far, "joins": comes}
        self._note(time, "sent", name, told)
        self._add(comes, partial(self._join, name))

    def _join(self, name: str, time: float) -> None:
        """Let a newcomer make fast, if it has not been lost on its way."""
        if self._crew.is_coming(name):
            self._crew.join(name, self._heading)
            self._note(time, "joined", name, f"{name} joins")


def resting(plant: Plant, streams: Array, heading: float) -> Array:
    """Return states (runs, 6 + 2 n) of a plant at rest over the ground at a heading [rad].

    Parameters
    ----------
    plant : Plant
    streams : (runs, 4) [m/s]
    heading : float [rad]
    """
    found = plant.rest(len(streams))
    found[:, 2] = heading
    flows = np.zeros((len(streams), 3))
    flows[:, :2] = -streams[:, 2:]
    found[:, 3:BODY] = Headings(found[:, 2]).to_object(flows)
    return found
