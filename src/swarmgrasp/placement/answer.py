"""The answer to a placement: the robot, what it adds, and the proof."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import Any, Self

from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import AnswerInvalid
from swarmgrasp.frozen import Frozen
from swarmgrasp.placement.certificate import Certificate
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.reason import explain_placement, reason_of
from swarmgrasp.placement.search import Optimum
from swarmgrasp.plain import Answer, Plain, picked, plain
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.ranges import items, kind_faults, shown
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.swarm.choices import Choice
from swarmgrasp.terms import SI, Terms
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
class RunnerUp(Plain):
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
class Placement(Frozen, Answer):
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
    asked_runners_up : float, optional
        The share of the best quality from which on other places were to be told.
    stopped_early : bool
        Whether the search came less near: it ran out of its budget, in units of work, or rounding
        hides the rest. The bound holds all the same. Qualities by a criterion have a budget, too:
        one that takes more is given as 0.
    improves : bool
        Whether the newcomer raises the quality, by more than the `noise`. If not, no allowed
        place does to within the gap, and `robot` is the one that lifts the other directions most.
    runners_up : tuple of RunnerUp
        Best first.
    choice_before, choice : Choice, optional
        The sectors kept without the newcomer and with it, where robots have gaps between theirs:
        all qualities told are with these; the upper bound is with the gaps filled, and
        `stopped_early` says, too, that it is not reached so.
    """

    problem: Problem
    robot: Robot
    place: str
    before: Weakest
    after: Weakest
    opposite: float
    upper_bound: float
    asked_gap: float
    asked_runners_up: float | None
    stopped_early: bool
    improves: bool
    runners_up: tuple[RunnerUp, ...]
    _found: Optimum[Any] = field(repr=False)
    choice_before: Choice | None = None
    choice: Choice | None = None
    _held: "Placement | None" = field(default=None, repr=False)
    """The same beside robots that keep those sectors, and have no gaps."""

    kind = "placements"

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
        return self.reason_in(SI)

    def reason_in(self, terms: Terms) -> str:
        """Return the same in other terms than ours."""
        if self._held is not None:
            return f"with the sectors kept, {reason_of(self._held, terms)}"
        return reason_of(self, terms)

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
        return verify_document(document_of(self))

    def to_data(self) -> dict[str, Any]:
        """Return question and answer as plain data: as of a sequence of one."""
        return Placements((self,)).to_data()

    def _found_data(self) -> dict[str, Any]:
        """Return the answer without its question as plain data."""
        return {
            **picked(
                self, "robot", "place", "quality_before", "quality", "upper_bound", "asked_gap",
                "asked_runners_up", "stopped_early", "improves", "reason", "runners_up",
                "choice_before", "choice",
            ),
            "proofs": plain(self.certificate.proofs),
            "boxes": plain(self.certificate.boxes),
            "spans": plain(self.certificate.spans),
            "patches": plain(self.certificate.patches),
        }  # fmt: skip


class Placements(tuple[Placement, ...], Answer):
    """Newcomers of one kind placed one after the other: each finds the robots of those before it.

    Raises
    ------
    AnswerInvalid
        If there is none, or they do not follow one from the other.
    """

    kind = "placements"

    def __new__(cls, answers: Iterable[Placement]) -> Self:
        """Check that they follow one from the other."""
        given = items(answers) or ()
        faults = [f for answer in given for f in kind_faults(answer, Placement, "place(...)")]
        if not given:
            faults.append(f"the answers are {shown(answers)}; give a list of at least one")
        if faults:
            raise AnswerInvalid(faults)
        made = super().__new__(cls, given)
        for before, after in pairwise(made):
            left = before.swarm_after
            if after.problem.swarm != left:
                raise AnswerInvalid(
                    f"{after.robot.name} was placed in another swarm than the one that "
                    f"{before.robot.name} joined: write them apart"
                )
            if after.problem != before.problem.with_swarm(left):
                raise AnswerInvalid(
                    f"{after.robot.name} answers another question than "
                    f"{before.robot.name}: write them apart"
                )
        return made

    def to_data(self) -> dict[str, Any]:
        """Return the first one's question, and what was found of each, as plain data."""
        return {
            "problem": self[0].problem.to_data(),
            "placements": [answer._found_data() for answer in self],
        }
