"""The wrenches that robots of uncertain pose may exert, and the worst of them (T14)."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.outline import Outline
from swarmgrasp.swarm import Swarm, Tolerance

Array = NDArray[np.float64]
Point = tuple[float, float]
TOUCH = 1e-12
"""Length of a straight part of a contact's interval, relative to the outline, that is none."""


class Poses(NamedTuple):
    """All the poses one robot may have.

    Attributes
    ----------
    parts : tuple of (start, end)
        The straight parts [m, m] of the boundary on which its contact lies, in the frame of the
        vertices.
    lo, hi : float [rad]
        Between which its direction lies.
    limit : float [N]
        What it can exert for certain.
    """

    parts: tuple[tuple[Point, Point], ...]
    lo: float
    hi: float
    limit: float

    def rows(self, robot: int, origin: Array) -> list[list[float]]:
        """Return the kernels' rows for it, (..., 12): see `criterion.h`."""
        halves = 1 + int(self.hi - self.lo > math.pi)
        step = (self.hi - self.lo) / halves
        x0, y0 = origin.tolist()
        found = []
        for (px, py), (qx, qy) in self.parts:
            for k in range(halves):
                lo, hi = self.lo + k * step, self.hi if k + 1 == halves else self.lo + step
                arms = [px - x0, py - y0, qx - x0, qy - y0]
                turns = [lo, hi, math.cos(lo), math.sin(lo), math.cos(hi), math.sin(hi)]
                found.append([float(robot), self.limit, *arms, *turns])
        return found

    def worst(self, origin: Array, covector: Array) -> tuple[Point, float]:
        """Return the pose whose wrench has the least product with a covector [1, 1, 1/m]."""
        x0, y0 = origin.tolist()
        u, v, turn = covector.tolist()
        least, pose = math.inf, (self.parts[0][0], self.lo)
        for x, y in (end for part in self.parts for end in part):
            a, b = u - turn * (y - y0), v + turn * (x - x0)
            trough = math.atan2(b, a) + math.pi
            trough += math.tau * math.ceil((self.lo - trough) / math.tau)
            for angle in (self.lo, self.hi, *((trough,) if trough <= self.hi else ())):
                value = a * math.cos(angle) + b * math.sin(angle)
                if value < least:
                    least, pose = value, ((x, y), angle)
        return pose


def poses_at(
    outline: Outline, contact: ArrayLike, direction: float, limit: float, tolerance: Tolerance
) -> Poses:
    """Return all the poses of a robot that is meant to be in one."""
    first, last = tolerance.offsets
    point = tuple(np.asarray(contact, dtype=float).tolist())
    parts: tuple[tuple[Point, Point], ...] = ((point, point),)
    if tolerance.is_adrift:
        at = _on_boundary(outline, point)
        parts = tuple(boundary_parts(outline, at + first, at + last))
    lo, hi = tolerance.turns
    least = limit if tolerance.least_limit is None else tolerance.least_limit
    return Poses(parts, direction + lo, direction + hi, least)


def boundary_parts(outline: Outline, start: float, end: float) -> list[tuple[Point, Point]]:
    """Return the straight parts of the boundary between two arc lengths, counter-clockwise.

    Parameters
    ----------
    outline : Outline
    start, end : float [m]
        ``start <= end``; outside [0, perimeter] they run across the first vertex.

    Examples
    --------
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> boundary_parts(square, -0.5, 0.5)
    [((-1.0, -0.5), (-1.0, -1.0)), ((-1.0, -1.0), (-0.5, -1.0))]
    """
    lap, corners = outline.perimeter, outline.corner_arc_lengths.tolist()
    turn = math.floor(start / lap)
    start, end = start - turn * lap, end - turn * lap
    found = []
    for k in range(2 * len(outline) + 1):
        edge, round_ = k % len(outline), k // len(outline)
        base = corners[edge] + round_ * lap
        length = float(outline.lengths[edge])
        low, high = max(start - base, 0.0), min(end - base, length)
        if low > high or (high - low <= TOUCH * lap and end - start > 2.0 * TOUCH * lap):
            continue
        p, q = outline.edge_ends(edge)
        ends = (p + (q - p) * (along / length) for along in (low, high))
        first, last = (tuple(point.tolist()) for point in ends)
        found.append((first, last))
    return found


def poses_of(swarm: Swarm) -> dict[int, Poses | None]:
    """Return the poses of all robots that have a tolerance, by index; None if absent at worst."""
    return {
        i: None
        if tolerance.may_be_absent
        else poses_at(
            swarm.outline,
            swarm.contacts[i],
            float(swarm.directions[i]),
            float(swarm.limits[i]),
            tolerance,
        )
        for i, tolerance in sorted(swarm.tolerances.items())
    }


def _on_boundary(outline: Outline, point: Point) -> float:
    """Return the arc length [m] of the boundary point nearest to one."""
    _, (arc_length,) = outline.nearest(point)
    return min(max(float(arc_length), 0.0), outline.perimeter)
