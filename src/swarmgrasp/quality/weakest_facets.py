"""Every facet as weak as the weakest, of swarms that balance as of any other (T2, T12)."""

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.quality.heights import ON_FACET, Array, Heights, largest
from swarmgrasp.quality.weakest import UNASKED

TIED = 1e-12
"""Difference of two heights that is rounding, relative to what was added up."""
ROUGH = 1e-9
"""The same, where it is only meant to leave few facets."""
SAME = 1e-9
"""Angle [rad] between two normals that are one."""
FEW = 60
"""Generators up to which all pairs of them are looked at."""
SMALLEST = 1e-7
"""Edge [rad] of a triangle that is not halved."""
MOST_CELLS = 20_000
"""Triangles after which the search is content with what it found; some 100 are usual."""
ROWS = 1 << 20
"""Products computed at a time."""

Indices = NDArray[np.intp]
Cell = tuple[Array, Array, Indices, Array]
"""Corners (3, 3), what is lost or asked there (3,) [N], generators across, sum of those above."""


def weakest_facets(heights: Heights, value: float, known: Array, more: Array) -> Array:
    """List the unit normals at which H(n) is `value` times D(n), the least it is anywhere.

    Parameters
    ----------
    heights : Heights
    value : float
        The criterion's value, at least 0.
    known : (3,)
        Unit normal at which it is.
    more : (m, 3)
        Unit normals to look at besides those of all facets.

    Returns
    -------
    (k, 3)
        Those within rounding, each once; none where the task asks for nothing there.
    """
    found = np.concatenate([more, _candidates(heights, value)])
    step = max(1, ROWS // max(1, len(heights.generators)))
    parts = [found[i : i + step] for i in range(0, len(found), step)]
    kept = [part[_is_tied(heights, value, part)] for part in parts]
    first = known[None][_is_asked(heights, heights.asked(known[None]))]
    return _each_once(np.concatenate([first, *kept]))


def _is_tied(heights: Heights, value: float, normals: Array) -> NDArray[np.bool_]:
    """Tell at which normals (m, 3) the value is attained, up to rounding."""
    found, weights = heights.at(normals)
    asked = heights.asked(normals)
    margins = found - value * asked
    # what counts as quality 0 is relative to all robots
    rounding = TIED * (weights + value * asked if value > 0.0 else heights.weight)
    return np.asarray((margins <= rounding) & _is_asked(heights, asked))


def _is_asked(heights: Heights, asked: Array) -> NDArray[np.bool_]:
    """Tell where D (m,) is more than rounding."""
    reach = float(np.linalg.norm(heights.task, axis=1).max(initial=0.0)) or 1.0
    return np.asarray(asked > UNASKED * reach)


def _each_once(normals: Array) -> Array:
    """Return normals (m, 3), those nearly equal once."""
    kept = []
    while len(normals):
        kept.append(normals[0])
        normals = normals[np.abs(normals - normals[0]).max(axis=1) > SAME]
    return np.reshape(kept, (-1, 3))


def _candidates(heights: Heights, value: float) -> Array:
    """Return facet normals (m, 3), among them all where the value is attained.

    Branch and bound on the sphere of directions (T12): a triangle is dropped when
    H - value D is positive all over it, and done with when few generators cross it.
    """
    units = heights.generators / heights.sizes[:, None]
    everyone = np.arange(len(units))
    if len(units) <= FEW:
        return _pairs(units)
    found = [np.zeros((0, 3))]
    stack = _octants(heights, value, everyone)
    for _ in range(MOST_CELLS):
        if not stack:
            break
        corners, rest, near, above = stack.pop()
        products = units[near] @ corners.T
        ups, downs = (products > ON_FACET).all(axis=1), (products < -ON_FACET).all(axis=1)
        above = above + heights.generators[near[ups]].sum(axis=0)
        crossed = ~(ups | downs)
        near, products = near[crossed], products[crossed]
        if len(near) < 2 or _is_above(heights, corners, rest, near, products, above):
            continue
        facets = _facets_across(units[near], corners)
        if facets is None:
            stack += _halves(heights, value, (corners, rest, near, above))
        elif len(facets):
            summed = np.maximum(facets @ heights.generators[near].T, 0.0).sum(axis=1)
            margins = summed + facets @ (above + heights.load) - _rest(heights, value, facets)
            found.append(facets[margins <= ROUGH * heights.weight])
    return np.concatenate(found)


def _octants(heights: Heights, value: float, everyone: Indices) -> list[Cell]:
    """Return the triangles to begin with."""
    # turned, lest facets of upright objects fall on their corners
    turn = np.linalg.qr(np.array([[1.0, 0.3, 0.2], [0.1, 1.0, 0.4], [0.3, -0.2, 1.0]]))[0]
    cells = []
    for signs in np.ndindex(2, 2, 2):
        corners = turn * (1.0 - 2.0 * np.array(signs))[:, None]
        cells.append((corners, _rest(heights, value, corners), everyone, np.zeros(3)))
    return cells


def _rest(heights: Heights, value: float, normals: Array) -> Array:
    """Compute what is lost and what is asked at normals (m, 3): (m,) [N], a convex function."""
    rest = value * heights.asked(normals)
    if heights.losing:
        rest += largest(np.maximum(normals @ heights.generators.T, 0.0), heights.losing)
    return rest


def _is_above(
    heights: Heights, corners: Array, rest: Array, near: Indices, products: Array, above: Array
) -> bool:
    """Tell whether H exceeds what is asked all over a triangle.

    At any direction the sum g of the generators above it bounds h from below everywhere:
    g . n - rest(n) is concave, so it is positive on the triangle if it is at the corners.
    """
    centres = np.column_stack([products.sum(axis=1), products])
    sums = (centres > 0.0).T @ heights.generators[near] + above + heights.load
    margins = sums @ corners.T - rest
    return bool((margins > 2.0 * TIED * heights.weight).all(axis=1).any())


def _facets_across(units: Array, corners: Array) -> Array | None:
    """Return the facet normals on a triangle that unit generators (m, 3) cross, None for many."""
    if len(units) <= FEW:
        return _within(_pairs(units), corners)
    crosses = np.cross(units[0], units)
    lengths = np.linalg.norm(crosses, axis=1)
    widest = int(lengths.argmax())
    if lengths[widest] <= ON_FACET:
        return np.zeros((0, 3))
    normal = crosses[widest] / lengths[widest]
    if (np.abs(units @ normal) <= ON_FACET).all():
        return np.array([normal, -normal])
    edge = float(np.abs(corners - np.roll(corners, 1, axis=0)).max())
    return _pairs(units[:FEW]) if edge < SMALLEST else None


def _within(normals: Array, corners: Array) -> Array:
    """Return the normals (m, 3) on a triangle, or just beyond its edges."""
    sides = np.cross(corners, np.roll(corners, -1, axis=0))
    sides *= np.sign(np.linalg.det(corners))
    lengths = np.linalg.norm(sides, axis=1)
    return np.asarray(normals[(normals @ sides.T >= -SMALLEST * lengths).all(axis=1)])


def _halves(heights: Heights, value: float, cell: Cell) -> list[Cell]:
    """Halve a triangle at the middle of its longest edge."""
    corners, rest, near, above = cell
    first = int(np.linalg.norm(corners - np.roll(corners, -1, axis=0), axis=1).argmax())
    second = (first + 1) % 3
    middle = corners[first] + corners[second]
    middle /= np.linalg.norm(middle)
    at_middle = _rest(heights, value, middle[None])[0]
    halves = []
    for replaced in (first, second):
        ends, there = corners.copy(), rest.copy()
        ends[replaced], there[replaced] = middle, at_middle
        halves.append((ends, there, near, above))
    return halves


def _pairs(units: Array) -> Array:
    """Return +-(b_j x b_k) for all pairs of unit generators (m, 3) not parallel, best first."""
    j, k = np.triu_indices(len(units), 1)
    crosses = np.cross(units[j], units[k])
    lengths = np.linalg.norm(crosses, axis=1)
    order = np.argsort(-lengths)
    order = order[lengths[order] > ON_FACET]
    normals = crosses[order] / lengths[order, None]
    return np.concatenate([normals, -normals])
