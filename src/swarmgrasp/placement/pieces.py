"""The pieces of a placement: straight contacts with one-sided sectors of directions (T8)."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import NowhereToAttach
from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.placement.problem import Problem
from swarmgrasp.robot import RIGHT_ANGLE, Zone

Interval = tuple[float, float]

SLIVER = 1e-9
"""Width of contacts, allowed or not, that counts as rounding, relative to the outline's extent."""


@dataclass(frozen=True)
class Piece:
    """A straight part of one edge and a sector of directions on one side of it.

    Attributes
    ----------
    edge : int
    start, end : float [m]
        Distances along the edge; equal for a single point.
    lo, hi : float [rad]
        The sector, 0 <= hi - lo <= pi.
    inward : bool
        Whether its forces point into the object.
    place : str
        The zone's name, or the edge's.
    """

    edge: int
    start: float
    end: float
    lo: float
    hi: float
    inward: bool
    place: str


def pieces_of(problem: Problem) -> list[Piece]:
    """List all pieces a newcomer may attach to.

    Raises
    ------
    NowhereToAttach
        If there are none.
    """
    outline, newcomer = problem.swarm.outline, problem.newcomer
    pieces = []
    for zone, label in zip(problem.zones or (None,), problem.zone_labels, strict=True):
        for edge, start, end in _allowed(problem, zone):
            inward_normal = outline.inward_normal(edge)
            for inward in (True, False):
                middle = inward_normal if inward else inward_normal + math.pi
                for lo, hi in _sectors(
                    newcomer.attachment, newcomer.half_angle, zone, inward, middle
                ):
                    place = label or outline.edge_label(edge)
                    pieces.append(Piece(edge, start, end, lo, hi, inward, place))
    if not pieces:
        raise NowhereToAttach(
            "no boundary point is left to the newcomer: widen the zones or their directions, "
            "shorten the no-go stretches or lessen the spacing"
        )
    return pieces


def piece_rows(outline: Outline, pieces: Sequence[Piece]) -> NDArray[np.float64]:
    """Return the pieces as rows for the kernels, (k, 10); see `kernels.sector`."""
    rows = np.empty((len(pieces), 10))
    for row, piece in zip(rows, pieces, strict=True):
        first, last = (point_on(outline, piece, s) - outline.origin for s in (0.0, 1.0))
        row[0:2], row[2:4] = (first, last) if piece.inward else (last, first)
        row[4:6] = piece.lo, piece.hi
    rows[:, 6], rows[:, 7] = np.cos(rows[:, 4]), np.sin(rows[:, 4])
    rows[:, 8], rows[:, 9] = np.cos(rows[:, 5]), np.sin(rows[:, 5])
    return rows


def point_on(outline: Outline, piece: Piece, share: float) -> NDArray[np.float64]:
    """Return the boundary point (2,) [m, m] at a share of the way along a piece."""
    p, q = outline.edge_ends(piece.edge)
    along = piece.start + share * (piece.end - piece.start)
    return np.asarray(p + (q - p) * (along / outline.lengths[piece.edge]))


def _allowed(problem: Problem, zone: Zone | None) -> Iterator[tuple[int, float, float]]:
    """Yield (edge, start, end) of every stretch of a zone that is left to the newcomer."""
    outline = problem.swarm.outline
    for edge in range(len(outline)):
        wanted = [(0.0, float(outline.lengths[edge]))]
        if zone is not None:
            wanted = _on_edge(outline, edge, zone.stretch)
        taken = [run for stretch in problem.no_go for run in _runs(outline, edge, stretch)]
        taken += _crowded(problem, edge)
        sliver = SLIVER * outline.extent
        for start, end in wanted:
            if start == end:
                if not any(a + sliver < start < b - sliver for a, b in taken):
                    yield edge, start, end
                continue
            for a, b in _minus((start, end), taken):
                if b - a > sliver:
                    yield edge, a, b


def _runs(outline: Outline, edge: int, stretch: Stretch) -> list[Interval]:
    """Return a stretch as distances along an edge, on every lap that may touch it."""
    lap = outline.perimeter
    start = stretch.start - float(outline.corner_arc_lengths[edge])
    length = stretch.end - stretch.start + (lap if stretch.end < stretch.start else 0.0)
    return [(start + turn, start + turn + length) for turn in (-lap, 0.0, lap)]


def _on_edge(outline: Outline, edge: int, stretch: Stretch) -> list[Interval]:
    """Return the parts of an edge that a stretch covers, as distances along the edge.

    A point on a corner belongs to both edges; a longer stretch that only touches an
    edge's end does not cover it.
    """
    length, near = float(outline.lengths[edge]), outline.tolerance
    parts = []
    for a, b in _runs(outline, edge, stretch):
        lo, hi = max(a, 0.0), min(b, length)
        if stretch.is_point and -near <= a <= length + near:
            parts.append((min(lo, length),) * 2)
        elif hi - lo > SLIVER * outline.extent:
            parts.append((lo, hi))
    return parts


def _crowded(problem: Problem, edge: int) -> Iterator[Interval]:
    """Yield the parts of an edge that are too near a robot already there."""
    outline, spacing = problem.swarm.outline, problem.spacing
    if spacing == 0.0:
        return
    p, q = outline.edge_ends(edge)
    along = (q - p) / outline.lengths[edge]
    for robot in problem.swarm.robots:
        offset = np.asarray(robot.contact) - p
        middle = float(offset @ along)
        height = float(abs(offset[0] * along[1] - offset[1] * along[0]))
        if not robot.mounted and height < spacing - SLIVER * outline.extent:
            half = math.sqrt(spacing**2 - height**2)
            yield middle - half, middle + half


def _minus(whole: Interval, taken: list[Interval]) -> list[Interval]:
    """Return what open intervals leave of a closed one."""
    left = [whole]
    for a, b in taken:
        left = [
            part
            for lo, hi in left
            for part in ((lo, min(hi, a)), (max(lo, b), hi))
            if part[0] < part[1]
        ]
    return left


def _sectors(
    attachment: str, half_angle: float | None, zone: Zone | None, inward: bool, middle: float
) -> list[Interval]:
    """Return the sectors of directions allowed on one side of an edge."""
    if zone is not None and zone.attachment is not None:
        attachment, half_angle = zone.attachment, zone.half_angle
    if attachment == ("pull" if inward else "push"):
        return []
    half = RIGHT_ANGLE if half_angle is None else half_angle
    lo, hi = middle - half, middle + half
    return [(lo, hi)] if zone is None else zone.sectors(lo, hi)
