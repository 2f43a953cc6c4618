"""Bins of directions: a grid on three faces of a cube, a direction and its opposite in one.

The face of a vector b is the axis of its largest component, and b is turned to point along it:
b = +-w (1, u, v) with the weight w > 0 and the position -1 <= u, v <= 1, components in cyclic order
from that axis. Each face is cut into side x side cells at u, v = tan(pi/4 s), s in equal steps:
equal angles, so that the largest cell is 1.4 times the smallest as seen from the origin. The side
is even: no cell reaches across a plane of two axes, and what a swarm can do along an axis is
known exactly. In a cell n . b is w times a function that is *linear* in (u, v), whatever n is:
that is what makes bounds on a whole bin sharp.
"""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import SummaryInvalid
from swarmgrasp.ranges import is_whole, shown

CYCLES = np.array([(0, 1, 2), (1, 2, 0), (2, 0, 1)])
"""Component along the axis, that of u and that of v, for each face."""
LEAST_BINS, MOST_SIDE = 12, 1024
"""Fewest bins, and most cells along a face's edge: 3 145 728 bins."""

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


def side_of(bins: int) -> int:
    """Return the even number of cells along a face's edge for at most so many bins.

    Raises
    ------
    SummaryInvalid
        If there are fewer bins than the least side takes, or more than `MOST_SIDE` allows.

    Examples
    --------
    >>> side = side_of(1024)
    >>> side, 3 * side**2
    (18, 972)
    """
    most = 3 * MOST_SIDE**2
    if not is_whole(bins) or not LEAST_BINS <= bins <= most:
        raise SummaryInvalid(
            f"the number of bins is {shown(bins)}; it should be a whole number, "
            f"{LEAST_BINS} <= bins <= {most}"
        )
    return 2 * math.isqrt(int(bins) // 12)


def edges(side: int) -> Array:
    """Return where the cells of a face begin and end, (side + 1,)."""
    ends = np.tan(0.25 * math.pi * np.linspace(-1.0, 1.0, side + 1))
    ends[0], ends[-1] = -1.0, 1.0
    return ends


def locate(vectors: Array, side: int) -> tuple[Indices, Array, Array]:
    """Find the cell, the weight and the position of each vector.

    Parameters
    ----------
    vectors : (n, 3) [N]
        None of them zero.
    side : int

    Returns
    -------
    cells : (n,)
        Within [0, 3 side^2): face by face, row by row.
    weights : (n,) [N]
        The largest component in size.
    positions : (2, n)
        The others, u and v, divided by it.

    Examples
    --------
    >>> cells, weights, positions = locate(np.array([[1.0, -2.0, 0.5], [-1.0, 2.0, -0.5]]), 2)
    >>> cells.tolist(), weights.tolist(), positions.tolist()
    ([4, 4], [2.0, 2.0], [[-0.25, -0.25], [-0.5, -0.5]])
    """
    x, y, z = np.ascontiguousarray(vectors.T)
    sizes = np.abs(vectors.T)
    on_x = (sizes[0] >= sizes[1]) & (sizes[0] >= sizes[2])
    on_y = ~on_x & (sizes[1] >= sizes[2])
    axial = np.where(on_x, x, np.where(on_y, y, z))
    positions = np.empty((2, len(vectors)))
    np.divide(np.where(on_x, y, np.where(on_y, z, x)), axial, out=positions[0])
    np.divide(np.where(on_x, z, np.where(on_y, x, y)), axial, out=positions[1])
    steps = np.arctan(positions)
    steps *= 2.0 * side / math.pi
    steps += 0.5 * side
    rows, columns = np.clip(steps.astype(np.int64), 0, side - 1)
    faces = np.where(on_x, 0, np.where(on_y, 1, 2))
    return (faces * side + rows) * side + columns, np.abs(axial), positions


def middles_and_halves(cells: Indices, side: int) -> tuple[Array, Array]:
    """Return the middle and half the width of cells in u and v, (2, g) each."""
    ends = edges(side)
    places = np.array([cells // side % side, cells % side])
    low, high = ends[places], ends[places + 1]
    return 0.5 * (low + high), 0.5 * (high - low)


def vectors_of(cells: Indices, side: int, axial: Array, positions: Array) -> Array:
    """Return vectors (g, 3) with a component (g,) along their face's axis, and (2, g) across."""
    vectors = np.empty((len(cells), 3))
    cycles = CYCLES[cells // side**2]
    rows = np.arange(len(cells))
    for k, part in enumerate((axial, *positions)):
        vectors[rows, cycles[:, k]] = part
    return vectors
