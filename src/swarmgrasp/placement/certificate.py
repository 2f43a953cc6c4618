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


def certificate_of(
    bounds: NDArray[np.float64],
    rows: NDArray[np.float64],
    shares: NDArray[np.float64],
    pool: NDArray[np.float64],
    weights: NDArray[np.float64],
) -> Certificate:
    """Gather the search's proofs, each distinct one once.

    Parameters
    ----------
    bounds, rows, shares, pool
        As given by `kernels.place.solve`.
    weights : (3,)
        That turned its normals into covectors.
    """
    proofs = {}
    for row, share in zip(rows, shares, strict=True):
        used = share > 0.0
        key = (tuple(row[used]), tuple(share[used]))
        if key not in proofs:
            normals = pool[row[used].astype(int), :3] / weights
            normals /= np.linalg.norm(normals, axis=1)[:, None]
            proofs[key] = Proof(normals, share[used])
    return Certificate(tuple(proofs.values()), float(bounds.max()))
