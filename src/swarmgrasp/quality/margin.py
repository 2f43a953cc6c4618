"""By how much a load is held or missed: the signed margin (T34).

A load that is not held lies outside the wrenches that are left in the worst of cases, and what
decides is the case that leaves the nearest of them farthest away. What stays within reach when
machines are lost is known from what they do there: nobody is farther away than what the others
do already. So losses are looked at the worst first, by that bound, and most of them never.
"""

import heapq
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import shares as kernel
from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.criterion import Criterion
from swarmgrasp.quality.heights import largest
from swarmgrasp.quality.robot_sets import failing_rows
from swarmgrasp.quality.weakest import MARGINAL
from swarmgrasp.swarm import Swarm

Array = NDArray[np.float64]
Normal = tuple[float, float, float]
MOST_CASES, MOST_ASKED = 4096, 1 << 20
"""Cases that are looked at, at most, and robots in all of them together."""
CLOSE = 1e-12
"""Relative difference of two distances that is none."""
STARTS, APART, ROUNDS = 8, 0.95, 50
"""Directions from which the worst poses are looked for, the cosine of the angle between two of
them at most, and rounds from each."""
_AROUND = 400
"""Directions that the starts are chosen from."""


class Margin(NamedTuple):
    """How far the wrenches left reach beyond a load, or fall short of it.

    Attributes
    ----------
    value : float [N]
        Below 0 where the load is missed: the distance to the nearest wrench that can be made.
    normal : tuple of float
        The unit normal of the way that decides, in the metric's coordinates.
    """

    value: float
    normal: Normal


class _Nearest(NamedTuple):
    """What robots make that is nearest to holding a load.

    Attributes
    ----------
    distance : float [N]
    point : (3,) [N]
        What is left over of the load: itself, and what the robots do against it.
    wrenches : (n, 3) [N]
        Of the robots; 0 of those that are gone.
    """

    distance: float
    point: Array
    wrenches: Array


def missed(swarm: Swarm, criterion: Criterion) -> Margin:
    """Return by how much a swarm without quality misses a load in the worst of cases.

    Parameters
    ----------
    swarm : Swarm
        Without gaps between sectors, whose quality by the criterion is 0.
    criterion : Criterion
        Without a task.

    Returns
    -------
    Margin
        0 where the load is just held: along no normal that means anything.
    """
    aim = Aim(swarm, criterion)
    found = _in_worst_poses(aim) if aim.spreads else _after_worst_loss(aim)
    size = aim.size + float(np.linalg.norm(np.array(criterion.load) * swarm.scale))
    if found.distance <= MARGINAL * size:
        return Margin(0.0, (0.0, 0.0, 0.0))
    x, y, z = (-found.point / found.distance).tolist()
    return Margin(-found.distance, (x, y, z))


def _nearest(swarm: Swarm, gone: NDArray[np.bool_], load: Array) -> _Nearest:
    """Return what robots make that is nearest to holding a load (3,) [N], some of them gone."""
    there, wrenches = ~gone, np.zeros((len(swarm), 3))
    a, b, c = load.tolist()
    nothing, count = np.zeros((1, 3)), int(there.sum())
    if count and swarm.has_rays_only:
        lines = np.ascontiguousarray(swarm.scaled_generators[there])
        row = np.frombuffer(kernel.least_shares(lines, nothing, (a, b, c)))
        wrenches[there] = row[:count, None] * lines
    elif count:
        elements, counts = swarm.force_sets
        arms = np.ascontiguousarray((swarm.contacts - swarm.outline.origin)[there])
        x, y, z = swarm.scale.tolist()
        row = np.frombuffer(kernel.push_forces(
            arms, np.ascontiguousarray(elements[np.repeat(there, counts)]),
            counts[there].astype(float), (x, y, z), nothing, (a, b, c),
        ))  # fmt: skip
        forces = row[: 2 * count].reshape(-1, 2)
        torques = arms[:, 0] * forces[:, 1] - arms[:, 1] * forces[:, 0]
        wrenches[there] = np.column_stack([forces, torques]) * swarm.scale
    point = load + wrenches.sum(axis=0)
    return _Nearest(float(np.linalg.norm(point)), point, wrenches)


# -- known poses --------------------------------------------------------------------------

_Lost = frozenset[int]


def _after_worst_loss(aim: Aim) -> _Nearest:
    """Return what is nearest after the worst failure and the worst loss of machines.

    Best first, by a bound on how far away the nearest can be that is left.
    """
    swarm, criterion = aim.swarm, aim.criterion
    load, machines = np.array(criterion.load) * swarm.scale, swarm.machines
    failing = failing_rows(swarm, criterion.failures, len(swarm), ())
    if not len(failing):
        failing = np.zeros((1, len(swarm)), dtype=bool)
    may_rest = not (swarm.leasts.any() or swarm.rare.envelopes)
    most = float(np.linalg.norm(load)) if may_rest else math.inf
    losing = min(criterion.losing, int(machines.max(initial=-1)) + 1)
    queue: list[tuple[float, int, int, _Lost]] = [
        (-math.inf, 0, k, frozenset()) for k in range(len(failing))
    ]
    seen: set[tuple[int, _Lost]] = set()
    worst: _Nearest | None = None
    for _ in range(max(len(queue), min(MOST_CASES, MOST_ASKED // max(1, len(swarm))))):
        bound, _, k, lost = heapq.heappop(queue)
        if worst is not None and -bound <= worst.distance * (1.0 + CLOSE):
            break
        found = _nearest(swarm, failing[k] | np.isin(machines, list(lost)), load)
        if worst is None or found.distance > worst.distance:
            worst = found
        for beyond, machine in _further(found, machines, losing - len(lost)):
            reached, more = min(beyond, most), lost | {machine}
            if reached > worst.distance * (1.0 + CLOSE) and (k, more) not in seen:
                seen.add((k, more))
                heapq.heappush(queue, (-reached, -len(more), k, more))
        if not queue:
            break
    assert worst is not None  # there is a case, if only that nobody is lost
    return worst


def _further(
    found: _Nearest, machines: NDArray[np.intp], losing: int
) -> Iterator[tuple[float, int]]:
    """Return what no loss of so many machines exceeds, one of them given: each [N], and which."""
    if losing <= 0:
        return
    sums = np.column_stack([np.bincount(machines, column) for column in found.wrenches.T])
    toward = -found.point / found.distance if found.distance > 0.0 else np.zeros(3)
    along = np.abs(sums @ toward)
    aside = np.linalg.norm(sums - (sums @ toward)[:, None] * toward, axis=1)
    others = min(losing, len(sums)) - 1
    ahead = found.distance + along + largest(along[None], others)[0]
    bounds = np.hypot(ahead, aside + largest(aside[None], others)[0])
    for machine in np.flatnonzero(sums.any(axis=1)).tolist():
        yield float(bounds[machine]), machine


# -- uncertain poses ----------------------------------------------------------------------


def _in_worst_poses(aim: Aim) -> _Nearest:
    """Return what is nearest in the worst poses that descents from several directions find.

    The worst poses along a normal, and the normal of what is nearest in them, in turn.
    """
    load = np.array(aim.criterion.load) * aim.swarm.scale
    farthest = _Nearest(0.0, np.zeros(3), np.zeros((0, 3)))
    for start in _starts(aim):
        normal, before = start, 0.0
        for _ in range(ROUNDS):
            x, y, z = normal.tolist()
            poses = aim.worst_swarm((x, y, z))
            found = _nearest(poses, np.zeros(len(poses), dtype=bool), load)
            if found.distance <= before * (1.0 + CLOSE):
                break
            before, normal = found.distance, -found.point / found.distance
            farthest = max(farthest, found, key=lambda one: one.distance)
    return farthest


def _starts(aim: Aim) -> Array:
    """Return unit normals (m, 3), apart from each other, along which least is left."""
    k = np.arange(_AROUND)
    heights = 1.0 - (2.0 * k + 1.0) / _AROUND
    turns, across = math.pi * (3.0 - math.sqrt(5.0)) * k, np.sqrt(1.0 - heights * heights)
    around = np.column_stack([across * np.cos(turns), across * np.sin(turns), heights])
    order = around[np.argsort(aim.levels(around)[:, 0])]
    kept = [order[0]]
    for one in order:
        if len(kept) < STARTS and (np.array(kept) @ one).max() < APART:
            kept.append(one)
    return np.array(kept)
