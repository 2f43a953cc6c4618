"""Generators whose wrench set lies inside that of every swarm with a given summary."""

from dataclasses import dataclass

import numpy as np

from swarmgrasp.errors import LinearProgramFailed
from swarmgrasp.linear import minimise
from swarmgrasp.summary.cells import Array
from swarmgrasp.summary.heights import Heights

SHORTFALL = 1e3
"""Cost of a shortfall in the program, where that of a bin's share is at most 1 per newton."""


@dataclass(frozen=True, eq=False)
class Inner:
    """A swarm whose wrench set lies inside.

    Attributes
    ----------
    generators : (m, 3) [N]
    margin : float [N]
        What to take off its qualities to be certain.
    """

    generators: Array
    margin: float


def inner_of(heights: Heights) -> Inner:
    """Return the inner swarm of a summary."""
    generators, shortfall = inner_generators(heights.sums, heights.total)
    return Inner(generators, heights.margin + shortfall)


def inner_generators(sums: Array, total: Array) -> tuple[Array, float]:
    """Split the bins' sums into robots of both senses that add up to the swarm's sum.

    A bin's sum b' with the share t in [-1, 1] becomes the generators (1 + t)/2 b' and
    -(1 - t)/2 b'. Their support functions add up to (n . sum t b' + sum |n . b'|) / 2: the lower
    bound on h once sum t b' = s. A vertex of the feasible shares, found by a linear program, has
    at most three of them strictly between -1 and 1, so there are hardly more generators than bins.
    Where s is out of reach the swarm may have no force closure; the shortfall is then least.

    Parameters
    ----------
    sums : (g, 3) [N]
    total : (3,) [N]
        s, the sum of all generators as they are.

    Returns
    -------
    generators : (m, 3) [N]
    shortfall : float [N]
        |s - sum t b'| / 2, to be taken off any bound on h from below.

    Examples
    --------
    Two pushes each way along x, and more of them ahead.

    >>> generators, shortfall = inner_generators(np.array([[4.0, 0.0, 0.0]]), np.array([2.0, 0, 0]))
    >>> generators.tolist(), shortfall
    ([[3.0, 0.0, 0.0], [-1.0, -0.0, -0.0]], 0.0)
    """
    unit = float(np.abs(sums).max(initial=0.0)) or 1.0  # the program's numbers are near 1
    sizes = np.linalg.norm(sums / unit, axis=1)
    # any vertex will do: costs at random lead to one quickly, no cost at all does not
    cost = sizes * np.random.default_rng(0).uniform(-1.0, 1.0, len(sums))
    cost = np.concatenate([cost, np.full(6, SHORTFALL)])
    matrix = np.concatenate([sums.T / unit, np.eye(3), -np.eye(3)], axis=1)
    least = np.concatenate([np.full(len(sums), -1.0), np.zeros(6)])
    most = np.concatenate([np.ones(len(sums)), np.full(6, np.inf)])
    try:
        found = minimise(cost, matrix, (total / unit,) * 2, (least, most))[: len(sums)]
    except LinearProgramFailed:
        found = np.zeros(len(sums))
    shares = np.clip(found, -1.0, 1.0)[:, None]
    generators = np.concatenate([0.5 * (1.0 + shares) * sums, -0.5 * (1.0 - shares) * sums])
    generators = generators[generators.any(axis=1)]
    short = 0.5 * float(np.linalg.norm(total - (shares * sums).sum(axis=0)))
    return generators, short
