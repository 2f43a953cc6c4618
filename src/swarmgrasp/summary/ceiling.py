"""What no robot can exceed, with the swarm's support function known from above only (T10, T13).

For unit normals n_k and weights l_k >= 0 that sum to 1, with any H >= h, no robot on the piece K
makes the quality exceed max(sigma_K(sum l_k n_k) + sum l_k H(n_k), max_k H(n_k)): a quality t above
all H(n_k) needs n_k . b >= t - h(n_k) >= t - H(n_k) of every k; take the weighted sum.
"""

import math
from collections.abc import Sequence

import numpy as np

from swarmgrasp.placement.certificate import Proof
from swarmgrasp.summary.cells import Array
from swarmgrasp.summary.support_bounds import SupportBounds


def best_possible(
    support: SupportBounds, rows: Array, weights: Array, proofs: Sequence[Proof], direction: Array
) -> float:
    """Bound the quality that any robot on any piece reaches.

    Every proof is tried on every piece. Two more are: a direction in which the swarm is weak, on
    its own and with its opposite (T17). The search's normals lie in the planes of bins' sums,
    where the bounds on h are widest; that direction was sought where they are low.

    Parameters
    ----------
    support : SupportBounds
    rows : (k, 10)
        The pieces; see `Pieces`.
    weights : (3,) [N, N, N/m]
        Turn a unit wrench [1, 1, m] of the newcomer into the metric's coordinates.
    proofs : sequence of Proof
        Of the search over the bins' sums.
    direction : (3,)
        A unit normal.

    Returns
    -------
    float [N]
    """
    trials = [(proof.normals, proof.weights / proof.weights.sum()) for proof in proofs]
    trials.append((direction[None], np.ones(1)))
    trials.append((np.array([direction, -direction]), np.full(2, 0.5)))
    ends = np.cumsum([len(shares) for _, shares in trials])[:-1]
    tall = np.split(support.upper(np.vstack([normals for normals, _ in trials])), ends)
    bounds = np.full(len(rows), math.inf)
    for (normals, shares), high in zip(trials, tall, strict=True):
        reach = most_along(rows, (shares @ normals) * weights)
        bounds = np.minimum(bounds, np.maximum(shares @ high + reach, high.max()))
    return float(bounds.max())


def most_along(rows: Array, covector: Array) -> Array:
    """Return the greatest v . b over the robots of each piece, sigma_K(v) of (T10).

    Parameters
    ----------
    rows : (k, 10)
        See `Pieces`.
    covector : (3,) [N, N, N/m]
        v, for a unit wrench [1, 1, m].

    Returns
    -------
    (k,) [N]

    Examples
    --------
    Pushing up anywhere along y = 0 from x = 1 to 2: the farther arm has more torque.

    >>> row = np.array([[1.0, 0, 2, 0, 0.5 * np.pi, 0.5 * np.pi, 0, 1, 0, 1]])
    >>> most_along(row, np.array([0.0, 0.0, 1.0])).tolist()
    [2.0]
    """
    best = np.full(len(rows), -math.inf)
    vx, vy, vt = covector
    lo, hi = rows[:, 4], rows[:, 5]
    for x, y in ((rows[:, 0], rows[:, 1]), (rows[:, 2], rows[:, 3])):
        a, b = vx - vt * y, vy + vt * x
        ends = np.maximum(a * rows[:, 6] + b * rows[:, 7], a * rows[:, 8] + b * rows[:, 9])
        crest = np.arctan2(b, a)
        crest += 2.0 * math.pi * np.ceil((lo - crest) / (2.0 * math.pi))
        best = np.maximum(best, np.where(crest <= hi, np.hypot(a, b), ends))
    return best
