"""The answer of a simulation: where the object went, and what the robots did."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Told, picked
from swarmgrasp.simulation.sentences import sentence
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.swarm import Swarm
from swarmgrasp.telling import Telling
from swarmgrasp.visible import Visible

Array = NDArray[np.float64]
Kept = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class Stint(Frozen, Told):
    """Some time in which the same robots hold the object.

    Attributes
    ----------
    start, end : float [s]
    swarm : Swarm
        Who holds it, whether known or not: a robot that is lost is not among them.
    """

    start: float
    end: float
    swarm: Swarm


@dataclass(frozen=True, eq=False)
class Happening(Frozen, Told):
    """Something that happened, and what the robots are worth after it.

    Attributes
    ----------
    time : float [s]
    kind : str
        "start", "lost", "noticed", "left", "sent", "joined", "aim" or "weather".
    robot : str
        Whom it happened to, or "".
    words : str
        A sentence.
    swarm : Swarm
        Who holds the object after it.
    load : (3,) [N, N, N m]
        The mean load then, in the object's frame.
    quality : float [N]
        What they exert whatever the direction, in the metric, without any load.
    margin : float [N]
        The same beside the mean load; 0 if they do not hold it.
    shortfall : float [N]
        How far the mean load is out of their reach; 0 if they hold it.
    numbers : mapping of str to float
        What the sentence tells in numbers, in SI units. Of who is "sent" the place on the outline,
        `x` and `y`, the way there, `away`, and when it `joins`; of an "aim" `x`, `y`, `heading`,
        and of a path its `speed`; of the "weather" what changes, such as `wind_speed`.
    """

    time: float
    kind: str
    robot: str
    words: str
    swarm: Swarm
    load: Array
    quality: float
    margin: float
    shortfall: float
    numbers: Mapping[str, float] = field(default_factory=dict)

    def told(self, tell: Telling) -> str:
        """Return the sentence in the terms of its readers."""
        if not self.numbers:
            return self.words
        return sentence(self.kind, self.robot, self.numbers, tell)


@dataclass(frozen=True, eq=False)
class Run(Frozen, Told, Visible):
    """What became of a simulation, in one run for each seed.

    Numbers are kept at m instants. Of a robot that is not there, forces and shares are 0 and angles
    are nan.

    Attributes
    ----------
    simulation : Simulation
    seeds : (runs,) of int
    times : (m,) [s]
    references : (m, 3) [m, m, rad]
        Where the object is to be, in the earth's frame, headings counter-clockwise.
    poses : (runs, m, 3) [m, m, rad]
        Where it is; headings go on beyond pi.
    velocities : (runs, m, 3) [m/s, m/s, rad/s]
        Relative to the water, in the object's frame.
    distances : (runs, m) [m]
        The largest error of position since the instant before.
    turns : (runs, m) [rad]
        The largest error of heading since then.
    streams : (runs, m, 4) [m/s]
        Velocities x, y of the air and x, y of the water, in the earth's frame.
    loads : (runs, m, 3) [N, N, N m]
        Of wind and water, in the object's frame.
    wanted, given : (runs, m, 3) [N, N, N m]
        The wrench that the robots are to exert, and that they do.
    shortfalls : (runs, m) [N]
        How far what is wanted is out of reach, in the metric.
    names : tuple of str
        Of the n robots that ever take part.
    forces : (runs, m, n) [N]
        Those exerted; negative for the other way.
    angles : (runs, m, n) [rad]
        Where they point, in the object's frame.
    shares : (runs, m, n)
        What is asked of each as a part of its limit.
    stints : tuple of Stint
        Who was there when; they follow each other from 0 to the end.
    happenings : tuple of Happening
        In order; the first is the start.
    gusts : (runs,) [m/s]
        Standard deviation of the wind's speed about its mean.
    is_whole : bool
        Whether it was run to the end; otherwise it was stopped from the keyboard.
    """

    simulation: Simulation
    seeds: tuple[int, ...]
    times: Array
    references: Kept
    poses: Kept
    velocities: Kept
    distances: Kept
    turns: Kept
    streams: Kept
    loads: Kept
    wanted: Kept
    given: Kept
    shortfalls: Kept
    names: tuple[str, ...]
    forces: Kept
    angles: Kept
    shares: Kept
    stints: tuple[Stint, ...]
    happenings: tuple[Happening, ...]
    gusts: Array
    is_whole: bool

    def __len__(self) -> int:
        """Return the number of runs."""
        return len(self.seeds)

    def summary(self) -> dict[str, Any]:
        """Return as plain data what was simulated and what happened, without numbers in time."""
        asked = picked(self, "simulation", "seeds", "is_whole", "happenings", "gusts")
        return {**asked, "end": float(self.times[-1])}
