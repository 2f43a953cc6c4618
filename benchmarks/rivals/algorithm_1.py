"""The paper's Algorithm 1, corrected: bisection on the level, SLSQP for each query.

A query looks in the cylinder |F| <= 1, |tau| <= r_max for a wrench with which every facet is at
least as far as the level: those of the swarm that is there, and those the wrench brings. It ends
at the nearest wrench that a robot can really make, since often none can make the one found.
"""

import numpy as np
from scipy.optimize import minimize

from rivals.all_pairs import facets
from rivals.choices import Choices

NAME = "Algorithm 1 with SLSQP"
PRECISION = 1e-4
"""Width of the bisection's last interval, relative to the level."""
MISSING = 1e-6
"""What a query may miss of the level, relative to it, and still count as met."""


class Query:
    """Maximise the slack s over (b, s): every facet at level + s or beyond.

    Parameters
    ----------
    problem : Problem
    """

    def __init__(self, problem):
        swarm = problem.swarm
        self.base = swarm.scaled_generators
        self.normals, self.heights = facets(self.base)
        self.force = problem.newcomer.limit
        self.torque = self.force * swarm.outline.radius * swarm.scale[2]
        self.level = 0.0

    def run(self, level, start):
        """Look from a wrench (3,) [N] for one that reaches a level; None if none is found."""
        self.level = level
        low = self.heights < level
        N, demands = self.normals[low], level - self.heights[low]
        tall = np.column_stack([N, -np.ones(len(N))])

        def slack(b):
            """Return the least slack over all facets at a wrench."""
            return min(np.min(N @ b - demands), np.min(self._brought(np.append(b, 0.0))[0]))

        found = minimize(
            lambda x: -x[3],
            np.append(start, slack(start)),
            jac=lambda _: np.array([0.0, 0.0, 0.0, -1.0]),
            constraints=[
                {"type": "ineq", "fun": lambda x: tall @ x - demands, "jac": lambda _: tall},
                {"type": "ineq", "fun": self._limits, "jac": self._slopes},
            ],
            method="SLSQP",
            options={"maxiter": 300, "ftol": 1e-10},
        )
        b = found.x[:3]  # back into the cylinder, which it may leave by rounding
        b[:2] /= max(1.0, np.hypot(b[0], b[1]) / self.force)
        b[2] = np.clip(b[2], -self.torque, self.torque)
        return b if slack(b) >= -MISSING * level else None

    def _brought(self, x):
        """Return the slack of the facets that a wrench brings, (2 n,), and its slopes, (2 n, 3)."""
        b, s = x[:3], x[3]
        cross = np.cross(b, self.base)
        sizes = np.linalg.norm(cross, axis=1)
        sizes[sizes < 1e-12] = np.inf  # a parallel robot brings no facet
        n = cross / sizes[:, None]
        shares = n @ self.base.T
        both = np.vstack([shares, -shares])
        heights = np.maximum(both, 0.0).sum(axis=1)
        # h = n . g, g the sum of the robots in front, n = b x b_i / |b x b_i|
        across = (both > 0.0) @ self.base - heights[:, None] * np.vstack([n, -n])
        slopes = np.cross(np.tile(self.base, (2, 1)), across) / np.tile(sizes, 2)[:, None]
        slopes[len(n) :] *= -1.0
        heights[np.tile(np.isinf(sizes), 2)] = 10.0 * self.level
        return heights - self.level - s, slopes

    def _limits(self, x):
        """Return the slack of the facets brought and of the cylinder, (2 n + 3,)."""
        bx, by, torque = x[:3]
        cylinder = self.force**2 - bx**2 - by**2, self.torque - torque, self.torque + torque
        return np.append(self._brought(x)[0], cylinder)

    def _slopes(self, x):
        """Return the derivatives of `_limits`, (2 n + 3, 4)."""
        slopes = self._brought(x)[1]
        bx, by = x[:2]
        cylinder = [(-2.0 * bx, -2.0 * by, 0.0, 0.0), (0.0, 0.0, -1.0, 0.0), (0.0, 0.0, 1.0, 0.0)]
        return np.vstack([np.column_stack([slopes, -np.ones(len(slopes))]), cylinder])


def place(problem):
    """Return the unit wrench (cos, sin, torque) of the robot, and the quality promised [N]."""
    query, choices = Query(problem), Choices(problem)
    k = int(query.heights.argmin())
    normal, low = query.normals[k], float(query.heights[k])
    size = max(np.linalg.norm(normal[:2]) / query.force, abs(normal[2]) / query.torque)
    best = normal / size
    high = low + float(np.hypot(query.force, query.torque))
    while high - low > PRECISION * high:
        level = 0.5 * (low + high)
        found = query.run(level, best)
        low, high = (low, level) if found is None else (level, high)
        best = best if found is None else found
    return choices.nearest(best / choices.weights), low
