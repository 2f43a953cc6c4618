"""Where a newcomer may attach and which way it may push, found anew for the check of an answer.

Every edge is cut wherever anything changes: at the ends of zones and no-go stretches, and where
a robot comes too near. Each part is then allowed or not as a whole.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from swarmgrasp.verify.boundary import Boundary, surrounds
from swarmgrasp.verify.lines import free_parts
from swarmgrasp.verify.recompute import (
    ANGLE,
    Array,
    covers,
    distance_to,
    hull_of,
    is_line,
    labels_of,
    sides_of,
    whole_turn,
    within,
)

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import ProblemClaim, RobotClaim, ZoneClaim

INSIDE = "inside"
"""What the whole inside of the outline is called."""
Span = tuple[float, float]
NEXT = 1e-5
"""Relative difference of widths next to a sliver's that rounding may make."""


@dataclass(frozen=True)
class Piece:
    """Contacts between two points of an edge [m], and a sector of directions [rad].

    Of an area, the points where the torque of these directions is least and greatest.
    """

    place: str
    p: Array
    q: Array
    lo: float
    hi: float
    is_sliver: bool
    """Whether the contacts are no more than rounding: no bound is asked for there."""
    area: Array | None = None
    edge: int = -1
    """Of the boundary; -1 for an area."""

    def has(self, point: Array, near: float) -> bool:
        """Tell whether a contact is allowed, but for so much [m]."""
        if self.area is None:
            return distance_to(point, self.p, self.q) <= near
        return surrounds(self.area, point) or any(
            distance_to(point, a, b) <= near
            for a, b in zip(self.area, np.roll(self.area, -1, axis=0), strict=True)
        )


@dataclass(frozen=True)
class Allowed:
    """What a placement's question allows, beside the robots already there."""

    asked: "ProblemClaim"
    boundary: Boundary
    present: "list[RobotClaim]"

    def pieces(self) -> Iterator[Piece]:
        """Yield the allowed contacts and directions, edge by edge and side by side."""
        boundary = self.boundary
        lap, sliver = boundary.perimeter, boundary.sliver
        zones = [None] if self.asked.zones is None else self.asked.zones
        labels = labels_of(zones)
        if self.asked.newcomer.mounted:
            for zone, label in zip(zones, labels, strict=True):
                yield from self.inside(zone, label)
            return
        for edge, (length, base) in enumerate(zip(boundary.lengths, boundary.arcs, strict=False)):
            p, q = boundary.edge(edge)
            inward = math.atan2(q[0] - p[0], p[1] - q[1])
            for zone, label in zip(zones, labels, strict=True):
                for a, b in self.spans(zone, base, lap, p, q):
                    start, end = (p + (q - p) * (s / length) for s in (a, b))
                    middle = base + 0.5 * (a + b)
                    if not self.has(zone, middle, lap, 0.5 * (start + end)):
                        continue
                    place = label or boundary.names[edge] or f"edge {edge}"
                    sectors = list(sides_of(self.asked, zone, inward))
                    if is_line(self.asked, zone):
                        yield from self.lines(place, edge, (a, b), inward + math.pi, sectors)
                        continue
                    is_sliver = 0.0 < b - a <= sliver * (1.0 + NEXT)
                    for lo, hi in sectors:
                        yield Piece(place, start, end, lo, hi, is_sliver, None, edge)

    def lines(
        self, place: str, edge: int, span: Span, outward: float, sectors: list[Span]
    ) -> Iterator[Piece]:
        """Yield the parts of a span with the directions in which lines run free."""
        boundary = self.boundary
        (p, q), length = boundary.edge(edge), float(boundary.lengths[edge])
        for a, b, low, high in free_parts(boundary, edge, *span):
            start, end = (p + (q - p) * (s / length) for s in (a, b))
            for lo, hi in sectors:
                first, last = max(lo, outward + low), min(hi, outward + high)
                if first <= last:
                    is_sliver = 0.0 < b - a <= boundary.sliver * (1.0 + NEXT)
                    yield Piece(place, start, end, first, last, is_sliver, None, edge)

    def inside(self, zone: "ZoneClaim | None", label: str) -> Iterator[Piece]:
        """Yield pieces of an area, or of all inside: of what steers, the area itself.

        Between the directions of the edges of its hull, the same corners are those of the least
        and of the greatest torque.
        """
        area = self.boundary.corners if zone is None else np.array(zone.area)
        if self.asked.newcomer.steers:
            yield Piece(
                label if zone else INSIDE, area[0], area[0], *whole_turn(zone, 0.0), False, area
            )
            return
        corners = hull_of(area)
        steps = np.diff(np.vstack([corners, corners[:1]]), axis=0)
        turns = np.arctan2(steps[:, 1], steps[:, 0])
        cuts = np.unique([*(turns % math.tau), *((turns + math.pi) % math.tau), 0.0, math.pi])
        for lo, hi in pairwise([*cuts.tolist(), math.tau]):
            if hi - lo <= ANGLE:
                continue
            middle = 0.5 * (lo + hi)
            torques = corners @ np.array([math.sin(middle), -math.cos(middle)])
            p, q = corners[np.argmin(torques)], corners[np.argmax(torques)]
            for a, b in within(zone, lo, hi):
                yield Piece(label if zone else INSIDE, p, q, a, b, False, area)

    def spans(
        self, zone: "ZoneClaim | None", base: float, perimeter: float, p: Array, q: Array
    ) -> list[tuple[float, float]]:
        """Return the parts of an edge [m from its start] that are allowed or not as a whole.

        They run from each place where anything changes to the next; of a single point, such
        as a bollard, they are its places on the edge.
        """
        length, near = float(np.linalg.norm(q - p)), self.boundary.near
        own = zone.stretch if zone else None
        stretches = [*self.asked.no_go, *([own] if own else [])]
        is_point = own is not None and own.is_point
        cuts = set() if is_point else {0.0, length, *self.spacing_cuts(p, q)}
        for stretch in [own] if is_point and own else stretches:
            for arc in (stretch.start, stretch.end):
                for turn in (-perimeter, 0.0, perimeter):
                    at = arc + turn - base
                    if -near <= at <= length + near:
                        cuts.add(min(max(at, 0.0), length))
        marks = sorted(cuts)
        return [(s, s) for s in marks] if is_point else list(pairwise(marks))

    def spacing_cuts(self, p: Array, q: Array) -> Iterator[float]:
        """Yield where the circles around the robots cross an edge [m from its start]."""
        length, spacing = float(np.linalg.norm(q - p)), self.asked.spacing
        for robot in self.present if spacing > 0.0 else []:
            if not robot.mounted:
                d, from_p = (q - p) / length, np.array(robot.contact) - p
                height = abs(float(d[0] * from_p[1] - d[1] * from_p[0]))
                if height < spacing - self.boundary.sliver:
                    half = math.sqrt(spacing**2 - height**2)
                    foot = float(d @ from_p)
                    yield from (s for s in (foot - half, foot + half) if 0.0 < s < length)

    def has(self, zone: "ZoneClaim | None", arc: float, perimeter: float, point: Array) -> bool:
        """Tell whether a contact is in the zone, in no no-go stretch, and not too near."""
        sliver = self.boundary.sliver
        own = zone.stretch if zone else None  # of a single point the contact is its own
        if own and not own.is_point and not covers(own, arc, perimeter, sliver):
            return False
        if any(covers(stretch, arc, perimeter, -sliver) for stretch in self.asked.no_go):
            return False
        spacing = self.asked.spacing - sliver
        return all(
            robot.mounted or float(np.linalg.norm(point - np.array(robot.contact))) >= spacing
            for robot in self.present
        )
