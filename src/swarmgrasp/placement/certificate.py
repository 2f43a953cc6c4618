"""The proof that no allowed robot does better (T10)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Proof:
    """A convex combination of directions that bounds some pieces.

    For unit normals n_k and weights l_k that sum to 1, no robot on a piece K makes the
    quality exceed ``max(sigma_K(sum l_k n_k) + sum l_k h(n_k), max_k h(n_k))``.

    Attributes
    ----------
    normals : (m, 3)
        Directions in the metric's coordinates, at most 4.
    weights : (m,)
        Positive.
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
        The greatest of the pieces' bounds.
    """

    proofs: tuple[Proof, ...]
    upper_bound: float
