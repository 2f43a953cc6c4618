"""Among equally good robots, the one that lifts the rest of h most (T17).

When the weakest facet cannot be raised, or the contact does not matter for it, a whole set of
robots shares the best quality. Of these the one is taken that makes the soft minimum of h over
directions greatest, so that the robots to come are not stuck where this one could not help.
"""

import math

import numpy as np

from swarmgrasp.placement.optimum import Array, Optimum, Search, robots_at

CANDIDATES = 300
"""Size of the first grid over all tied pieces together."""
ZOOMS = 3
"""How often a finer grid is laid around the best candidate."""
SHARPNESS = 8.0
"""Of the soft minimum, relative to the mean of h over directions."""
DIRECTIONS = 100
"""Number of directions it is taken over."""
UNTURNED = 1e-6
"""Torque part of a proof's mean normal below which the contact does not matter to it."""


def is_tied(found: Optimum, target: float) -> bool:
    """Tell whether other robots may be as good as the best one.

    The best robot of a piece maximises v . b, v the mean normal of its proof. It is unique
    unless v vanishes or says nothing of the torque.
    """
    rivals = np.flatnonzero(found.bounds >= target)
    turns = np.abs(found.mean_normals(rivals.tolist())[:, 2])
    return bool(found.best[4] < 0.0 or (turns <= UNTURNED).any())


def break_tie(search: Search, found: Optimum, target: float) -> Array:
    """Find the robot of at least the target quality that lifts the rest of h most.

    Returns
    -------
    (5,)
        As `Optimum.best`.
    """
    directions = even_directions(DIRECTIONS)
    support = np.maximum(search.generators @ directions.T, 0.0).sum(axis=0)
    mean = max(float(support.mean()), float(np.linalg.norm(search.weights[:2])) / 4.0)
    decay = np.exp(-SHARPNESS / mean * (support - support.min()))
    covectors = (SHARPNESS / mean) * directions * search.weights

    def softness(robots: Array) -> Array:
        """Return the sum of exp(-sharpness h) over directions with each robot: less is better."""
        return np.asarray(np.exp(-np.maximum(robots @ covectors.T, 0.0)) @ decay)

    grid, step = _grid(search.rows, np.flatnonzero(found.bounds >= target).tolist())
    best, least = found.best, math.inf
    if best[4] >= 0.0:
        least = float(softness(best[None, 1:4])[0])
    for _ in range(1 + ZOOMS):
        rows = search.rows[grid[:, 0].astype(int)]
        robots = robots_at(rows, grid[:, 1], grid[:, 2])
        scores = softness(robots)
        values = search.qualities(robots)
        scores[values < target] = math.inf
        k = int(np.argmin(scores))
        if scores[k] < least:
            least = float(scores[k])
            best = np.array([values[k], *robots[k], grid[k, 0]])
            at = grid[k]
        elif best is found.best:
            break  # no candidate is better than the search's own
        around = np.linspace(-1.0, 1.0, 7)
        near = at + step * np.array([(0.0, u, v) for u in around for v in around])
        grid = np.column_stack([near[:, 0], np.clip(near[:, 1:], 0.0, 1.0)])
        step *= 0.3
    return best


def _grid(pieces: Array, rivals: list[int]) -> tuple[Array, float]:
    """Lay a grid over the rival pieces: (piece, share of the contact, share of the sector)."""
    each = max(1, CANDIDATES // max(len(rivals), 1))
    side = max(1, round(math.sqrt(each)))
    cells = []
    for k in rivals:
        is_point = np.array_equal(pieces[k, :2], pieces[k, 2:4])
        is_ray = pieces[k, 4] == pieces[k, 5]
        contacts = 1 if is_point else each if is_ray else side
        sectors = 1 if is_ray else each if is_point else side
        cells += [(float(k), u, v) for u in _shares(contacts) for v in _shares(sectors)]
    return np.array(cells), 1.0 / side


def _shares(count: int) -> Array:
    """Return evenly spaced shares within [0, 1]."""
    return np.linspace(0.0, 1.0, count) if count > 1 else np.array([0.5])


def even_directions(count: int) -> Array:
    """Spread directions evenly over the sphere on a Fibonacci spiral, (count, 3).

    Examples
    --------
    >>> spread = even_directions(1000)
    >>> bool(np.allclose(spread.mean(axis=0), 0.0, atol=1e-3))
    True
    """
    k = np.arange(count)
    z = 1.0 - (2.0 * k + 1.0) / count
    radius, turn = np.sqrt(1.0 - z * z), k * math.pi * (3.0 - math.sqrt(5.0))
    return np.column_stack([radius * np.cos(turn), radius * np.sin(turn), z])
