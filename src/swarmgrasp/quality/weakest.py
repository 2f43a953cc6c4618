"""The weakest facet of a wrench set: its exact quality and where it is attained."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.kernels import core
from swarmgrasp.quality.generators import checked_generators

MARGINAL = core.MARGINAL
"""Quality relative to sum |b_i| at and below which it counts as zero."""
UNASKED = core.UNASKED
"""Share of a task's size at and below which it asks for nothing along a normal, and share of
sum |b_i| by which rounding may change what robots can do there."""


class Weakest(NamedTuple):
    """The least support function over all unit normals (T2).

    Attributes
    ----------
    quality : float [N]
        That least h; 0 up to `MARGINAL` is exactly 0.
    normal : tuple of float
        The unit normal that attains it, in the metric's coordinates.
    """

    quality: float
    normal: tuple[float, float, float]


def weakest_of(
    generators: NDArray[np.float64], load: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> Weakest:
    """Find the weakest facet, exactly: by sweeping all planes, or by branch and bound (T11, T12).

    A set that spans no plane is weakest across it.

    Parameters
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates.
    load : (3,) [N]
        A wrench that is always there: h(n) = n . load + sum max(0, n . b_i).

    Examples
    --------
    Four robots to the corners of a tetrahedron: sqrt(6)/3 for unit ones.

    >>> corners = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], dtype=float)
    >>> round(weakest_of(corners / 3**0.5).quality, 6)
    0.816497
    """
    return bounded_weakest(generators, load)[0]


def bounded_weakest(
    generators: NDArray[np.float64], load: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> tuple[Weakest, float]:
    """Find the weakest facet, and what the quality [N] is at least: less if the work is spent."""
    quality, normal, bound = core.weakest(np.ascontiguousarray(generators, dtype=float), load)
    return Weakest(quality, normal), bound


def qualities(generators: ArrayLike) -> NDArray[np.float64]:
    """Compute the exact qualities of many swarms of one size.

    Parameters
    ----------
    generators : (m, n, 3) [N]
        Of m swarms of n robots, in the metric's coordinates: see `wrenches`, and multiply by
        a swarm's `scale`.

    Returns
    -------
    (m,) [N]

    Raises
    ------
    WrenchInvalid
        If the generators are no such array of numbers, or the largest component of one is
        neither zero nor within 1e-120 to 1e120 N.

    Examples
    --------
    The tetrahedron, and the same twice as strong:

    >>> corners = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], dtype=float)
    >>> qualities([corners, 2.0 * corners]).round(6).tolist()
    [1.414214, 2.828427]
    """
    rows = np.ascontiguousarray(checked_generators(generators, "(m, n, 3)"))
    if rows.size == 0:
        return np.zeros(len(rows))
    return np.frombuffer(core.qualities(rows, rows.shape[1]))
