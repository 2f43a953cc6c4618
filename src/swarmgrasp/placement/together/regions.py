"""Regions of contacts and directions, halved again and again, and the wrenches that span them."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement.together.stands import Ground

Array = NDArray[np.float64]
PIECE, START, END, LOW, HIGH = range(5)
"""Columns of a box: its piece, its arc lengths [m] and its directions [rad], from and to."""
WIDEST_ARC = 0.2
"""Widest arc of directions [rad] that three wrenches span: they are 0.5 % longer than its own."""
THIN = 1e-9
"""Width of an interval of directions [rad], or of contacts relative to the perimeter, that is none.
"""
CONTACT, DIRECTION = 0, 1
"""The two ways to halve a region."""


class Hull(NamedTuple):
    """Wrenches whose convex hull contains all that a newcomer can exert in a region.

    Attributes
    ----------
    points : (c, ...)
        As `Ground.points_at` has them.
    at : (c, 2) [m, rad]
        Arc lengths and directions.
    """

    points: Array
    at: Array


class Cut(NamedTuple):
    """A region in two halves, at an arc length [m] or a direction [rad]."""

    low: "Region"
    high: "Region"
    where: float


@dataclass(frozen=True, eq=False)
class Region:
    """Boxes of contacts and directions, each on one piece.

    Attributes
    ----------
    ground : Ground
    boxes : (b, 5)
        Piece, first and last arc length [m], first and last direction [rad].
    """

    ground: Ground
    boxes: Array

    @cached_property
    def hull(self) -> Hull:
        """What spans it."""
        return self.finer_hull(WIDEST_ARC)

    def finer_hull(self, step: float) -> Hull:
        """Return what spans it, from arcs of at most so many radians.

        For a fixed normal n, max(0, n . b) is convex in b. So no more is exerted in a region than
        by robots split up among points whose hull contains it: at the ends of the contacts,
        and there at the corners of a polygon around the arc of directions.
        """
        points, at = [], []
        for box in self.boxes:
            radii, angles = _around(box[LOW], box[HIGH], step, 2 if len(self.boxes) == 1 else 1)
            for arc in sorted({box[START], box[END]}):
                points.append(self.ground.points_at(int(box[PIECE]), arc, radii, angles))
                at.append(np.column_stack([np.full(len(angles), arc), angles]))
        return Hull(np.vstack(points), np.vstack(at))

    def halves(self, axis: int) -> Cut | None:
        """Return the region in two; None if it is too thin that way."""
        return (self._by_contact, self._by_direction)[axis]

    @cached_property
    def _by_contact(self) -> Cut | None:
        return self._cut(START, END, THIN * self.ground.outline.perimeter)

    @cached_property
    def _by_direction(self) -> Cut | None:
        return self._cut(LOW, HIGH, THIN)

    def _cut(self, first: int, last: int, thin: float) -> Cut | None:
        """Halve it between boxes if that can be, otherwise in the middle."""
        boxes = self.boxes
        low, high = boxes[:, first].min(), boxes[:, last].max()
        if high - low <= thin:
            return None
        where = 0.5 * (low + high)
        ends = np.unique(boxes[:, [first, last]])
        inner = ends[(ends > low + thin) & (ends < high - thin)]
        if first == START and len(inner):
            where = inner[np.argmin(np.abs(inner - where))]
        elif not (boxes[:, last] - boxes[:, first] > thin).any():  # single directions only
            middle = len(ends) // 2
            where = 0.5 * (ends[middle - 1] + ends[middle])
        halves: tuple[list[Array], list[Array]] = ([], [])
        for box in boxes:
            if box[first] < where - thin and box[last] > where + thin:
                for half, column in zip(halves, (last, first), strict=True):
                    part = box.copy()
                    part[column] = where
                    half.append(part)
            else:
                halves[int(0.5 * (box[first] + box[last]) >= where)].append(box)
        if not halves[0] or not halves[1]:
            return None
        below, above = (Region(self.ground, np.array(half)) for half in halves)
        return Cut(below, above, float(where))

    def span(self, axis: int) -> float:
        """Return its width in contacts [m] or directions [rad]."""
        first, last = ((START, END), (LOW, HIGH))[axis]
        return float(self.boxes[:, last].max() - self.boxes[:, first].min())

    @cached_property
    def room(self) -> float:
        """How many newcomers have room in it at the spacing, or a few more; inf without one."""
        spacing = self.ground.spacing - self.ground.near
        if spacing <= 0.0:
            return math.inf
        return float(sum(math.floor((end - start) / spacing) + 1 for start, end in self._runs))

    @cached_property
    def _runs(self) -> list[tuple[float, float]]:
        """Its contacts as intervals of arc lengths [m], each on one edge, that do not overlap."""
        edges = self.ground.edges[self.boxes[:, PIECE].astype(int)].tolist()
        starts, ends = self.boxes[:, START].tolist(), self.boxes[:, END].tolist()
        runs: list[tuple[int, float, float]] = []
        for edge, start, end in sorted(zip(edges, starts, ends, strict=True)):
            if runs and runs[-1][0] == edge and start <= runs[-1][2]:
                runs[-1] = (edge, runs[-1][1], max(end, runs[-1][2]))
            else:
                runs.append((edge, start, end))
        return [(start, end) for _, start, end in runs]

    @cached_property
    def ends(self) -> Array:
        """(e, 2) [m, m]: the ends of its contacts' intervals."""
        outline = self.ground.outline
        found = []
        for box in self.boxes:
            edge = self.ground.edges[int(box[PIECE])]
            p, q = outline.edge_ends(edge)
            base, length = outline.corner_arc_lengths[edge], outline.lengths[edge]
            found += [p + (q - p) * ((arc - base) / length) for arc in box[[START, END]]]
        return np.array(found)

    def is_apart(self, other: "Region") -> bool:
        """Tell whether a newcomer in each may keep the spacing."""
        spacing = self.ground.spacing - self.ground.near
        if spacing <= 0.0:
            return True
        offsets = self.ends[:, None] - other.ends[None]
        return bool(np.linalg.norm(offsets, axis=2).max() >= spacing)


def whole(ground: Ground) -> Region:
    """Return the region of all pieces; directions lie within [-pi, pi]."""
    boxes = []
    arcs = ground.outline.corner_arc_lengths[ground.edges]
    for k, (arc, low, high) in enumerate(zip(arcs, ground.low, ground.high, strict=True)):
        start, end = arc + low[0], arc + high[0]
        first = (low[1] + math.pi) % math.tau - math.pi
        last = first + high[1] - low[1]
        if last > math.pi + THIN:
            boxes.append((k, start, end, first, math.pi))
            first, last = -math.pi, last - math.tau
        boxes.append((k, start, end, first, last))
    return Region(ground, np.array(boxes))


def _around(low: float, high: float, step: float, least: int) -> tuple[Array, Array]:
    """Return the corners of a polygon around an arc of the unit circle: radii and angles."""
    width = high - low
    if width <= THIN:
        return np.ones(1), np.array([0.5 * (low + high)])
    count = max(least, math.ceil(width / step - 1e-9))
    half = 0.5 * width / count
    angles = low + half * np.arange(1, 2 * count, 2)
    radii = np.full(count, 1.0 / math.cos(half))
    return np.concatenate([[1.0], radii, [1.0]]), np.concatenate([[low], angles, [high]])
