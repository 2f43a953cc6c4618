"""Places of a mounted newcomer: areas inside the outline (T24).

One that keeps its force set may be anywhere on them: they are cut into triangles. For a fixed
direction all points of an area on one line of action are the same wrench, and only the two corners
outermost across the direction matter. So an area is as many pieces as there are sectors of
directions with the same two corners, each from one of them to the other.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import NowhereToAttach
from swarmgrasp.outline import Outline
from swarmgrasp.outline.polygon import triangles_of
from swarmgrasp.placement.pieces import Interval, rows_of, zone_labels
from swarmgrasp.swarm import Zone
from swarmgrasp.swarm.sectors import SAME_ANGLE

Array = NDArray[np.float64]
INSIDE = "inside"
"""What the whole inside of the outline is called."""
ON_LINE = 1e-12
"""Distance from a line of action, relative to the area's size, that is none."""


class AreaPiece(NamedTuple):
    """A sector of directions across which the same two corners of an area are outermost.

    Attributes
    ----------
    area : int
    first, last : int
        Its corners with the least and the greatest torque.
    lo, hi : float [rad]
        The sector, 0 <= hi - lo <= pi.
    place : str
        The zone's name.
    """

    area: int
    first: int
    last: int
    lo: float
    hi: float
    place: str


@dataclass(frozen=True, eq=False)
class Areas:
    """All pieces a mounted newcomer may be put on.

    Attributes
    ----------
    corners : tuple of (k, 2) [m, m]
        Of each area, as moment arms.
    each : tuple of AreaPiece
    rows : (k, 10)
        As of `Pieces`.
    """

    outline: Outline
    corners: tuple[Array, ...]
    each: tuple[AreaPiece, ...]
    rows: Array

    @property
    def places(self) -> list[str]:
        """The place of each."""
        return [piece.place for piece in self.each]

    def robot_at(self, index: int, c: float, s: float, torque: float) -> tuple[Interval, float]:
        """Return a contact [m, m], and the direction [rad], of a unit wrench [1, 1, m] on a piece.

        Of all the contacts on its line of action, the middle of the longest part inside.
        """
        corners = self.corners[self.each[index].area]
        x, y = (_middle_on_line(corners, c, s, torque) + self.outline.origin).tolist()
        return (x, y), math.atan2(s, c)


class Deck(NamedTuple):
    """An area, and the sector that a newcomer keeps there.

    Attributes
    ----------
    place : str
        The zone's name.
    lo, hi : float [rad]
    parts : tuple of (k, 2) [m, m]
        Moment arms of the corners of triangles, or of a line or a spot, that together make it.
    """

    place: str
    lo: float
    hi: float
    parts: tuple[Array, ...]


@dataclass(frozen=True, eq=False)
class Decks:
    """All areas that a mounted newcomer may be put on which keeps its force set."""

    outline: Outline
    each: tuple[Deck, ...]

    @property
    def places(self) -> list[str]:
        """The place of each."""
        return [deck.place for deck in self.each]


def decks_of(outline: Outline, zones: Sequence[Zone] | None) -> Decks:
    """List the areas of a mounted newcomer that keeps its force set.

    Parameters
    ----------
    outline : Outline
    zones : sequence of Zone, optional
        With areas; the whole inside of the outline when left out.
    """
    if not zones:
        return Decks(outline, (Deck(INSIDE, -math.pi, math.pi, _parts(outline.vertices, outline)),))
    return Decks(
        outline,
        tuple(
            Deck(label, *zone.turns(0.0), _parts(np.array(zone.area), outline))
            for zone, label in zip(zones, zone_labels(zones), strict=True)
        ),
    )


def _parts(corners: Array, outline: Outline) -> tuple[Array, ...]:
    """Cut an area into triangles, of moment arms; a line and a spot are as they are."""
    if len(corners) <= 3:
        return (corners - outline.origin,)
    return tuple(triangles_of(corners) - outline.origin)


def areas_of(outline: Outline, zones: Sequence[Zone] | None) -> Areas:
    """List all pieces of a mounted newcomer.

    Parameters
    ----------
    outline : Outline
    zones : sequence of Zone, optional
        With areas; the whole inside of the outline when left out.

    Raises
    ------
    NowhereToAttach
        If there are none.
    """
    areas = [np.array(zone.area) - outline.origin for zone in zones or ()]
    labels = zone_labels(zones) if zones else (INSIDE,)
    corners = tuple(areas) or (outline.vertices - outline.origin,)
    each = tuple(
        AreaPiece(k, first, last, a, b, labels[k])
        for k, area in enumerate(corners)
        for first, last, lo, hi in _outermost(area)
        for a, b in (zones[k].sectors(lo, hi) if zones else [(lo, hi)])
    )
    if not each:
        raise NowhereToAttach("no direction is left to the newcomer: widen those of the zones")
    first, last = (
        np.array([corners[piece.area][end] for piece, end in zip(each, ends, strict=True)])
        for ends in ([piece.first for piece in each], [piece.last for piece in each])
    )
    return Areas(outline, corners, each, rows_of(first, last, [piece[3:5] for piece in each]))


def _outermost(corners: Array) -> Iterator[tuple[int, int, float, float]]:
    """Yield the corners with the least and the greatest torque, and in which sector they are so."""
    hull = _hull(corners)
    steps = np.roll(corners[hull], -1, axis=0) - corners[hull]
    angles = np.arctan2(steps[:, 1], steps[:, 0])[: len(hull) if len(hull) > 1 else 0]
    cuts = np.unique(np.concatenate([angles, angles + math.pi, [0.0, math.pi]]) % math.tau)
    for lo, hi in zip(cuts, [*cuts[1:], cuts[0] + math.tau], strict=True):
        if hi - lo <= SAME_ANGLE:
            continue
        middle = 0.5 * (lo + hi)
        torques = corners[hull, 0] * math.sin(middle) - corners[hull, 1] * math.cos(middle)
        yield hull[np.argmin(torques)], hull[np.argmax(torques)], float(lo), float(hi)


def _hull(points: Array) -> list[int]:
    """Return the corners of the hull of points, counter-clockwise, without those on its edges."""
    order = np.lexsort((points[:, 1], points[:, 0])).tolist()
    sides: list[list[int]] = []
    for way in (order, order[::-1]):
        side: list[int] = []
        for k in way:
            while len(side) > 1 and _turn(*points[[side[-2], side[-1], k]]) <= 0.0:
                side.pop()
            side.append(k)
        sides.append(side[:-1])
    return sides[0] + sides[1] or order[:1]


def _turn(p: Array, q: Array, r: Array) -> float:
    """Return twice the area of a triangle, positive if it turns left."""
    return float((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))


def _middle_on_line(corners: Array, c: float, s: float, torque: float) -> Array:
    """Return the middle of the longest part of a line of action inside an area."""
    off = corners[:, 0] * s - corners[:, 1] * c - torque
    near = ON_LINE * float(np.abs(off).max())
    after, beyond = np.roll(off, -1), np.roll(corners, -1, axis=0)
    crossed = (off > near) & (after < -near) | (off < -near) & (after > near)
    share = (off[crossed] / (off[crossed] - after[crossed]))[:, None]
    points = np.vstack(
        [corners[np.abs(off) <= near], corners[crossed] * (1.0 - share) + beyond[crossed] * share]
    )
    if not len(points):  # only just outside, by rounding
        return np.asarray(corners[np.argmin(np.abs(off))])
    points = points[np.argsort(points @ np.array([c, s]), kind="stable")]
    middles = 0.5 * (points[:-1] + points[1:])
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    lengths = lengths[inside := _encloses(corners, middles)]
    if not len(lengths) or not lengths.max() > 0.0:
        return np.asarray(points[0])
    return np.asarray(middles[inside][np.argmax(lengths)])


def _encloses(corners: Array, points: Array) -> NDArray[np.bool_]:
    """Tell which points (m, 2) are inside: a ray from one crosses an odd number of edges."""
    ends = np.roll(corners, -1, axis=0)
    x, y = points[:, 0, None], points[:, 1, None]
    spans = (corners[:, 1] > y) != (ends[:, 1] > y)
    rise = np.where(ends[:, 1] == corners[:, 1], 1.0, ends[:, 1] - corners[:, 1])
    meets = corners[:, 0] + (y - corners[:, 1]) * (ends[:, 0] - corners[:, 0]) / rise
    return np.asarray((spans & (meets > x)).sum(axis=1) % 2 == 1)
