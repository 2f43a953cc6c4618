"""One swarm that grows, each newcomer going where it thinks best by what it knows."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from swarmgrasp.agents.knowledge.beliefs import ALL, GAP, decide, known_in
from swarmgrasp.agents.knowledge.cases import Case, Generator
from swarmgrasp.agents.knowledge.unevenness import unevenness
from swarmgrasp.placement import place
from swarmgrasp.quality import quality
from swarmgrasp.swarm import Swarm

SUMMARY_GAP = 1e-4
"""Relative gap of a decision from a summary to the best by its lower bound."""


class Task(NamedTuple):
    """One draw of a case.

    Attributes
    ----------
    case : Case
    seed, draw : int
    """

    case: Case
    seed: int
    draw: int

    def draws(self, purpose: str = "") -> Generator:
        """Return the random numbers of the draw, of their own for each purpose."""
        words = f"{self.case.words}, {self.case.present}: {purpose}".encode()
        return np.random.default_rng([self.seed, self.draw, *words])


class Growth(NamedTuple):
    """A swarm that grew.

    Attributes
    ----------
    quality : float [N]
        The true one of all robots in the end.
    regrets : tuple of float [N]
        For each decision that rests on a belief: by how much the best place was better.
    bounds : tuple of float [N]
        What T30 says that it is at most, the gap of the decision itself included.
    """

    quality: float
    regrets: tuple[float, ...]
    bounds: tuple[float, ...]


def grow(task: Task) -> dict[str, Growth]:
    """Let the swarm of a draw grow, once with each knowledge; by name."""
    return {name: _grown(task, name) for name in known_in(task.case)}


def _grown(task: Task, name: str) -> Growth:
    """Let it grow with one of them."""
    case, draws = task.case, task.draws(name)
    swarm, regrets, bounds = case.start(task.draws()), [], []
    taken = case.taken(swarm.robots)
    for _ in range(case.final - case.present):
        robot, belief = decide(case, name, swarm, taken, draws)
        grown = swarm.with_robot(replace(robot, name=""))  # a swarm numbers its robots
        if name != ALL and belief is not None:
            best = place(case.question(swarm, taken), gap=GAP).quality
            spread = unevenness(swarm, belief)
            gap = GAP if isinstance(belief, Swarm) else SUMMARY_GAP
            regrets.append(max(best - quality(grown).value, 0.0))
            bounds.append(spread + 2.0 * gap * (best + spread))
        swarm, taken = grown, taken + case.taken([robot])
    return Growth(quality(swarm).value, tuple(regrets), tuple(bounds))
