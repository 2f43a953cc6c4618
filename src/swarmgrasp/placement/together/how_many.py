"""The fewest robots of a kind that bring a required quality."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from swarmgrasp.errors import NowhereToAttach, ProblemInvalid, refuse
from swarmgrasp.frozen import Frozen
from swarmgrasp.placement.place import place_sequence
from swarmgrasp.placement.problem import Problem, check_several, problem_faults
from swarmgrasp.placement.together.effort import EFFORT, Budget, effort_faults
from swarmgrasp.placement.together.joint import JointSearch
from swarmgrasp.placement.together.place import (
    Together,
    answer_of,
    start,
)
from swarmgrasp.plain import Answer, picked
from swarmgrasp.ranges import call_faults, count_faults, number, shown
from swarmgrasp.swarm import Swarm
from swarmgrasp.terms import SI, Terms

MOST = 20
"""Robots tried unless told otherwise."""
SLICE = 0.5
"""Share of the steps left that goes to one number of robots."""
MET = 1e-9
"""Share of the required quality that may be missing, by rounding."""


@dataclass(frozen=True, eq=False)
class HowMany(Frozen, Answer):
    """How many robots a required quality takes.

    Attributes
    ----------
    problem : Problem
    required : float [N]
        The quality asked for.
    count : int or None
        Of robots with which it was reached; None if no number up to `most` was found.
    at_least : int
        No fewer robots reach it, wherever they attach.
    most : int
        The largest number looked at.
    asked_effort : int
        The steps that the search was allowed.
    answer : Together or None
        Where they go; None if there are none, or none are needed.
    quality_before : float [N]
        Without them.
    """

    problem: Problem
    required: float
    count: int | None
    at_least: int
    most: int
    asked_effort: int
    answer: Together | None
    quality_before: float

    kind = "count"

    def to_data(self) -> dict[str, Any]:
        """Return question and answer as plain data."""
        told = picked(
            self, "problem", "required", "count", "at_least", "most", "asked_effort", "is_proven",
            "quality_before", "quality", "reason",
        )  # fmt: skip
        found = ("robots", "places", "upper_bound")
        return {**told, "answer": None if self.answer is None else picked(self.answer, *found)}

    @property
    def is_proven(self) -> bool:
        """Whether the number is certainly the fewest, or certainly none up to `most` is enough."""
        return self.at_least > self.most if self.count is None else self.count == self.at_least

    @property
    def quality(self) -> float:
        """The quality reached [N]: at least the required one if there is a `count`."""
        return self.quality_before if self.answer is None else self.answer.quality

    @property
    def swarm_after(self) -> Swarm:
        """The swarm with the robots found."""
        return self.problem.swarm if self.answer is None else self.answer.swarm_after

    @property
    def reason(self) -> str:
        """How sure the number is, in words."""
        return self.reason_in(SI)

    def reason_in(self, terms: Terms) -> str:
        """Return the same in other terms than ours."""
        some = terms.robots
        if self.count == 0:
            return "the swarm has that quality already"
        if self.count is None and self.is_proven:
            return f"{some(self.most)} cannot reach it, wherever they attach"
        least = f"no fewer than {some(self.at_least)} can, wherever they attach"
        if self.count is None:
            return f"no places for up to {some(self.most)} that reach it were found; {least}"
        if self.is_proven:
            fewer = self.count - 1
            return f"{some(self.count)} can, {fewer or 'none'} cannot, wherever they attach"
        last = self.count - 1
        open_ = f"{last}" if self.at_least == last else f"{self.at_least} to {last}"
        return f"{some(self.count)} can; {least}; whether {open_} can is not settled"


def how_many(
    problem: Problem,
    quality: float,
    *,
    most: int = MOST,
    effort: int = EFFORT,
    progress: Callable[[int, int], object] | None = None,
) -> HowMany:
    """Find the fewest newcomers with which the quality reaches a required one.

    One number after the other is tried: from the first that a relaxed bound allows, to the one
    that robots placed one after the other take. Each is either reached, or ruled out by the
    bound of `place_together`, or left open when its share of the effort is spent.

    Parameters
    ----------
    problem : Problem
        Its newcomer is one of them.
    quality : float [N]
        Required; without a unit if the problem's criterion has a task.
    most : int
        How many to allow, from 1 to 1000.
    effort : int
        Steps of the whole search, as for `place_together`.
    progress : callable, optional
        Called with the number that is being tried and the one known to be enough, which is beyond
        `most` if none is, now and then. If what it returns is true, the search ends there.

    Returns
    -------
    HowMany

    Raises
    ------
    NowhereToAttach
        If there is no place for a single one.
    ProblemInvalid
        If an argument is outside its range; all faults at once.

    Examples
    --------
    >>> from math import pi
    >>> from swarmgrasp import Newcomer, Outline, Robot
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pulls = [((1, -0.4), 0), ((-1, 0.4), pi), ((-0.4, 1), pi / 2), ((0.4, -1), -pi / 2)]
    >>> four = Swarm(square, [Robot(c, a) for c, a in pulls], characteristic_length=1.0)
    >>> found = how_many(Problem(four, Newcomer(1.0, "pull", 0.0)), 2.0)
    >>> found.count, found.is_proven, found.reason
    (4, True, '4 robots can, 3 cannot, wherever they attach')
    """
    faults = problem_faults(problem) + effort_faults(effort)
    faults += count_faults(most, "the most robots to try") + call_faults(progress)
    if not number(quality) > 0.0:
        faults.append(f"the quality is {shown(quality)}; it should be 0 < quality < inf [N]")
    refuse((ProblemInvalid, faults))
    check_several(problem, "the count")
    return _Count(problem, float(quality), int(most), Budget(int(effort)), progress).found()


class _Count:
    """One question on its way to an answer."""

    def __init__(
        self, problem: Problem, quality: float, most: int, budget: Budget,
        progress: Callable[[int, int], object] | None,
    ) -> None:  # fmt: skip
        self.problem, self.required, self.most = problem, quality, most
        self.progress, self.is_stopped = progress, False
        self.enough = quality * (1.0 - MET)
        self.budget = budget
        self.before = self.search_for(1, budget).gauge.before.quality

    def found(self) -> HowMany:
        """Try one number after the other."""
        if self.before >= self.enough:
            return self.told(0, 0, None)
        least = self.at_least()
        reached = self.one_after_the_other()
        is_settled = True
        for count in range(least, min(reached, self.most + 1)):
            slice_ = Budget(int(SLICE * max(self.budget.left, 0)))
            self.budget.left -= slice_.left
            search = self.search_for(count, slice_)
            sequential = start(search)
            search.run(lambda *_, count=count, reached=reached: self._told(count, reached))
            self.budget.left += slice_.left
            if search.best.quality >= self.enough:
                return self.told(count, least, answer_of(search, sequential))
            is_settled &= search.bound < self.enough
            least += is_settled
            if self.is_stopped:
                break
        if reached > self.most:
            return self.told(None, least, None)
        search = self.search_for(reached, Budget(0))
        return self.told(reached, least, answer_of(search, start(search)))

    def _told(self, count: int, reached: int) -> bool:
        """Tell what is being tried; return whether to stop."""
        if self.progress is not None and self.progress(count, reached):
            self.is_stopped = True
        return self.is_stopped

    def told(self, count: int | None, least: int, answer: Together | None) -> HowMany:
        """Return an answer."""
        return HowMany(
            self.problem,
            self.required,
            count,
            least,
            self.most,
            self.budget.asked,
            answer,
            self.before,
        )

    def search_for(self, count: int, budget: Budget) -> JointSearch:
        """Return the search for places of so many."""
        return JointSearch(self.problem, count, MET, budget, self.enough)

    def at_least(self) -> int:
        """Return the first number that a relaxed bound does not rule out, or one beyond `most`.

        What is beyond the reach of some is beyond that of fewer.
        """
        low, high = 1, self.most + 1
        while low < high:
            middle = (low + high) // 2
            search = self.search_for(middle, self.budget)
            if search.has_room:
                search.branches.step(-math.inf)
            if search.has_room and search.bound < self.enough:
                low = middle + 1
            else:
                high = middle
        return low

    def one_after_the_other(self) -> int:
        """Return how many it takes when each is placed after the others; too many if none do."""
        problem = self.problem
        for count in range(1, self.most + 1):
            self.budget.spend()
            try:
                (answer,) = place_sequence(problem, 1)
            except NowhereToAttach:
                break
            if answer.quality >= self.enough:
                return count
            problem = problem.with_swarm(answer.swarm_after)
        return self.most + 1
