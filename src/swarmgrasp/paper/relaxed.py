"""The best wrench in the paper's cylinder, with a bound: what Algorithm 1 looks for (T7)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.linear import minimise
from swarmgrasp.paper.cylinder import Cylinder
from swarmgrasp.placement import Problem
from swarmgrasp.quality.weakest import weakest_of

Array = NDArray[np.float64]

TANGENTS = 8
"""Of the disc |F| <= 1 that every program begins with; others are added where they matter."""
ADDED = 4
"""Facets added to a program at a time, the most violated ones."""
SLACK = 1e-9
"""What a program may miss of a constraint that it does not know yet."""
FLOOR = 1e-9
"""Gap, relative to the longest wrench, that is not worth closing."""
MOST_ROUNDS = 500
"""After so many the bound is what it is; some 30 are usual."""


@dataclass(frozen=True, eq=False)
class Relaxed:
    """The best wrench in the cylinder, which perhaps no robot can make.

    Attributes
    ----------
    wrench : (3,) [1, 1, m]
        Per newton of the newcomer's limit.
    quality : float [N]
        Of the swarm with it, exact.
    upper_bound : float [N]
        What no wrench in the cylinder exceeds.
    """

    wrench: Array
    quality: float
    upper_bound: float


def relaxed_optimum(problem: Problem, gap: float = 1e-6) -> Relaxed:
    """Find the best wrench in the paper's cylinder by cutting planes (T5, T9, T10).

    At a level m every known normal with h(n) <= m demands n . b >= t - h(n); the largest t that
    all of these allow is a linear program. The largest t, or m if that is more, bounds the
    quality. The exact quality at its solution is a lower bound, and gives a new normal.

    Parameters
    ----------
    problem : Problem
        Without a criterion; only its swarm and the newcomer's limit matter.
    gap : float
        Largest difference between bound and quality, relative to the quality.

    Raises
    ------
    NotInThePaper
        If the problem has a criterion, or the swarm has no facets.
    """
    program = _Program(Cylinder(problem))
    cylinder = program.cylinder
    normal, low = cylinder.closest
    best, high = cylinder.on_boundary(normal), low + cylinder.longest
    for _ in range(MOST_ROUNDS):
        if high - low <= max(gap * low, FLOOR * cylinder.longest):
            break
        level = 0.5 * (low + high)
        reached, x, tallest = program.solve(level)
        high = min(high, max(reached, tallest))
        if reached > level:
            x = cylinder.inside(x)
            found = weakest_of(np.vstack([cylinder.base, x * cylinder.size]))
            program.add(np.array(found.normal))
            if found.quality > low:
                low, best = found.quality, x
    return Relaxed(cylinder.wrench(best), low, max(high, low))


class _Program:
    """The linear programs over the unit cylinder, with the facets and tangents met so far.

    Parameters
    ----------
    cylinder : Cylinder
    """

    def __init__(self, cylinder: Cylinder) -> None:
        self.cylinder = cylinder
        self.slopes = cylinder.normals * cylinder.size
        self.heights = cylinder.heights
        self.used: list[int] = [int(self.heights.argmin())]
        turn = np.arange(TANGENTS) * (2.0 * np.pi / TANGENTS)
        self.tangents = np.column_stack([np.cos(turn), np.sin(turn)])

    def add(self, normal: Array) -> None:
        """Add a unit normal (3,) that the exact quality has found."""
        height = np.maximum(self.cylinder.base @ normal, 0.0).sum()
        self.slopes = np.vstack([self.slopes, normal * self.cylinder.size])
        self.heights = np.append(self.heights, height)
        self.used.append(len(self.heights) - 1)

    def solve(self, level: float) -> tuple[float, Array, float]:
        """Maximise t over (x, t), t <= h(n) + n . b for all normals with h(n) <= level.

        Returns
        -------
        t : float [N]
        x : (3,)
            Where it is attained, in the unit cylinder but for rounding.
        tallest : float [N]
            The largest h(n) that was asked.
        """
        low = self.heights <= level
        while True:
            chosen = [k for k in self.used if low[k]]
            t, x = self._largest(chosen)
            reach = np.where(low, self.heights + self.slopes @ x, np.inf)
            worst = np.argsort(reach)[:ADDED]
            missed = [int(k) for k in worst if reach[k] < t - SLACK * self.cylinder.longest]
            outside = float(np.hypot(x[0], x[1]))
            if not missed and outside <= 1.0 + SLACK:
                return t, x, float(self.heights[chosen].max())
            self.used += missed
            if outside > 1.0 + SLACK:
                self.tangents = np.vstack([self.tangents, x[:2] / outside])

    def _largest(self, chosen: list[int]) -> tuple[float, Array]:
        """Return the largest t and its x (3,) for the chosen facets."""
        disc = np.column_stack([self.tangents, np.zeros((len(self.tangents), 2))])
        facets = np.column_stack([-self.slopes[chosen], np.ones(len(chosen))])
        most = np.concatenate([np.ones(len(disc)), self.heights[chosen]])
        lower, upper = (-2.0, -2.0, -1.0, -np.inf), (2.0, 2.0, 1.0, np.inf)
        cost, matrix = (0.0, 0.0, 0.0, -1.0), np.vstack([disc, facets])
        solution = minimise(cost, matrix, rows=(-np.inf, most), columns=(lower, upper))
        return float(solution[3]), solution[:3]
