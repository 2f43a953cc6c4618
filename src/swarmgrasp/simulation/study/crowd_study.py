"""What studies of random swarms have in common: whom they draw, and how many."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import StudyInvalid, refuse
from swarmgrasp.placement import Problem
from swarmgrasp.simulation.study.crowds import crowd_faults, crowds_of, like_words, question_of
from swarmgrasp.simulation.study.study import Seeds, Study, draws_of
from swarmgrasp.terms import SI, Terms

Array = NDArray[np.float64]


@dataclass(frozen=True)
class CrowdStudy(Study):
    """A study of random swarms, whose robots are all like the newcomer of a problem.

    Attributes
    ----------
    problem : Problem
        Its own robots are left out.
    fewest_robots, most_robots : int
        Robots in a swarm; one number is as likely as another.

    Raises
    ------
    StudyInvalid
        If it is no `Problem`, or not 1 <= fewest_robots <= most_robots <= 1000; all faults at once.
    ForceSetUnsupported, NowhereToAttach
        As for `Crowds`.
    """

    problem: Problem
    fewest_robots: int
    most_robots: int

    def __post_init__(self) -> None:
        """Check the values."""
        refuse((StudyInvalid, self._faults()))
        vars(self)["problem"] = question_of(self.problem)
        crowds_of(self.problem)

    def _faults(self) -> list[str]:
        """Return what is wrong with the values."""
        return crowd_faults(self.problem, self.fewest_robots, self.most_robots)

    def words(self, terms: Terms = SI) -> str:
        """Say of what swarms it is."""
        return f"{self.fewest_robots} to {self.most_robots} {like_words(self.problem, terms)}"

    def swarms(self, seeds: Seeds) -> Iterator[tuple[NDArray[np.bool_], Array]]:
        """Draw a swarm for each seed; yield those of n robots at a time, fewest first.

        Yields
        ------
        alike : (k,)
            Which of the seeds they are of.
        generators : (m, n, 3) [N]
            In the metric's coordinates.
        """
        draws, crowds = draws_of(seeds), crowds_of(self.problem)
        robots = draws.integers(self.fewest_robots, self.most_robots, len(seeds), endpoint=True)
        for count in np.unique(robots).tolist():
            alike = robots == count
            yield alike, crowds.generators(crowds.draw(draws, (int(alike.sum()), count)))
