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
