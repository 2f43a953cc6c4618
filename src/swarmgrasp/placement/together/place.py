"""Several newcomers placed together: often more than one after the other (T17)."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from swarmgrasp.errors import NowhereToAttach, ProblemInvalid, refuse
from swarmgrasp.frozen import Frozen
from swarmgrasp.placement.answer import relative_gap
from swarmgrasp.placement.place import place_sequence, rise_of
from swarmgrasp.placement.problem import Problem, check_several, problem_faults
from swarmgrasp.placement.reason import too_few_words
from swarmgrasp.placement.together.effort import EFFORT, Budget, effort_faults
from swarmgrasp.placement.together.joint import JointSearch
from swarmgrasp.placement.together.stands import Stands
from swarmgrasp.plain import Answer, picked
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.ranges import call_faults, count_faults, gap_faults
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.terms import SI, Terms

GAP = 1e-3
"""Difference between bound and quality, relative to the quality, at which a search ends."""


@dataclass(frozen=True, eq=False)
class Together(Frozen, Answer):
    """Where several newcomers go together.

    Attributes
    ----------
    problem : Problem
        Its newcomer is one of them.
    robots : tuple of Robot
        The newcomers in contact, counter-clockwise along the boundary.
    places : tuple of str
        The zone's name, or the edge's, of each.
    before, after : Weakest
        Quality and weakest normal of the swarm without and with them.
    upper_bound : float [N]
        What no such newcomers exceed, wherever they attach.
    asked_gap : float
        The `gap` at which the search was to end.
    asked_effort : int
        The steps it was allowed.
    sequential : float [N]
        The quality of as many placed one after the other; nan if not all found a place.
    stopped_early : bool
        Whether the effort was spent before the bound came so near. The bound holds all the same.
    """

    problem: Problem
    robots: tuple[Robot, ...]
    places: tuple[str, ...]
    before: Weakest
    after: Weakest
    upper_bound: float
    asked_gap: float
    asked_effort: int
    sequential: float
    stopped_early: bool

    kind = "together"

    def to_data(self) -> dict[str, Any]:
        """Return question and answer as plain data."""
        return picked(
            self, "problem", "robots", "places", "quality_before", "quality", "upper_bound",
            "asked_gap", "asked_effort", "sequential", "stopped_early", "improves", "reason",
        )  # fmt: skip

    @property
    def quality_before(self) -> float:
        """Quality of the swarm without the newcomers [N]."""
        return self.before.quality

    @property
    def quality(self) -> float:
        """Quality of the swarm with the newcomers [N]."""
        return self.after.quality

    @property
    def gap(self) -> float:
        """By how much the bound exceeds the quality, as `relative_gap` has it."""
        return relative_gap(self.upper_bound, self.quality)

    @property
    def improves(self) -> bool:
        """Whether the newcomers raise the quality, by more than the `noise`."""
        rise = rise_of(self.problem.criterion)
        return self.quality > self.quality_before * (1.0 + rise) + self.noise

    @property
    def noise(self) -> float:
        """By how much rounding in the outline's coordinates may change the quality [N] (T4)."""
        return self.problem.criterion.noise(self.swarm_after, self.after.normal)

    def is_optimal(self, within: float | None = None) -> bool:
        """Tell whether no places are better by more than a share of the quality.

        Parameters
        ----------
        within : float, optional
            The `asked_gap` when left out.
        """
        return self.gap <= (self.asked_gap if within is None else within) + 1e-12

    @cached_property
    def swarm_after(self) -> Swarm:
        """The swarm with the newcomers."""
        return swarm_with(self.problem.swarm, self.robots)

    @property
    def reason(self) -> str:
        """What limits the answer, in words."""
        return self.reason_in(SI)

    def reason_in(self, terms: Terms) -> str:
        """Return the same in other terms than ours."""
        criterion = self.problem.criterion
        weakest = criterion.weakest_words(self.problem.swarm, self.after.normal)
        if self.improves:
            return f"what remains weakest is {weakest}"
        robots = len(self.problem.swarm) + len(self.robots)
        fewest = self.problem.fewest
        if self.upper_bound == 0.0 and robots < fewest:
            return too_few_words(fewest, criterion.losing, robots, "these", terms)
        count = len(self.robots)
        many = f"{count} such {terms.several}" if count > 1 else f"such {terms.robot}"
        if self.upper_bound == 0.0:
            return f"no {many} can give the swarm any quality, wherever they are: place more"
        if self.is_optimal():
            return f"no {many} can raise what is weakest, {weakest}: place more"
        return (
            f"no {many} that raise what is weakest, {weakest}, were found; whether there are any "
            "is not settled: allow more effort, or place more"
        )


def place_together(
    problem: Problem,
    count: int,
    *,
    gap: float = GAP,
    effort: int = EFFORT,
    progress: Callable[[float, float], object] | None = None,
) -> Together:
    """Place several newcomers of one kind at the same time.

    The quality is no longer quasi-concave (T17). Answers come from robots placed one after the
    other, from random ones and from relaxed solutions, all moved until no move helps. The bound
    comes from branch and bound over how many stand where, each share of them bounded by a linear
    program over split-up robots whose rows are normals of the exact quality. It holds for all
    allowed contacts and directions, not only for those of a grid.

    Parameters
    ----------
    problem : Problem
        Its newcomer is one of them; its spacing is kept among them, too.
    count : int
        How many, from 1 to 1000; up to about 20 in reasonable time.
    gap : float
        Ends the search when the bound exceeds the quality by no more than this share of it.
    effort : int
        Ends it anyway after so many steps; the answer is then `stopped_early`. A step is a linear
        program, or one newcomer placed exactly beside the others: about 2 ms for up to a dozen
        newcomers, more for more. The answer is the same on every machine.
    progress : callable, optional
        Called with the quality so far and the bound so far, now and then. If what it returns is
        true, the search ends there, and the answer is `stopped_early`.

    Returns
    -------
    Together

    Raises
    ------
    NowhereToAttach
        If the spacing leaves no room to so many, as far as was found.
    ProblemInvalid
        If an argument is outside its range; all faults at once.

    Examples
    --------
    From the square of theory section 7 three robots one after the other are no better than two;
    together they are, and the bound proves that nothing is better.

    >>> from math import pi
    >>> from swarmgrasp import Newcomer, Outline
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pulls = [((1, -0.4), 0), ((-1, 0.4), pi), ((-0.4, 1), pi / 2), ((0.4, -1), -pi / 2)]
    >>> four = Swarm(square, [Robot(c, a) for c, a in pulls], characteristic_length=1.0)
    >>> pulling = Newcomer(limit=1.0, attachment="pull", half_angle=0.0)
    >>> answer = place_together(Problem(four, pulling), 3)
    >>> round(answer.sequential, 3), round(answer.quality, 3), round(answer.upper_bound, 3)
    (0.953, 1.0, 1.0)
    """
    faults = problem_faults(problem) + count_faults(count) + effort_faults(effort)
    refuse((ProblemInvalid, faults + gap_faults(gap) + call_faults(progress)))
    check_several(problem, "placement together")
    search = JointSearch(problem, int(count), float(gap), Budget(int(effort)))
    sequential = start(search)
    search.run(progress)
    return answer_of(search, sequential)


def start(search: JointSearch) -> float:
    """Offer the newcomers placed one after the other; return their quality, or nan."""
    try:
        found = place_sequence(search.problem, search.count)
    except NowhereToAttach:
        return math.nan
    if search.count == 1:
        search.ceiling = found[-1].upper_bound
    robots = [answer.robot for answer in found]
    contacts, directions = [r.contact for r in robots], [r.direction for r in robots]
    search.offer(search.ground.stands_at(contacts, directions))
    return found[-1].quality


def answer_of(search: JointSearch, sequential: float) -> Together:
    """Return what a search has found.

    Raises
    ------
    NowhereToAttach
        If that is nothing.
    """
    if search.best.quality < 0.0:
        raise NowhereToAttach(
            f"no room was found for {search.count} robots at a spacing of "
            f"{search.problem.spacing:.9g} m: lessen it, widen the zones, or place fewer"
        )
    stands = _along_the_boundary(search)
    name = search.problem.newcomer.name or "newcomer"
    names = search.problem.swarm.names.fresh(name, search.count)
    after = search.gauge.exact(stands)
    bound = max(search.bound, after.quality)
    return Together(
        problem=search.problem,
        robots=search.ground.robots(stands, names),
        places=tuple(search.ground.pieces.each[piece].place for piece in stands.piece),
        before=search.gauge.before,
        after=after,
        upper_bound=bound,
        asked_gap=search.gap,
        asked_effort=search.budget.asked,
        sequential=sequential,
        stopped_early=not search.is_over,
    )


def swarm_with(swarm: Swarm, robots: tuple[Robot, ...]) -> Swarm:
    """Return a swarm with more robots."""
    for robot in robots:
        swarm = swarm.with_robot(robot)
    return swarm


def _along_the_boundary(search: JointSearch) -> Stands:
    """Return the best stands in the order of their contacts."""
    stands, outline = search.best.stands, search.ground.outline
    arcs = outline.corner_arc_lengths[search.ground.edges[stands.piece]] + stands.at[:, 0]
    return stands.take(np.lexsort([stands.at[:, 1], np.round(arcs, 9)]).tolist())
