"""The answer to a placement: the robot, what it adds, and the proof."""

import math
from dataclasses import dataclass, field
from functools import cached_property

from swarmgrasp.placement.certificate import Certificate
from swarmgrasp.placement.optimum import Optimum
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.reason import explain_placement, reason_of
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.verify import Verdict, verify_document

COARSE = 1e-3
"""Gap above which an answer is the best found, and not called the best."""


def relative_gap(upper_bound: float, quality: float) -> float:
    """Return by how much a bound exceeds a quality, relative to it.

    Of no quality it is infinite, unless the bound is none either.

    Examples
    --------
    >>> relative_gap(1.25, 1.0), relative_gap(1.0, 0.0), relative_gap(0.0, 0.0)
    (0.25, inf, 0.0)
    """
    if upper_bound <= quality:
        return 0.0
    return (upper_bound - quality) / quality if quality > 0.0 else math.inf


@dataclass(frozen=True)
class RunnerUp:
    """The best robot in another place.

    Attributes
    ----------
    robot : Robot
    quality : float [N]
        Of the swarm with it.
    place : str
        The zone's name, or the edge's.
    """

    robot: Robot
    quality: float
    place: str


@dataclass(frozen=True, eq=False)
class Placement:
    """Where the newcomer goes.

    Attributes
    ----------
    problem : Problem
    robot : Robot
        The newcomer in contact, at its full limit (T6).
    place : str
        The zone's name, or the edge's.
    before, after : Weakest
        Quality and weakest normal of the swarm without and with it.
    opposite : float [N]
        The support function without it, opposite to the weakest normal.
    upper_bound : float [N]
        What no allowed robot exceeds.
    asked_gap : float
        The `gap` at which the search was to end.
    stopped_early : bool
        Whether the search ran out of its budget before coming so near. The bound holds all
        the same.
    improves : bool
        Whether the newcomer raises the quality, by more than the `noise`. If not, no allowed
        place does to within the gap, and `robot` is the one that lifts the other directions most.
    runners_up : tuple of RunnerUp
        Best first.
    """

    problem: Problem
    robot: Robot
    place: str
    before: Weakest
    after: Weakest
    opposite: float
    upper_bound: float
    asked_gap: float
    stopped_early: bool
    improves: bool
    runners_up: tuple[RunnerUp, ...]
    _found: Optimum = field(repr=False)

    @property
    def quality_before(self) -> float:
        """Quality of the swarm without the newcomer [N]."""
        return self.before.quality

    @property
    def quality(self) -> float:
        """Quality of the swarm with the newcomer [N]."""
        return self.after.quality

    @property
    def gap(self) -> float:
        """By how much the bound exceeds the quality, as `relative_gap` has it."""
        return relative_gap(self.upper_bound, self.quality)

    @property
    def is_open(self) -> bool:
        """Whether another place may be better by a share that matters."""
        if self.upper_bound - self.quality <= self.noise and not self.improves:
            return False
        return self.gap > COARSE and (self.quality > 0.0 or self.stopped_early)

    @property
    def noise(self) -> float:
        """By how much rounding in the outline's coordinates may change the quality [N] (T4)."""
        return self.problem.criterion.noise(self.swarm_after, self.after.normal)

    @property
    def reason(self) -> str:
        """What limits the answer, in words."""
        return reason_of(self)

    @property
    def explanation(self) -> str:
        """What limited the swarm, what the newcomer adds, the runner-up, the bound: in sentences.

        One per line; prose, and not checked by `verify`.
        """
        return explain_placement(self)

    @property
    def certificate(self) -> Certificate:
        """The proof that no allowed robot exceeds the bound."""
        return self._found.certificate

    @cached_property
    def swarm_after(self) -> Swarm:
        """The swarm with the newcomer."""
        return self.problem.swarm.with_robot(self.robot)

    def verify(self) -> Verdict:
        """Check everything this answer claims, by code that shares nothing with the search.

        Returns
        -------
        Verdict
            True in a condition when all claims hold; its faults say which do not. The
            reason is prose and is not checked.
        """
        from swarmgrasp.placement.document import document_of

        return verify_document(document_of(self))
