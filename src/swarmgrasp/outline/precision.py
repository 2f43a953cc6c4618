"""How well an outline is known: to half a unit in the last decimal that it is written with."""

import numpy as np
from numpy.typing import NDArray

FEWEST, MOST = 3, 12
"""Decimals of rounded coordinates: fewer are design values, more those of a computation."""
CURVE = 16
"""Corners from which on an outline is a curve, rounded even if most coordinates have 2 decimals."""
COARSEST = 1e-3
"""Unit in the last decimal, relative to the extent, above which it is the grid of a design."""


def written_precision(corners: NDArray[np.float64]) -> float:
    """Return the rounding that coordinates carry by the decimals they are written with.

    Half a unit in the last decimal that any of them needs, if that is the 3rd to the 12th; of
    a curve, also if most of them need a 2nd. With fewer decimals they are taken for design
    values, with more for the doubles of a computation: both are exact.

    Parameters
    ----------
    corners : (k, 2) [m, m]
        Or in any other unit of length that they were written in.

    Returns
    -------
    float [m]
        In that unit; 0 if they are exact.

    Examples
    --------
    >>> tank = 25.0 * np.exp(2j * np.pi * np.arange(360) / 360).view(float).reshape(-1, 2)
    >>> written_precision(tank.round(6)), written_precision(tank.round(2)), written_precision(tank)
    (5e-07, 0.005, 0.0)
    >>> written_precision(np.array([(0, 0), (40.25, 0), (40.25, 12.75), (3.25, 12.75)]))
    0.0
    """
    extent = float(np.linalg.norm(np.ptp(corners, axis=0)))
    share = 1.0  # of the coordinates that need more decimals
    for decimals in range(MOST + 1):
        unit = 10.0**decimals  # exact, and so a written number comes back as the same double
        is_whole = np.rint(corners * unit) / unit == corners
        if is_whole.all():
            fewest = FEWEST - 1 if len(corners) >= CURVE and share > 0.5 else FEWEST
            is_rounded = decimals >= fewest and 1.0 / unit <= COARSEST * extent
            return 0.5 / unit if is_rounded else 0.0
        share = 1.0 - is_whole.mean()
    return 0.0
