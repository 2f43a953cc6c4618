"""What the loss of a robot leaves, of random swarms."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

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
class Losses(Study):
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

    problem: Problem
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
        """Draw a swarm for each seed, and lose each of its robots."""
        draws, crowds = draws_of(seeds), crowds_of(self.problem)
        robots = draws.integers(self.fewest_robots, self.most_robots, len(seeds), endpoint=True)
        quality, after = np.empty(len(seeds)), np.empty(len(seeds))
        vital = np.empty(len(seeds), dtype=int)
        for count in np.unique(robots).tolist():
            alike = robots == count
            rows = crowds.generators(crowds.draw(draws, (int(alike.sum()), count)))
            left = qualities_after_losses(rows)
            quality[alike], after[alike] = qualities(rows), left.min(axis=1)
            vital[alike] = (left == 0.0).sum(axis=1)
        return {"robots": robots, "quality": quality, "after": after, "vital": vital}

    def find(self, ask: Ask) -> Findings:
        """Sum up the swarms of each size."""
        rows = ask(
            "SELECT robots, count(*), avg((quality > 0)::INT), avg((after > 0)::INT), "
            "avg(vital) FILTER (quality > 0), "
            "median(after / quality) FILTER (quality > 0) "
            "FROM runs GROUP BY robots ORDER BY robots"
        )
        kept = next((row[0] for row in rows if row[3] >= 0.5), None)
        said = (
            f"At least half of the random swarms bear the loss of any one robot from {kept} robots "
            "on"
            if kept is not None
            else f"Less than half of the random swarms of up to {self.most_robots} robots bear the "
            "loss of any one"
        )
        return Findings(said, HEADINGS, told_rows(rows))


HEADINGS = (
    Heading("robots"),
    Heading("runs"),
    Heading("with force closure", "%"),
    Heading("and after any loss", "%"),
    Heading("vital robots, mean"),
    Heading("left of the quality, median", "%"),
)


def qualities_after_losses(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the qualities (m, n) [N] of swarms (m, n, 3) [N] without each robot in turn."""
    m, n, _ = rows.shape
    others = np.array([[k for k in range(n) if k != lost] for lost in range(n)], dtype=int)
    without = rows[:, others.reshape(n, n - 1)].reshape(m * n, n - 1, 3)
    return qualities(without).reshape(m, n)
