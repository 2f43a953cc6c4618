"""One placement in the kernels' terms: its pool of normals, its pieces, and their optimum."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement.certificate import Certificate, Proof
from swarmgrasp.placement.pieces import piece_rows, pieces_of
from swarmgrasp.placement.problem import Problem
from swarmgrasp.quality.facets import MARGINAL, facets_of

POOL_ROOM = 2000
"""Normals that a search may add to the known facets before the pool grows; some 10 are usual."""
ROOM_PER_PIECE = 16
"""More of them for every piece: many edges and a newcomer of another size can take that many."""
MOST_NORMALS = 200_000
"""Pool size at which a search that still wants more stops with the bound it has."""
ROUNDING = 1e-14
"""A level missed by less than this share of sum |b_i| counts as reached."""
FLOOR = 1e-13
"""Gap between bound and best, relative to sum |b_i|, that is not worth closing."""
OPPOSITE = -1.0 + 1e-12
"""Cosine below which two normals count as opposite."""

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Optimum:
    """The best robot over some pieces, and what bounds them: see `kernels.place.solve`.

    Attributes
    ----------
    best : (5,)
        Quality [N] and (cos, sin, torque) [1, 1, m] of the best robot, and its piece; -1
        when none betters the swarm as it is.
    bounds : (k,) [N]
        What no robot on each piece exceeds.
    rows, shares : (k, 4), (k, 4)
        The proof of each bound: rows of `normals`, and weights.
    normals : (m, 3)
        In the metric's coordinates.
    """

    best: Array
    bounds: Array
    rows: Array
    shares: Array
    normals: Array

    def mean_normals(self, pieces: Sequence[int]) -> Array:
        """Return the weighted mean normal of each piece's proof, (k, 3)."""
        chosen = list(pieces)
        normals = self.normals[self.rows[chosen].astype(int)]
        return np.asarray((self.shares[chosen][:, :, None] * normals).sum(axis=1))

    def certificate(self) -> Certificate:
        """Gather the proofs, each distinct one once."""
        proofs = {}
        for row, share in zip(self.rows, self.shares, strict=True):
            used = share > 0.0
            key = (tuple(row[used]), tuple(share[used]))
            if key not in proofs:
                proofs[key] = Proof(self.normals[row[used].astype(int)], share[used])
        return Certificate(tuple(proofs.values()), float(self.bounds.max()))


class Search:
    """The kernels' view of a problem.

    Attributes
    ----------
    pieces : tuple of Piece
    rows : (k, 10)
        The pieces as the kernels take them.
    facets : Facets
        Of the base swarm, those that one newcomer can matter to.
    generators : (n, 3) [N]
        Of the base swarm, in the metric's coordinates.
    weights : (3,) [N, N, N/m]
        Turn a unit wrench [1, 1, m] of the newcomer into the metric's coordinates.
    gap : float
        Largest difference between bound and best, relative to the best.
    pool, count
        The kernels' pool of normals, and how many rows of it are in use.
    first : (f, 2, 4)
        Proofs to begin with: pool rows and shares.
    floor, slack, zero : float [N]
        A difference not worth closing, a rounding error, and a quality that counts as 0.

    Raises
    ------
    NowhereToAttach
        If the problem leaves no boundary point to the newcomer.
    """

    def __init__(self, problem: Problem, gap: float = 1e-6) -> None:
        swarm = problem.swarm
        self.pieces = tuple(pieces_of(problem))
        self.rows = piece_rows(swarm.outline, self.pieces)
        self.generators = np.array(swarm.scaled_generators)
        self.weights = weights = swarm.scale * problem.newcomer.limit
        self.gap = gap
        # no robot lifts the weakest facet by more than its own wrench
        reach = np.linalg.norm(self.rows[:, :4].reshape(-1, 2), axis=1).max() * weights[2]
        most = float(np.hypot(weights[:2].max(), reach)) * (1.0 + 1e-9)
        self.facets = facets = facets_of(self.generators, margin=most)
        size = np.linalg.norm(self.generators, axis=1).sum() + np.linalg.norm(weights[:2]) + reach
        self.floor, self.slack = FLOOR * float(size), ROUNDING * float(size)
        self.zero = MARGINAL * float(size)
        # T17: a set as weak at n as at -n gains nothing from one robot
        opposite = np.flatnonzero(facets.normals @ facets.weakest < OPPOSITE)
        first = [int(np.argmin(facets.heights))]
        first += [int(opposite[np.argmin(facets.heights[opposite])])] if len(opposite) else []
        rest = np.ones(len(facets.heights), dtype=bool)
        rest[first] = False
        order = np.concatenate([first, np.flatnonzero(rest)])
        self.pool, self.count = self._pool(facets.normals[order], facets.heights[order])
        self.first = np.zeros((len(first), 2, 4))
        self.first[:, 0, :2] = (2, 3) if len(first) > 1 else (2, 2)
        self.first[0, 1, 0] = 1.0
        self.first[1:, 1, :2] = 0.5

    def _pool(self, normals: Array, heights: Array) -> tuple[Array, int]:
        """Return the kernels' pool with room to grow, and its number of rows so far."""
        from swarmgrasp.kernels.place import PIECE_ROWS, TORQUE_FREE

        count = PIECE_ROWS + len(heights)
        pool = np.zeros((count + POOL_ROOM + ROOM_PER_PIECE * len(self.pieces), 5))
        rows = pool[PIECE_ROWS:count]
        rows[:, :3] = normals * self.weights
        rows[:, 3] = heights
        free = np.abs(normals[:, 2]) <= TORQUE_FREE * np.abs(normals[:, :2]).sum(axis=1)
        rows[free, 2] = 0.0
        rows[:, 4] = 1.0 / np.where(free, 1.0, np.abs(rows[:, 2]))
        return pool, count

    def solve(self, chosen: Sequence[int] | None = None) -> Optimum:
        """Find the best robot over all pieces, or over the chosen ones.

        The numbers of pieces in the answer count the chosen ones. Normals met on the way
        serve the next run.
        """
        from swarmgrasp.kernels.place import OUT_OF_ROOM, solve

        pieces = self.rows if chosen is None else self.rows[list(chosen)]
        while True:
            best = np.array([self.facets.quality, 0.0, 0.0, 0.0, -1.0])
            status, self.count, bounds, rows, shares = solve(
                self.generators, self.pool, self.count, self.weights, pieces, self.first, best,
                self.gap, self.floor, self.slack,
            )  # fmt: skip
            if status != OUT_OF_ROOM or self.count >= MOST_NORMALS:
                break
            # Normals met so far are kept: the second run is quick to come as far as the first.
            self.pool = np.concatenate([self.pool, np.zeros_like(self.pool)])
        normals = self.pool[: self.count, :3] / self.weights
        sizes = np.linalg.norm(normals, axis=1)[:, None]
        return Optimum(best, bounds, rows, shares, normals / np.where(sizes > 0.0, sizes, 1.0))

    def qualities(self, robots: Array) -> Array:
        """Compute the exact quality with each of many new robots, one at a time.

        Parameters
        ----------
        robots : (r, 3) [1, 1, m]
            Unit wrenches (cos, sin, torque) that the pieces allow.

        Returns
        -------
        (r,) [N]
        """
        from swarmgrasp.kernels.place import qualities_with

        values = qualities_with(self.generators, self.pool, self.count, self.weights, robots)
        return np.where(values > self.zero, values, 0.0)


def robots_at(rows: Array, along: Array, across: Array) -> Array:
    """Return unit wrenches at shares of the way p to q and of the sector lo to hi.

    Parameters
    ----------
    rows : (r, 10)
        One piece per robot.
    along, across : (r,)

    Returns
    -------
    (r, 3) [1, 1, m]

    Examples
    --------
    >>> piece = np.array([[0.0, -1.0, 2.0, -1.0, 0.0, 3.0]])  # from (0, -1) to (2, -1)
    >>> robots_at(piece, np.array([0.5]), np.array([0.0])).tolist()
    [[1.0, 0.0, 1.0]]
    """
    angles = rows[:, 4] + across * (rows[:, 5] - rows[:, 4])
    c, s = np.cos(angles), np.sin(angles)
    x = rows[:, 0] + along * (rows[:, 2] - rows[:, 0])
    y = rows[:, 1] + along * (rows[:, 3] - rows[:, 1])
    return np.column_stack([c, s, x * s - y * c])
