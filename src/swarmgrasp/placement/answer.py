"""The answer to a placement: the robot, what it adds, and the proof."""

from dataclasses import dataclass, field
from functools import cached_property

from swarmgrasp.placement.certificate import Certificate
from swarmgrasp.placement.optimum import Optimum
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.reason import explain_placement, reason_of
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.verify import Verdict, verify_document


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
    tolerance : float
        By how much the bound may exceed the quality, relative to it, as asked for.
    stopped_early : bool
        Whether the search ran out of its budget before coming so near. The bound holds all
        the same.
    improves : bool
        Whether the newcomer raises the quality. If not, no allowed place does to within
        the gap, and `robot` is the one that lifts the other directions most.
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
    tolerance: float
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
        """By how much the bound exceeds the quality [N]."""
        return self.upper_bound - self.quality

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
