"""The qualities that many newcomers would bring, in one call."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import ForceSetUnsupported, ProblemInvalid, refuse
from swarmgrasp.placement.boxes import BoxSearch
from swarmgrasp.placement.pieces import Pieces
from swarmgrasp.placement.problem import Problem, check_newcomer, problem_faults
from swarmgrasp.placement.search import search_for
from swarmgrasp.placement.spans import SpanSearch
from swarmgrasp.quality.criterion import Keywords, criterion_of
from swarmgrasp.ranges import is_whole, items, shown
from swarmgrasp.swarm import Newcomer, Swarm, wrenches
from swarmgrasp.swarm.columns import check_contacts, checked_columns
from swarmgrasp.swarm.names import numbered
from swarmgrasp.swarm.swarm import check_swarm

Array = NDArray[np.float64]
MOST_CELLS = 10_000
"""Columns of cells, and rows."""


def qualities_with(
    swarm: Swarm,
    contacts: ArrayLike,
    directions: ArrayLike,
    limits: ArrayLike = 1.0,
    **keywords: Unpack[Keywords],
) -> NDArray[np.float64]:
    """Compute the exact quality of a swarm with each of many newcomers, one at a time.

    Parameters
    ----------
    swarm : Swarm
    contacts : (k, 2) [m, m]
        On the boundary, in the frame of the outline's vertices.
    directions : (k,) [rad]
    limits : float or (k,) [N]
    losing, worst_case, load, task
        As for `Criterion`.

    Returns
    -------
    (k,) [N]

    Raises
    ------
    SwarmInvalid
        If it is no `Swarm`.
    RobotInvalid, RobotOffBoundary
        As for `Swarm.from_arrays`.
    CriterionInvalid
        If a term is outside its range.

    Examples
    --------
    >>> from math import pi
    >>> from swarmgrasp import Outline, Robot
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pulls = [((1, -0.4), 0), ((-1, 0.4), pi), ((-0.4, 1), pi / 2)]
    >>> three = Swarm(square, [Robot(c, a) for c, a in pulls], characteristic_length=1.0)
    >>> qualities_with(three, [(0.4, -1), (0.4, 1)], [-pi / 2, pi / 2]).round(6).tolist()
    [0.696311, 0.0]
    """
    check_swarm(swarm)
    criterion = criterion_of("qualities_with", keywords)
    columns = checked_columns(contacts, directions, limits, False)
    check_contacts(swarm.outline, columns, numbered(len(columns.limits)))
    if not len(columns.limits):
        return np.zeros(0)
    limit = float(columns.limits.max())
    problem = Problem(swarm, Newcomer(limit), criterion=criterion)
    arms = columns.contacts - swarm.outline.origin
    if not problem.has_rays_only:
        found = np.zeros(len(arms))
        robots = np.column_stack([arms, columns.directions])
        for each in np.unique(columns.limits).tolist():
            same = columns.limits == each
            boxes = BoxSearch(replace(problem, newcomer=Newcomer(each)), problem.pieces())
            found[same] = boxes.qualities_at(robots[same])
        return found
    search = search_for(problem, problem.pieces().rows)
    return search.qualities_with(wrenches(arms, columns.directions, columns.limits / limit))


def cell_qualities(problem: Problem, resolution: tuple[int, int]) -> NDArray[np.float64]:
    """Compute the quality with the newcomer in every cell of contacts and directions.

    By the problem's criterion, but for a newcomer that hits its place.

    Parameters
    ----------
    problem : Problem
    resolution : tuple of int
        Columns (arc lengths within [0, perimeter]) and rows (directions within
        [-pi, pi]), from 1 to 10000 of each.

    Returns
    -------
    (columns, rows) [N]
        nan where nothing is allowed.

    Raises
    ------
    ProblemInvalid
        If `problem` is no `Problem`, or the resolution not two such numbers.
    ForceSetUnsupported
        If the newcomer is mounted, or its place is not known how to find.
    NowhereToAttach
        If no allowed point is left.
    """
    sides = items(resolution) or ()
    faults = problem_faults(problem)
    if len(sides) != 2 or not all(is_whole(n) and 1 <= n <= MOST_CELLS for n in sides):
        faults.append(
            f"the resolution is {shown(resolution)}; it should be two whole numbers, columns and "
            f"rows, from 1 to {MOST_CELLS}"
        )
    refuse((ProblemInvalid, faults))
    check_cells(problem)
    outline = problem.swarm.outline
    columns = np.linspace(0.0, outline.perimeter, sides[0] + 1)
    rows = np.linspace(-math.pi, math.pi, sides[1] + 1)
    grid = np.full(sides, np.nan)
    pieces = problem.pieces()
    qualities = qualities_on(problem, pieces)
    for index, piece in enumerate(pieces.each):
        base = float(outline.corner_arc_lengths[piece.edge])
        where, arc_lengths = _samples(columns, base + piece.start, base + piece.end)
        p, q = outline.edge_ends(piece.edge)
        shares = (arc_lengths - base)[:, None] / outline.lengths[piece.edge]
        arms = p + shares * (q - p) - outline.origin
        low = (piece.lo + math.pi) % math.tau - math.pi
        width = piece.hi - piece.lo
        parts = [_samples(rows, low - t, low - t + width) for t in (0.0, math.tau)]
        which, directions = (np.concatenate(side) for side in zip(*parts, strict=True))
        cells = np.ix_(where, which)
        grid[cells] = np.fmax(grid[cells], qualities(index, arms, directions))
    return grid


def check_cells(problem: Problem) -> None:
    """Raise `ForceSetUnsupported` for a newcomer that is mounted, or whose place is not known."""
    check_newcomer(problem)
    if problem.newcomer.mounted:
        raise ForceSetUnsupported(
            "the landscape is of places along the boundary, and a mounted newcomer sits inside"
        )


def qualities_on(problem: Problem, pieces: Pieces) -> Callable[[int, Array, Array], Array]:
    """Return what computes the quality on a piece, by its index, moment arms and directions.

    What keeps its force set has the same quality in all directions of it.
    """
    if problem.newcomer.keeps:
        spans = SpanSearch(problem, pieces)

        def kept(index: int, arms: Array, directions: Array) -> Array:
            """Compute (c, d) qualities of a newcomer that keeps its force set."""
            ends = pieces.rows[index, :4].reshape(2, 2)
            step = ends[1] - ends[0]
            along = (arms - ends[0]) @ step / max(float(step @ step), np.finfo(float).tiny)
            found = [spans.quality_at(index, float(share)) for share in np.clip(along, 0.0, 1.0)]
            return np.repeat(np.array(found)[:, None], len(directions), axis=1)

        return kept
    if not problem.has_rays_only:
        boxes = BoxSearch(problem, pieces)

        def fixed(index: int, arms: Array, directions: Array) -> Array:  # noqa: ARG001
            """Compute (c, d) qualities of a newcomer of fixed direction."""
            rows = [np.repeat(arms, len(directions), axis=0), np.tile(directions, len(arms))]
            return boxes.qualities_at(np.column_stack(rows)).reshape(len(arms), -1)

        return fixed
    search = search_for(problem, pieces.rows)

    def rays(index: int, arms: Array, directions: Array) -> Array:  # noqa: ARG001
        """Compute (c, d) qualities of a ray beside rays."""
        return search.qualities_with(wrenches(arms[:, None], directions, 1.0))

    return rays


def _samples(
    bounds: NDArray[np.float64], low: float, high: float
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Return the cells an interval reaches and the value in it nearest to each middle.

    A single value, such as a bollard's place, takes its neighbours too: one cell alone
    is too narrow to see.
    """
    step = float(bounds[1] - bounds[0])
    last = len(bounds) - 2
    if high - low <= 1e-9 * step:
        middle = min(int((low - bounds[0]) // step), last) if bounds[0] <= low else -2
        cells = np.arange(max(middle - 1, 0), min(middle + 1, last) + 1)
    else:
        first = min(max(int((low - bounds[0]) // step) - 1, 0), last)
        near = bounds[first : max(int((high - bounds[0]) // step), first) + 3]
        reached = np.minimum(near[1:], high) - np.maximum(near[:-1], low)
        cells = first + np.flatnonzero(reached > 1e-9 * step)
    return cells, np.clip(0.5 * (bounds[cells] + bounds[cells + 1]), low, high)
