"""Whether random swarms hold in gusts, against the margin that foretells it."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import StudyInvalid, refuse
from swarmgrasp.forces import forces
from swarmgrasp.quality import quality
from swarmgrasp.ranges import kind_faults
from swarmgrasp.simulation.simulate import Course
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.simulation.station import StationKeeping
from swarmgrasp.simulation.study.crowds import crowd_faults, crowds_of, like_words, question_of
from swarmgrasp.simulation.study.study import (
    Ask,
    Column,
    ColumnHead,
    Findings,
    Seeds,
    Study,
    draws_of,
    told_rows,
)
from swarmgrasp.simulation.verdict import usual_within, verdict_of
from swarmgrasp.simulation.weather import CALM, Mean, Weather, mean_of
from swarmgrasp.telling import Telling
from swarmgrasp.terms import SI, Terms
from swarmgrasp.words import span

Array = NDArray[np.float64]
SELDOM = 100_000
"""Of so many periods of control one is kept: what is told is the largest error since the last."""
EDGES = (-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0)
"""Of the classes of margin over spread that are told apart; the outer ones are open."""


@dataclass(frozen=True)
class Gusts(Study):
    """Success against margin: which random swarms hold the object in gusts from anywhere.

    Each batch is a swarm of random robots that are all like the problem's newcomer; each run of it
    has a bearing that the weather comes from, and gusts, of its own. The gusts' load goes with the
    square of the wind's speed: its spread is twice the mean wind's load times the relative one of
    the speed.

    Attributes
    ----------
    simulation : Simulation
        Its robots, its events, its seed and where the wind comes from are left out; so is where the
        current comes from, which goes with the wind. The gusts are those of NPD's spectrum.
    fewest_robots, most_robots : int
        Robots in a swarm.

    Raises
    ------
    StudyInvalid
        If it is no `Simulation`, or not 1 <= fewest_robots <= most_robots <= 1000.
    ForceSetUnsupported, NowhereToAttach
        As for `Crowds`.
    """

    simulation: Simulation
    fewest_robots: int = 6
    most_robots: int = 12

    kind: ClassVar[str] = "gusts"
    question: ClassVar[str] = "whether random swarms hold in gusts, against their margin"
    batch: ClassVar[int] = 20
    size: ClassVar[int] = 20
    columns: ClassVar[Mapping[str, Column]] = {
        "robots": Column("count", "", "robots in the swarm"),
        "bearing": Column("number", "rad", "where the weather comes from, clockwise from the bow"),
        "quality": Column("number", "N", "quality without any load"),
        "margin": Column("number", "N", "quality beside the mean load; below 0 what is missing"),
        "spread": Column("number", "N", "standard deviation of the gusts' load"),
        "held": Column("flag", "", "whether it stayed within the usual limits"),
        "distance": Column("number", "m", "largest error of position"),
        "turn": Column("number", "rad", "largest error of heading"),
    }

    def __post_init__(self) -> None:
        """Check the values."""
        faults = kind_faults(self.simulation, Simulation, "Simulation(problem, environment, hull)")
        if not faults:
            faults = crowd_faults(self.simulation.problem, self.fewest_robots, self.most_robots)
        refuse((StudyInvalid, faults))
        given, environment = self.simulation, self.simulation.environment
        current = environment.current and replace(environment.current, bearing=None)
        wind = replace(environment.wind, speed=environment.wind.speed or 0.0, bearing=0.0)
        vars(self)["simulation"] = replace(
            given, problem=question_of(given.problem), events=(), actuators=(), seed=0,
            weather=Weather("npd"), environment=replace(environment, wind=wind, current=current),
        )  # fmt: skip
        crowds_of(self.simulation.problem)

    def words(self, terms: Terms = SI) -> str:
        """Say of what swarms it is, and in which wind."""
        problem, speed = self.simulation.problem, self.simulation.environment.wind.speed or 0.0
        wind = Telling.of(terms, problem.swarm.outline.extent, []).speed(speed)
        return (
            f"{self.fewest_robots} to {self.most_robots} {like_words(problem, terms)}, "
            f"{span(self.simulation.duration)} in gusts about {wind} from anywhere"
        )

    def drawn(self, seeds: Seeds) -> tuple[Simulation, Array]:
        """Return the simulation that a batch of seeds is of, and the bearing [rad] of each run."""
        draws, given = draws_of(seeds), self.simulation
        robots = int(draws.integers(self.fewest_robots, self.most_robots, endpoint=True))
        swarm = crowds_of(given.problem).swarm(draws, robots)
        bearings = draws.uniform(0.0, math.tau, len(seeds))
        return replace(given, problem=given.problem.with_swarm(swarm)), bearings

    def measure(self, seeds: Seeds) -> Mapping[str, ArrayLike]:
        """Draw a swarm, and simulate it in weather from a bearing for each seed."""
        asked, bearings = self.drawn(seeds)
        swarm, runs = asked.problem.swarm, len(seeds)
        mean = Mean(*(np.full(runs, value) for value in mean_of(asked.environment)))
        mean = mean._replace(wind_bearing=bearings, current_bearing=bearings)
        run = Course(asked, tuple(seeds.tolist()), mean, StationKeeping(), SELDOM).run(None)
        told = [_foretold(asked, bearing) for bearing in bearings.tolist()]
        speed = max(float(mean.wind_speed[0]), CALM)
        return {
            "robots": np.full(runs, len(swarm)),
            "bearing": bearings,
            "quality": np.full(runs, quality(swarm).value),
            "margin": [margin for margin, _ in told],
            "spread": np.array([wind for _, wind in told]) * 2.0 / speed * run.gusts,
            "held": verdict_of(run, usual_within(swarm.outline)).held,
            "distance": run.distances.max(axis=1).astype(float),
            "turn": run.turns.max(axis=1).astype(float),
        }

    def find(self, ask: Ask, terms: Terms = SI) -> Findings:  # noqa: ARG002 (it names no robots)
        """Sum up the runs of each class, and how well numbers tell success from failure."""
        over = "margin / nullif(spread, 0)"
        classes = " + ".join(f"({over} >= {edge})::INT" for edge in EDGES)
        rows = ask(
            f"SELECT {classes} AS class, count(*), avg(held::INT), "
            "median(distance), quantile_cont(distance, 0.9) "
            "FROM runs WHERE spread > 0 GROUP BY class ORDER BY class"
        )
        ends = (-math.inf, *EDGES, math.inf)
        told = [(ends[int(c)], ends[int(c) + 1], *rest) for c, *rest in rows]
        well = {name: _area(ask, what) for name, what in (("m", over), ("q", "quality"))}
        said = (
            f"Margin over the gusts' spread tells who holds from who does not with an area of "
            f"{well['m']:.3f} under the curve, plain quality with {well['q']:.3f}"
            if math.isfinite(well["m"])
            else "All runs held, or none"
        )
        return Findings(said, HEADINGS, told_rows(told))


HEADINGS = (
    ColumnHead("margin over spread from"),
    ColumnHead("to"),
    ColumnHead("runs"),
    ColumnHead("held", "%"),
    ColumnHead("largest error, median", "m"),
    ColumnHead("of 90 %", "m"),
)


def _area(ask: Ask, what: str) -> float:
    """Return how often a run that held has the larger number than one that did not; nan if all did.

    Ties count half: the area under the receiver operating characteristic, by ranks.
    """
    ((area,),) = ask(
        f"WITH ranked AS (SELECT held, {what} AS value FROM runs WHERE spread > 0), "
        "placed AS (SELECT held, rank() OVER (ORDER BY value) "
        "+ (count(*) OVER (PARTITION BY value) - 1) / 2 AS place FROM ranked) "
        "SELECT (sum(place) FILTER (held) - n1 * (n1 + 1) / 2) / nullif(n1 * n0, 0) FROM placed, "
        "(SELECT count(*) FILTER (held) AS n1, count(*) FILTER (NOT held) AS n0 FROM ranked) "
        "GROUP BY n1, n0"
    ) or ((None,),)
    return math.nan if area is None else float(area)


def _foretold(asked: Simulation, bearing: float) -> tuple[float, float]:
    """Return the margin [N] beside the mean load from a bearing, and the size [N] of the wind's.

    Both are in the metric; what is missing of the load is a margin below 0.
    """
    swarm, weather = asked.problem.swarm, asked.environment
    wind = weather.wind.load(swarm.outline, bearing, weather.wind.speed or 0.0)
    load = wind + replace(weather, dynamic_factor=1.0).current_load(swarm.outline, bearing)
    margin = quality(swarm, load=tuple(load.tolist())).value
    if margin == 0.0:
        margin = -forces(swarm, np.zeros(3), load=load).shortfall
    return margin, float(np.linalg.norm(wind * swarm.scale))
