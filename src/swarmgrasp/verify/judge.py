"""What a criterion makes of robots, written anew and apart from the search (T14, T15, T16).

H(n) adds up what each robot certainly contributes along a normal n, after the worst of the
failures, without the largest contributions that may be lost, and the load's part. D(n) is what the
task asks there. The value is the least H / D, and 0 if the load is not held.
"""

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.recompute import ABSOLUTE, Array, exact_quality, spiral
from swarmgrasp.verify.team import Team, team_of

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import CriterionClaim, RobotClaim, SwarmClaim

MOST_SWEPT, MOST_LISTED = 2000, 400
"""Robots up to which a quality is recomputed, by the nominal criterion and by any other: a few
seconds, growing with the square and with the cube."""
MOST_DESCENDED = 100
"""Robots of uncertain poses up to which these are made worse and worse."""
AROUND = 500
"""Directions, spread evenly, in which a quality is bounded from above."""
UNASKED = 4e-15
"""D relative to the task's size, at and below which the task asks for nothing there."""
ROUNDED = 1e-14
"""Share of sum |b_i| by which rounding may change a sum of up to 100 robots, and by that / D their
quality; it grows with the number of more."""
STEPS, NEAR_BY = tuple(0.5 * 0.6**k for k in range(45)), 40
"""From how far to how near a weakest direction is looked for around the best so far, and at how
many places each time: where robots are no rays."""
PROVEN = 5e-7
"""Relative difference between a quality of robots that are no rays and what it is proven to be at
least."""
MOST_TERMS = 1_500_000
"""Contributions that such a proof may add up, of each robot in each triangle of directions, and as
many as `BESIDES` robots' for what a triangle takes besides: up to a second."""
BESIDES = 10
PARALLEL = 1e-12
"""Sine of the angle between generators that have no common plane."""
BLOCK = 200_000
"""Contributions computed at a time."""


class Held(NamedTuple):
    """What a newcomer finds at unit normals, (m,) each."""

    height: Array
    """H [N]"""
    cap: Array
    """What no newcomer lifts it beyond [N]: H before the last loss."""
    extent: Array
    """D: 1, or the task's support [N]; exactly 0 where it asks for nothing."""


class Judge:
    """A criterion in the metric's coordinates.

    Attributes
    ----------
    scale : (3,) [1, 1, 1/m]
        Turns wrenches into these coordinates.
    load : (3,) [N]
    unit : float
        The task's size [N], or 1: qualities are forces divided by it.
    failures : tuple of frozenset of str
        The robots that each takes, by name.
    """

    def __init__(
        self, boundary: Boundary, swarm: "SwarmClaim", criterion: "CriterionClaim"
    ) -> None:
        self._boundary, self._criterion = boundary, criterion
        self.failures = tuple(
            frozenset[str]().union(*map(swarm.called, failure)) for failure in criterion.failures
        )
        a1, a2 = swarm.force_weights
        self.scale = np.array([a1**0.5, a2**0.5, 1.0 / swarm.characteristic_length])
        self.load = np.array(criterion.load) * self.scale
        self.unit, task = 1.0, criterion.task
        if task is not None:
            rows = np.array(task.rows) * self.scale
            largest = float(np.abs(rows).max())
            self.unit = largest * float(np.linalg.norm(rows / largest, axis=1).max())
            self._rows, self._is_polytope = rows / self.unit, bool(task.vertices)

    @property
    def is_plain(self) -> bool:
        """Whether H is the support function itself and D is 1."""
        asked = self._criterion
        is_whole = asked.losing == 0 and not self.failures
        return is_whole and asked.task is None and not self.load.any()

    @property
    def has_task(self) -> bool:
        """Whether D is not 1."""
        return self._criterion.task is not None

    def team(self, robots: "Iterable[RobotClaim]") -> Team:
        """Return robots by what they contribute."""
        worst_case = self._criterion.worst_case
        return team_of(robots, self._boundary, self.scale, worst_case, self.failures)

    def extents(self, normals: Array, more: float = 0.0) -> Array:
        """Return D (m,) at unit normals (m, 3), with so much more of the terms it adds up."""
        if self._criterion.task is None:
            return np.ones(len(normals))
        along = normals @ self._rows.T
        if more > 0.0:
            along = along if self._is_polytope else np.abs(along)
            along = along + more * (np.abs(normals) @ np.abs(self._rows).T)
        found = along.max(axis=1) if self._is_polytope else np.linalg.norm(along, axis=1)
        found = np.maximum(found, 0.0)
        return np.asarray(np.where(found > UNASKED, found * self.unit, 0.0))

    def farthest(self, normals: Array) -> Array:
        """Return wrenches d (m, 3) of the task, so that D(n) >= d . n relative to its size.

        Those farthest along normals (m, 3).
        """
        with np.errstate(divide="ignore", invalid="ignore"):
            if self._criterion.task is None:
                found = normals / np.linalg.norm(normals, axis=1)[:, None]
            elif self._is_polytope:
                found = self._rows[(normals @ self._rows.T).argmax(axis=1)]
            else:
                along = normals @ self._rows.T
                found = (along @ self._rows) / np.linalg.norm(along, axis=1)[:, None]
        return np.asarray(np.nan_to_num(found, posinf=0.0, neginf=0.0))

    def is_convex(self, team: Team) -> bool:
        """Tell whether H is known to be convex: of known poses, of one way that robots are lost."""
        return self._criterion.losing == 0 and len(self.failures) < 2 and team.is_sure

    @property
    def losing(self) -> int:
        """Machines that may be lost."""
        return self._criterion.losing

    def height(self, team: Team, normals: Array) -> Array:
        """Return what all of a team exert with the load, at unit normals (m, 3): (m,) [N]."""
        return np.asarray(normals @ self.load + team.exerted(normals).sum(axis=1))

    def held(self, team: Team, normals: Array) -> Held:
        """Return what a newcomer to a team finds at unit normals (m, 3)."""
        step = max(1, BLOCK // max(1, len(team)))
        parts = [self._summed(team, normals[k : k + step]) for k in range(0, len(normals), step)]
        height, cap = map(np.concatenate, zip(*parts, strict=True))
        return Held(height, cap, self.extents(normals))

    def _summed(self, team: Team, normals: Array) -> tuple[Array, Array]:
        """Return H and what no newcomer lifts it beyond, at unit normals."""
        exerted = team.exerted(normals)
        parts = [self._after(team.by_machine(exerted * left)) for left in team.left]
        height, cap = (np.min(part, axis=0) for part in zip(*parts, strict=True))
        held = normals @ self.load
        return held + height, held + cap

    def _after(self, terms: Array) -> tuple[Array, Array]:
        """Return the same without the load, of what each machine exerts (m, k) [N]."""
        lost = self._criterion.losing
        if lost == 0:
            return terms.sum(axis=1), np.full(len(terms), np.inf)
        kept = terms.shape[1] - lost
        held = np.minimum(terms, 0.0).sum(axis=1)  # what robots always exert is not lost
        terms = np.maximum(terms, 0.0)
        if kept < 0:
            return held, held
        terms = np.partition(terms, kept, axis=1)
        height = held + terms[:, :kept].sum(axis=1)
        return height, height + terms[:, kept]

    # -- values

    def value(self, team: Team, normals: Array) -> tuple[float, float]:
        """Bound the quality of a team from both sides; they are as good as equal if it is known.

        Of uncertain poses, or of too many robots, it is known only that no direction holds
        less: the given unit normals (k, 3), their opposites, and others spread evenly. Of robots
        that are no rays the lower bound is proven, to `PROVEN`, or 0.
        """
        if not team.spread and not team.round:
            if self.is_plain and len(team) <= MOST_SWEPT:
                return (exact_quality(team.known),) * 2
            if not self.is_plain and len(team) <= MOST_LISTED:
                low, most, _ = self.listed(team)
                return low, most
        known = np.concatenate([normals, -normals, spiral(AROUND)])
        most, at = self.weakest(self.held(team, known), known, self.size(team))
        falls = not (team.is_sure or team.round) and len(team) <= MOST_DESCENDED
        while falls and most > 0.0:
            _, least, place = self.listed(team.worst(at))
            falls = least < most * (1.0 - PARALLEL)
            most, at = (least, place) if falls else (most, at)
        for step in STEPS if team.round else ():
            near = at + step * spiral(NEAR_BY)
            near /= np.linalg.norm(near, axis=1)[:, None]
            least, place = self.weakest(self.held(team, near), near, self.size(team))
            most, at = (least, place) if least < most else (most, at)
        if team.round and team.is_sure:
            return self._proven(team, most)
        return 0.0, max(most, 0.0)

    def _proven(self, team: Team, most: float) -> tuple[float, float]:
        """Bound a quality from below, which is at most so much, in all directions (T21, T25).

        On a triangle with corners v_j and n = sum l_j v_j, l_j >= 0, H(n) is at least W . n, W the
        best wrenches in its middle, less what is lost, a convex function as D is: so H >= t D
        holds on the triangle if this does at the corners, after each failure. Otherwise the longest
        edge is cut.
        """
        signs = np.array(np.meshgrid(*[(1.0, -1.0)] * 3)).reshape(3, -1).T
        cells, seen, size = signs[:, :, None] * np.eye(3), 0, self.size(team)
        while len(cells) and most > ABSOLUTE * size:
            seen += len(cells)
            if seen * (len(team) + BESIDES) * len(team.left) > MOST_TERMS:
                return 0.0, most
            middles = cells.sum(axis=1)
            middles /= np.linalg.norm(middles, axis=1)[:, None]
            corners = cells.reshape(-1, 3)
            wanted = (1.0 - PROVEN) * most * self.extents(corners).reshape(-1, 3) + ROUNDED * size
            is_short = np.zeros(len(cells), dtype=bool)
            for left in team.left:
                made = self.load + team.best(middles, left)
                least = np.einsum("ck,cjk->cj", made, cells)
                least -= self._lost(team, corners, left).reshape(-1, 3)
                is_short |= (least < wanted).any(axis=1)
            cells, middles = cells[is_short], middles[is_short]
            if len(cells):
                most = min(most, self.weakest(self.held(team, middles), middles, size)[0])
                cells = _halves(cells)
        return 0.0 if len(cells) else (1.0 - PROVEN) * most, max(most, 0.0)

    def _lost(self, team: Team, normals: Array, left: NDArray[np.bool_]) -> Array:
        """Return what those left may lose at most along unit normals (m, 3): (m,) [N]."""
        lost = self._criterion.losing
        if lost == 0:
            return np.zeros(len(normals))
        terms = team.by_machine(team.exerted(normals) * left)
        terms = np.sort(np.maximum(terms, 0.0), axis=1)
        return np.asarray(terms[:, -lost:].sum(axis=1))

    def listed(self, team: Team) -> tuple[float, float, Array]:
        """List all vertices: bounds of the quality from both sides, and a normal that attains it.

        Between the planes n . b_i = 0 H is concave, and D is convex: H >= t D holds
        everywhere if it does where two planes meet. The axes' planes leave no region
        without such a place.
        """
        size, generators = self.size(team), team.known
        low, most, at = np.inf, np.inf, np.zeros(3)
        for candidates in vertices(generators):
            normals = candidates[self._may_be_below(most, team, candidates, size)]
            if not len(normals):
                continue
            levels = self.held(team, normals)
            least, place = self.weakest(levels, normals, size)
            at = place if least < most else at
            most = min(most, least)
            asked = self.extents(normals, 2.0 * UNASKED)
            certainly = over(levels.height - ROUNDED * size, asked, 2.0 * ROUNDED * size)
            low = min(low, float(certainly.min()))
        return max(low, 0.0), max(most, 0.0), at

    def _may_be_below(
        self, value: float, team: Team, normals: Array, size: float
    ) -> NDArray[np.bool_]:
        """Tell at which unit normals (m, 3) H / D may be below a value: a quick first look."""
        products = normals @ team.known.T
        np.abs(products, out=products)
        pushing = 0.5 * (normals @ (team.left @ team.known).T + products @ team.left.T)
        least = normals @ self.load + pushing.min(axis=1)
        if self._criterion.losing:
            most = team.by_machine(products).max(axis=1, initial=0.0)
            least -= float(self._criterion.losing) * most
        with np.errstate(invalid="ignore"):
            above = least > value * self.extents(normals) + ABSOLUTE * size
        return np.asarray(~above)

    @staticmethod
    def weakest(levels: Held, normals: Array, size: float) -> tuple[float, Array]:
        """Return the least that H / D certainly does not exceed, and the normal of it."""
        found = over(levels.height + ROUNDED * size, levels.extent, ABSOLUTE * size)
        k = int(np.argmin(found))
        return float(found[k]), normals[k]

    def size(self, team: Team) -> float:
        """Return what the rounding of H is relative to [N]."""
        return team.size + float(np.linalg.norm(self.load))


def _halves(cells: Array) -> Array:
    """Cut triangles of unit normals (c, 3, 3) in two, across their longest edges."""
    edges = np.linalg.norm(cells - np.roll(cells, -1, axis=1), axis=2)
    rows, first = np.arange(len(cells)), edges.argmax(axis=1)
    second = (first + 1) % 3
    between = cells[rows, first] + cells[rows, second]
    between /= np.linalg.norm(between, axis=1)[:, None]
    one, other = cells.copy(), cells.copy()
    one[rows, first] = between
    other[rows, second] = between
    return np.concatenate([one, other])


def over(height: Array, extent: Array, rounding: float) -> Array:
    """Return H / D; without D, -inf for a load not held by more than rounding, otherwise inf."""
    with np.errstate(divide="ignore", invalid="ignore"):
        found = np.where(extent > 0.0, height / extent, np.inf)
    found[(extent == 0.0) & (height < -rounding)] = -np.inf
    return np.asarray(found)


def vertices(generators: Array) -> Iterator[Array]:
    """Yield the unit normals (m, 3) at right angles to two generators, or to axes, in blocks."""
    sizes = np.linalg.norm(generators, axis=1)
    units = np.vstack([generators[sizes > 0.0] / sizes[sizes > 0.0, None], np.eye(3)])
    for j, unit in enumerate(units[:-1]):
        # in the plane across one of them, so that the normal is at right angles to both even
        # if they are nearly parallel
        plane = np.linalg.svd(unit[None])[2][1:]
        flat = units[j + 1 :] @ plane.T
        lengths = np.linalg.norm(flat, axis=1)
        flat = flat[lengths > PARALLEL] / lengths[lengths > PARALLEL, None]
        found = np.column_stack([-flat[:, 1], flat[:, 0]]) @ plane
        if len(found):
            yield np.concatenate([found, -found])
