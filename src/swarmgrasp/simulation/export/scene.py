"""What is to be seen of a run at an instant, for animations of any format."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.simulation.events import Send
from swarmgrasp.simulation.run import Happening, Run
from swarmgrasp.swarm import Robot

Vector = NDArray[np.float64]

PROBE = 1e-4
"""Step that tells inside from outside, relative to the object's extent."""
ASIDE = 0.08
"""How far off the outline a robot on its way is shown, relative to the object's extent."""


@dataclass(frozen=True)
class Pusher:
    """A robot that holds the object.

    Attributes
    ----------
    robot : Robot
    force : (2,) [N, N]
        On the object, in its frame.
    """

    robot: Robot
    force: Vector


@dataclass(frozen=True)
class Scene:
    """What is to be seen at an instant.

    Attributes
    ----------
    time : float [s]
    pose, reference : (3,) [m, m, rad]
        Where the object is and should be, in the earth's frame.
    pushers : tuple of Pusher
    travellers : tuple of (str, (2,) [m, m])
        Robots on their way, in the earth's frame.
    wind, water : (2,) [m/s]
        In the earth's frame.
    shortfall : float [N]
        How far what is wanted is out of reach.
    error : float [m]
    turn : float [rad]
        The error of the heading, the shorter way.
    happening : Happening
        The last one.
    """

    time: float
    pose: Vector
    reference: Vector
    pushers: tuple[Pusher, ...]
    travellers: tuple[tuple[str, Vector], ...]
    wind: Vector
    water: Vector
    shortfall: float
    error: float
    turn: float
    happening: Happening


@dataclass(frozen=True, eq=False)
class Film:
    """One of the runs, to be looked at.

    Attributes
    ----------
    run : Run
    index : int
        Which of the runs.
    """

    run: Run
    index: int = 0

    def at(self, i: int) -> Scene:
        """Return what is to be seen at the i-th of the run's instants."""
        run, k = self.run, self.index
        time = float(run.times[i])
        pose, reference = (np.asarray(v[i], float) for v in (run.poses[k], run.references))
        off = pose - reference
        off[2] = math.remainder(off[2], math.tau)
        return Scene(
            time, pose, reference, self._pushers(i), self._travellers(time),
            np.asarray(run.streams[k, i, :2], float), np.asarray(run.streams[k, i, 2:], float),
            float(run.shortfalls[k, i]), float(np.hypot(off[0], off[1])), float(off[2]),
            self._last(time),
        )  # fmt: skip

    def picked(self, most: int) -> Iterator[int]:
        """Go through at most so many instants, evenly, the first and the last among them."""
        count = len(self.run.times)
        yield from np.unique(
            np.linspace(0, count - 1, min(most, count)).round().astype(int)
        ).tolist()

    def box(self) -> tuple[Vector, Vector]:
        """Return the corners, each (2,) [m, m], of all that the object covers and should cover."""
        vertices = self.run.simulation.problem.swarm.outline.vertices - self.origin
        poses = np.concatenate([self.run.poses[self.index], self.run.references])
        points = np.concatenate([placed(vertices, poses[i]) for i in range(len(poses))])
        return points.min(axis=0), points.max(axis=0)

    def pushes(self, pusher: Pusher) -> bool:
        """Tell whether a robot's force goes into the object: its arrow ends at the contact."""
        size = float(np.hypot(*pusher.force))
        turn = pusher.robot.direction
        way = pusher.force / size if size else np.nan_to_num([np.cos(turn), np.sin(turn)])
        outline = self.run.simulation.problem.swarm.outline
        return outline.contains(np.array(pusher.robot.contact) + PROBE * outline.extent * way)

    @property
    def origin(self) -> Vector:
        """The outline's origin (2,) [m, m] in the frame of its vertices."""
        return np.asarray(self.run.simulation.problem.swarm.outline.origin)

    @cached_property
    def robots(self) -> dict[str, Robot]:
        """All robots that ever hold the object, by name."""
        return {robot.name: robot for stint in self.run.stints for robot in stint.swarm}

    def _pushers(self, i: int) -> tuple[Pusher, ...]:
        """Return who holds the object, and how hard."""
        run, time = self.run, float(self.run.times[i])
        found = []
        stint = next((s for s in run.stints if s.start <= time < s.end), run.stints[-1])
        for name in stint.swarm.names:
            j = run.names.index(name)
            angle = float(run.angles[self.index, i, j])
            force = float(run.forces[self.index, i, j])
            way = np.nan_to_num(np.array([np.cos(angle), np.sin(angle)]))
            found.append(Pusher(self.robots[name], force * way))
        return tuple(found)

    def _last(self, time: float) -> Happening:
        """Return the last thing that happened."""
        return [h for h in self.run.happenings if h.time <= time or h is self.run.happenings[0]][-1]

    # -- robots on their way ----------------------------------------------------------------

    @cached_property
    def routes(self) -> tuple["Route", ...]:
        """The ways of all robots that are sent and join."""
        simulation, found = self.run.simulation, []
        joined = {h.robot: h.time for h in self.run.happenings if h.kind == "joined"}
        sends = [event for event in simulation.events if isinstance(event, Send)]
        for name, event in zip(simulation.joining, sends, strict=True):
            if name in joined and name in self.robots:
                arrival = max(joined[name] - event.make_fast, event.at)
                points = self._way(event, self.robots[name])
                found.append(Route(name, event.at, arrival, joined[name], points))
        return tuple(found)

    def _way(self, event: Send, robot: Robot) -> Vector:
        """Return the corners (k, 2) [m, m] of a robot's way in the frame of the object.

        Straight to the nearest point of the outline, and beside it the shorter way.
        """
        outline = self.run.simulation.problem.swarm.outline
        start = self.origin + event.away * np.array([np.cos(event.bearing), -np.sin(event.bearing)])
        _, (first, last) = outline.nearest(np.array([start, robot.contact]))
        way = (last - first + 0.5 * outline.perimeter) % outline.perimeter - 0.5 * outline.perimeter
        arcs = first + way * np.linspace(0.0, 1.0, 40)
        along = [outline.at_arc_length(float(arc) % outline.perimeter).point for arc in arcs]
        off = np.array(along) - self.origin
        far = off + ASIDE * outline.extent * off / np.maximum(np.hypot(*off.T), 1e-12)[:, None]
        return np.vstack([start - self.origin, far])

    def _travellers(self, time: float) -> tuple[tuple[str, Vector], ...]:
        """Return who is on the way, and where in the earth's frame."""
        i = int(np.searchsorted(self.run.times, time))
        pose = np.asarray(self.run.poses[self.index, i], float)
        return tuple(
            (route.robot, placed(route.at(time), pose)[0])
            for route in self.routes
            if route.start <= time < route.joined
        )


@dataclass(frozen=True)
class Route:
    """The way of a robot that is sent, as the object lies.

    Attributes
    ----------
    robot : str
    start, arrival, joined : float [s]
    points : (k, 2) [m, m]
        Corners, from the object's origin and in its frame.
    """

    robot: str
    start: float
    arrival: float
    joined: float
    points: Vector

    def at(self, time: float) -> Vector:
        """Return where it is (1, 2) [m, m]."""
        steps = np.hypot(*np.diff(self.points, axis=0).T)
        gone = np.concatenate([[0.0], np.cumsum(steps)])
        share = min(1.0, (time - self.start) / max(self.arrival - self.start, 1e-9))
        x, y = (np.interp(share * gone[-1], gone, column) for column in self.points.T)
        return np.array([[float(x), float(y)]])


def placed(points: ArrayLike, pose: ArrayLike) -> Vector:
    """Return points (k, 2) [m, m] of the object's frame where its pose (3,) puts them.

    Examples
    --------
    >>> placed([(1.0, 0.0)], (10.0, 5.0, np.pi / 2)).round(12).tolist()
    [[10.0, 6.0]]
    """
    x, y, heading = np.asarray(pose, float)
    cos, sin = np.cos(heading), np.sin(heading)
    turn = np.array([[cos, sin], [-sin, cos]])
    return np.asarray(np.asarray(points, float) @ turn + np.array([x, y]))
