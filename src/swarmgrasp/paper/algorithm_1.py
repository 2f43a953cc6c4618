"""The paper's Algorithm 1: bisection on the quality, a local solver for each query.

A query looks in the cylinder |F| <= limit, |tau| <= limit r_max for a wrench with which every
facet is at least as far from the origin as a level: the facets of the swarm that is there, and
those the new wrench brings. The algorithm ends at the nearest wrench that a robot can really make.
"""

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from enum import Flag, auto
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import PackageMissing
from swarmgrasp.paper.attachment import Attachment, nearest_attachment
from swarmgrasp.paper.cylinder import Cylinder
from swarmgrasp.placement import Problem

Array = NDArray[np.float64]

PRECISION = 1e-4
"""Width of the bisection's last interval [N] for a newcomer of 1 N: the paper's epsilon."""
MISSING = 1e-6
"""What a query may miss of the level, relative to it, and still count as met."""
SOLVER: dict[str, Any] = {"method": "SLSQP", "options": {"maxiter": 300, "ftol": 1e-10}}
"""SciPy's sequential least-squares programming, as the local solver that the paper calls for."""
MOST_QUERIES = 100
"""After so many the bisection is taken not to end; 15 are usual."""
PARALLEL = 1e-12
"""|b x b_i| / |b_i|, relative to the longest wrench, below which the two bring no facet."""
FAR = 1e3
"""What "no lower bound" on the torque is here, in upper bounds."""


class Printed(Flag):
    """Misprints of Algorithm 1 that may be followed to the letter, to see where they lead."""

    NOTHING = 0
    LOOP = auto()
    """Go on while Q_upper - Q_lower < epsilon."""
    MIDPOINT = auto()
    """Try the level (Q_upper - Q_lower) / 2."""
    TORQUE = auto()
    """Bound the torque by tau <= r_max alone."""


@dataclass(frozen=True, eq=False)
class Promise:
    """What Algorithm 1 found.

    Attributes
    ----------
    problem : Problem
    wrench : (3,) [1, 1, m]
        The wrench in the cylinder, per newton of the newcomer's limit.
    promised : float [N]
        The quality with it, as far as the bisection got: Q_lower.
    refuted : float [N]
        The lowest level for which no wrench was found: Q_upper.
    queries : int
        How many levels were tried.
    iterations : int
        That the local solver took for all of them.
    ended : bool
        Whether the bisection came to its end.
    """

    problem: Problem
    wrench: Array
    promised: float
    refuted: float
    queries: int
    iterations: int
    ended: bool

    def attach(self, problem: Problem | None = None) -> Attachment:
        """Determine the attachment: the nearest wrench that a robot can really make.

        Parameters
        ----------
        problem : Problem, optional
            The same question with another kind of newcomer; the cylinder knows no kinds.
        """
        return nearest_attachment(self.problem if problem is None else problem, self.wrench)


def algorithm_1(
    problem: Problem, precision: float = PRECISION, printed: Printed = Printed.NOTHING
) -> Promise:
    """Place a newcomer as the paper does; see `place` for the true optimum.

    Parameters
    ----------
    problem : Problem
        Without a criterion.
    precision : float
        The paper's epsilon, relative to the newcomer's limit.
    printed : Printed
        Misprints to follow; by default all are corrected.

    Returns
    -------
    Promise
        Its wrench is in the cylinder; `Promise.attach` turns it into a robot.

    Raises
    ------
    PackageMissing
        If SciPy is not installed.
    NotInThePaper
        If the problem has a criterion, or the swarm has no facet to start from.
    """
    query = Query(Cylinder(problem), one_sided=Printed.TORQUE in printed)
    epsilon = precision * problem.newcomer.limit
    normal, low = query.cylinder.closest
    best = query.cylinder.on_boundary(normal)  # the start: the normal of the closest facet
    high = low + query.cylinder.longest
    queries = 0
    while _goes_on(low, high, epsilon, printed) and queries < MOST_QUERIES:
        queries += 1
        # printed: (Q_upper - Q_lower) / 2
        level = 0.5 * (high - low if Printed.MIDPOINT in printed else high + low)
        found = query.run(level, best)
        low, high = (low, level) if found is None else (level, high)
        best = best if found is None else found
    ended = not _goes_on(low, high, epsilon, printed)
    wrench, iterations = query.cylinder.wrench(best), query.iterations
    return Promise(problem, wrench, low, high, queries, iterations, ended)


def _goes_on(low: float, high: float, epsilon: float, printed: Printed) -> bool:
    """Tell whether the loop goes on; printed: while Q_upper - Q_lower < epsilon."""
    return high - low < epsilon if Printed.LOOP in printed else high - low > epsilon


class Query:
    """Maximise the slack s over (x, s): with b = size * x every facet is at level + s or beyond.

    Parameters
    ----------
    cylinder : Cylinder
    one_sided : bool
        Bound the torque from above only, as printed.

    Raises
    ------
    PackageMissing
        If SciPy is not installed.
    """

    def __init__(self, cylinder: Cylinder, one_sided: bool = False) -> None:
        self.cylinder = cylinder
        self.lowest = -FAR if one_sided else -1.0  # printed: tau <= r_max, and nothing below
        self.level, self.iterations = 0.0, 0
        self._minimise = local_solver()
        low, longest = cylinder.closest[1], cylinder.longest
        self._far = 10.0 * (low + longest)  # higher than any level
        self._at: Array | None = None
        self._facets = np.zeros(0), np.zeros((0, 3))

    def run(self, level: float, start: Array) -> Array | None:
        """Look from a point (3,) of the unit cylinder for one that reaches a level [N].

        Returns
        -------
        (3,) or None
            None if none is found, which does not mean that there is none.
        """
        self.level, size = level, self.cylinder.size
        low = self.cylinder.heights < level
        slopes = self.cylinder.normals[low] * size
        demands = level - self.cylinder.heights[low]
        tall = np.column_stack([slopes, -np.ones(len(slopes))])

        def slack(x: Array) -> float:
            """Return the least slack over all facets at a point."""
            old = slopes @ x - demands
            return float(min(old.min(initial=np.inf), self._brought(np.append(x, 0.0))[0].min()))

        with warnings.catch_warnings(), np.errstate(all="ignore"):
            # SLSQP complains of points outside its bounds, and may try infinite ones
            warnings.simplefilter("ignore", RuntimeWarning)
            found = self._minimise(
                lambda x: -x[3],
                np.append(start, slack(start)),
                jac=lambda _: np.array([0.0, 0.0, 0.0, -1.0]),
                constraints=[
                    {"type": "ineq", "fun": lambda x: tall @ x - demands, "jac": lambda _: tall},
                    {"type": "ineq", "fun": self._limits, "jac": self._limit_slopes},
                ],
                **SOLVER,
            )
            self.iterations += int(found.nit)
            x = self._inside(found.x[:3])
            return x if slack(x) >= -MISSING * level else None

    def _inside(self, x: Array) -> Array:
        """Return a point (3,) in the unit cylinder, which the solver may leave by rounding."""
        kept = self.cylinder.inside(x)
        kept[2] = np.clip(x[2], self.lowest, 1.0)
        return kept

    def _brought(self, x: Array) -> tuple[Array, Array]:
        """Return the slack of the facets that a point brings, (2 n,), and its slopes, (2 n, 3)."""
        if self._at is None or not np.array_equal(x[:3], self._at):  # asked for twice in a row
            self._at, self._facets = x[:3].copy(), self._facets_brought(x[:3])
        heights, slopes = self._facets
        return heights - self.level - x[3], slopes

    def _facets_brought(self, x: Array) -> tuple[Array, Array]:
        """Return h at the facets that a point (3,) brings, (2 n,) [N], and its slopes, (2 n, 3)."""
        base, size = self.cylinder.base, self.cylinder.size
        cross = _cross(x * size, base)
        sizes = np.sqrt(np.einsum("ij,ij->i", cross, cross))[:, None]
        parallel = sizes[:, 0] < PARALLEL * self.cylinder.longest
        sizes[parallel] = np.inf  # a parallel robot brings no facet
        n = cross / sizes
        shares = n @ base.T
        up = shares > 0.0
        # h = n . g, g the sum of the robots in front, n = b x b_i / |b x b_i|
        front, behind = up @ base, (shares < 0.0) @ base
        high, low = np.einsum("ij,ij->i", n, front), -np.einsum("ij,ij->i", n, behind)
        rise = _cross(base, front - high[:, None] * n) / sizes
        fall = _cross(behind + low[:, None] * n, base) / sizes
        heights = np.concatenate([high, low])
        heights[np.tile(parallel, 2)] = self._far
        return heights, np.vstack([rise, fall]) * size

    def _limits(self, x: Array) -> Array:
        """Return the slack of the facets brought and of the cylinder, (2 n + 3,)."""
        cylinder = 1.0 - x[0] ** 2 - x[1] ** 2, 1.0 - x[2], x[2] - self.lowest
        return np.append(self._brought(x)[0], cylinder)

    def _limit_slopes(self, x: Array) -> Array:
        """Return the derivatives of `_limits`, (2 n + 3, 4)."""
        slopes = self._brought(x)[1]
        cylinder = [
            (-2.0 * x[0], -2.0 * x[1], 0.0, 0.0),
            (0.0, 0.0, -1.0, 0.0),
            (0.0, 0.0, 1.0, 0.0),
        ]
        return np.vstack([np.column_stack([slopes, -np.ones(len(slopes))]), cylinder])


def _cross(a: Array, b: Array) -> Array:
    """Return the cross products of rows (n, 3) or of one vector (3,) with rows."""
    (ax, ay, az), (bx, by, bz) = a.T, b.T
    return np.column_stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])


def local_solver() -> Callable[..., Any]:
    """Return SciPy's `minimize`.

    Raises
    ------
    PackageMissing
        If SciPy is not installed.
    """
    try:
        from scipy.optimize import minimize
    except ImportError as error:
        raise PackageMissing(
            f"Algorithm 1 needs SciPy for its local solver, and it cannot be imported ({error}); "
            "install it with: pip install 'swarmgrasp[paper]'"
        ) from None
    return minimize  # type: ignore[no-any-return]
