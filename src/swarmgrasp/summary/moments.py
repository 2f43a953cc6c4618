"""What a summary keeps of each bin: how much pushes there, where on average, and how spread."""

from dataclasses import dataclass

import numpy as np

from swarmgrasp.frozen import Frozen
from swarmgrasp.summary.cells import Array, Indices, locate

CHUNK = 1 << 20
"""Generators that are summed at once: it bounds the rounding, and the memory."""
EPS = 2.0**-52
DIAGONAL = 3.0**0.5
"""Longest vector of weight 1."""


@dataclass(frozen=True, eq=False)
class Moments(Frozen):
    """The generators of each occupied bin, as a distribution of weight over positions.

    Attributes
    ----------
    cells : (g,)
        Increasing.
    weights : (g,) [N]
        Sum of the generators' weights, positive.
    means : (2, g)
        Their weighted mean position (u, v): the bin's sum is weight (1, u, v).
    covariances : (3, g)
        Of u, of u with v, and of v.
    """

    cells: Indices
    weights: Array
    means: Array
    covariances: Array

    @property
    def size(self) -> float:
        """A bound on the sum of |b_i| over all generators [N]."""
        return DIAGONAL * float(self.weights.sum())


def none() -> Moments:
    """Return the moments of no generators."""
    return Moments(np.empty(0, np.int64), np.empty(0), np.empty((2, 0)), np.empty((3, 0)))


def moments_of(generators: Array, side: int) -> tuple[Moments, Array, float]:
    """Sort generators into bins, and add them up.

    Parameters
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates.

    Returns
    -------
    moments : Moments
    total : (3,) [N]
    rounding : float [N]
        By how much rounding may have moved the bins' sums, and the sum of all, altogether.
    """
    parts, total, rounding = [none()], np.zeros(3), 0.0
    for first in range(0, len(generators), CHUNK):
        part = generators[first : first + CHUNK]
        moving = part.any(axis=1)
        cells, weights, positions = locate(part if moving.all() else part[moving], side)
        parts.append(grouped(cells, weights, positions, None, side))
        total += part.sum(axis=0)
        rounding += rounding_of(len(part), parts[-1].size)
    if len(parts) > 2:
        parts.append(merged(parts, side))
        rounding += rounding_of(len(parts), parts[-1].size)
    return parts[-1], total, rounding


def merged(parts: list[Moments], side: int) -> Moments:
    """Return the moments of several sets of generators together."""
    return grouped(
        np.concatenate([p.cells for p in parts]),
        np.concatenate([p.weights for p in parts]),
        np.concatenate([p.means for p in parts], axis=1),
        np.concatenate([p.covariances for p in parts], axis=1),
        side,
    )


def rounding_of(terms: int, size: float) -> float:
    """Bound the rounding [N] of sums of so many terms, whose sizes add up to `size` [N]."""
    return 4.0 * (terms + 16) * EPS * size


def grouped(
    cells: Indices, weights: Array, means: Array, covariances: Array | None, side: int
) -> Moments:
    """Unite what lies in the same cell; no covariances means points.

    The spread of a union is the mean spread of its parts and the spread of their means: taken
    about the common mean there is nothing to cancel. Of two parts in one cell the order does
    not matter, to the last bit.
    """
    present = np.zeros(3 * side**2, dtype=bool)
    present[cells] = True
    occupied: Indices = np.flatnonzero(present)
    slots = np.empty(len(present), dtype=np.int64)
    slots[occupied] = np.arange(len(occupied))
    slot, many = slots[cells], len(occupied)
    totals = np.bincount(slot, weights, many)
    centres = np.array([np.bincount(slot, weights * mean, many) for mean in means]) / totals
    du, dv = means - centres[:, slot]
    spreads = np.array([du * du, du * dv, dv * dv])
    if covariances is not None:
        spreads += covariances
    around = np.array([np.bincount(slot, weights * part, many) for part in spreads]) / totals
    return Moments(occupied, np.asarray(totals, dtype=float), centres, around)
