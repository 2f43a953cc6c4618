"""What the library is asked for one document: where the newcomer goes, and how well all hold."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

from swarmgrasp.errors import NowhereToAttach
from swarmgrasp.gui.reading import Question
from swarmgrasp.placement import Placement, Problem, place
from swarmgrasp.quality import Criterion, Polytope, Quality, quality
from swarmgrasp.swarm import Robot, Swarm

ABOUT = Literal["quality", "wind", "load"]
CALM = (0.0, 0.0, 0.0)
NO_ZONE = "no zone is left to the newcomer"


@dataclass(frozen=True)
class Found:
    """What was found of a question.

    Attributes
    ----------
    question : Question
    about : {"quality", "wind", "load"}
        What is best: the quality; where that is 0 everywhere, the wind held from its bearing, or
        how many times the load is held.
    placement : Placement or None
        By the criterion of `about`; None where there is nobody to place, or nowhere.
    before : float [N]
        The quality of the robots that are there, by the question's criterion.
    after : Quality
        With the newcomer in its place.
    nowhere : str
        Why there is no place; "" if there is, or nobody to place.
    """

    question: Question
    about: ABOUT
    placement: Placement | None
    before: float
    after: Quality
    nowhere: str = ""

    @property
    def problem(self) -> Problem:
        """The question as it was asked."""
        return self.question.problem

    @property
    def asked(self) -> Problem:
        """The question that was answered."""
        return self.placement.problem if self.placement is not None else self.problem

    @property
    def newcomer(self) -> Robot | None:
        """The newcomer in its place."""
        return self.placement.robot if self.placement is not None else None

    @cached_property
    def swarm(self) -> Swarm:
        """All that hold in the end."""
        if self.placement is None:
            return self.problem.swarm
        return self.placement.swarm_after

    @cached_property
    def values(self) -> tuple[float, float, float | None]:
        """What is told: before, after, and what no place exceeds.

        Qualities [N], winds [m/s], or how many times the load is held.
        """
        if self.placement is None:
            return self.after.value, self.after.value, None
        found = self.placement
        numbers = found.quality_before, found.quality, found.upper_bound
        if self.about == "wind":
            before, after, bound = map(math.sqrt, numbers)
            return before, after, bound
        return numbers


def ask(question: Question, share: float | None) -> Found:
    """Answer a question; where nothing is held, another one, so that there is an answer.

    Parameters
    ----------
    question : Question
    share : float, optional
        Of the best, from which on other places are told.
    """
    problem = question.problem
    keywords = problem.criterion.keywords
    if not question.places:
        return _judged(question, NO_ZONE if question.doc.newcomer else "")
    try:
        placement = place(problem, runners_up=share)
    except NowhereToAttach as error:
        return _judged(question, error.faults[0])
    before = placement.quality_before
    after = quality(placement.swarm_after, **keywords)
    if placement.quality > 0.0 or not problem.criterion.has_load:
        return Found(question, "quality", placement, before, after)
    for about, criterion in _others(question):
        other = place(replace(problem, criterion=criterion()), runners_up=share)
        if other.quality > 0.0:
            after = quality(other.swarm_after, **keywords)
            return Found(question, about, other, before, after)
    return Found(question, "quality", placement, before, after)


def _judged(question: Question, nowhere: str = "") -> Found:
    """Judge the robots that are there: there is nobody to place, or nowhere."""
    found = quality(question.problem.swarm, **question.problem.criterion.keywords)
    return Found(question, "quality", None, found.value, found, nowhere)


def _others(question: Question) -> list[tuple[ABOUT, Callable[[], Criterion]]]:
    """Return what else can be best where a load is not held."""
    environment, criterion = question.environment, question.problem.criterion
    asked: list[tuple[ABOUT, Callable[[], Criterion]]] = []
    outline = question.problem.swarm.outline
    if question.in_weather and environment is not None and environment.grows_with_square:
        bearing = environment.wind.bearing or 0.0

        def wind() -> Criterion:
            """Ask for the square of the wind."""
            x, y, turn = environment.load_in(outline, bearing, 0.0).tolist()
            task = Polytope([-environment.wind_load(outline, bearing, 1.0)])
            return replace(criterion, load=(x, y, turn), task=task)

        asked.append(("wind", wind))
    if criterion.task is None:
        asked.append(
            (
                "load",
                lambda: replace(
                    criterion, load=CALM, task=Polytope([tuple(-w for w in criterion.load)])
                ),
            )
        )
    return asked
