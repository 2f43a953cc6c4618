"""Quality against the number of robots, of random swarms."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.errors import StudyInvalid, refuse
from swarmgrasp.placement import Problem
from swarmgrasp.quality import qualities
from swarmgrasp.simulation.study.crowds import crowd_faults, crowds_of, like_words, question_of
from swarmgrasp.simulation.study.study import (
    Ask,
    Column,
    Findings,
    Heading,
    Seeds,
    Study,
    draws_of,
    told_rows,
)


@dataclass(frozen=True)
class Sizes(Study):
    """Quality against the number of robots.

    Each run is a swarm of random robots that are all like the problem's newcomer, anywhere in its
    zones; their number is as likely one as another. Quality is exact and nominal.

    Attributes
    ----------
    problem : Problem
        Its own robots, its spacing and its criterion are left out.
    fewest_robots, most_robots : int
        Robots in a swarm.

    Raises
    ------
    StudyInvalid
        If it is no `Problem`, or not 1 <= fewest_robots <= most_robots <= 1000; all faults at once.
    ForceSetUnsupported, NowhereToAttach
        As for `Crowds`.
    """

    problem: Problem
    fewest_robots: int = 4
    most_robots: int = 16

    kind: ClassVar[str] = "sizes"
    question: ClassVar[str] = "quality against the number of robots, of random swarms"
    batch: ClassVar[int] = 5_000
    size: ClassVar[int] = 50_000
    columns: ClassVar[Mapping[str, Column]] = {
        "robots": Column("count", "", "robots in the swarm"),
        "quality": Column("number", "N", "exact quality"),
    }

    def __post_init__(self) -> None:
        """Check the values."""
        refuse((StudyInvalid, crowd_faults(self.problem, self.fewest_robots, self.most_robots)))
        vars(self)["problem"] = question_of(self.problem)
        crowds_of(self.problem)

    @property
    def words(self) -> str:
        """Of what swarms it is."""
        return f"{self.fewest_robots} to {self.most_robots} {like_words(self.problem)}"

    def measure(self, seeds: Seeds) -> Mapping[str, ArrayLike]:
        """Draw a swarm for each seed, and measure its quality."""
        draws, crowds = draws_of(seeds), crowds_of(self.problem)
        robots = draws.integers(self.fewest_robots, self.most_robots, len(seeds), endpoint=True)
        quality = np.empty(len(seeds))
        for count in np.unique(robots).tolist():
            alike = robots == count
            crowd = crowds.draw(draws, (int(alike.sum()), count))
            quality[alike] = qualities(crowds.generators(crowd))
        return {"robots": robots, "quality": quality}

    def find(self, ask: Ask) -> Findings:
        """Sum up the swarms of each size."""
        rows = ask(
            "SELECT robots, count(*), avg((quality > 0)::INT), quantile_cont(quality, 0.1), "
            "quantile_cont(quality, 0.5), quantile_cont(quality, 0.9) "
            "FROM runs GROUP BY robots ORDER BY robots"
        )
        closed = next((row[0] for row in rows if row[2] >= 0.5), None)
        said = (
            f"At least half of the random swarms have force closure from {closed} robots on"
            if closed is not None
            else f"Less than half of the random swarms of up to {self.most_robots} robots have "
            "force closure"
        )
        return Findings(said, HEADINGS, told_rows(rows))


HEADINGS = (
    Heading("robots"),
    Heading("runs"),
    Heading("with force closure", "%"),
    Heading("quality of 10 %", "N"),
    Heading("median", "N"),
    Heading("of 90 %", "N"),
)
