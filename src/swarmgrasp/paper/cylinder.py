"""The set that the paper lets a new robot choose from: |F| <= limit, |tau| <= limit r_max."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import NotInThePaper
from swarmgrasp.paper.all_pairs import facets
from swarmgrasp.placement import Problem
from swarmgrasp.quality.weakest import MARGINAL

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Cylinder:
    """A problem as the paper poses it: a swarm, and a cylinder of wrenches for the new robot.

    No robot can exert all of these wrenches: its torque is tied to its force (T7).

    Parameters
    ----------
    problem : Problem
        Of which only the swarm and the newcomer's limit matter here.

    Raises
    ------
    NotInThePaper
        If the problem has a criterion, or the swarm no facet to start from.
    """

    problem: Problem

    def __post_init__(self) -> None:
        """Check that the paper knows such a problem."""
        if not self.problem.criterion.is_nominal:
            raise NotInThePaper(
                f"the paper knows no quality {self.problem.criterion.words(self.problem.swarm)}; "
                "leave the criterion out, or use `place`"
            )
        if not len(self.normals):
            raise NotInThePaper(
                f"{len(self.base)} robots whose wrenches are all parallel have no facet to start "
                "from; there should be two that are not"
            )

    @property
    def base(self) -> Array:
        """(n, 3) [N]: the swarm's generators in the metric's coordinates."""
        return self.problem.swarm.scaled_generators

    @cached_property
    def _facets(self) -> tuple[Array, Array]:
        if len(self.base) < 2:
            return np.zeros((0, 3)), np.zeros(0)
        return facets(self.base)

    @property
    def normals(self) -> Array:
        """(m, 3): unit normals of the swarm's facets, both signs."""
        return self._facets[0]

    @property
    def heights(self) -> Array:
        """(m,) [N]: the distances of these facets from the origin."""
        return self._facets[1]

    @cached_property
    def size(self) -> Array:
        """(3,) [N]: half widths in the metric's coordinates; b = size * x for x in the unit one."""
        swarm = self.problem.swarm
        reach = np.array([1.0, 1.0, swarm.outline.radius])
        return np.asarray(self.problem.newcomer.limit * swarm.scale * reach)

    @property
    def longest(self) -> float:
        """Length of its longest wrench [N], which no quality rises by more than (T4)."""
        return float(np.hypot(self.size[:2].max(), self.size[2]))

    @property
    def closest(self) -> tuple[Array, float]:
        """The normal (3,) of the facet closest to the origin, and its distance: the quality [N]."""
        k = int(self.heights.argmin())
        height = float(self.heights[k])
        none = MARGINAL * float(np.linalg.norm(self.base, axis=1).sum())
        return self.normals[k], height if height > none else 0.0

    def inside(self, x: Array) -> Array:
        """Return a point (3,) shrunk into the unit cylinder where it leaves it."""
        force = x[:2] / max(1.0, float(np.hypot(x[0], x[1])))
        return np.append(force, np.clip(x[2], -1.0, 1.0))

    def on_boundary(self, direction: Array) -> Array:
        """Return where the ray of a direction (3,) [N] leaves the cylinder, as a unit one's x."""
        x = direction / self.size
        return np.asarray(x / max(np.hypot(x[0], x[1]), abs(x[2])))

    def wrench(self, x: Array) -> Array:
        """Return a point (3,) of the unit cylinder as a wrench for unit force [1, 1, m]."""
        return np.asarray(x * np.array([1.0, 1.0, self.problem.swarm.outline.radius]))
