"""Generators given as arrays: their type, their shape, and the range of their sizes."""

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import WrenchInvalid
from swarmgrasp.ranges import array_of, shown
from swarmgrasp.swarm.columns import MOST_LISTED

SMALLEST, LARGEST = 1e-120, 1e120
"""Range of a generator's largest component [N] whose squares are still numbers."""


def checked_generators(
    generators: ArrayLike, shape: Literal["(n, 3)", "(m, n, 3)"]
) -> NDArray[np.float64]:
    """Return generators as an array of the right shape, in range; what is empty as it comes.

    Parameters
    ----------
    generators : (n, 3) or (m, n, 3) [N, N, N]
        In the metric's coordinates; of m swarms, if there are three axes.
    shape : {"(n, 3)", "(m, n, 3)"}
        Which of them.

    Raises
    ------
    WrenchInvalid
        If they are no numbers, or no array of that shape, or the largest component of one is
        neither zero nor within 1e-120 to 1e120 N; the first ten at fault are shown.

    Examples
    --------
    >>> checked_generators([[(0, 0, 1), (0, 1e-200, 0)]], "(m, n, 3)")
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.WrenchInvalid: generator 1 of swarm 0 is [0.0, 1e-200, 0.0]; its ...
    """
    rows = array_of(generators)
    if rows is None:
        raise WrenchInvalid(
            f"the generators are {shown(generators)}; they should be real numbers {shape} [N]"
        )
    if rows.size and (rows.ndim != shape.count(",") + 1 or rows.shape[-1] != 3):
        raise WrenchInvalid(f"the generators have the shape {rows.shape}; it should be {shape} [N]")
    if rows.size:
        _check_sizes(rows)
    return rows


def _check_sizes(rows: NDArray[np.float64]) -> None:
    """Raise `WrenchInvalid` for generators (..., 3) out of range."""
    largest = np.maximum.reduce(np.abs(np.moveaxis(rows, -1, 0)))
    good = (largest == 0.0) | ((largest >= SMALLEST) & (largest <= LARGEST))
    if good.all():
        return
    wrong = np.argwhere(~good)
    faults = []
    for *swarm, i in wrong[:MOST_LISTED].tolist():
        of = f" of swarm {swarm[0]}" if swarm else ""
        faults.append(
            f"generator {i}{of} is {rows[(*swarm, i)].tolist()}; its largest component should be "
            f"0 or {SMALLEST:g} <= size <= {LARGEST:g} [N]"
        )
    left = len(wrong) - MOST_LISTED
    raise WrenchInvalid(faults + ([f"... and {left} more"] if left > 0 else []))
