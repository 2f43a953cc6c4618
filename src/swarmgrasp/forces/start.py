"""The normal that limits a wrench, by linear programs."""

import numpy as np

from swarmgrasp.forces.answer import Array
from swarmgrasp.linear import Program

Normal = tuple[float, float, float]


def start_for(generators: Array, wrench: Array) -> Normal:
    """Find a normal near that of the face that limits a wrench, or is nearest to it.

    The prices of the wrench in the program for the least largest share are that normal (T18). Of
    a wrench out of reach, those of the program for the least sum of what is missing are near it.

    Parameters
    ----------
    generators : (n, 3) [N]
    wrench : (3,) [N]
        In the metric's coordinates.

    Returns
    -------
    tuple of float
        A unit vector; the wrench's own direction if there is nothing better.

    Examples
    --------
    >>> start_for(np.array([[2.0, 0.0, 0.0], [0.0, 1.0, 0.0]]), np.array([1.0, 0.0, 0.0]))
    (1.0, 0.0, 0.0)
    """
    n, unit = len(generators), max(np.abs(wrench).max(), np.abs(generators).max(initial=0.0))
    B, w = generators.T / unit, wrench / unit
    made = np.column_stack([B, np.zeros(3)])
    below = np.column_stack([np.eye(n), -np.ones(n)])
    largest = Program(
        np.append(np.zeros(n), 1.0),
        np.vstack([made, below]),
        (np.append(w, np.full(n, -np.inf)), np.append(w, np.zeros(n))),
        (0.0, 1.0),
    )
    missing = Program(
        np.append(np.zeros(n), np.ones(6)),
        np.column_stack([B, np.eye(3), -np.eye(3)]),
        (w, w),
        (0.0, np.append(np.ones(n), np.full(6, np.inf))),
    )
    for program in (largest, missing):
        solution = program.solve()
        if solution is not None and solution.prices[:3].any():
            return _unit(solution.prices[:3])
    return _unit(wrench)


def _unit(vector: Array) -> Normal:
    """Return a vector scaled to unit length."""
    x, y, z = (vector / np.linalg.norm(vector) + 0.0).tolist()
    return x, y, z
