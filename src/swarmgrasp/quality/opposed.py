"""How far some direction opposes all robots: what keeps a swarm without force closure so."""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.linear import minimise
from swarmgrasp.quality.weakest import MARGINAL
from swarmgrasp.swarm import Swarm

Array = NDArray[np.float64]
STRAIGHT = 1e-9
"""Difference from a half turn [rad] that is none."""


def is_opposed(swarm: Swarm) -> bool:
    """Tell whether a swarm without quality has none for certain, whatever the outline's rounding.

    Some direction then opposes all robots, and by more than rounding can change. Exact robots
    need not be opposed by more than 0.
    """
    if swarm.noise == 0.0:
        return True
    across, generators, owners = _borders(swarm)
    sizes = np.linalg.norm(swarm.scaled_generators, axis=1)
    shares = swarm.errors / sizes
    most = float(shares.max())
    # a direction across those that push both ways, which moves when they do
    singular = np.linalg.svd(across, compute_uv=False)
    if len(across) > 2 or (len(across) and singular[-1] <= MARGINAL * len(across)):
        return False
    plane = np.linalg.svd(across, full_matrices=True)[2][len(across) :]
    moved = math.sqrt(len(across)) / singular[-1] if len(across) else 0.0
    found = opposition(generators @ plane.T, shares[owners] / most)
    return found > math.sqrt(3.0) * most * (1.0 + moved)


def _borders(swarm: Swarm) -> tuple[Array, Array, NDArray[np.intp]]:
    """Return what a direction should be across, and not along, to get nothing of any robot.

    Returns
    -------
    across : (k, 3)
        Unit wrenches of the robots that push both ways along them.
    generators : (m, 3)
        Unit wrenches at the borders of what the others push along.
    owners : (m,)
        Whose they are.
    """
    across: list[tuple[int, float]] = []
    borders: list[tuple[int, float]] = []
    elements, counts = swarm.force_sets
    ends = np.cumsum(counts)
    for i, (start, end) in enumerate(zip(ends - counts, ends, strict=True)):
        ways = []
        for radius, x, y, lo, hi in elements[start:end].tolist():
            if radius > 0.0:
                ways += np.linspace(lo, hi, 9).tolist()
            elif x or y:
                ways.append(math.atan2(y, x))
        turns = np.sort(np.remainder(ways, math.tau))
        gaps = np.diff(turns, append=turns[0] + math.tau)
        widest = int(gaps.argmax())
        first, last = float(turns[(widest + 1) % len(turns)]), float(turns[widest])
        if gaps[widest] > math.pi + STRAIGHT:
            borders += [(i, first)] if first == last else [(i, first), (i, last)]
            continue
        across.append((i, first))
        inside = [turn for turn in turns.tolist() if abs(math.sin(turn - first)) > STRAIGHT]
        if gaps[widest] < math.pi - STRAIGHT:
            across.append((i, first + 0.5 * math.pi))
        elif inside:
            borders.append((i, inside[len(inside) // 2]))
    return (
        _wrenches(swarm, across),
        _wrenches(swarm, borders),
        np.array([i for i, _ in borders], int),
    )


def _wrenches(swarm: Swarm, ways: list[tuple[int, float]]) -> Array:
    """Return unit wrenches (m, 3) of robots along directions [rad], in the metric's coordinates."""
    found = np.zeros((len(ways), 3))
    for row, (i, way) in zip(found, ways, strict=True):
        x, y = swarm.contacts[i] - swarm.outline.origin
        c, s = math.cos(way), math.sin(way)
        row[:] = np.array([c, s, x * s - y * c]) * swarm.scale
    return np.asarray(found / np.linalg.norm(found, axis=1)[:, None])


def opposition(generators: Array, shares: Array) -> float:
    """Find by how much some direction opposes all robots.

    The largest s for which some n with |n| <= sqrt 3 has n . b_i <= -s share_i |b_i| for all
    robots. If every b_i may change by less than s / sqrt 3 of share_i |b_i|, no force closure
    comes of it.

    Parameters
    ----------
    generators : (n, d) [N]
        In the metric's coordinates, of d dimensions: 3, or fewer across some directions.
    shares : (n,)
        Not negative, and 1 at most.

    Returns
    -------
    float
        0 where the robots only just leave a direction out, or leave none; infinite for fewer than
        d + 1 robots, and for generators in a plane.

    Examples
    --------
    >>> ahead = np.array([(1.0, y, y) for y in (-0.5, 0.0, 0.5)] + [(1.0, 0.5, -0.5)])
    >>> round(opposition(ahead, np.ones(4)), 3), opposition(ahead[:3], np.ones(3))
    (0.816, inf)
    """
    many, wide = generators.shape
    sizes = np.linalg.norm(generators, axis=1)
    if many <= wide and (sizes > 0.0).all():
        return math.inf
    units = generators / np.where(sizes > 0.0, sizes, 1.0)[:, None]
    if np.linalg.svd(units, compute_uv=False)[-1] <= MARGINAL * many:
        return math.inf
    cost, matrix = np.append(np.zeros(wide), -1.0), np.column_stack([units, shares])
    bounds = np.append(np.ones(wide), np.inf)
    found = minimise(cost, matrix, rows=(-np.inf, 0.0), columns=(-1.0, bounds))
    return float(found[wide])
