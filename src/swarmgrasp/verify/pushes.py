"""What robots of any force set exert, from what is said of them: for the check of push forces.

Support functions are made anew from limits, steering, friction and envelopes (T20). Shares and the
least squares are checked by nothing else: a force is in a set if it is behind its support in
every direction.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Pair = tuple[float, float]
THIN = 1e-9
"""Of its largest force: what a set may be thicker than it is said to be."""
NO_CHOICE = 1e-12
"""Of its limit: a reach that is rounding."""
ANGLE = 1e-8
"""Difference of two directions [rad] that counts as none."""
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
LOOKS = 72
"""Steps of a golden section that leave what rounding leaves of a half turn."""


@dataclass(frozen=True, eq=False)
class Robots:
    """What is said of robots.

    Attributes
    ----------
    arms : (n, 2) [m, m]
        Contacts relative to the origin of moments.
    directions, steers : (n,) [rad]
    limits, reverse_limits, leasts : (n,) [N]
    frictions : (n,)
    envelopes : mapping of int to points (N, N)
        By index.
    sectors : mapping of int to pairs (rad, rad)
        By index: the directions, with gaps between. Such a robot counts as what it would be with
        the gaps filled: the hull of its forces.
    """

    arms: Array
    directions: Array
    limits: Array
    reverse_limits: Array
    steers: Array
    frictions: Array
    leasts: Array
    envelopes: Mapping[int, Sequence[Pair]]
    sectors: Mapping[int, Sequence[Pair]]

    @property
    def are_rays(self) -> bool:
        """Whether all push along one ray each, from nothing to their limit."""
        extra = (self.reverse_limits, self.steers, self.frictions, self.leasts)
        has_more = bool(self.envelopes or self.sectors)
        return not has_more and not any(column.any() for column in extra)

    def keeping(self, kept: Sequence[tuple[int, Pair]]) -> "Robots":
        """Return the same with some robots with gaps that keep to one sector each."""
        directions, steers, left = self.directions.copy(), self.steers.copy(), dict(self.sectors)
        for i, (start, end) in kept:
            directions[i], steers[i] = 0.5 * (start + end), 0.5 * (end - start)
            del left[i]
        return replace(self, directions=directions, steers=steers, sectors=left)

    @cached_property
    def corners(self) -> dict[int, Array]:
        """Corners of the envelopes, (k, 2) [N, N] in the object's frame."""
        found = {}
        for i, points in self.envelopes.items():
            c, s = math.cos(self.directions[i]), math.sin(self.directions[i])
            found[i] = np.asarray(points, dtype=float) @ np.array([[c, s], [-s, c]])
        return found

    @cached_property
    def rests(self) -> Array:
        """(n, 2) [N, N]: the force of each set nearest to none."""
        steady = self.leasts * np.where(
            self.frictions > 0.0, 1.0, np.maximum(np.cos(self.steers), 0.0)
        )
        found = steady[:, None] * self._ways
        for i, corners in self.corners.items():
            found[i] = _nearest(corners)
        return found

    @cached_property
    def reaches(self) -> Array:
        """(n,) [N]: the largest force of each beyond its rest; 0 if it has no choice."""
        half, least, across = self.steers, self.leasts, self.frictions * self.limits
        steady = np.hypot(*self.rests.T)
        ends = np.hypot(self.limits * np.cos(half) - steady, self.limits * np.sin(half) + across)
        found = np.maximum.reduce([self.limits - steady, self.reverse_limits, ends])
        found = np.maximum(found, np.hypot(least * np.cos(half) - steady, least * np.sin(half)))
        for i, corners in self.corners.items():
            found[i] = np.hypot(*(corners - self.rests[i]).T).max()
        return np.where(found > NO_CHOICE * self.limits, found, 0.0)

    @cached_property
    def _ways(self) -> Array:
        """(n, 2): the directions as unit vectors."""
        return np.column_stack([np.cos(self.directions), np.sin(self.directions)])

    def supports(self, levers: Array) -> Array:
        """Return the greatest F . p over each set, beyond its rest, for p (..., n, 2): (..., n)."""
        x, y = np.moveaxis(levers, -1, 0)
        ahead = x * self._ways[:, 0] + y * self._ways[:, 1]
        aside = np.abs(y * self._ways[:, 0] - x * self._ways[:, 1])
        size, off = np.hypot(ahead, aside), np.arctan2(aside, ahead)
        front = self.limits * np.cos(np.maximum(off - self.steers, 0.0)) * size
        back = np.cos(np.maximum(math.pi - off - self.steers, 0.0)) * size
        held = self.leasts * np.cos(off - self.steers) * size
        found = np.maximum(front, np.where(self.leasts > 0.0, held, self.reverse_limits * back))
        gripped = ahead + self.frictions * aside
        gripped = np.maximum(self.limits * gripped, self.leasts * gripped)
        found = np.where(self.frictions > 0.0, gripped, found)
        for i, corners in self.corners.items():
            found[..., i] = (levers[..., i, :] @ corners.T).max(axis=-1)
        for i, sectors in self.sectors.items():
            way = np.arctan2(y[..., i], x[..., i])
            off = np.min([outside(way, *sector) for sector in sectors], axis=0)
            ahead = np.cos(np.minimum(off, 0.5 * math.pi))
            found[..., i] = self.limits[i] * size[..., i] * ahead
        return np.asarray(found - (levers * self.rests).sum(axis=-1))

    def levers(self, normals: Array) -> Array:
        """Return p of normals (..., 3) for each robot, with which F is worth F . p: (..., n, 2)."""
        force, turn = normals[..., None, :2], normals[..., None, 2:]
        return np.asarray(force + turn * np.column_stack([-self.arms[:, 1], self.arms[:, 0]]))

    def wrenches(self, forces: Array) -> Array:
        """Return the wrenches (..., n, 3) [N, N, N m] of forces (..., n, 2)."""
        torque = self.arms[:, 0] * forces[..., 1] - self.arms[:, 1] * forces[..., 0]
        return np.concatenate([forces, torque[..., None]], axis=-1)

    def shares(self, forces: Array) -> tuple[Array, Array]:
        """Return between which forces (..., n, 2) beyond the rests are as parts of their sets.

        The greatest of F . p over the support is the share, and rises to it and falls from it as p
        turns. The sets are taken `THIN` thicker first, and then as they are in that direction.
        """
        middle = np.arctan2(forces[..., 1], forces[..., 0])
        thick = THIN * self.reaches

        def parts(turn: Array) -> tuple[Array, Array]:
            """Return the force's part along a direction, and what the set has there."""
            p = np.stack([np.cos(middle + turn), np.sin(middle + turn)], axis=-1)
            return (forces * p).sum(axis=-1), np.maximum(self.supports(p), 0.0)

        def share(turn: Array) -> Array:
            """Return the share along a direction, of thicker sets."""
            part, whole = parts(turn)
            return np.asarray(part / np.maximum(whole + thick, np.finfo(float).tiny))

        low, high = np.full(middle.shape, -0.5 * math.pi), np.full(middle.shape, 0.5 * math.pi)
        a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        at_a, at_b = share(a), share(b)
        for _ in range(LOOKS):
            is_left = at_a > at_b
            low, high = np.where(is_left, low, a), np.where(is_left, b, high)
            kept, at_kept = np.where(is_left, a, b), np.where(is_left, at_a, at_b)
            new = np.where(is_left, high - GOLDEN * (high - low), low + GOLDEN * (high - low))
            at_new = share(new)
            a, b = np.where(is_left, new, kept), np.where(is_left, kept, new)
            at_a, at_b = np.where(is_left, at_new, at_kept), np.where(is_left, at_kept, at_new)
        best = np.where(at_a > at_b, a, b)
        part, whole = parts(best)
        least = np.maximum(np.maximum(at_a, at_b), share(np.zeros(middle.shape)))
        with np.errstate(divide="ignore", invalid="ignore"):
            most = np.where(part > 0.0, part / whole, 0.0)
        is_none = ~forces.any(axis=-1) | (self.reaches == 0.0)
        return np.where(is_none, 0.0, least), np.where(is_none, 0.0, np.maximum(most, least))


def outside(way: Array, start: float, end: float) -> Array:
    """Return how far directions [rad] are outside a sector [rad]."""
    past = (way - start) % math.tau - (end - start)
    return np.asarray(np.maximum(np.minimum(past, (start - way) % math.tau), 0.0))


def is_part(part: Pair, sectors: Sequence[Pair]) -> bool:
    """Tell whether a sector is a part of one of some, and convex."""
    start, end = part
    return 0.0 <= end - start <= math.pi + ANGLE and any(
        (start - first + ANGLE) % math.tau + end - start <= last - first + 2.0 * ANGLE
        for first, last in sectors
    )


def _nearest(corners: Array) -> Array:
    """Return the point (2,) nearest to the origin in the hull of corners (k, 2)."""
    turns = np.sort(np.arctan2(corners[:, 1], corners[:, 0]))
    gap = np.diff(turns, append=turns[0] + math.tau).max()
    best = corners[np.argmin(np.hypot(*corners.T))]
    if gap <= math.pi:
        return np.zeros(2)
    for i, a in enumerate(corners):
        for b in corners[:i]:
            way = b - a
            size = float(way @ way)
            point = a + min(max(-float(a @ way) / size, 0.0), 1.0) * way if size > 0.0 else a
            if np.hypot(*point) < np.hypot(*best):
                best = point
    return np.where(np.hypot(*best) <= 1e-12 * np.hypot(*corners.T).max(), 0.0, best)
