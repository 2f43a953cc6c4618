"""The pieces of a placement: straight contacts with one-sided sectors of directions (T8)."""

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import NowhereToAttach
from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.outline.lines import free_cells
from swarmgrasp.outline.nearest import chords
from swarmgrasp.swarm import Newcomer, Zone
from swarmgrasp.swarm.robot import RIGHT_ANGLE, Attachment
from swarmgrasp.swarm.sectors import SAME_ANGLE

Interval = tuple[float, float]

SLIVER = 1e-9
"""Width of contacts, allowed or not, that counts as rounding, relative to the outline's extent."""
LINE = "; a line that pulls has to run free of the object"
"""What else may leave nothing to a newcomer that pulls."""
REMEMBERED = 32
"""Outlines whose pieces are kept for the next question."""


class Piece(NamedTuple):
    """A straight part of one edge and a sector of directions on one side of it.

    Attributes
    ----------
    edge : int
    start, end : float [m]
        Distances along the edge; equal for a single point.
    lo, hi : float [rad]
        The sector, 0 <= hi - lo <= pi; up to 2 pi for a newcomer that keeps it.
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


@dataclass(frozen=True, eq=False)
class Pieces:
    """All pieces a newcomer may attach to.

    Attributes
    ----------
    each : tuple of Piece
    rows : (k, 10)
        As the kernels take them: the moment arms of both ends [m], in an order that makes
        the torque grow from the first to the second, the sector's limits [rad], and the
        cosine and sine of each.
    """

    outline: Outline
    each: tuple[Piece, ...]
    rows: NDArray[np.float64]

    def arm_at(self, index: int, share: float) -> Interval:
        """Return the moment arm [m, m] at a share of the way along a row."""
        first_x, first_y, last_x, last_y = self.rows[index, :4].tolist()
        return first_x + (last_x - first_x) * share, first_y + (last_y - first_y) * share

    def point_at(self, index: int, share: float) -> Interval:
        """Return the contact [m, m] at a share of the way along a row."""
        piece = self.each[index]
        return _point_on(self.outline, piece, share if piece.inward else 1.0 - share)

    @property
    def places(self) -> list[str]:
        """The place of each."""
        return [piece.place for piece in self.each]

    def robot_at(self, index: int, c: float, s: float, torque: float) -> tuple[Interval, float]:
        """Return the contact [m, m] and direction [rad] of a unit wrench [1, 1, m] on a piece."""
        first_x, first_y, last_x, last_y = self.rows[index, :4].tolist()
        from_first, from_last = first_x * s - first_y * c, last_x * s - last_y * c
        spread = from_last - from_first
        share = 0.5 if spread == 0.0 else min(max((torque - from_first) / spread, 0.0), 1.0)
        return self.point_at(index, share), math.atan2(s, c)


def pieces_of(
    outline: Outline,
    newcomer: Newcomer,
    zones: Sequence[Zone] | None = None,
    no_go: Sequence[Stretch] = (),
    crowd: NDArray[np.float64] | None = None,
    spacing: float = 0.0,
) -> Pieces:
    """List all pieces a newcomer may attach to.

    Parameters
    ----------
    outline : Outline
    newcomer : Newcomer
    zones, no_go, spacing
        As for `Problem`.
    crowd : (n, 2) [m, m], optional
        The contacts that the spacing is kept to.

    Raises
    ------
    NowhereToAttach
        If there are none.
    """
    crowded = crowd is not None and spacing > 0.0
    if zones is None and not no_go and not crowded:
        keeps = (newcomer.steers, newcomer.friction)
        return _whole_boundary(outline, newcomer.attachment, newcomer.half_angle, *keeps)
    pieces: list[Piece] = []
    for zone, label in zip(zones or (None,), zone_labels(zones), strict=True):
        for edge in range(len(outline)):
            taken = [run for stretch in no_go for run in runs_on(outline, edge, stretch)]
            if crowd is not None and spacing > 0.0:
                taken += crowded_on(outline, edge, crowd, spacing)
            for start, end in _allowed(outline, edge, zone, taken):
                pieces += _on_stretch(outline, newcomer, zone, label, edge, start, end)
    is_line = any(_attachment(newcomer, zone)[0] == "pull" for zone in zones or (None,))
    return checked_pieces(outline, pieces, LINE * is_line)


def zone_labels(zones: Sequence[Zone] | None) -> tuple[str, ...]:
    """Return the zones' names; of several with one name, each with its number; "" without zones."""
    names = [zone.name for zone in zones or ()]
    uses, so_far, labels = Counter(names), Counter[str](), []
    for name in names:
        so_far[name] += 1
        labels.append(f"{name} ({so_far[name]})" if name and uses[name] > 1 else name)
    return tuple(labels) or ("",)


@lru_cache(maxsize=REMEMBERED)
def _whole_boundary(
    outline: Outline, attachment: Attachment, half_angle: float | None, steers: bool,
    friction: float | None,
) -> Pieces:  # fmt: skip
    """Return the pieces of a newcomer that may attach anywhere."""
    newcomer = Newcomer(1.0, attachment, half_angle, steers=steers, friction=friction)
    pieces: list[Piece] = []
    for edge in range(len(outline)):
        end = float(outline.lengths[edge])
        pieces += _on_stretch(outline, newcomer, None, "", edge, 0.0, end)
    return checked_pieces(outline, pieces)


def checked_pieces(outline: Outline, pieces: list[Piece], more: str = "") -> Pieces:
    """Return pieces with their rows.

    Parameters
    ----------
    outline : Outline
    pieces : list of Piece
    more : str
        What else may have taken all the boundary, with a semicolon before it.

    Raises
    ------
    NowhereToAttach
        If there are none.
    """
    if not pieces:
        raise NowhereToAttach(
            "no boundary point is left to the newcomer: widen the zones or their directions, "
            f"shorten the no-go stretches or lessen the spacing{more}"
        )
    numbers = np.array([piece[:6] for piece in pieces])
    edges = numbers[:, 0].astype(int)
    corners = outline.vertices - outline.origin
    p = corners[edges]
    along = (np.roll(corners, -1, axis=0)[edges] - p) / outline.lengths[edges][:, None]
    inward = numbers[:, 5:6] != 0.0
    first = p + along * np.where(inward, numbers[:, 1:2], numbers[:, 2:3])
    last = p + along * np.where(inward, numbers[:, 2:3], numbers[:, 1:2])
    return Pieces(outline, tuple(pieces), rows_of(first, last, numbers[:, 3:5]))


def halves_of(sectors: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far sectors (..., 2) [rad] reach to both sides: pi of a whole turn.

    Examples
    --------
    >>> halves_of(np.array([[0.1, 0.5], [0.7 - math.pi, 0.7 + math.pi - 1e-15]])).tolist()
    [0.2, 3.141592653589793]
    """
    width = sectors[..., 1] - sectors[..., 0]
    return np.where(width >= math.tau - SAME_ANGLE, math.pi, 0.5 * width)


def rows_of(
    first: NDArray[np.float64], last: NDArray[np.float64], sectors: ArrayLike
) -> NDArray[np.float64]:
    """Return pieces as the kernels take them, (k, 10), from ends and sectors, (k, 2) each."""
    limits = np.asarray(sectors, dtype=float)
    rows = np.empty((len(limits), 10))
    rows[:, 0:2], rows[:, 2:4], rows[:, 4:6] = first, last, limits
    rows[:, 6::2], rows[:, 7::2] = np.cos(limits), np.sin(limits)
    rows.setflags(write=False)
    return rows


def _point_on(outline: Outline, piece: Piece, share: float) -> Interval:
    """Return the boundary point [m, m] at a share of the way along a piece."""
    p, q = outline.edge_ends(piece.edge)
    along = (piece.start + share * (piece.end - piece.start)) / float(outline.lengths[piece.edge])
    (x, y), (to_x, to_y) = p.tolist(), q.tolist()
    return x + (to_x - x) * along, y + (to_y - y) * along


def _on_stretch(
    outline: Outline, newcomer: Newcomer, zone: Zone | None, label: str, edge: int,
    start: float, end: float,
) -> Iterator[Piece]:  # fmt: skip
    """Yield the pieces of one stretch of an edge."""
    inward_normal = outline.inward_normal(edge)
    place = label or outline.edge_label(edge)
    for inward in (True, False):
        middle = inward_normal if inward else inward_normal + math.pi
        for lo, hi in _sectors(newcomer, zone, inward, middle):
            if inward or _attachment(newcomer, zone)[0] != "pull":
                yield Piece(edge, start, end, lo, hi, inward, place)
            else:
                for a, b, first, last in _free(outline, edge, (start, end), (lo, hi), middle):
                    yield Piece(edge, a, b, first, last, inward, place)


def _free(
    outline: Outline, edge: int, stretch: Interval, sector: Interval, middle: float
) -> Iterator[tuple[float, float, float, float]]:
    """Yield the parts of a stretch with the directions in which a line from there runs free."""
    (start, end), (lo, hi), cells = stretch, sector, free_cells(outline)[edge]
    if cells is None:
        yield start, end, lo, hi
        return
    for cell in cells:
        a, b = max(start, cell.start), min(end, cell.end)
        first, last = max(lo, middle + cell.lo), min(hi, middle + cell.hi)
        if first <= last and (b - a > SLIVER * outline.extent or (start == end and a == b)):
            yield a, b, first, last


def _allowed(
    outline: Outline, edge: int, zone: Zone | None, taken: list[Interval]
) -> Iterator[Interval]:
    """Yield (start, end) of every stretch of an edge that a zone allows and others leave."""
    sliver = SLIVER * outline.extent
    wanted = [(0.0, float(outline.lengths[edge]))]
    if zone is not None and zone.stretch is not None:
        wanted = parts_on(outline, edge, zone.stretch)
    for start, end in wanted:
        if start == end:
            if not any(a + sliver < start < b - sliver for a, b in taken):
                yield start, end
            continue
        for a, b in left_of((start, end), taken):
            if b - a > sliver:
                yield a, b


def runs_on(outline: Outline, edge: int, stretch: Stretch) -> list[Interval]:
    """Return a stretch as distances along an edge, on every lap that may touch it."""
    lap = outline.perimeter
    start = stretch.start - float(outline.corner_arc_lengths[edge])
    length = stretch.end - stretch.start + (lap if stretch.end < stretch.start else 0.0)
    return [(start + turn, start + turn + length) for turn in (-lap, 0.0, lap)]


def parts_on(outline: Outline, edge: int, stretch: Stretch) -> list[Interval]:
    """Return the parts of an edge that a stretch covers, as distances along the edge.

    A point on a corner belongs to both edges; a longer stretch that only touches an
    edge's end does not cover it.
    """
    length, near = float(outline.lengths[edge]), outline.tolerance
    parts = []
    for a, b in runs_on(outline, edge, stretch):
        lo, hi = max(a, 0.0), min(b, length)
        if stretch.is_point and -near <= a <= length + near:
            parts.append((min(lo, length),) * 2)
        elif hi - lo > SLIVER * outline.extent:
            parts.append((lo, hi))
    return parts


def crowded_on(
    outline: Outline, edge: int, crowd: NDArray[np.float64], spacing: float
) -> list[Interval]:
    """Return the parts of an edge that are too near a robot already there."""
    p, q = outline.edge_ends(edge)
    along = (q - p) / outline.lengths[edge]
    _, first, last = chords(p, along, crowd, spacing, SLIVER * outline.extent)
    return list(zip(first.tolist(), last.tolist(), strict=True))


def left_of(whole: Interval, taken: list[Interval]) -> Iterator[Interval]:
    """Yield what open intervals leave of a closed one."""
    start, end = whole
    for a, b in sorted(taken):
        if b <= a or b <= start:
            continue
        if a >= end:
            break
        if a > start:
            yield start, a
        start = b
    if start < end:
        yield start, end


def _sectors(newcomer: Newcomer, zone: Zone | None, inward: bool, middle: float) -> list[Interval]:
    """Return the sectors of directions allowed on one side of an edge."""
    attachment, half_angle = _attachment(newcomer, zone)
    if newcomer.friction:  # a finger pushes, whatever else a zone lets others do
        attachment, half_angle = ("pull" if attachment == "pull" else "push"), 0.0
        if not inward:
            return []
    if newcomer.steers and attachment == "free":  # one sector, not one on each side
        if not inward:
            return []
        return [(middle - math.pi, middle + math.pi)] if zone is None else [zone.turns(middle)]
    if attachment == ("pull" if inward else "push"):
        return []
    half = RIGHT_ANGLE if half_angle is None else half_angle
    lo, hi = middle - half, middle + half
    return [(lo, hi)] if zone is None else zone.sectors(lo, hi)


def _attachment(newcomer: Newcomer, zone: Zone | None) -> tuple[Attachment, float | None]:
    """Return how a newcomer attaches in a zone, and its half angle [rad]."""
    if zone is not None and zone.attachment is not None:
        return zone.attachment, zone.half_angle
    return newcomer.attachment, newcomer.half_angle
