"""What a newcomer can choose, as two numbers between 0 and 1: the contact and the direction."""

import numpy as np


class Choices:
    """A newcomer's contact and direction as shares of the perimeter and of its sector.

    Parameters
    ----------
    problem : Problem
        Without zones; the newcomer pushes or pulls within a right angle, or is free.
    """

    def __init__(self, problem):
        outline, kind = problem.swarm.outline, problem.newcomer.attachment
        self.arcs = outline.corner_arc_lengths
        self.corners = np.vstack([outline.vertices, outline.vertices[:1]]) - outline.origin
        turn = np.pi if kind == "pull" else 0.0
        self.middles = np.array([outline.inward_normal(e) + turn for e in range(len(outline))])
        self.half = np.pi if kind == "free" else 0.5 * np.pi
        self.weights = problem.swarm.scale * problem.newcomer.limit

    def wrenches(self, along, across):
        """Return unit wrenches (cos, sin, torque), (m, 3) [1, 1, m], at shares (m,) and (m,)."""
        arc = np.clip(along, 0.0, 1.0) * self.arcs[-1]
        edge = np.minimum(np.searchsorted(self.arcs, arc, side="right") - 1, len(self.middles) - 1)
        x, y = (np.interp(arc, self.arcs, self.corners[:, axis]) for axis in (0, 1))
        alpha = self.middles[edge] + (2.0 * np.clip(across, 0.0, 1.0) - 1.0) * self.half
        c, s = np.cos(alpha), np.sin(alpha)
        return np.column_stack([c, s, x * s - y * c])

    def nearest(self, wanted):
        """Return the unit wrench (3,) nearest to a wanted one (3,) [1, 1, m], in the metric.

        For one edge and one direction the torque is free between those at the edge's two ends,
        so only the direction is searched, ever finer around the best.
        """
        best, middle, width = (np.inf, None), np.zeros(len(self.middles)), self.half
        for _ in range(4):
            turn = np.clip(middle[:, None] + np.linspace(-width, width, 181), -self.half, self.half)
            c, s = np.cos(self.middles[:, None] + turn), np.sin(self.middles[:, None] + turn)
            ends = [p[:, :1] * s - p[:, 1:] * c for p in (self.corners[:-1], self.corners[1:])]
            torque = np.clip(wanted[2], np.minimum(*ends), np.maximum(*ends))
            apart = (np.stack([c, s, torque], axis=2) - wanted) * self.weights
            gaps = np.einsum("eti,eti->et", apart, apart)
            k = gaps.argmin(axis=1)
            rows = np.arange(len(k))
            edge = int(gaps[rows, k].argmin())
            if gaps[edge, k[edge]] < best[0]:
                found = (c[edge, k[edge]], s[edge, k[edge]], torque[edge, k[edge]])
                best = gaps[edge, k[edge]], np.array(found)
            middle, width = turn[rows, k], width / 60.0
        return best[1]
