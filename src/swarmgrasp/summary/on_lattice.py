"""Placement by the heights along a lattice of directions, by boxes (T13, T23).

No robot b of a box of contacts and directions makes the quality exceed the least over any unit
normals n_k of H(n_k) + max(0, most n_k . b), H >= h. The wrenches of the box lie in the hull of
six: at both contacts, in both directions, and in the middle one so much longer that the arc between
lies inside.
"""

import math
from itertools import pairwise

import numpy as np

from swarmgrasp.summary.cells import Array
from swarmgrasp.summary.lattice import lattice
from swarmgrasp.summary.support_bounds import SupportBounds

GAP = 1e-3
"""Of the newcomer's largest wrench, that is left between the best box and the best robot."""
ROUNDS, MOST_BOXES = 40, 4000
"""Halvings, and boxes at once, after which the bound is what it is."""
WIDEST = 0.5 * math.pi
"""Widest box of directions [rad] to begin with."""
AT_ONCE = 1 << 21
"""Products of boxes and normals that are held at once."""


def best_on_lattice(
    support: SupportBounds, rows: Array, weights: Array
) -> tuple[tuple[int, float, float, float], float]:
    """Find a robot whose least upper bound along the lattice is the greatest.

    Parameters
    ----------
    support : SupportBounds
    rows : (k, 10)
        The pieces; see `Pieces`.
    weights : (3,) [N, N, N/m]
        Turn a unit wrench [1, 1, m] of the newcomer into the metric's coordinates.

    Returns
    -------
    spot : tuple
        Its piece and unit wrench (cos, sin, torque).
    most : float [N]
        What no allowed robot exceeds.
    """
    normals = lattice(support.side)
    heights, covectors = support.upper(normals), (normals * weights).T
    step = AT_ONCE // len(normals) + 1

    def least(points: Array) -> Array:
        """Return the least height (m,) once the best of points (m, p, 3) is there."""
        values = np.empty(len(points))
        for first in range(0, len(points), step):
            some = points[first : first + step]
            gains = np.maximum((some @ covectors).max(axis=1), 0.0)
            values[first : first + step] = (heights + gains).min(axis=1)
        return values

    boxes = _first_boxes(rows)
    reach = float(np.abs(rows[:, :4]).max()) or 1.0
    gap = GAP * float(np.hypot(weights[:2].max(), weights[2] * reach))
    best, spot, closed = -np.inf, (0, 1.0, 0.0, 0.0), -np.inf
    for _ in range(ROUNDS):
        centres, points = _wrenches(rows, boxes)
        values = least(centres[:, None])
        k = int(values.argmax())
        if values[k] > best:
            best, spot = float(values[k]), (int(boxes[k, 0]), *centres[k].tolist())
        bounds = least(points)
        is_open = bounds > best + gap
        closed = max(closed, float(bounds[~is_open].max(initial=-np.inf)))
        if not is_open.any():
            return spot, closed
        if 2 * int(is_open.sum()) > MOST_BOXES:
            break
        boxes = _halved(boxes[is_open], rows, weights)
    return spot, max(closed, float(bounds[is_open].max()))


def _first_boxes(rows: Array) -> Array:
    """Return boxes (m, 5) that cover the pieces.

    Each a piece, the shares of the way along it of the first and the last contact, and the first
    and the last direction [rad].
    """
    boxes = []
    for piece, (lo, hi) in enumerate(rows[:, 4:6].tolist()):
        turns = np.linspace(lo, hi, max(1, math.ceil((hi - lo) / WIDEST)) + 1).tolist()
        boxes += [(piece, 0.0, 1.0, *ends) for ends in pairwise(turns)]
    return np.array(boxes)


def _wrenches(rows: Array, boxes: Array) -> tuple[Array, Array]:
    """Return the unit wrench (m, 3) in the middle of each box, and six (m, 6, 3) around all."""
    piece = rows[boxes[:, 0].astype(np.int64)]
    shares = np.column_stack([boxes[:, 1], boxes[:, 2], boxes[:, 1:3].mean(axis=1)])
    x, y = (piece[:, k, None] + shares * (piece[:, k + 2] - piece[:, k])[:, None] for k in (0, 1))
    turns = np.column_stack([boxes[:, 3], boxes[:, 4], boxes[:, 3:].mean(axis=1)])
    c, s = np.cos(turns), np.sin(turns)
    longer = np.ones((len(boxes), 3))
    longer[:, 2] = 1.0 / np.cos(0.5 * (boxes[:, 4] - boxes[:, 3]))
    centre = np.column_stack([c[:, 2], s[:, 2], x[:, 2] * s[:, 2] - y[:, 2] * c[:, 2]])
    c, s = c * longer, s * longer
    points = [np.stack([c, s, x[:, [end]] * s - y[:, [end]] * c], axis=2) for end in (0, 1)]
    return centre, np.concatenate(points, axis=1)


def _halved(boxes: Array, rows: Array, weights: Array) -> Array:
    """Return the halves (2 m, 5) of boxes, cut where their wrenches differ more."""
    piece = rows[boxes[:, 0].astype(np.int64)]
    lengths = np.hypot(*(piece[:, 2:4] - piece[:, :2]).T) * (boxes[:, 2] - boxes[:, 1])
    arms = np.hypot(*np.abs(piece[:, :4]).reshape(-1, 2, 2).max(axis=1).T)
    turned = (boxes[:, 4] - boxes[:, 3]) * np.hypot(weights[:2].max(), weights[2] * arms)
    is_turn = turned > weights[2] * lengths
    first, second = boxes.copy(), boxes.copy()
    for chosen, lo, hi in ((is_turn, 3, 4), (~is_turn, 1, 2)):
        first[chosen, hi] = second[chosen, lo] = boxes[chosen, lo : hi + 1].mean(axis=1)
    return np.concatenate([first, second])
