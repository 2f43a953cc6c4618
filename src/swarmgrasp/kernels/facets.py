"""Facets of a wrench set and its exact quality (T1, T2, T11).

All generators are in the metric's coordinates, (n, 3) [N]. In the plane across b_j the others are
vectors in two dimensions; sorted by angle, h at the normal to each follows from running sums.
Looking in an orthonormal basis of that plane matters: an error there turns the normal about b_j
and moves the answer by rounding alone, whereas cross products of nearly parallel generators with
a zero threshold miss normals altogether.

Kernels are written in plain loops: Numba compiles slices and array expressions, and NumPy's
argsort, ten times more slowly.
"""

import math

import numpy as np
from numba import njit, types

PARALLEL = 1e-14
"""Sine of the angle below which two generators count as parallel."""

inner = njit(no_cpython_wrapper=True, no_cfunc_wrapper=True)  # type: ignore[call-overload]
"""Decorator of kernels that only other kernels call (Numba's type stubs miss both options)."""


@inner
def sort_order(key, order):
    """Write the indices (n,) that sort `key` (n,) to `order`, by Shell's method."""
    n = key.shape[0]
    gap = 1
    while 9 * gap < 4 * n:
        gap = (9 * gap + 4) // 4
    for i in range(n):
        order[i] = i
    while gap > 0:
        for i in range(gap, n):
            moved = order[i]
            j = i
            while j >= gap and key[order[j - gap]] > key[moved]:
                order[j] = order[j - gap]
                j -= gap
            order[j] = moved
        gap = max(1, 4 * gap // 9) if gap > 1 else 0


@inner
def plane_heights(generators, axis, first, flat, order, normals, heights):
    """Find h at the normals orthogonal to `axis` and to one generator each.

    Parameters
    ----------
    generators : (n, 3)
    axis : (3,)
        Not zero.
    first : int
        Generators before this one contribute to h but give no normal of their own.
    flat, order : (4, n), (n,)
        Work space, overwritten.
    normals, heights : (2 n, 3), (2 n,)
        Overwritten with the unit normals found, each followed by its negative, and with h.

    Returns
    -------
    int
        How many were found; generators parallel to the axis give none.
    """
    n = generators.shape[0]
    # an orthonormal basis (e, f) of the plane, without branches (Duff et al. 2017)
    size = math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2])
    x, y, z = axis[0] / size, axis[1] / size, axis[2] / size
    sign = math.copysign(1.0, z)
    a = -1.0 / (sign + z)
    b = x * y * a
    e = (1.0 + sign * x * x * a, sign * b, -sign * x)
    f = (b, sign + y * y * a, -y)
    sum_u = sum_v = fold_u = fold_v = 0.0
    for i in range(n):
        g = generators[i]
        u = g[0] * e[0] + g[1] * e[1] + g[2] * e[2]
        v = g[0] * f[0] + g[1] * f[1] + g[2] * f[2]
        sum_u += u
        sum_v += v
        # Flip first, then take the angle: folding an angle modulo pi misorders axis-aligned input.
        if v < 0.0 or (v == 0.0 and u < 0.0):
            u, v = -u, -v
        fold_u += u
        fold_v += v
        flat[0, i], flat[1, i] = u, v
        flat[2, i] = math.sqrt(u * u + v * v)
        parallel = flat[2, i] <= PARALLEL * (abs(g[0]) + abs(g[1]) + abs(g[2]))
        flat[3, i] = 4.0 if parallel else -u / (u + v if u >= 0.0 else v - u)
    sort_order(flat[3], order)
    found = 0
    for k in order:
        u, v, length = flat[0, k], flat[1, k], flat[2, k]
        if flat[3, k] == 4.0:
            break  # sorted last
        if k >= first:
            width = (u * fold_v - v * fold_u) / length
            skew = (u * sum_v - v * sum_u) / length
            for c in range(3):
                normals[found, c] = (u * f[c] - v * e[c]) / length
                normals[found + 1, c] = -normals[found, c]
            heights[found] = max(0.0, 0.5 * (width + skew))
            heights[found + 1] = max(0.0, 0.5 * (width - skew))
            found += 2
        fold_u -= 2.0 * u
        fold_v -= 2.0 * v
    return found


@njit(cache=True)
def list_facets(generators, cutoff, normals, heights):
    """List the facet normals n with h(n) < cutoff, both signs, with h.

    Parameters
    ----------
    generators : (n, 3) [N]
    cutoff : float [N]
    normals, heights : (m, 3), (m,)
        Overwritten with the first m facets: unit vectors, and h [N]. A facet with many
        generators in its plane appears once per pair.

    Returns
    -------
    count : int
        How many facets there are below the cutoff, which may be more than m.
    quality : float [N]
        The least h of all: the exact quality (T2); inf if no two generators span a plane.
    weakest : (3,)
        The unit normal that attains it.
    """
    n = generators.shape[0]
    row_normals, row_heights = np.empty((2 * n, 3)), np.empty(2 * n)
    flat, order = np.empty((4, n)), np.empty(n, dtype=np.int64)
    weakest = np.zeros(3)
    quality = np.inf
    count = 0
    for j in range(n):
        b = generators[j]
        if b[0] == 0.0 and b[1] == 0.0 and b[2] == 0.0:
            continue
        found = plane_heights(generators, b, j + 1, flat, order, row_normals, row_heights)
        for k in range(found):
            height = row_heights[k]
            if height < quality:
                quality = height
                for c in range(3):
                    weakest[c] = row_normals[k, c]
            if height < cutoff:
                if count < heights.shape[0]:
                    heights[count] = height
                    for c in range(3):
                        normals[count, c] = row_normals[k, c]
                count += 1
    return count, quality, weakest


def compile_ahead() -> None:
    """Compile `list_facets` for the types it is called with."""
    row, table = types.float64[::1], types.float64[:, ::1]
    list_facets.compile((table, types.float64, table, row))
