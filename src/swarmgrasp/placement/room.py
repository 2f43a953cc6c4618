"""Room for a newcomer's body: clear of the object and of the bodies already there.

Contacts and directions are cut into cells. A cell is left to the newcomer if the hull of its body
in the cell's corners, stretched so that it covers all between, is clear of everything. So what is
left is clear for certain, and what is lost is less than a cell.
"""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.outline import Outline
from swarmgrasp.placement.pieces import SLIVER, Piece
from swarmgrasp.swarm import Body, Newcomer, Robot, Swarm

if TYPE_CHECKING:
    from shapely import Polygon

Array = NDArray[np.float64]

TURN = math.radians(2.0)
"""Greatest turn from one side of a cell to the other [rad]."""
PER_BEAM = 4
"""Cells along an edge, for each beam."""
MOST_CELLS = 500
"""Along an edge."""
ALONG = 1e-9
"""Cosine to the normal below which a force is along the hull: it counts as a push."""
TOUCHES = 1e-6
"""Of the extent: how far bodies may be in each other, or in the object, and only touch."""


class Room:
    """What is taken up beside an object.

    Parameters
    ----------
    swarm : Swarm
        The object and its robots, of which those with bodies count.
    """

    def __init__(self, swarm: Swarm) -> None:
        from shapely import Polygon

        self.outline = outline = swarm.outline
        self._touches = TOUCHES * outline.extent
        self.names = [swarm.names[i] for i in sorted(swarm.rare.bodies)]
        self.bodies = [swept(outline, swarm[n]).buffer(-self._touches) for n in self.names]
        self._object = Polygon(outline.vertices).buffer(-self._touches)

    def crossings(self) -> list[tuple[str, str]]:
        """Return the names of robots whose bodies are in each other."""
        return [
            (self.names[i], self.names[j])
            for i in range(len(self.bodies))
            for j in range(i)
            if self.bodies[i].intersects(self.bodies[j])
        ]

    def left(self, pieces: Sequence[Piece], newcomer: Newcomer) -> Iterator[Piece]:
        """Yield what is left of pieces to a newcomer with a body."""
        for piece in pieces:
            yield from self._on_piece(piece, newcomer)

    def _on_piece(self, piece: Piece, newcomer: Newcomer) -> Iterator[Piece]:
        """Yield what is left of one piece."""
        body, outline = newcomer.body, self.outline
        assert body is not None
        stretches = self._cut(piece, body.beam)
        for start, end in stretches:
            p, q = outline.edge_ends(piece.edge)
            along = (q - p) / outline.lengths[piece.edge]
            contacts = np.array([p + start * along, p + end * along])
            normal = outline.inward_normal(piece.edge)
            turns, away = _turns_of(piece, normal)
            swept = _hulls(body, contacts, away)
            clear = ~self._is_taken(swept)
            if newcomer.keeps:
                if clear.all():
                    yield piece._replace(start=start, end=end)
                continue
            for first, last in _runs(clear):
                lo, hi = turns[first], turns[last]
                yield piece._replace(start=start, end=end, lo=lo, hi=hi)

    def _cut(self, piece: Piece, beam: float) -> list[tuple[float, float]]:
        """Cut a stretch of an edge where the edge's cells end, and leave no sliver."""
        length, sliver = float(self.outline.lengths[piece.edge]), SLIVER * self.outline.extent
        count = min(max(1, math.ceil(PER_BEAM * length / beam)), MOST_CELLS)
        ends = length * np.arange(count + 1) / count
        inside = ends[(ends > piece.start + sliver) & (ends < piece.end - sliver)]
        return list(pairwise([piece.start, *inside.tolist(), piece.end]))

    def _is_taken(self, shapes: Any) -> NDArray[np.bool_]:
        """Tell of shapes whether any is in the object or in a body."""
        from shapely import intersects

        taken = intersects(shapes, self._object)
        for body in self.bodies:
            taken |= intersects(shapes, body)
        return np.asarray(taken)


def swept(outline: Outline, robot: Robot) -> "Polygon":
    """Return the room that a robot takes up with all that it steers."""
    from shapely import union_all

    assert robot.body is not None
    middle, half = _lies(outline, robot)
    count = max(1, math.ceil(2.0 * half / TURN))
    away = middle + half * np.linspace(-1.0, 1.0, count + 1)
    contacts = np.array([robot.contact, robot.contact])
    return union_all(_hulls(robot.body, contacts, away))


def body_corners(outline: Outline, robot: Robot) -> Array:
    """Return the corners (5, 2) [m, m] of a robot's body as it lies along its direction."""
    assert robot.body is not None
    middle, _ = _lies(outline, robot)
    return np.asarray(robot.body.corners([robot.contact], [middle])[0])


def _lies(outline: Outline, robot: Robot) -> tuple[float, float]:
    """Return the direction in which a robot's body lies, and how far it swings to both sides."""
    inward = _inward(outline, robot.contact)
    if robot.steers > 0.5 * math.pi or robot.sectors is not None:
        return inward + math.pi, 0.0
    pushes = math.cos(robot.direction - inward) >= -ALONG
    return robot.direction + (math.pi if pushes else 0.0), robot.steers


def pulls_on_line(outline: Outline, robot: Robot) -> bool:
    """Tell whether a robot pulls one way, from the boundary: not what steers by a right angle."""
    if robot.mounted or robot.reverse_limit or robot.sectors or robot.steers >= 0.5 * math.pi:
        return False
    return math.cos(robot.direction - _inward(outline, robot.contact)) < -ALONG


def _inward(outline: Outline, point: tuple[float, float]) -> float:
    """Return the direction into the object at a contact, at a corner the middle one [rad]."""
    contact = outline.at_point(point)
    if not contact.is_corner:
        return contact.inward
    before = float(outline.inward_normals[contact.edge - 1])
    return before + 0.5 * math.remainder(contact.inward - before, math.tau)


def _turns_of(piece: Piece, normal: float) -> tuple[list[float], Array]:
    """Return where a piece's directions are cut, and how a body lies there [rad].

    One that pushes lies behind its contact. Of a sector wider than half a turn it lies along the
    normal, whatever the direction.
    """
    lo, hi = piece.lo, piece.hi
    if hi - lo > math.pi * (1.0 + 1e-9):
        return [lo, hi], np.full(2, normal + math.pi)
    first, last = math.floor((lo - normal) / TURN) + 1, math.ceil((hi - normal) / TURN)
    cuts = [lo, *(normal + k * TURN for k in range(first, last)), hi]
    return cuts, np.array(cuts) + (math.pi if piece.inward else 0.0)


def _hulls(body: Body, contacts: Array, away: Array) -> Any:
    """Return the hull of a body in both contacts and each two ways that follow each other."""
    from shapely import convex_hull, multipoints

    widened = 1.0 / np.cos(0.5 * np.diff(away))
    corners = [
        body.corners(np.broadcast_to(contact, (len(widened), 2)), ways, widened)
        for contact in contacts
        for ways in (away[:-1], away[1:])
    ]
    return convex_hull(multipoints(np.concatenate(corners, axis=1)))


def _runs(clear: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return where runs of cells begin and end, as indices of their ends."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], clear, [False]]).astype(int)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))
