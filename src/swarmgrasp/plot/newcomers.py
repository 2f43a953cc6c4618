"""The newcomers of an answer: one after the other, together, or a robot that moves."""

from collections.abc import Sequence
from dataclasses import dataclass

from swarmgrasp.placement import Move, Placement, Problem, Together
from swarmgrasp.plot import written
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.words import TIMES

MOST_RUNNERS_UP = 8
"""The best runners-up of each newcomer that are labelled."""

Answer = Sequence[Placement] | Together | Move
"""What brings newcomers."""


@dataclass(frozen=True, eq=False)
class Newcomers:
    """Newcomers, and what they bring.

    Attributes
    ----------
    problem : Problem
    robots : tuple of Robot
    words : tuple of str
        What each of them brings.
    runners_up : tuple of (Robot, str)
        Other places, each with the quality there; "" for one that is not to be labelled.
    quality_before, quality : float [N]
    swarm_after : Swarm
        All robots, newcomers last.
    leaving : frozenset of int
        Indices of the robots that are elsewhere then.
    """

    problem: Problem
    robots: tuple[Robot, ...]
    words: tuple[str, ...]
    runners_up: tuple[tuple[Robot, str], ...]
    quality_before: float
    quality: float
    swarm_after: Swarm
    leaving: frozenset[int] = frozenset()

    @property
    def gain(self) -> str:
        """How they change the quality."""
        return written.gain(self.quality_before, self.quality, self.problem.criterion)


def newcomers_of(answer: Answer) -> Newcomers | None:
    """Return the newcomers of an answer; None where there are none.

    Parameters
    ----------
    answer : sequence of Placement, Together or swarmgrasp.Move
    """
    if isinstance(answer, Together):
        words = ("",) * len(answer.robots)
        return Newcomers(
            answer.problem, answer.robots, words, (),
            answer.quality_before, answer.quality, answer.swarm_after,
        )  # fmt: skip
    if isinstance(answer, Move):
        return _moved(answer) if answer.improves else None
    return _placed(answer) if answer else None


def _placed(answers: Sequence[Placement]) -> Newcomers:
    """Return robots placed one after the other, each with what it brings."""
    first, last = answers[0], answers[-1]
    criterion = first.problem.criterion
    others = [
        (runner.robot, _short(p, runner.quality) if rank < MOST_RUNNERS_UP else "")
        for p in answers
        for rank, runner in enumerate(p.runners_up)
    ]
    return Newcomers(
        first.problem,
        tuple(p.robot for p in answers),
        tuple(written.gain(p.quality_before, p.quality, criterion) for p in answers),
        tuple(others),
        first.quality_before,
        last.quality,
        last.swarm_after,
    )


def _moved(found: Move) -> Newcomers:
    """Return the robot that moves, where it then is."""
    best, swarm = found.best, found.problem.swarm
    gain = written.gain(found.quality_before, found.quality, found.problem.criterion)
    rest = swarm.without(best.name)
    return Newcomers(
        found.problem, (best.new,), (gain,), (), found.quality_before, found.quality,
        rest.with_robot(best.new), frozenset([swarm.index(best.name)]),
    )  # fmt: skip


def _short(placement: Placement, quality: float) -> str:
    """Return what a runner-up would have brought, in the unit of the answer."""
    text = written.quality(quality, placement.problem.criterion, placement.quality)
    return text.removesuffix(f" {TIMES}")
