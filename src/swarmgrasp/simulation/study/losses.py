"""What the loss of a robot leaves, of random swarms."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

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
class Losses(CrowdStudy):
    """How random swarms bear the loss of one robot.

    Each run is a swarm of random robots that are all like the problem's newcomer, anywhere in its
    zones; each of them is lost in turn. Qualities are exact and nominal.

    Attributes
    ----------
    problem : Problem
        Its own robots, its spacing and its criterion are left out.
    fewest_robots, most_robots : int
        Robots in a swarm before the loss.

    Raises
    ------
    StudyInvalid
        If it is no `Problem`, or not 1 <= fewest_robots <= most_robots <= 1000; all faults at once.
    ForceSetUnsupported, NowhereToAttach
        As for `Crowds`.
    """

    fewest_robots: int = 5
    most_robots: int = 16

    kind: ClassVar[str] = "losses"
    question: ClassVar[str] = "what the loss of one robot leaves, of random swarms"
    batch: ClassVar[int] = 500
    size: ClassVar[int] = 10_000
    columns: ClassVar[Mapping[str, Column]] = {
        "robots": Column("count", "", "robots in the swarm"),
        "quality": Column("number", "N", "exact quality before"),
        "after": Column("number", "N", "exact quality after the worst loss of one robot"),
        "vital": Column("count", "", "robots whose loss leaves no force closure"),
    }

    def measure(self, seeds: Seeds) -> Mapping[str, ArrayLike]:
        """Draw a swarm for each seed, and lose each of its robots."""
        quality, after = np.empty(len(seeds)), np.empty(len(seeds))
        robots, vital = np.empty(len(seeds), dtype=int), np.empty(len(seeds), dtype=int)
        for alike, rows in self.swarms(seeds):
            left = qualities_after_losses(rows)
            robots[alike], quality[alike] = rows.shape[1], qualities(rows)
            after[alike], vital[alike] = left.min(axis=1), (left == 0.0).sum(axis=1)
        return {"robots": robots, "quality": quality, "after": after, "vital": vital}

    def find(self, ask: Ask, terms: Terms = SI) -> Findings:
        """Sum up the swarms of each size."""
        rows = ask(
            "SELECT robots, count(*), avg((quality > 0)::INT), avg((after > 0)::INT), "
            "avg(vital) FILTER (quality > 0), "
            "median(after / quality) FILTER (quality > 0) "
            "FROM runs GROUP BY robots ORDER BY robots"
        )
        kept = next((row[0] for row in rows if row[3] >= 0.5), None)
        said = (
            f"At least half of the random swarms bear the loss of any one {terms.robot} from "
            f"{kept} {terms.several} on"
            if kept is not None
            else f"Less than half of the random swarms of up to {terms.robots(self.most_robots)} "
            "bear the loss of any one"
        )
        return Findings(said, in_words(HEADINGS, terms), told_rows(rows))


HEADINGS = (
    ColumnHead("{robots}"),
    ColumnHead("runs"),
    ColumnHead("with force closure", "%"),
    ColumnHead("and after any loss", "%"),
    ColumnHead("vital {robots}, mean"),
    ColumnHead("left of the quality, median", "%"),
)


def qualities_after_losses(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the qualities (m, n) [N] of swarms (m, n, 3) [N] without each robot in turn."""
    m, n, _ = rows.shape
    others = np.array([[k for k in range(n) if k != lost] for lost in range(n)], dtype=int)
    without = rows[:, others.reshape(n, n - 1)].reshape(m * n, n - 1, 3)
    return qualities(without).reshape(m, n)
