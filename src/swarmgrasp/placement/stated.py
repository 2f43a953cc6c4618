"""Placements as an answer file states them, as objects again: nothing is searched for."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from swarmgrasp.placement.answer import Placement, Placements, RunnerUp
from swarmgrasp.placement.certificate import BoxProof, Certificate, PatchProof, Proof, SpanProof
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.search import Optimum
from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.max_transfer import quality
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.swarm.choices import Choice


@dataclass(frozen=True, eq=False)
class _Stated(Optimum[RunnerUp]):
    """What a search found, by a file."""

    _certificate: Certificate = field(repr=False)

    @property
    def certificate(self) -> Certificate:
        """The proofs of all bounds."""
        return self._certificate


def placements_in(document: Mapping[str, Any]) -> Placements:
    """Return the placements that an answer file states.

    What they claim is as good as the file: check it first, with `verify_document`.

    Parameters
    ----------
    document : dict
        An answer file about placements, as `read_answer` gives it.

    Returns
    -------
    Placements

    Raises
    ------
    DataInvalid
        If a part of it is none.

    Examples
    --------
    >>> from swarmgrasp import Newcomer, Outline, Robot, Swarm, place
    >>> from swarmgrasp.answer_file import document_of
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> crew = [Robot((1, 0.3), 3.0), Robot((-1, 0.5), 0.4), Robot((0.2, -1), 1.7)]
    >>> answer = place(Swarm(square, crew), Newcomer(attachment="push"))
    >>> (stated,) = placements_in(document_of(answer))
    >>> stated.robot == answer.robot, stated.quality == answer.quality
    (True, True)
    >>> stated.reason == answer.reason
    True
    """
    problem, found = Problem.from_data(document["problem"]), list[Placement]()
    for claim in document["placements"]:
        found.append(_placement(problem, claim))
        problem = problem.with_swarm(found[-1].swarm_after)
    return Placements(found)


def _placement(problem: Problem, claim: Mapping[str, Any]) -> Placement:
    """Return one placement; beside robots with gaps between their sectors, with those kept."""
    choice = _choice(claim["choice"])
    held = None
    if choice is not None:
        kept = {problem.swarm.index(name): sector for name, sector in choice.sectors.items()}
        beside = problem.with_swarm(problem.swarm.choosing(kept))
        held = _placement(beside, {**claim, "choice": None, "choice_before": None})
    robot, swarm = Robot.from_data(claim["robot"]), problem.swarm
    before = _weakest(problem, swarm, claim["quality_before"])
    normals = -np.array([before.normal])
    base = swarm if held is None else held.problem.swarm
    return Placement(
        problem=problem,
        robot=robot,
        place=claim["place"],
        before=before,
        after=_weakest(problem, swarm.with_robot(robot), claim["quality"]),
        opposite=float(Aim(base, problem.criterion).values(normals)[0]),
        upper_bound=claim["upper_bound"],
        asked_gap=claim["asked_gap"],
        asked_runners_up=claim["asked_runners_up"],
        stopped_early=claim["stopped_early"],
        improves=claim["improves"],
        runners_up=tuple(map(RunnerUp.from_data, claim["runners_up"])),
        _found=_optimum(claim),
        choice_before=_choice(claim["choice_before"]),
        choice=choice,
        _held=held,
    )


def _weakest(problem: Problem, swarm: Swarm, value: float) -> Weakest:
    """Return a quality that is stated, with the direction in which a swarm is weakest."""
    x, y, z = quality(swarm, **problem.criterion.keywords).direction.tolist()
    return Weakest(value, (x, y, z))


def _choice(data: Any) -> Choice | None:
    """Return the sectors that are kept, if any are."""
    if data is None:
        return None
    return Choice({name: (lo, hi) for name, (lo, hi) in data["sectors"].items()}, data["is_best"])


def _optimum(claim: Mapping[str, Any]) -> _Stated:
    """Return what was found, with its proofs."""
    proofs = Certificate(
        tuple(map(Proof.from_data, claim["proofs"])),
        tuple(map(BoxProof.from_data, claim["boxes"])),
        tuple(map(SpanProof.from_data, claim["spans"])),
        tuple(map(PatchProof.from_data, claim["patches"])),
        claim["upper_bound"],
    )
    best = RunnerUp(Robot.from_data(claim["robot"]), claim["quality"], claim["place"])
    bounds = np.array([claim["upper_bound"]])
    is_solved = not claim["stopped_early"]
    return _Stated(is_solved, best, claim["upper_bound"], bounds, np.zeros((0, 3)), proofs)
