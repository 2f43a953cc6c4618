"""The proof that no allowed robot does better (T10)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Plain


@dataclass(frozen=True, eq=False)
class Proof(Frozen, Plain):
    """A convex combination of directions that bounds some pieces.

    For unit normals n_k and weights l_k that sum to 1, no robot on a piece K makes the
    quality exceed ``max(sigma_K(sum l_k n_k) + sum l_k h(n_k), max_k h(n_k))``.

    By a criterion, H stands for h, both are divided by the task's D, and nothing exceeds the
    least C(n_k) / D(n_k), where C is H before the last loss (T14, T15, T16):
    ``min(max((sigma_K(sum l_k n_k) + sum l_k H(n_k)) / sum l_k D(n_k), max_k H(n_k) / D(n_k)),
    min_k C(n_k) / D(n_k))``.

    Attributes
    ----------
    normals : (m, 3)
        Directions in the metric's coordinates, at most 4.
    weights : (m,)
        Positive; of any sum.
    """

    normals: NDArray[np.float64]
    weights: NDArray[np.float64]


@dataclass(frozen=True)
class Certificate:
    """Proofs that together bound every piece.

    Attributes
    ----------
    proofs : tuple of Proof
        Each piece is bounded by at least one of them.
    upper_bound : float [N]
        The greatest of the pieces' bounds; without a unit for a task.
    """

    proofs: tuple[Proof, ...]
    upper_bound: float
