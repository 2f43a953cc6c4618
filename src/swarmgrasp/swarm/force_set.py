"""What a robot can exert at its contact: a convex set of forces, by its elements (T20).

The set is the hull of points and of arcs about the origin. Going around it counter-clockwise, each
element, a point or an arc, is the farthest in the directions of its normal cone. A kind of robot is
a function below that returns the points and arcs of its set; the elements follow.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.swarm.columns import Columns
from swarmgrasp.swarm.robot import Envelope, Robot
from swarmgrasp.swarm.sectors import Sectors

Array = NDArray[np.float64]
Pair = tuple[float, float]
RIGHT = math.pi / 2
NO_CONE = 1e-12
"""Width of a normal cone [rad] that is none."""
SAME_DISTANCE = 1e-12
"""Difference of two distances, relative to the largest, that is rounding."""
CHORD = math.radians(3.0)
"""Turn from one corner of an arc to the next, where it is drawn [rad]."""


class Arc(NamedTuple):
    """An arc about the origin: a radius [N], and the directions [rad] of its ends."""

    radius: float
    start: float
    end: float


class Element(NamedTuple):
    """A point or an arc, and the directions in which it is the farthest.

    Attributes
    ----------
    radius : float [N]
        Of an arc; 0 for a point.
    x, y : float [N]
        The point; 0 for an arc.
    start, end : float [rad]
        Of its normal cone, counter-clockwise, at most one turn apart.
    """

    radius: float
    x: float
    y: float
    start: float
    end: float


class ForceSets(NamedTuple):
    """The force sets of n robots, in the object's frame.

    Attributes
    ----------
    elements : (k, 5)
        Each an `Element`, robot by robot; those of a robot in any order.
    counts : (n,)
        How many each robot has.
    """

    elements: Array
    counts: NDArray[np.intp]


def hull_of(points: Sequence[Pair], arcs: Sequence[Arc] = ()) -> tuple[Element, ...]:
    """Return the elements of the hull of points [N, N] and of arcs, counter-clockwise.

    Where one gives way to another, both are as far: across the line between two points, and for a
    point and an arc where the tangent to the arc goes through the point.

    Examples
    --------
    >>> [round(e.end - e.start, 3) for e in hull_of([(0.0, 0.0)], [Arc(1.0, -0.5, 0.5)])]
    [1.0, 1.571, 2.142, 1.571]
    """
    ends = [(a.radius * math.cos(t), a.radius * math.sin(t)) for a in arcs for t in a[1:]]
    round_ = [a for a in arcs if a.end - a.start >= math.tau]
    corners = list(dict.fromkeys([*points, *(() if len(round_) == len(arcs) else ends)]))
    cuts = sorted({cut % math.tau for cut in _cuts(corners, arcs)})
    if not cuts:
        cuts = [0.0]
    found: list[tuple[tuple[float, float, float], float, float]] = []
    for start, end in zip(cuts, [*cuts[1:], cuts[0] + math.tau], strict=True):
        if end - start <= NO_CONE:
            continue
        best = _farthest(0.5 * (start + end), corners, arcs)
        if found and found[-1][0] == best:
            found[-1] = (best, found[-1][1], end)
        else:
            found.append((best, start, end))
    if len(found) > 1 and found[0][0] == found[-1][0]:
        best, start, _ = found.pop()
        found[0] = (best, start - math.tau, found[0][2])
    return tuple(Element(*best, start, end) for best, start, end in found)


def _cuts(corners: Sequence[Pair], arcs: Sequence[Arc]) -> Iterator[float]:
    """Yield the directions [rad] in which one may give way to another."""
    for a in arcs:
        yield from a[1:]
        for x, y in corners:
            share = math.hypot(x, y) / a.radius
            if share > 1.0:
                half = math.acos(1.0 / share)
                yield from (math.atan2(y, x) + turn for turn in (half, -half))
    for i, (px, py) in enumerate(corners):
        for qx, qy in corners[:i]:
            turn = math.atan2(px - qx, qy - py)
            yield from (turn, turn + math.pi)


def _farthest(
    angle: float, corners: Sequence[Pair], arcs: Sequence[Arc]
) -> tuple[float, float, float]:
    """Return the point or arc (radius, x, y) that is the farthest in a direction [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    best, most = (0.0, 0.0, 0.0), -math.inf
    for a in arcs:
        if (angle - a.start) % math.tau <= a.end - a.start and a.radius > most:
            best, most = (a.radius, 0.0, 0.0), a.radius
    margin = SAME_DISTANCE * max([abs(most), *(math.hypot(*p) for p in corners)]) if corners else 0
    for x, y in corners:
        if x * c + y * s > most + (margin if best[0] else 0.0):
            best, most = (0.0, x, y), x * c + y * s
    return best


def points_and_arcs(
    limit: float, reverse_limit: float, steers: float, friction: float, least: float
) -> tuple[list[Pair], list[Arc]]:
    """Return the points and arcs of a robot's force set, in its own frame: x is its direction.

    Parameters
    ----------
    limit, reverse_limit, steers, friction, least
        As for `Robot`.
    """
    if friction > 0.0:
        fronts = [(limit, side * friction * limit) for side in (-1.0, 1.0)]
        backs = [(least, side * friction * least) for side in (-1.0, 1.0)]
        return [*fronts, *(backs if least > 0.0 else [(0.0, 0.0)])], []
    ends = (0.0,) if steers == 0.0 else (-steers, steers)
    points = [(least * math.cos(t), least * math.sin(t)) for t in ends]
    arcs = []
    for size, way in ((limit, 0.0), (reverse_limit, math.pi)):
        if size > 0.0 and steers > 0.0:
            arcs.append(Arc(size, way - steers, way + steers))
        elif size > 0.0:
            points.append((math.copysign(size, math.cos(way)), 0.0))
    return points, arcs


@lru_cache(maxsize=4096)
def shape_of(
    limit: float, reverse_limit: float, steers: float, friction: float, least: float
) -> tuple[Element, ...]:
    """Return the elements of a robot's force set, in its own frame."""
    return hull_of(*points_and_arcs(limit, reverse_limit, steers, friction, least))


def boundary_of(robot: Robot) -> Array:
    """Return corners (k, 2) [N, N] around a robot's force set, in the object's frame.

    Counter-clockwise; arcs are cut into chords of a few degrees. Of a ray its two ends.

    Examples
    --------
    >>> boundary_of(Robot((1.0, 0.0), 0.0, 2.0, reverse_limit=1.0))[:, 0].tolist()
    [-1.0, 2.0]
    """
    if robot.envelope is None:
        shape = shape_of(
            robot.limit, robot.reverse_limit, robot.steers, robot.friction or 0.0, robot.least
        )
    else:
        shape = hull_of(robot.envelope)
    found: list[Pair] = []
    for radius, x, y, start, end in shape:
        if radius > 0.0:
            halves = math.ceil(0.5 * (end - start) / CHORD)
            turns = np.linspace(start, end, 2 * halves + 1).tolist()  # its middle among them
            found += [(radius * math.cos(t), radius * math.sin(t)) for t in turns]
        else:
            found.append((x, y))
    c, s = math.cos(robot.direction), math.sin(robot.direction)
    return np.asarray(np.array(found) @ np.array([[c, s], [-s, c]]))


def fans_of(robot: Robot) -> list[Array]:
    """Return corners (k, 2) [N, N] around a robot's forces, for each of its sectors if it has gaps.

    Otherwise it is the one of `boundary_of`.

    Examples
    --------
    >>> len(fans_of(Robot((1.0, 0.0), sectors=[(0.0, 1.0), (2.0, 3.0)])))
    2
    """
    if robot.sectors is None:
        return [boundary_of(robot)]
    found = []
    for start, end in robot.sectors:
        turns = np.linspace(start, end, math.ceil((end - start) / CHORD) + 1)
        rim = robot.limit * np.column_stack([np.cos(turns), np.sin(turns)])
        found.append(np.vstack([np.zeros(2), rim]))
    return found


def rays_among(columns: Columns, shapes: Sequence[int]) -> NDArray[np.bool_]:
    """Tell which robots push along one ray only, from nothing to their limit: (n,).

    Those with shapes that the columns do not tell push along none.
    """
    extra = (columns.reverse_limits, columns.steers, columns.frictions, columns.leasts)
    rays = np.logical_and.reduce([column == 0.0 for column in extra])
    rays[list(shapes)] = False
    return np.asarray(rays)


def least_along(columns: Columns) -> Array:
    """Return the least force (n,) [N] of robots along their directions: negative if both ways."""
    return np.where(columns.reverse_limits > 0.0, -columns.reverse_limits, columns.leasts)


def lines_among(columns: Columns, shapes: Sequence[int]) -> NDArray[np.bool_]:
    """Tell which robots push along one line only, one way or both: (n,); none with a shape."""
    lines = (columns.steers == 0.0) & (columns.frictions == 0.0)
    lines[list(shapes)] = False
    return np.asarray(lines)


def _lines(turns: Array, most: Array, least: Array, _: Array) -> Array:
    """Return the elements (m, 2, 5) of robots that push along a line: its ends."""
    found = np.empty((len(turns), 2, 5))
    found[..., 0] = 0.0
    for k, size in enumerate((most, least)):
        found[:, k, 1], found[:, k, 2] = size * np.cos(turns), size * np.sin(turns)
    found[..., 3:] = turns[:, None, None] + np.array([[-RIGHT, RIGHT], [RIGHT, 3.0 * RIGHT]])
    return found


def _rounds(turns: Array, most: Array, _: Array, __: Array) -> Array:
    """Return the elements (m, 1, 5) of azimuths: a circle."""
    zero = np.zeros(len(turns))
    return np.column_stack([most, zero, zero, turns, turns + math.tau])[:, None]


def _sectors(turns: Array, most: Array, _: Array, half: Array) -> Array:
    """Return the elements (m, 3, 5) of robots that steer: an arc, and its ends."""
    found = np.zeros((len(turns), 3, 5))
    found[:, 0, 0] = most
    reach = np.minimum(half + RIGHT, math.pi)
    cones = ((-half, half), (half, reach), (math.tau - reach, math.tau - half))
    for k, (start, end) in enumerate(cones):
        found[:, k, 3], found[:, k, 4] = turns + start, turns + end
    for k, angle in ((1, turns + half), (2, turns - half)):
        found[:, k, 1], found[:, k, 2] = most * np.cos(angle), most * np.sin(angle)
    return found


def _backs(turns: Array, _: Array, __: Array, half: Array) -> Array:
    """Return the last element (m, 1, 5) of robots that steer less than a half turn: nothing."""
    zero = np.zeros(len(turns))
    ends = turns + half + RIGHT, turns + 3.0 * RIGHT - half
    return np.column_stack([zero, zero, zero, *ends])[:, None]


def _turned(shape: Sequence[Element], turn: float) -> Array:
    """Return the elements (m, 5) of a shape, turned."""
    table = np.array(shape)
    c, s = math.cos(turn), math.sin(turn)
    table[:, 1:3] = table[:, 1:3] @ np.array([[c, s], [-s, c]])
    table[:, 3:] += turn
    return table


def force_sets_of(
    columns: Columns, envelopes: Mapping[int, Envelope], hulls: Mapping[int, Sectors]
) -> ForceSets:
    """Return the force sets of robots, in the object's frame; of some, the hulls of sectors."""
    steers, reverse = columns.steers, columns.reverse_limits
    odd = (columns.frictions > 0.0) | ((steers > 0.0) & ((reverse > 0.0) | (columns.leasts > 0.0)))
    odd[[*envelopes, *hulls]] = True
    lines, rounds = ~odd & (steers == 0.0), ~odd & (steers >= math.pi)
    sectors = ~(odd | lines | rounds)
    kinds = (
        (lines, _lines), (rounds, _rounds), (sectors, _sectors),
        (sectors & (steers < RIGHT - NO_CONE), _backs),
    )  # fmt: skip
    given = columns.directions, columns.limits, least_along(columns), steers
    owner, rows = [], []
    for is_so, elements in kinds:
        chosen = np.flatnonzero(is_so)
        if len(chosen):
            table = elements(*(column[chosen] for column in given))
            owner.append(np.repeat(chosen, table.shape[1]))
            rows.append(table.reshape(-1, 5))
    for i, each in hulls.items():
        limit = float(columns.limits[i])
        shape = hull_of([(0.0, 0.0)], [Arc(limit, *sector) for sector in each])
        owner.append(np.full(len(shape), i))
        rows.append(np.array(shape))
    for i in np.flatnonzero(odd).tolist():
        if i in hulls:
            continue
        shape = hull_of(envelopes[i]) if i in envelopes else shape_of(
            float(columns.limits[i]), float(reverse[i]), float(steers[i]),
            float(columns.frictions[i]), float(columns.leasts[i]),
        )  # fmt: skip
        rows.append(_turned(shape, float(columns.directions[i])))
        owner.append(np.full(len(rows[-1]), i))
    if not rows:
        return ForceSets(np.zeros((0, 5)), np.zeros(len(steers), dtype=np.intp))
    owners = np.concatenate(owner)
    order = np.argsort(owners, kind="stable")
    return ForceSets(np.concatenate(rows)[order], np.bincount(owners, minlength=len(steers)))


def best_forces(sets: ForceSets, ways: Array) -> Array:
    """Return the force of each set that is the farthest along a way.

    Parameters
    ----------
    sets : ForceSets
        Of n robots.
    ways : (..., n, 2)
        Of any length. Where several forces are as far, it is one of them.

    Returns
    -------
    (..., n, 2) [N, N]

    Examples
    --------
    >>> sector = hull_of([(0.0, 0.0)], [Arc(2.0, -0.5, 0.5)])
    >>> sets = ForceSets(np.array(sector), np.array([len(sector)]))
    >>> best_forces(sets, np.array([[[3.0, 0.0]], [[-1.0, 0.0]]])).round(3).tolist()
    [[[2.0, 0.0]], [[0.0, 0.0]]]
    """
    n, most = len(sets.counts), int(sets.counts.max(initial=0))
    last = np.cumsum(sets.counts) - 1
    first = last + 1 - sets.counts
    rows = sets.elements[np.minimum(first[:, None] + np.arange(most), last[:, None])]
    radius, x, y, start, end = np.moveaxis(rows, -1, 0)
    middle, half = 0.5 * (start + end), 0.5 * (end - start)
    turn = np.arctan2(ways[..., 1], ways[..., 0])[..., None] - middle
    turn = middle + np.clip((turn + math.pi) % math.tau - math.pi, -half, half)
    forces = np.stack([radius * np.cos(turn) + x, radius * np.sin(turn) + y], axis=-1)
    values = np.einsum("...nkd,...nd->...nk", forces, ways)
    best = values.argmax(axis=-1) if n else np.zeros(values.shape[:-1], dtype=np.intp)
    return np.take_along_axis(forces, best[..., None, None], axis=-2)[..., 0, :]
