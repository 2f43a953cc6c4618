"""A scenario's own simulation, run after run with other gusts."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.errors import StudyInvalid
from swarmgrasp.ranges import kind_faults
from swarmgrasp.simulation.simulate import simulate
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.simulation.study.study import (
    Ask,
    Column,
    ColumnHead,
    Findings,
    Seeds,
    Study,
    told_rows,
)
from swarmgrasp.simulation.verdict import USUAL_TURN, usual_within, verdict_of
from swarmgrasp.telling import Telling
from swarmgrasp.terms import SI, Terms
from swarmgrasp.words import percent, span

PARTS = (0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 1.0)
"""Of the runs, that stay within what is told."""


@dataclass(frozen=True)
class Story(Study):
    """A simulation with all its events, each run with gusts and noise of its own.

    Attributes
    ----------
    simulation : Simulation
        Its seed is that of the run.

    Raises
    ------
    StudyInvalid
        If it is no `Simulation`.
    """

    simulation: Simulation

    kind: ClassVar[str] = "story"
    question: ClassVar[str] = "a simulation with other gusts in each run"
    batch: ClassVar[int] = 50
    size: ClassVar[int] = 100
    columns: ClassVar[Mapping[str, Column]] = {
        "seed": Column("count", "", "seed of the run: simulate it alone to see it"),
        "held": Column("flag", "", "whether it stayed within the usual limits"),
        "left_at": Column("number", "s", "when it was beyond them first"),
        "distance": Column("number", "m", "largest error of position"),
        "turn": Column("number", "rad", "largest error of heading"),
        "gusts": Column("number", "m/s", "standard deviation of the wind's speed"),
        "margin_over_spread": Column(
            "number", "", "margin at the start over the standard deviation of the gusts' load"
        ),
        "use": Column("number", "", "mean share of the robots"),
        "activity": Column("number", "1/s", "limits that the robots' forces pass in a second"),
    }

    def __post_init__(self) -> None:
        """Check the values."""
        faults = kind_faults(self.simulation, Simulation, "Simulation(problem, environment, hull)")
        if faults:
            raise StudyInvalid(faults)
        vars(self)["simulation"] = replace(self.simulation, seed=0)

    @property
    def within(self) -> float:
        """How far [m] the object may be, and be held."""
        return usual_within(self.simulation.problem.swarm.outline)

    def words(self, terms: Terms = SI) -> str:
        """Say what its runs are."""
        wind = self.simulation.environment.wind
        count = len(self.simulation.events)
        events = f"{count} event{'' if count == 1 else 's'}" if count else "no events"
        outline = self.simulation.problem.swarm.outline
        tell = Telling.of(terms, outline.extent, [])
        speed = f" in a mean wind of {tell.speed(wind.speed)}" if wind.speed is not None else ""
        return f"{span(self.simulation.duration)}{speed}, {events}"

    def measure(self, seeds: Seeds) -> Mapping[str, ArrayLike]:
        """Simulate a run for each seed, all in step."""
        run = simulate(self.simulation, seeds.tolist())
        told = verdict_of(run, self.within)
        return {
            "seed": seeds,
            "held": told.held,
            "left_at": told.left_at,
            "distance": run.distances.max(axis=1).astype(float),
            "turn": run.turns.max(axis=1).astype(float),
            "gusts": run.gusts,
            "margin_over_spread": np.where(np.isfinite(told.margins_over_spread),
                                           told.margins_over_spread, np.nan),
            "use": told.use,
            "activity": told.activity,
        }  # fmt: skip

    def find(self, ask: Ask, terms: Terms = SI) -> Findings:
        """Sum up the runs: within what how many of them stay."""
        parts = ", ".join(map(str, PARTS))
        names = "distance", "turn", "use"
        what = ", ".join(f"quantile_cont({name}, [{parts}])" for name in names)
        ((runs, held, *columns),) = ask(f"SELECT count(*), avg(held::INT), {what} FROM runs")
        if not runs:
            return Findings("No run was without a fault", HEADINGS, ())
        rows = list(zip(PARTS, *columns, strict=True))
        tell = Telling.of(terms, self.simulation.problem.swarm.outline.extent, [])
        limits = f"{tell.length.short(self.within)} and {math.degrees(USUAL_TURN):.3g} degrees"
        said = f"Within {limits} all the time in {percent(held)} of {runs} runs"
        return Findings(said, HEADINGS, told_rows(rows))


HEADINGS = (
    ColumnHead("of the runs", "%"),
    ColumnHead("are within", "m"),
    ColumnHead("and within", "deg"),
    ColumnHead("mean share at most", "%"),
)
