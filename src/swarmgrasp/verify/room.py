"""Room for a newcomer's body, found anew for the check of an answer.

Contacts and directions are cut into cells as the question says. A cell counts as allowed if the
hull of the body in it, stretched to cover all between its corners, meets neither the object nor a
body already there. Two convex shapes are apart if they are so along the normal of a side of one; a
line between any two corners may be tried as a side, so that hulls need not be found. Shapes that
are in each other by no more than rounding count as apart: where a robot is claimed to be, by twice
as much, and where a bound is asked for, by half.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import groupby, pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.verify.allowed import Piece
from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.recompute import Array

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import BodyClaim, NewcomerClaim, RobotClaim

TURN = math.radians(2.0)
"""Greatest turn within a cell [rad]."""
PER_BEAM, MOST_CELLS = 4, 500
"""Cells along an edge, for each beam, and at most."""
ALONG = 1e-9
"""Cosine to the normal at which a force is along the hull."""
TOUCHES = 1e-6
"""Of the extent: depth of one shape in another that is rounding."""
WIDE = math.pi * (1.0 + 1e-9)
"""Sectors wider than this leave a body along the normal."""


class Room:
    """What bodies leave free beside the object.

    Parameters
    ----------
    boundary : Boundary
    present : list of RobotClaim
    """

    def __init__(self, boundary: Boundary, present: "list[RobotClaim]") -> None:
        self.boundary = boundary
        extent = float(np.linalg.norm(np.ptp(boundary.corners, axis=0)))
        self.rounding = TOUCHES * extent
        sides = zip(boundary.corners, np.roll(boundary.corners, -1, axis=0), strict=True)
        self.taken = [np.array(side) for side in sides]
        for robot in present:
            if robot.body is not None:
                self.taken += list(self.swept(robot)[:, 0])
        self.boxes = np.array([(shape.min(axis=0), shape.max(axis=0)) for shape in self.taken])

    def swept(self, robot: "RobotClaim", least: float = -ALONG) -> Array:
        """Return corners (n, 1, k, 2) of convex shapes that together are the room of a robot.

        It pushes if the cosine of its direction to the normal is at least so much.
        """
        assert robot.body is not None
        contact = np.array(robot.contact)
        inward = self._inward(contact)
        pushes = math.cos(robot.direction - inward) >= least
        middle, half = robot.direction + (math.pi if pushes else 0.0), robot.steers
        if half > 0.5 * math.pi or robot.sectors is not None:
            middle, half = inward + math.pi, 0.0
        ways = np.linspace(middle - half, middle + half, max(1, math.ceil(2.0 * half / TURN)) + 1)
        return _corners(robot.body, [contact], np.column_stack([ways[:-1], ways[1:]]))

    def are_free(self, shapes: Array, slack: float) -> NDArray[np.bool_]:
        """Tell of shapes (n, s, k, 2) whether each is apart from everything, but for a depth.

        All of them begin at the boundary, so that none is inside without crossing it.
        """
        low, high = shapes.min(axis=(1, 2)), shapes.max(axis=(1, 2))
        free = np.ones(len(shapes), dtype=bool)
        for (least, most), other in zip(self.boxes, self.taken, strict=True):
            near = free & ((least <= high) & (most >= low)).all(axis=1)
            if near.any():
                free[near] = depths(shapes[near], other) <= slack
        return free

    def holds(self, robot: "RobotClaim") -> bool:
        """Tell whether a robot has room, to one side at least if its force is along the hull."""
        sides = (self.swept(robot, least) for least in (-ALONG, ALONG))
        return any(self.are_free(swept, 2.0 * self.rounding).all() for swept in sides)

    def left(self, piece: Piece, newcomer: "NewcomerClaim", keeps: bool) -> Iterator[Piece]:
        """Yield what is left of a piece to a newcomer with a body."""
        assert newcomer.body is not None
        corner, _ = self.boundary.edge(piece.edge)
        length = float(self.boundary.lengths[piece.edge])
        along = (self.boundary.edge(piece.edge)[1] - corner) / length
        normal = math.atan2(along[0], -along[1])
        inward = math.cos(0.5 * (piece.lo + piece.hi) - normal) > 0.0
        start, end = sorted(float((p - corner) @ along) for p in (piece.p, piece.q))
        for a, b in self._cut(start, end, length, newcomer.body.beam):
            ends = [corner + a * along, corner + b * along]
            part = replace(piece, p=ends[0], q=ends[1])
            cells = _cells(piece, normal, inward)
            free = self.are_free(_corners(newcomer.body, ends, cells[:, 2:]), 0.5 * self.rounding)
            if keeps:
                if all(free):
                    yield part
                continue
            for is_free, run in groupby(zip(free, cells.tolist(), strict=True), lambda f: f[0]):
                if is_free:
                    each = [cell for _, cell in run]
                    yield replace(part, lo=each[0][0], hi=each[-1][1])

    def _cut(
        self, start: float, end: float, length: float, beam: float
    ) -> Iterator[tuple[float, float]]:
        """Cut a stretch of an edge where the edge's cells end, and leave no sliver."""
        sliver = self.boundary.sliver
        count = min(max(1, math.ceil(PER_BEAM * length / beam)), MOST_CELLS)
        ends = (length * k / count for k in range(count + 1))
        inside = [s for s in ends if start + sliver < s < end - sliver]
        yield from pairwise([start, *inside, end])

    def _inward(self, point: Array) -> float:
        """Return the direction into the object at a contact, at a corner the middle one [rad]."""
        normals = []
        for k in self.boundary.at(point):
            p, q = self.boundary.edge(k)
            normals.append(math.atan2(q[0] - p[0], p[1] - q[1]))
        return normals[0] + 0.5 * math.remainder(normals[-1] - normals[0], math.tau)


def depths(shapes: Array, other: Array) -> Array:
    """Return how deep convex shapes are in another one [m]; 0 or less where they are apart.

    Parameters
    ----------
    shapes : (n, s, k, 2) [m, m]
        Points whose hulls they are, at s spots along a line.
    other : (m, 2) [m, m]

    Returns
    -------
    (n,)

    Examples
    --------
    >>> square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    >>> depths(np.array([[square + 0.75], [square + (1.5, 0.0)]]), square).tolist()
    [0.25, -0.5]
    """
    along = shapes[:, -1, :1] - shapes[:, 0, :1]
    ours = np.concatenate([_lines(shapes[:, 0]), along], axis=1)
    theirs = np.broadcast_to(_lines(other), (len(shapes), len(other) * (len(other) - 1) // 2, 2))
    points = shapes.reshape(len(shapes), -1, 2).transpose(0, 2, 1)
    found = np.full(len(shapes), math.inf)
    for sides in (ours, theirs):
        sizes = np.hypot(sides[..., 0], sides[..., 1])
        normals = np.stack([sides[..., 1], -sides[..., 0]], axis=-1)
        normals = normals / np.where(sizes > 0.0, sizes, 1.0)[..., None]
        one, two = normals @ points, normals @ other.T
        overlap = np.minimum(one.max(axis=2) - two.min(axis=2), two.max(axis=2) - one.min(axis=2))
        found = np.minimum(found, np.where(sizes > 0.0, overlap, math.inf).min(axis=1))
    return found


def _lines(points: Array) -> Array:
    """Return the vectors between any two of points (..., k, 2)."""
    first, last = np.triu_indices(points.shape[-2], 1)
    return np.asarray(points[..., last, :] - points[..., first, :])


def _corners(body: "BodyClaim", contacts: list[Array], ways: Array) -> Array:
    """Return corners (k, s, 10, 2) of a body at s contacts, for every two ways (k, 2) [rad]."""
    half, waist = 0.5 * body.beam, min(0.5 * body.beam, body.length)
    x = np.array([0.0, waist, waist, body.length, body.length])
    y = np.array([0.0, half, -half, half, -half])
    stretched = 1.0 / np.cos(0.5 * (ways[:, 1] - ways[:, 0]))[:, None, None]
    c, s = np.cos(ways)[:, :, None], np.sin(ways)[:, :, None]
    plan = np.stack([stretched * (x * c - y * s), stretched * (x * s + y * c)], axis=-1)
    spots = [contact + plan.reshape(len(ways), -1, 2) for contact in contacts]
    return np.stack(spots, axis=1)


def _cells(piece: Piece, normal: float, inward: bool) -> Array:
    """Return the cells of a piece's directions, and how a body lies there, (k, 4) [rad]."""
    lo, hi = piece.lo, piece.hi
    if hi - lo > WIDE:
        return np.array([[lo, hi, normal + math.pi, normal + math.pi]])
    steps = range(math.floor((lo - normal) / TURN) + 1, math.ceil((hi - normal) / TURN))
    cuts = np.array([lo, *(normal + k * TURN for k in steps), hi])
    cells = np.column_stack([cuts[:-1], cuts[1:]])
    return np.hstack([cells, cells + (math.pi if inward else 0.0)])
