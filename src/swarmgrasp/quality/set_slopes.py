"""Slopes of the quality of robots that have force sets (T19, T20).

At the weakest normal n the swarm makes the wrench that ball or task touches there, each robot with
a force that is its best along n. When one robot changes, the quality changes as what that force
makes along n does, divided by D(n). Robots whose best force jumps at n exert a mixture of the
forces beside it, such that the wrenches add up; where several mixtures do, the slope is the
greatest over them. Of several weakest normals, of machines that may be lost instead of others, and
of vertices that a task has there, the least slope counts.

At quality 0 there are no slopes here. The normals along which the swarm makes nothing then fill a
convex cone, with a border that may be round, and the slope is the least over all of it. Rays have a
list of normals that are enough, those across two generators or across one and its move; what round
sets have is not a list, and a search that misses one would call a swarm force closed that is not.
"""

import itertools
import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.linear import minimise
from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.heights import FARTHEST, Array, Mask
from swarmgrasp.quality.task import Ellipsoid
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.columns import Columns
from swarmgrasp.swarm.force_set import ForceSets, best_forces, force_sets_of

BESIDE = 3e-6
"""Angle [rad] beside its best direction at which a robot's best force may be another."""
JUMP = 1e-3
"""Difference of the two, relative to the larger, that is a jump."""
FAN = 64
"""Corners that stand for a whole force set, of a robot that can do nothing along a normal."""
NUDGE = 1e-7
"""Relative change of a robot; what its forces do is linear in it up to the square of that."""
TIED = 1e-8
"""Relative difference of two normals' values that is none."""
NEAR = 1e-3
"""The same for one that may come down to it."""
MOST_STEPS, FARTHEST_STEP = 20, 0.02
"""Newton's steps towards a weakest normal, and their greatest length [rad]."""
SAME = 1e-11
"""By how much the cosine between two normals is below 1 that are one."""
LOOKS = 3000
"""Normals looked at for others as weak as the weakest,"""
STARTS, APART = 40, 0.9
"""and how many of them are followed down, with which cosine between them at most."""
COMBINATIONS = 64
"""Ways to lose machines that add equally much, after which no others are looked at."""
ROUNDING = 1e-8
"""Slope, relative to the greatest there may be, that is none."""
SLACK = 1e3
"""Price of wrenches that do not add up, by rounding, relative to the slopes'."""

KINDS = ("contact", "direction", "limit", "reverse_limit", "start", "end")
"""What may change of a robot."""


class Slopes(NamedTuple):
    """What `set_slopes` finds.

    Attributes
    ----------
    slopes : (6, 2, n)
        Of each kind in `KINDS`, the one way and the other; nan of what a robot does not have.
    largest : (6, 2, n)
        What they could be at most.
    normals : (m, 3)
        The weakest normals.
    """

    slopes: Array
    largest: Array
    normals: Array


def set_slopes(
    aim: Aim, value: float, normal: Array, tangents: tuple[Array, Array], failing: Mask
) -> Slopes:
    """Compute the slopes of a positive quality.

    Parameters
    ----------
    aim : Aim
    value : float
        The quality.
    normal : (3,)
        A unit normal at which it is.
    tangents : two of (n, 2)
        The ways along the boundary from each contact, clockwise and the other.
    failing : (f, n or more)
        Which robots each failure takes.
    """
    place = _Place(aim, tangents, failing)
    normals = _weakest_normals(aim, place, value, normal)
    least = np.full((len(KINDS), 2, len(aim.swarm)), np.inf)
    extents = [place.asked(n)[0] for n in normals]
    for n, extent in zip(normals, extents, strict=True):
        around = place.at(n)
        rates = place.rates(around)
        for vertex, lost in place.cases(around):
            found = place.slopes(around, rates, value * vertex, lost)
            least = np.minimum(least, found / extent)
    swarm = aim.swarm
    least[2][:, list(swarm.rare.envelopes)] = np.nan
    least[3][:, swarm.reverse_limits == 0.0] = np.nan
    least[4:][:, :, (swarm.steers == 0.0) | (swarm.steers >= math.pi)] = np.nan
    largest = place.largest() / min(extents)
    least[np.abs(least) <= ROUNDING * largest] = 0.0
    return Slopes(least, largest, normals)


class _Around(NamedTuple):
    """The robots at a normal.

    Attributes
    ----------
    normal : (3,)
    ways : (k, n, 2)
        Along which the corners of their faces are the farthest.
    forces : (k, n, 2) [N]
        The corners.
    counts : (n,)
        How many of them, the first ones, count: 1, 2, 3 with no force between two, or all of
        one that can do nothing there.
    """

    normal: Array
    ways: Array
    forces: Array
    counts: NDArray[np.intp]


class _Place:
    """A swarm's force sets, as arrays."""

    def __init__(self, aim: Aim, tangents: tuple[Array, Array], failing: Mask) -> None:
        self.aim, self.swarm, self.tangents = aim, aim.swarm, tangents
        self.scale = self.swarm.scale
        self.arms = self.swarm.contacts - self.swarm.outline.origin
        self.sets = self.swarm.force_sets
        self.load = np.array(aim.criterion.load) * self.scale
        self.failing = failing[:, : len(self.arms)]
        self.changes = list(_changes(self.swarm))
        reach = np.hypot(self.sets.elements[:, 1], self.sets.elements[:, 2])
        firsts = np.cumsum(self.sets.counts) - self.sets.counts
        self.sizes = np.maximum.reduceat(reach + self.sets.elements[:, 0], firsts)

    def largest(self) -> Array:
        """Return how fast a robot's wrench changes at most: (6, 2, n)."""
        reach = self.scale[:2].max() + self.scale[2] * np.hypot(*self.arms.T)
        turned = self.sizes * reach
        kinds = (self.sizes * self.scale[2], turned, reach, reach, turned, turned)
        return np.stack([np.stack([kind, kind]) for kind in kinds])

    def levers(self, normal: Array) -> Array:
        """Return p (n, 2) of each robot."""
        x, y, turn = (normal * self.scale).tolist()
        aside = np.column_stack([-self.arms[:, 1], self.arms[:, 0]])
        return np.asarray(np.array([x, y]) + turn * aside)

    def wrenches(self, forces: Array) -> Array:
        """Return the wrenches (..., n, 3) of forces, in the metric's coordinates."""
        torques = self.arms[:, 0] * forces[..., 1] - self.arms[:, 1] * forces[..., 0]
        return np.concatenate([forces, torques[..., None]], axis=-1) * self.scale

    def at(self, normal: Array) -> _Around:
        """Look at the robots at a normal."""
        levers = self.levers(normal)
        reach = self.scale[:2].max() + self.scale[2] * np.hypot(*self.arms.T)
        is_idle = np.hypot(*levers.T) <= BESIDE * reach
        beside = BESIDE * np.column_stack([-levers[:, 1], levers[:, 0]])
        ways = np.stack([levers - beside, levers + beside, np.zeros_like(levers)])
        if is_idle.any():
            turns = np.linspace(0.0, math.tau, FAN, endpoint=False)
            fan = np.column_stack([np.cos(turns), np.sin(turns)])[:, None]
            ways = np.concatenate([ways, np.zeros((FAN - 3, len(levers), 2))])
            ways = np.where(is_idle[:, None], fan, ways)
        forces = best_forces(self.sets, ways)
        jumps = np.hypot(*(forces[0] - forces[1]).T) > JUMP * self.sizes
        # a sector of half a turn has a corner between them as soon as an end moves
        is_through = np.abs(_across(*forces[:2])) <= BESIDE * self.sizes**2
        is_through &= (forces[0] * forces[1]).sum(axis=1) < 0.0
        counts = np.where(is_idle, len(ways), np.where(jumps, np.where(is_through, 3, 2), 1))
        forces[2, counts == 3] = 0.0
        middle = best_forces(self.sets, levers)
        ways[0] = np.where((counts == 1)[:, None], levers, ways[0])
        forces[0] = np.where((counts == 1)[:, None], middle, forces[0])
        return _Around(normal, ways, forces, counts)

    def rates(self, around: _Around) -> Array:
        """Return how fast what each corner makes along the normal rises: (6, 2, k, n)."""
        shape = (len(KINDS), 2, *around.forces.shape[:2])
        rates = np.zeros(shape)
        turn, levers = float(around.normal[2] * self.scale[2]), self.levers(around.normal)
        fx, fy = np.moveaxis(around.forces, -1, 0)
        for way, (tx, ty) in enumerate(t.T for t in self.tangents):
            rates[0, way] = turn * (tx * fy - ty * fx)
        for kind, way, steps, sets in self.changes:
            gained = best_forces(sets, around.ways) - around.forces
            rates[kind, way] = (gained * levers).sum(axis=-1) / steps
        rates[:, :, 2, around.counts == 3] = 0.0
        return rates

    def asked(self, normal: Array) -> tuple[float, list[Array]]:
        """Return D, and its slope; several where it bends."""
        task = self.aim.criterion.task
        if task is None:
            size = float(np.linalg.norm(normal))
            return size, [normal / size]
        rows = task.generators * self.scale
        reached = rows @ normal
        if isinstance(task, Ellipsoid):
            extent = float(np.linalg.norm(reached))
            return extent, [reached @ rows / extent]
        near = reached >= reached.max() - FARTHEST * np.linalg.norm(rows, axis=1).max()
        return float(reached.max()), list(rows[near])

    def cases(self, around: _Around) -> Iterator[tuple[Array, Mask]]:
        """Yield the task's slopes at a normal with each choice of robots (n,) that may be lost."""
        losing = self.aim.criterion.losing
        worths = (around.forces[0] * self.levers(around.normal)).sum(axis=-1)
        rounding = TIED * float(np.abs(worths).sum())
        failing = self.failing if len(self.failing) else np.zeros((1, len(worths)), dtype=bool)
        machines = self.swarm.machines
        left = [
            np.asarray(np.bincount(machines, np.where(row, 0.0, worths)), dtype=float)
            for row in failing
        ]
        heights = [
            sums.sum() - np.maximum(np.sort(sums)[::-1][:losing], 0.0).sum() for sums in left
        ]
        for row, sums, height in zip(failing, left, heights, strict=True):
            if height > min(heights) + rounding:
                continue
            for lost in _losses(sums, losing, rounding):
                for vertex in self.asked(around.normal)[1]:
                    yield vertex, row | np.isin(machines, lost)

    def slopes(self, around: _Around, rates: Array, touched: Array, lost: Mask) -> Array:
        """Return the slopes (6, 2, n) of H when some robots are lost and `touched` is held."""
        found = np.where(lost, 0.0, rates[:, :, 0])
        mixing = np.flatnonzero((around.counts > 1) & ~lost)
        if not len(mixing):
            return found
        across = np.linalg.svd(around.normal[None])[2][1:]
        wrenches = self.wrenches(around.forces) @ across.T
        sure = ~lost & (around.counts == 1)
        left = across @ (touched - self.load) - wrenches[0, sure].sum(axis=0)
        columns = [(i, k) for i in mixing.tolist() for k in range(int(around.counts[i]))]
        owners = np.array([i for i, _ in columns])
        corners = np.array([wrenches[k, i] for i, k in columns])
        worth = rates[:, :, [k for _, k in columns], owners]
        size = float(np.abs(corners).max()) or 1.0
        balance = np.concatenate([corners.T / size, owners == mixing[:, None]])
        target = np.concatenate([left / size, np.ones(len(mixing))])
        shares = np.linalg.lstsq(balance, target, rcond=1e-6)[0]
        if np.linalg.matrix_rank(balance, 1e-6) == len(columns):
            mixed = worth * np.clip(shares, 0.0, 1.0)
            for i in mixing.tolist():
                found[:, :, i] = mixed[:, :, owners == i].sum(axis=-1)
            return found
        slack = np.vstack([np.hstack([np.eye(2), -np.eye(2)]), np.zeros((len(mixing), 4))])
        matrix = np.hstack([balance, slack])
        for i, kind, way in itertools.product(mixing.tolist(), range(len(KINDS)), range(2)):
            own = np.where(owners == i, worth[kind, way], 0.0)
            unit = float(np.abs(own).max())
            if unit > 0.0:
                cost = np.concatenate([-own / unit, np.full(4, SLACK)])
                best = minimise(cost, matrix, (target, target), (0.0, np.inf))
                found[kind, way, i] = own @ best[: len(columns)]
        return found

    def polished(self, normal: Array, value: float) -> Array:
        """Return a normal at which H / D is least next to a unit normal that nearly is."""
        n = normal
        for _ in range(MOST_STEPS):
            around = self.at(n)
            rows = [np.zeros((0, 3))]
            for i in np.flatnonzero(around.counts > 1).tolist():
                corners = self.wrenches(around.forces[: around.counts[i]])[:, i]
                rows.append((corners - corners[0])[1:] / self.sizes[i])
            kinks = np.concatenate(rows)
            _, sizes, axes = np.linalg.svd(np.concatenate([kinks, np.zeros((3, 3))]))
            rank = int((sizes > 1e-4).sum())
            if rank >= 2:
                return np.asarray(axes[2] * math.copysign(1.0, float(axes[2] @ n)))
            n = n - axes[:rank].T @ (axes[:rank] @ n)
            n /= np.linalg.norm(n)
            free = np.linalg.svd(np.concatenate([n[None], axes[:rank]]))[2][1 + rank :]
            step = self._newton(n, free, value)
            trials = n + np.array([1.0, 0.25, 0.06, 0.0])[:, None] * step
            best = int(self.aim.values(trials).argmin())
            n = trials[best] / np.linalg.norm(trials[best])
            if best == 3 or np.abs(step).max() <= 1e-12:
                break
        return n

    def _newton(self, normal: Array, free: Array, value: float) -> Array:
        """Return a step (3,) along rows (f, 3) towards where H - value D is level."""

        def slope(n: Array) -> Array:
            """Return how H - value D rises along the rows, (f,)."""
            around = self.at(n)
            vertex, lost = next(self.cases(around))
            made = self.wrenches(around.forces[0])[~lost].sum(axis=0)
            return np.asarray(free @ (made + self.load - value * vertex))

        here = slope(normal)
        bends = np.column_stack([(slope(normal + 1e-6 * way) - here) / 1e-6 for way in free])
        step = np.linalg.lstsq(bends, -here, rcond=1e-6)[0] @ free
        return np.asarray(step * min(1.0, FARTHEST_STEP / (np.linalg.norm(step) or 1.0)))


def _losses(sums: Array, losing: int, rounding: float) -> Iterator[tuple[int, ...]]:
    """Yield each choice of machines whose loss hurts most, given what they add."""
    gains = np.maximum(sums, 0.0)
    last = float(np.sort(gains)[-losing]) if 0 < losing <= len(gains) else math.inf
    surely = np.flatnonzero(gains > last + rounding).tolist()
    tied = np.flatnonzero(np.abs(gains - last) <= rounding).tolist()
    for chosen in itertools.islice(
        itertools.combinations(tied, max(0, losing - len(surely))), COMBINATIONS
    ):
        yield (*surely, *chosen)


def _across(one: Array, other: Array) -> Array:
    """Return the cross products (n,) of vectors (n, 2)."""
    return np.asarray(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])


def _changes(swarm: Swarm) -> Iterator[tuple[int, int, Array, ForceSets]]:
    """Yield a kind after the contact, a way, the steps (n,), and the sets once all have changed."""
    columns, envelopes = swarm.columns, swarm.rare.envelopes
    for way, sign in enumerate((-1.0, 1.0)):
        turn = np.full(len(swarm), NUDGE)
        kinds: tuple[tuple[int, dict[str, Any], Array], ...] = (
            (1, {"directions": columns.directions + sign * NUDGE}, turn),
            (2, {"limits": columns.limits * (1.0 + sign * NUDGE)}, NUDGE * columns.limits),
            (
                3,
                {"reverse_limits": columns.reverse_limits * (1.0 + sign * NUDGE)},
                NUDGE * np.maximum(columns.reverse_limits, 1e-300),
            ),
            (4, _opened(columns, sign * NUDGE, -1.0), turn),
            (5, _opened(columns, sign * NUDGE, 1.0), turn),
        )
        for kind, changed, steps in kinds:
            yield kind, way, steps, force_sets_of(columns._replace(**changed), envelopes, {})


def _opened(columns: Columns, turn: float, end: float) -> dict[str, Array]:
    """Return directions and steers once the one end of sectors has turned."""
    is_sector = (columns.steers > 0.0) & (columns.steers < math.pi)
    half = np.where(is_sector, 0.5 * turn, 0.0)
    return {
        "directions": columns.directions + half,
        "steers": columns.steers + end * half,
    }


def _weakest_normals(aim: Aim, place: _Place, value: float, normal: Array) -> Array:
    """Return the normals (m, 3) as weak as the weakest, of those that a search finds."""
    k = np.arange(LOOKS) + 0.5
    heights, turns = 1.0 - 2.0 * k / LOOKS, k * math.pi * (1.0 + math.sqrt(5.0))
    ring = np.sqrt(1.0 - heights**2)
    looks = np.column_stack([ring * np.cos(turns), ring * np.sin(turns), heights])
    looks = looks[np.argsort(aim.values(looks), kind="stable")]
    starts = normal[None]
    for look in looks:
        if len(starts) == STARTS:
            break
        if (starts @ look).max() < APART:
            starts = np.concatenate([starts, look[None]])
    near = _followed_down(aim, starts, 0.05)
    for step in (1e-3, 1e-5):  # valleys bend
        near = _each_once(near[aim.values(near) <= value * (1.0 + NEAR)])
        near = np.array([place.polished(n, value) for n in near]).reshape(-1, 3)
        near = _followed_down(aim, near, step)
    found = np.array([place.polished(n, value) for n in (normal, *near)])
    values = aim.values(found)
    return _each_once(found[values <= max(value, float(values.min())) * (1.0 + TIED)])


def _each_once(normals: Array) -> Array:
    """Return unit normals (m, 3), those that are the same once."""
    kept: list[Array] = []
    for n in normals:
        if all(n @ other < 1.0 - SAME for other in kept):
            kept.append(n)
    return np.reshape(kept, (-1, 3))


def _followed_down(aim: Aim, normals: Array, step: float) -> Array:
    """Return unit normals (m, 3) moved by steps to where H / D is least nearby, or towards it."""
    here, values = normals.copy(), aim.values(normals)
    steps = np.full(len(here), step)
    for turn in range(60):
        angles = 0.7 * turn + np.arange(8) * (math.pi / 4.0)
        bases = np.linalg.svd(here[:, None])[2][:, 1:]
        around = np.column_stack([np.cos(angles), np.sin(angles)]) @ bases
        trials = here[:, None] + steps[:, None, None] * around
        trials /= np.linalg.norm(trials, axis=2, keepdims=True)
        tried = aim.values(trials.reshape(-1, 3)).reshape(len(here), 8)
        best = tried.argmin(axis=1)
        rows = np.arange(len(here))
        better = tried[rows, best] < values
        here[better], values[better] = trials[rows, best][better], tried[rows, best][better]
        steps[~better] *= 0.5
    return here
