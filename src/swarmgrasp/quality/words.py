"""A wrench direction in a seaman's words."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

MENTIONED = 0.25
"""Share of a unit direction below which a component goes unmentioned."""


def wrench_words(direction: ArrayLike) -> str:
    """Say which way a wrench acts, the strongest part first.

    Parameters
    ----------
    direction : (3,)
        Surge, sway and yaw in the metric's coordinates: x forward, y to port, yaw
        counter-clockwise. Need not be a unit vector.

    Examples
    --------
    >>> wrench_words([0.0, -1.0, 0.0])
    'sway to starboard'
    >>> wrench_words([-0.5, 0.0, 0.8])
    'yaw to port with surge astern'
    >>> wrench_words([0.0, 0.0, 0.0])
    'no wrench'
    """
    parts: NDArray[np.float64] = np.asarray(direction, dtype=float)
    size = float(np.linalg.norm(parts))
    if size == 0.0:
        return "no wrench"
    names = (
        ("surge ahead", "surge astern"),
        ("sway to port", "sway to starboard"),
        ("yaw to port", "yaw to starboard"),
    )
    order = np.argsort(-np.abs(parts), kind="stable")
    said = [names[i][int(parts[i] < 0.0)] for i in order if abs(parts[i]) >= MENTIONED * size]
    return said[0] + (" with " + " and ".join(said[1:]) if said[1:] else "")
