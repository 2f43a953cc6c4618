"""What a criterion asks in each direction, over plain arrays: h(n), and the task's share of it."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

ON_FACET = 1e-9
"""Sine of the angle to a facet within which a generator counts as lying in it."""
FARTHEST = 1e-10
"""Distance along a normal, relative to the task's size, within which a vertex is the farthest."""


def _zeros() -> Array:
    return np.zeros(3)


def _no_rows() -> Array:
    return np.zeros((0, 3))


@dataclass(frozen=True, eq=False)
class Heights:
    """H(n), what the robots left can exert along n, and D(n), what the task asks (T15, T16).

    Attributes
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates; none is zero.
    load : (3,) [N]
        A wrench that is always there, in the metric's coordinates.
    losing : int
        H is what remains without the so many robots that add most.
    task : (m, 3)
        The vertices of a polytope or the axes of an ellipsoid; no rows: the unit ball.
    is_polytope : bool
    """

    generators: Array
    load: Array = field(default_factory=_zeros)
    losing: int = 0
    task: Array = field(default_factory=_no_rows)
    is_polytope: bool = True

    @cached_property
    def sizes(self) -> Array:
        """(n,) [N]: |b_i|."""
        return np.asarray(np.linalg.norm(self.generators, axis=1))

    @cached_property
    def weight(self) -> float:
        """The sum of |b_i|, and the load's size [N]: what rounding is relative to."""
        return float(self.sizes.sum() + np.linalg.norm(self.load))

    def products(self, normals: Array) -> Array:
        """Compute n . b_i for unit normals (m, 3): (m, n) [N], exactly 0 for those on a facet."""
        found = normals @ self.generators.T
        found[np.abs(found) <= ON_FACET * self.sizes] = 0.0
        return np.asarray(found)

    def at(self, normals: Array) -> tuple[Array, Array]:
        """Compute H at unit normals (m, 3).

        Returns
        -------
        heights : (m,) [N]
        weights : (m,) [N]
            What the rounding of each is relative to: the size of what was added up.
        """
        products = np.maximum(self.products(normals), 0.0)
        weights = (products > 0.0) @ self.sizes + np.linalg.norm(self.load)
        heights = normals @ self.load + products.sum(axis=1) - largest(products, self.losing)
        return heights, weights

    def asked(self, normals: Array) -> Array:
        """Compute D at normals (m, 3): (m,)."""
        if not len(self.task):
            return np.asarray(np.linalg.norm(normals, axis=1))
        reached = normals @ self.task.T
        if self.is_polytope:
            return np.asarray(np.maximum(reached.max(axis=1), 0.0))
        return np.asarray(np.linalg.norm(reached, axis=1))

    def asked_slopes(self, normal: Array, steps: Array) -> Array:
        """Compute how D rises from a unit normal along steps (m, 3) across it: (m,)."""
        if not len(self.task):
            return np.zeros(len(steps))
        reached = self.task @ normal
        if not self.is_polytope:
            return np.asarray(steps @ (reached @ self.task) / np.linalg.norm(reached))
        touched = reached >= reached.max() - FARTHEST * np.linalg.norm(self.task, axis=1).max()
        return np.asarray((steps @ self.task[touched].T).max(axis=1))


def largest(rows: Array, count: int) -> Array:
    """Add up the `count` largest numbers of each row (m, n): (m,)."""
    if count == 0:
        return np.zeros(len(rows))
    if count >= rows.shape[1]:
        return np.asarray(rows.sum(axis=1))
    return np.asarray(np.partition(rows, -count, axis=1)[:, -count:].sum(axis=1))
