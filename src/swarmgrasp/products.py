"""Products of matrices whose sums are taken in the same order on every machine.

NumPy's own go to a library that orders them by the processor and its threads. The last digit then
differs, and with it which of two equals a search looks at first.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def dots(rows: Array, others: Array) -> Array:
    """Return the scalar products (m, n) of rows (m, k) with other rows (n, k).

    One pass over the result for each of k: meant for few columns.

    Examples
    --------
    >>> dots(np.array([[1.0, 2.0]]), np.array([[3.0, 4.0], [0.0, 1.0]])).tolist()
    [[11.0, 2.0]]
    """
    found = np.zeros((len(rows), len(others)))
    for left, right in zip(rows.T, others.T, strict=True):
        found += np.multiply.outer(left, right)
    return found


def weighted(weights: Array, rows: Array) -> Array:
    """Return the sum of rows (m, ...) times their weights (m,).

    Examples
    --------
    >>> weighted(np.array([1.0, 2.0]), np.array([[3.0, 4.0], [0.0, 1.0]])).tolist()
    [3.0, 6.0]
    """
    return np.asarray((rows.T * weights).T.sum(axis=0))
