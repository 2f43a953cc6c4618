"""What a newcomer would bring in every place that is allowed, piece by piece.

On each piece of the boundary the values stand at contacts and directions that begin and end with
those of the piece, so that a picture may join them. For a strip along the boundary only the best
direction of each contact matters: normals met so far bound all directions from above, the one that
promises most is computed exactly, and the normal that this meets is one more for all contacts
(T9). Two or three directions a contact are enough.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import ProblemInvalid, refuse
from swarmgrasp.frozen import Frozen
from swarmgrasp.placement.many import MOST_CELLS, check_cells, qualities_on
from swarmgrasp.placement.pieces import Piece, Pieces
from swarmgrasp.placement.problem import Problem, problem_faults
from swarmgrasp.placement.search import Search, search_for
from swarmgrasp.plain import Told
from swarmgrasp.quality.aim import Aim
from swarmgrasp.ranges import is_whole, shown
from swarmgrasp.swarm import wrenches

Array = NDArray[np.float64]
AT_ONCE = 256
"""Values computed before it is asked whether to stop."""
Stop = Callable[[], bool]


@dataclass(frozen=True, eq=False)
class Patch(Frozen, Told):
    """What a newcomer would bring on one piece of the boundary.

    Attributes
    ----------
    place : str
        The zone's name, or the edge's.
    edge : int
        Of the outline.
    inward : bool
        Whether it pushes.
    arc_lengths : (c,) [m]
        Of the contacts, counter-clockwise, with both ends of the piece; one for a bollard.
    angles : (r,) [rad]
        Of the forces, counter-clockwise from square to the edge: from the inward normal where they
        push, and from the outward one where they pull. One where there is no choice.
    values : (c, r) [N]
        The quality with the newcomer there, by the problem's criterion; nan where that was stopped.
    """

    place: str
    edge: int
    inward: bool
    arc_lengths: Array
    angles: Array
    values: Array


@dataclass(frozen=True, eq=False)
class Strip(Frozen, Told):
    """What a newcomer would bring along one piece of the boundary, in its best direction.

    Attributes
    ----------
    place, edge, inward, arc_lengths
        As of a `Patch`.
    values : (c,) [N]
        The best over the angles of the `Patch`; nan where that was stopped.
    angles : (c,) [rad]
        Which one it is.
    """

    place: str
    edge: int
    inward: bool
    arc_lengths: Array
    values: Array
    angles: Array


def landscape(
    problem: Problem, columns: int, rows: int, *, stop: Stop | None = None
) -> tuple[Patch, ...]:
    """Compute the quality with the newcomer at contacts and in directions of every piece.

    By the problem's criterion, but for a newcomer that hits its place.

    Parameters
    ----------
    problem : Problem
    columns : int
        Contacts on the whole allowed boundary, about, shared out by length; from 1 to 10000.
    rows : int
        Directions on each piece, from 1 to 10000.
    stop : callable, optional
        Asked now and then whether to stop: what is not computed by then is nan.

    Returns
    -------
    tuple of Patch
        One a piece; a zone around a corner has several, and one where a newcomer may push and pull.

    Raises
    ------
    ProblemInvalid
        If `problem` is no `Problem`, or a number of cells is none.
    ForceSetUnsupported
        If the newcomer is mounted, or its place is not known how to find.
    NowhereToAttach
        If no allowed point is left.

    Examples
    --------
    >>> from swarmgrasp import Newcomer, Outline, Robot, Swarm, Zone
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)], edge_names=["s", "e", "n", "w"])
    >>> ahead, astern, left = Robot((1, -0.4), 0), Robot((-1, 0.4), 3.1416), Robot((-0.4, 1), 1.5)
    >>> three = Swarm(square, [ahead, astern, left])
    >>> side = Zone(square.stretch("s", 0.2, 1.8))
    >>> (found,) = landscape(Problem(three, Newcomer(1.0, "pull", 0.5), (side,)), 5, 3)
    >>> found.place, found.arc_lengths.round(6).tolist(), found.values.shape
    ('s', [0.2, 0.6, 1.0, 1.4, 1.8], (5, 3))
    """
    pieces = _pieces(problem, columns, rows)
    qualities = qualities_on(problem, pieces)
    found = []
    for index, (piece, count) in enumerate(zip(pieces.each, _shares(pieces, columns), strict=True)):
        arc_lengths, arms, angles = _grid(problem, piece, count, rows)
        values = np.full((count, len(angles)), np.nan)
        step = max(1, AT_ONCE // len(angles))
        for first in range(0, count, step):
            if stop is not None and stop():
                break
            some = slice(first, first + step)
            values[some] = qualities(index, arms[some], _square(problem, piece) + angles)
        label = (piece.place, piece.edge, piece.inward)
        found.append(Patch(*label, arc_lengths, angles, values))
    return tuple(found)


def strips(
    problem: Problem, columns: int, rows: int, *, stop: Stop | None = None
) -> tuple[Strip, ...]:
    """Compute the best quality with the newcomer at contacts of every piece, over directions.

    It is the largest of what `landscape` gives for each contact; where all robots push along one
    ray each, and more is asked than how they stand, for a fraction of the work.

    Parameters
    ----------
    problem, columns, rows, stop
        As for `landscape`.

    Returns
    -------
    tuple of Strip
        One a piece.

    Raises
    ------
    ProblemInvalid, ForceSetUnsupported, NowhereToAttach
        As for `landscape`.
    """
    if (
        not isinstance(problem, Problem)
        or not problem.has_rays_only
        or problem.criterion.is_nominal
    ):
        return tuple(map(_best_of, landscape(problem, columns, rows, stop=stop)))
    pieces = _pieces(problem, columns, rows)
    climb = _Climb(problem, pieces)
    found = []
    for piece, count in zip(pieces.each, _shares(pieces, columns), strict=True):
        arc_lengths, arms, angles = _grid(problem, piece, count, rows)
        directions = _square(problem, piece) + angles
        values, best = climb.best(wrenches(arms[:, None], directions, 1.0), stop)
        label = (piece.place, piece.edge, piece.inward)
        found.append(Strip(*label, arc_lengths, values, angles[best]))
    return tuple(found)


class _Climb:
    """The best direction at each of many contacts, with what is known of all of them together."""

    def __init__(self, problem: Problem, pieces: Pieces) -> None:
        self._aim = Aim(problem.swarm, problem.criterion)
        self._search: Search = search_for(problem, pieces.rows)
        self._weights = problem.swarm.scale * problem.certain_limit
        self._normals, self._levels = np.zeros((0, 3)), np.zeros((0, 3))
        self._meet(np.array([self._search.base.normal]))

    def _meet(self, normals: Array) -> None:
        """Note normals (m, 3), and what is asked and reached along them."""
        self._normals = np.concatenate([self._normals, normals])
        self._levels = np.concatenate([self._levels, self._aim.levels(normals)])

    def best(self, robots: Array, stop: Stop | None) -> tuple[Array, NDArray[np.intp]]:
        """Return the best quality (c,) [N] of unit wrenches (c, r, 3), and which one has it."""
        count = len(robots)
        values, which = np.full(count, np.nan), np.zeros(count, dtype=np.intp)
        most = np.full(robots.shape[:2], np.inf)
        for normal, level in zip(self._normals, self._levels, strict=True):
            np.minimum(most, self._bound(robots, normal, level), out=most)
        for c in range(count):
            if stop is not None and stop():
                break
            known: dict[int, float] = {}
            while True:
                j = int(most[c].argmax())
                if j in known or (known and most[c, j] <= max(known.values())):
                    break
                found = self._search.quality_with(*robots[c, j].tolist())
                known[j] = found.quality
                most[c, j] = found.quality
                if found.normal not in map(tuple, self._normals.tolist()):
                    self._meet(np.array([found.normal]))
                    bound = self._bound(robots[c:], self._normals[-1], self._levels[-1])
                    np.minimum(most[c:], bound, out=most[c:])
            which[c] = max(known, key=lambda j: known[j])
            values[c] = known[int(which[c])]
        return values, which

    def _bound(self, robots: Array, normal: Array, level: Array) -> Array:
        """Return what no unit wrench of (c, r, 3) exceeds, by one normal."""
        height, most, asked = level.tolist()
        if asked <= 0.0:
            return np.full(robots.shape[:2], np.inf)
        lifted = height + np.maximum(robots @ (normal * self._weights), 0.0)
        return np.asarray(np.maximum(np.minimum(lifted, most), 0.0) / asked)


def _pieces(problem: Problem, columns: int, rows: int) -> Pieces:
    """Return the pieces of a problem that can be asked so.

    Raises
    ------
    ProblemInvalid, ForceSetUnsupported, NowhereToAttach
        As for `landscape`.
    """
    faults = problem_faults(problem)
    faults += [
        f"the number of {name} is {shown(count)}; it should be a whole number from 1 to "
        f"{MOST_CELLS}"
        for name, count in (("columns", columns), ("rows", rows))
        if not is_whole(count) or not 1 <= count <= MOST_CELLS
    ]
    refuse((ProblemInvalid, faults))
    check_cells(problem)
    return problem.pieces()


def _shares(pieces: Pieces, columns: int) -> list[int]:
    """Return how many contacts each piece has: its share of the length, and both ends."""
    lengths = np.array([piece.end - piece.start for piece in pieces.each])
    places = {(p.edge, p.start, p.end) for p in pieces.each}
    total = sum(end - start for _, start, end in places) or 1.0
    wanted = np.maximum(np.rint(columns * lengths / total), 2)
    return [1 if length == 0.0 else int(n) for length, n in zip(lengths, wanted, strict=True)]


def _square(problem: Problem, piece: Piece) -> float:
    """Return the direction [rad] square to a piece's edge, the way that its forces point."""
    normal = problem.swarm.outline.inward_normal(piece.edge)
    return normal if piece.inward else normal + math.pi


def _grid(problem: Problem, piece: Piece, count: int, rows: int) -> tuple[Array, Array, Array]:
    """Return arc lengths (c,) [m], moment arms (c, 2) [m, m] and angles off square (r,) [rad]."""
    outline, newcomer = problem.swarm.outline, problem.newcomer
    along = np.linspace(piece.start, piece.end, count)
    p, q = outline.edge_ends(piece.edge)
    arms = p + along[:, None] * (q - p) / outline.lengths[piece.edge] - outline.origin
    square = _square(problem, piece)
    middle = 0.5 * (piece.lo + piece.hi)
    half = 0.5 * (piece.hi - piece.lo)
    off = math.remainder(middle - square, math.tau)
    has_choice = half > 0.0 and rows > 1 and not newcomer.keeps
    angles = off + (np.linspace(-half, half, rows) if has_choice else np.zeros(1))
    return along + float(outline.corner_arc_lengths[piece.edge]), arms, angles


def _best_of(patch: Patch) -> Strip:
    """Return the best of each contact of a patch."""
    which = np.where(np.isnan(patch.values), -np.inf, patch.values).argmax(axis=1)
    values = patch.values[np.arange(len(which)), which]
    label = (patch.place, patch.edge, patch.inward)
    return Strip(*label, patch.arc_lengths, values, patch.angles[which])
