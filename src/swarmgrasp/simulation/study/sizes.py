"""Quality against the number of robots, of random swarms."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.quality import qualities
from swarmgrasp.simulation.study.crowd_study import CrowdStudy
from swarmgrasp.simulation.study.study import (
    Ask,
    Column,
    ColumnHead,
    Findings,
    Seeds,
    in_words,
    told_rows,
)
from swarmgrasp.terms import SI, Terms


@dataclass(frozen=True)
class Sizes(CrowdStudy):
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

    def measure(self, seeds: Seeds) -> Mapping[str, ArrayLike]:
        """Draw a swarm for each seed, and measure its quality."""
        robots, quality = np.empty(len(seeds), dtype=int), np.empty(len(seeds))
        for alike, rows in self.swarms(seeds):
            robots[alike], quality[alike] = rows.shape[1], qualities(rows)
        return {"robots": robots, "quality": quality}

    def find(self, ask: Ask, terms: Terms = SI) -> Findings:
        """Sum up the swarms of each size."""
        rows = ask(
            "SELECT robots, count(*), avg((quality > 0)::INT), quantile_cont(quality, 0.1), "
            "quantile_cont(quality, 0.5), quantile_cont(quality, 0.9) "
            "FROM runs GROUP BY robots ORDER BY robots"
        )
        closed = next((row[0] for row in rows if row[2] >= 0.5), None)
        said = (
            f"At least half of the random swarms have force closure from "
            f"{closed} {terms.several} on"
            if closed is not None
            else f"Less than half of the random swarms of up to {terms.robots(self.most_robots)} "
            "have force closure"
        )
        return Findings(said, in_words(HEADINGS, terms), told_rows(rows))


HEADINGS = (
    ColumnHead("{robots}"),
    ColumnHead("runs"),
    ColumnHead("with force closure", "%"),
    ColumnHead("quality of 10 %", "N"),
    ColumnHead("median", "N"),
    ColumnHead("of 90 %", "N"),
)
