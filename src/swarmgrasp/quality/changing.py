"""The quality of robots that change between sectors with gaps between, from both sides (T28).

A wrench is within reach if some choice of sectors makes it. What a choice makes is convex: if one
makes three wrenches, it makes all of the flat triangle between them. So triangles that cover all
directions, each with a choice for its three corners, prove how far the swarm reaches in any. How
far the best choice reaches along one of the corners is what no quality exceeds.
"""

import math
from itertools import product

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.quality.push_table import push_table
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.choices import Choices

Array = NDArray[np.float64]
NEAR = 0.01
"""Relative difference of the two bounds that is near enough."""
MOST_CHOICES, MOST_ASKED = 256, 60_000
"""Choices up to which this is asked for, and wrenches that they are asked for in all."""
MOST_SPREAD = 1e5
"""Largest limit of a robot over the least, above which rounding decides how far choices reach."""
ROUNDED = 5e-6
"""Share of how far a choice reaches that the kernel may be off."""
OCTAHEDRON = np.array(list(product((1.0, -1.0), repeat=3)))[:, :, None] * np.eye(3)


def changing_bounds(swarm: Swarm, most: float) -> tuple[float, float]:
    """Bound the quality [N] of robots that change sectors from below and above.

    Parameters
    ----------
    swarm : Swarm
        In which robots have gaps between their sectors.
    most : float [N]
        What it is at most.

    Returns
    -------
    tuple of float [N]
        0 and `most` if there are too many choices or limits are too far apart; apart by more than
        `NEAR` if the work is spent.
    """
    choices = Choices(swarm)
    is_spread = float(swarm.limits.max()) > MOST_SPREAD * float(swarm.limits.min())
    if choices.count > MOST_CHOICES or most == 0.0 or is_spread:
        return 0.0, most
    fixed = [choices.swarm(taken) for taken in np.ndindex(*map(len, choices.options))]
    cells, found, least, asked = OCTAHEDRON, np.zeros(0), math.inf, 0
    known: dict[tuple[float, ...], Array] = {}
    while len(cells):
        corners = np.unique(cells.reshape(-1, 3), axis=0)
        new = np.array([c for c in corners if tuple(c.tolist()) not in known]).reshape(-1, 3)
        asked += len(new) * len(fixed)
        if asked > MOST_ASKED:
            least = min(least, float(found.min(initial=math.inf)))
            break
        reaches = np.array([_reaches(one, new) for one in fixed]).reshape(len(fixed), -1).T
        known.update(zip(map(tuple, new.tolist()), reaches, strict=True))
        farthest = np.where(np.isnan(reaches), math.inf, reaches).max(axis=1)
        most = min(most, float(farthest.min(initial=math.inf)) * (1.0 + ROUNDED))
        found = np.array(
            [_within(cell, [known[tuple(c)] for c in cell.tolist()]) for cell in cells]
        )
        is_near = found >= (1.0 - NEAR) * most
        least = min(least, float(found[is_near].min(initial=math.inf)))
        cells, found = cells[~is_near], found[~is_near]
        if most == 0.0:
            return 0.0, 0.0
        cells = quarters(cells)
    return min(least, most), most


def _reaches(swarm: Swarm, ways: Array) -> Array:
    """Return how far a swarm without gaps reaches along unit wrenches (m, 3): (m,) [N].

    nan where rounding decides.
    """
    table = push_table(swarm, ways)
    needed = np.where(table[:, -1] == 1.0, table[:, 3 * len(swarm)], np.nan)
    return np.asarray(1.0 / np.maximum(needed, np.finfo(float).tiny))


def _within(cell: Array, reaches: list[Array]) -> float:
    """Return how far some choice reaches in all directions of a triangle (3, 3) [N]."""
    far = np.nan_to_num(np.array(reaches)).min(axis=0).max() * (1.0 - ROUNDED)
    across = np.cross(cell[1] - cell[0], cell[2] - cell[0])
    return float(far * abs(cell[0] @ across) / np.linalg.norm(across))


def quarters(cells: Array) -> Array:
    """Cut triangles of unit vectors (c, 3, 3) in four, between the middles of their edges."""
    a, b, c = cells[:, 0], cells[:, 1], cells[:, 2]
    middles = [one + other for one, other in ((a, b), (b, c), (c, a))]
    ab, bc, ca = (m / np.linalg.norm(m, axis=1)[:, None] for m in middles)
    parts = ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
    return np.concatenate([np.stack(part, axis=1) for part in parts])
