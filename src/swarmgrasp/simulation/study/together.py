"""Robots placed together against robots placed one after the other, beside random swarms."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from numpy.typing import ArrayLike

from swarmgrasp.placement import place_together
from swarmgrasp.placement.problem import check_several
from swarmgrasp.ranges import is_whole, shown
from swarmgrasp.simulation.study.crowd_study import CrowdStudy
from swarmgrasp.simulation.study.crowds import crowds_of
from swarmgrasp.simulation.study.study import (
    Ask,
    Column,
    ColumnHead,
    Findings,
    Seeds,
    draws_of,
    in_words,
    told_rows,
)
from swarmgrasp.terms import SI, Terms
from swarmgrasp.words import percent

MOST_NEWCOMERS = 12
GAP = 1e-2
"""Share of the quality at which a search ends: a gain above it is one of places, not of effort."""
EFFORT = 1000
"""Steps of a search; its bound tells what more of them could still bring."""


@dataclass(frozen=True)
class PlacedTogether(CrowdStudy):
    """What is lost by placing robots one after the other instead of together.

    Each run is a swarm of random robots that are all like the problem's newcomer, anywhere in its
    zones; as many newcomers as are asked for are placed beside it both ways, by the problem's
    spacing and criterion.

    Attributes
    ----------
    problem : Problem
        Its own robots are left out.
    fewest_robots, most_robots : int
        Robots there before.
    newcomers : int
        How many are placed.

    Raises
    ------
    StudyInvalid
        If it is no `Problem`, not 1 <= fewest_robots <= most_robots <= 1000, or not
        2 <= newcomers <= 12; all faults at once.
    ForceSetUnsupported, NowhereToAttach
        As for `Crowds`.
    """

    fewest_robots: int = 4
    most_robots: int = 8
    newcomers: int = 2

    kind: ClassVar[str] = "together"
    question: ClassVar[str] = "robots placed together against one after the other"
    batch: ClassVar[int] = 1
    size: ClassVar[int] = 5
    columns: ClassVar[Mapping[str, Column]] = {
        "robots": Column("count", "", "robots there before"),
        "before": Column("number", "N", "quality before"),
        "sequential": Column("number", "N", "quality with newcomers one after the other"),
        "together": Column("number", "N", "quality with newcomers placed together"),
        "bound": Column("number", "N", "what no places exceed"),
    }

    def __post_init__(self) -> None:
        """Check the values."""
        super().__post_init__()
        check_several(self.problem, "placement together")

    def _faults(self) -> list[str]:
        """Return what is wrong with the values."""
        faults = super()._faults()
        if not is_whole(self.newcomers) or not 2 <= self.newcomers <= MOST_NEWCOMERS:
            faults.append(
                f"the newcomers are {shown(self.newcomers)}; they should be a whole number from 2 "
                f"to {MOST_NEWCOMERS}"
            )
        return faults

    def words(self, terms: Terms = SI) -> str:
        """Say of what swarms it is."""
        return f"{self.newcomers} newcomers beside {super().words(terms)}"

    def measure(self, seeds: Seeds) -> Mapping[str, ArrayLike]:
        """Draw a swarm, and place newcomers beside it both ways."""
        draws = draws_of(seeds)
        robots = int(draws.integers(self.fewest_robots, self.most_robots, endpoint=True))
        swarm = crowds_of(self.problem).swarm(draws, robots)
        asked = self.problem.with_swarm(swarm)
        found = place_together(asked, self.newcomers, gap=GAP, effort=EFFORT)
        return {
            "robots": [robots],
            "before": [found.quality_before],
            "sequential": [found.sequential],
            "together": [found.quality],
            "bound": [found.upper_bound],
        }

    def find(self, ask: Ask, terms: Terms = SI) -> Findings:
        """Sum up the swarms of each size."""
        better = f"together > sequential * {1.0 + GAP} AND together > 0"
        gains = f"together / sequential - 1) FILTER ({better} AND sequential > 0"
        what = (
            f"count(*), avg(({better})::INT), median({gains}), max({gains}), "
            "avg((sequential = 0 AND together > 0)::INT), "
            f"avg((bound <= together * {1.0 + GAP} + 1e-9)::INT)"
        )
        rows = ask(f"SELECT robots, {what} FROM runs GROUP BY robots ORDER BY robots")
        ((runs, share, *_),) = ask(f"SELECT {what} FROM runs")
        said = (
            f"Placed together, {self.newcomers} newcomers are better by more than 1 % in "
            f"{percent(share or 0.0)} of {runs} random swarms"
        )
        return Findings(said, in_words(HEADINGS, terms), told_rows(rows))


HEADINGS = (
    ColumnHead("{robots} before"),
    ColumnHead("runs"),
    ColumnHead("better together", "%"),
    ColumnHead("then better by, median", "%"),
    ColumnHead("and at most", "%"),
    ColumnHead("force closure only together", "%"),
    ColumnHead("proven within 1 %", "%"),
)
