"""Where newcomers stand: on a piece each, so far along its edge, and in which direction."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement.pieces import SLIVER, Pieces, pieces_of
from swarmgrasp.placement.problem import Problem
from swarmgrasp.swarm import Robot, wrenches

Array = NDArray[np.float64]
Indices = NDArray[np.intp]
PARTS = 8
"""Contacts tried along a length of the spacing when newcomers are packed."""
TRIES = 50
"""Random contacts tried until one is far enough from the others."""


class Stands(NamedTuple):
    """The places of k newcomers.

    Attributes
    ----------
    piece : (k,)
        Indices of pieces.
    at : (k, 2) [m, rad]
        Distances along the pieces' edges, and directions.
    """

    piece: Indices
    at: Array

    def take(self, rows: Sequence[int]) -> "Stands":
        """Return some of them."""
        return Stands(self.piece[list(rows)], self.at[list(rows)])

    def joined(self, others: "Stands") -> "Stands":
        """Return these and others."""
        return Stands(np.append(self.piece, others.piece), np.vstack([self.at, others.at]))

    def with_one(self, row: int, piece: int, at: Array) -> "Stands":
        """Return them with one that stands elsewhere."""
        moved = Stands(self.piece.copy(), self.at.copy())
        moved.piece[row], moved.at[row] = piece, at
        return moved


class Ground:
    """The pieces that newcomers may stand on, and the wrenches they exert there.

    Parameters
    ----------
    problem : Problem

    Attributes
    ----------
    low, high : (p, 2) [m, rad]
        Between which a stand on each piece lies.
    scale : (3,) [N, N, N/m]
        Turns a unit wrench of a newcomer into the metric's coordinates.

    Raises
    ------
    NowhereToAttach
        If there is no piece.
    """

    def __init__(self, problem: Problem) -> None:
        self.problem, self.pieces = problem, problem.pieces()
        self.outline, self.spacing = problem.swarm.outline, problem.spacing
        self.scale = problem.swarm.scale * problem.certain_limit
        each = self.pieces.each
        self.edges = np.array([piece.edge for piece in each])
        ends = np.roll(self.outline.vertices, -1, axis=0)
        steps = (ends - self.outline.vertices) / self.outline.lengths[:, None]
        self._corners, self._steps = self.outline.vertices[self.edges], steps[self.edges]
        self.low = np.array([(piece.start, piece.lo) for piece in each])
        self.high = np.array([(piece.end, piece.hi) for piece in each])
        self.near = SLIVER * self.outline.extent

    def contacts(self, stands: Stands) -> Array:
        """Return the contacts (k, 2) [m, m], in the frame of the vertices."""
        along = self._steps[stands.piece] * stands.at[:, :1]
        return np.asarray(self._corners[stands.piece] + along)

    def steps(self, stands: Stands) -> Array:
        """Return the unit vectors (k, 2) along the edges they stand on."""
        return np.asarray(self._steps[stands.piece])

    def wrenches(self, stands: Stands) -> Array:
        """Return the generators (k, 3) [N] in the metric's coordinates, at the certain limit."""
        arms = self.contacts(stands) - self.outline.origin
        return wrenches(arms, stands.at[:, 1], 1.0) * self.scale

    def points_at(self, piece: int, arc: float, radii: Array, angles: Array) -> Array:
        """Return generators (c, 3) [N] at an arc length [m], of so many limits, in directions."""
        edge = self.edges[piece]
        along = float(arc - self.outline.corner_arc_lengths[edge])
        arm = self._corners[piece] + self._steps[piece] * along - self.outline.origin
        return wrenches(np.tile(arm, (len(angles), 1)), angles, radii) * self.scale

    def slopes(self, stands: Stands) -> tuple[Array, Array]:
        """Return how the generators change along the edges [N/m] and with the directions [N/rad].

        Returns
        -------
        (k, 3), (k, 3)
        """
        arms, quarter = self.contacts(stands) - self.outline.origin, 0.5 * math.pi
        turned = wrenches(arms, stands.at[:, 1] + quarter, 1.0) * self.scale
        moved = wrenches(self._steps[stands.piece], stands.at[:, 1], 1.0) * self.scale
        moved[:, :2] = 0.0
        return moved, turned

    def clipped(self, stands: Stands) -> Stands:
        """Return stands moved onto their pieces."""
        low, high = self.low[stands.piece], self.high[stands.piece]
        return Stands(stands.piece, np.clip(stands.at, low, high))

    def robots(self, stands: Stands, names: Sequence[str]) -> tuple[Robot, ...]:
        """Return the newcomers in contact."""
        newcomer = self.problem.newcomer
        directions = np.remainder(stands.at[:, 1] + math.pi, math.tau) - math.pi
        rows = zip(self.contacts(stands).tolist(), directions.tolist(), names, strict=True)
        return tuple(
            Robot((x, y), direction, newcomer.limit, name, tolerance=newcomer.tolerance)
            for (x, y), direction, name in rows
        )

    def stands_at(
        self, contacts: Sequence[tuple[float, float]], directions: Sequence[float]
    ) -> Stands:
        """Return the stands nearest to contacts [m, m] and directions [rad]."""
        found = [self.stand_at(*pose) for pose in zip(contacts, directions, strict=True)]
        pieces = np.array([piece for piece, _ in found], dtype=np.intp)
        return Stands(pieces, np.array([at for _, at in found]).reshape(-1, 2))

    def stand_at(self, contact: Sequence[float], direction: float) -> tuple[int, Array]:
        """Return the piece and the place on it nearest to a contact [m, m] and a direction [rad].

        Of several pieces as near, the first.
        """
        offsets = np.asarray(contact) - self._corners
        alongs = (offsets * self._steps).sum(axis=1)
        middles = 0.5 * (self.low[:, 1] + self.high[:, 1])
        angles = direction + math.tau * np.round((middles - direction) / math.tau)
        wanted = np.column_stack([alongs, angles])
        found = np.clip(wanted, self.low, self.high)
        points = self._corners + self._steps * found[:, :1]
        misses = np.linalg.norm(points - np.asarray(contact), axis=1) / self.outline.extent
        best = int(np.argmin(misses + np.abs(found[:, 1] - angles)))
        return best, found[best]

    def random(self, rng: np.random.Generator, count: int, others: Stands | None = None) -> Stands:
        """Return so many stands, others and more anywhere, at the spacing if that succeeds."""
        lengths = self.high[:, 0] - self.low[:, 0] + self.near
        shares = lengths / lengths.sum()
        found = Stands(np.zeros(0, dtype=np.intp), np.zeros((0, 2))) if others is None else others
        for _ in range(count - len(found.piece)):
            for _ in range(TRIES):
                piece = rng.choice(len(shares), 1, p=shares)
                low, high = self.low[piece], self.high[piece]
                one = found.joined(Stands(piece, rng.uniform(low, high)))
                if self.keeps_spacing(one):
                    break
            found = one
        return found

    def parted(self, stands: Stands, rng: np.random.Generator) -> Stands:
        """Return stands with those that are too near the ones before them anywhere instead."""
        points, kept = self.contacts(stands), list[int]()
        for row, point in enumerate(points):
            apart = np.linalg.norm(points[kept] - point, axis=1)
            if apart.min(initial=np.inf) >= self.spacing - self.near:
                kept.append(row)
        return self.random(rng, len(points), stands.take(kept))

    def packed(self, rng: np.random.Generator, count: int) -> Stands:
        """Return as many stands as fit, up to a number, one after the other along the boundary."""
        each = []
        for piece, (low, high) in enumerate(zip(self.low, self.high, strict=True)):
            parts = 1 + int((high[0] - low[0]) * PARTS / self.spacing)
            alongs = np.append(np.arange(parts) * self.spacing / PARTS + low[0], high[0])
            angles = rng.uniform(low[1], high[1], len(alongs))
            arcs = self.outline.corner_arc_lengths[self.edges[piece]] + alongs
            each.append(np.column_stack([arcs, np.full(len(arcs), piece), alongs, angles]))
        rows = np.vstack(each)
        rows = np.roll(rows[np.argsort(rows[:, 0], kind="stable")], int(rng.integers(len(rows))), 0)
        stands = Stands(rows[:, 1].astype(np.intp), rows[:, 2:])
        points, taken = self.contacts(stands), list[int]()
        for row, point in enumerate(points):
            apart = np.linalg.norm(points[taken] - point, axis=1)
            if len(taken) < count and apart.min(initial=np.inf) >= self.spacing:
                taken.append(row)
        return stands.take(taken)

    def keeps_spacing(self, stands: Stands) -> bool:
        """Tell whether newcomers keep their distance from each other."""
        if self.spacing == 0.0 or len(stands.piece) < 2:
            return True
        points = self.contacts(stands)
        first, second = np.triu_indices(len(points), 1)
        apart = np.linalg.norm(points[first] - points[second], axis=1)
        return bool(apart.min() >= self.spacing - self.near)

    def pieces_beside(self, stands: Stands) -> Pieces:
        """List the pieces that other newcomers leave to one more.

        Raises
        ------
        NowhereToAttach
            If there are none.
        """
        if self.spacing == 0.0:
            return self.pieces
        problem, swarm = self.problem, self.problem.swarm
        crowd = np.vstack([swarm.contacts[~swarm.mounted], self.contacts(stands)])
        rules = (problem.zones, problem.no_go, crowd, problem.spacing)
        return pieces_of(swarm.outline, problem.newcomer, *rules)
