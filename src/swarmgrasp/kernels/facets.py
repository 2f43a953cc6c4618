"""Facets of a wrench set and its exact quality (T1, T2).

Loops are written out: slices and array expressions would take seconds more to compile.
All generators are in the metric's coordinates, (n, 3) [N]. The support function is
h(n) = sum_i max(0, n . b_i) = (n . sum_i b_i + sum_i |n . b_i|) / 2, so one pass serves n and -n.
Normals orthogonal to b_j are looked for in an orthonormal basis of the plane across b_j:
an error there turns the normal about b_j and moves the answer by rounding alone, whereas cross
products of nearly parallel generators with a zero threshold miss normals altogether.
"""

import numpy as np
from numba import njit

PARALLEL = 1e-14
"""Sine of the angle below which two generators count as parallel."""

SWEEP_FROM = 48
"""Number of generators from which sorting a plane beats summing it once per normal."""


@njit(cache=True)
def plane_across(axis):
    """Return an orthonormal basis (e, f), each (3,), of the plane across `axis` (3,)."""
    size = np.sqrt(axis[0] ** 2 + axis[1] ** 2 + axis[2] ** 2)
    x, y, z = axis[0] / size, axis[1] / size, axis[2] / size
    e = np.empty(3)
    if abs(x) <= abs(y) and abs(x) <= abs(z):
        e[0], e[1], e[2] = 0.0, -z, y
    elif abs(y) <= abs(z):
        e[0], e[1], e[2] = z, 0.0, -x
    else:
        e[0], e[1], e[2] = -y, x, 0.0
    length = np.sqrt(e[0] ** 2 + e[1] ** 2 + e[2] ** 2)
    e[0] /= length
    e[1] /= length
    e[2] /= length
    f = np.empty(3)
    f[0] = y * e[2] - z * e[1]
    f[1] = z * e[0] - x * e[2]
    f[2] = x * e[1] - y * e[0]
    return e, f


@njit(cache=True)
def plane_heights(generators, axis, first, x, y, key, normals, heights):
    """Find h at the normals orthogonal to `axis` and to one generator each.

    Parameters
    ----------
    generators : (n, 3)
    axis : (3,)
        Not zero.
    first : int
        Generators before this one contribute to h but give no normal of their own.
    x, y, key : (n,)
        Work space, overwritten.
    normals : (2 (n - first), 3)
        Overwritten with the unit normals found.
    heights : (2 (n - first),)
        Overwritten with h at them.

    Returns
    -------
    int
        How many were found; generators parallel to the axis give none.
    """
    n = generators.shape[0]
    e, f = plane_across(axis)
    sum_x = sum_y = 0.0
    for i in range(n):
        b0, b1, b2 = generators[i, 0], generators[i, 1], generators[i, 2]
        x[i] = b0 * e[0] + b1 * e[1] + b2 * e[2]
        y[i] = b0 * f[0] + b1 * f[1] + b2 * f[2]
        sum_x += x[i]
        sum_y += y[i]
        floor = PARALLEL**2 * (b0 * b0 + b1 * b1 + b2 * b2)
        key[i] = 1.0 if x[i] ** 2 + y[i] ** 2 > floor else 0.0
    if n >= SWEEP_FROM:
        return _swept(x, y, key, first, sum_x, sum_y, e, f, normals, heights)
    found = 0
    for k in range(first, n):
        if key[k] == 0.0:
            continue
        size = np.sqrt(x[k] ** 2 + y[k] ** 2)
        u, v = -y[k] / size, x[k] / size
        width = 0.0
        for i in range(n):
            width += abs(u * x[i] + v * y[i])
        found = _record(u, v, width, sum_x, sum_y, e, f, normals, heights, found)
    return found


@njit(cache=True)
def _swept(x, y, key, first, sum_x, sum_y, e, f, normals, heights):
    """Do the same by sorting the plane once: O(n log n) in place of O(n^2) (T11)."""
    n = x.shape[0]
    total_x = total_y = 0.0
    fold = np.empty(n)
    for i in range(n):
        # Flip first, then take the angle: folding an angle modulo pi misorders axis-aligned input.
        fold[i] = 1.0 if y[i] > 0.0 or (y[i] == 0.0 and x[i] > 0.0) else -1.0
        total_x += fold[i] * x[i]
        total_y += fold[i] * y[i]
        reach = abs(x[i]) + abs(y[i])
        if key[i] == 0.0 or reach == 0.0:
            key[i] = 4.0  # sorted last, gives no normal
        else:
            key[i] = -fold[i] * x[i] / reach
    order = np.argsort(key)
    found = 0
    past_x = past_y = 0.0
    for k in order:
        if key[k] == 4.0:
            break
        if k >= first:
            size = np.sqrt(x[k] ** 2 + y[k] ** 2)
            u, v = -fold[k] * y[k] / size, fold[k] * x[k] / size
            width = u * (total_x - 2.0 * past_x) + v * (total_y - 2.0 * past_y)
            found = _record(u, v, width, sum_x, sum_y, e, f, normals, heights, found)
        past_x += fold[k] * x[k]
        past_y += fold[k] * y[k]
    return found


@njit(cache=True)
def _record(u, v, width, sum_x, sum_y, e, f, normals, heights, found):
    """Store the normal u e + v f and its negative; return the new count."""
    skew = u * sum_x + v * sum_y
    for c in range(3):
        normals[found, c] = u * e[c] + v * f[c]
        normals[found + 1, c] = -normals[found, c]
    heights[found] = max(0.0, 0.5 * (width + skew))
    heights[found + 1] = max(0.0, 0.5 * (width - skew))
    return found + 2


@njit(cache=True)
def null_normal(generators):
    """Return a unit normal (3,) orthogonal to all generators, given that they share a line."""
    best = np.zeros(3)
    size = 0.0
    for i in range(generators.shape[0]):
        b = generators[i]
        square = b[0] ** 2 + b[1] ** 2 + b[2] ** 2
        if square > size:
            size = square
            best = b
    if size == 0.0:
        best[0] = 1.0
    return plane_across(best)[0]


@njit(cache=True)
def list_facets(generators, cutoff):
    """List the facet normals n with h(n) < cutoff, both signs, with h.

    Parameters
    ----------
    generators : (n, 3) [N]
    cutoff : float [N]

    Returns
    -------
    normals : (m, 3)
        Unit vectors. A facet with many generators in its plane appears once per pair.
    heights : (m,) [N]
    weakest : (3,)
        The unit normal with the least h of all.
    quality : float [N]
        That least h: the exact quality (T2).
    """
    n = generators.shape[0]
    normals = np.empty((2 * n + 64, 3))
    heights = np.empty(2 * n + 64)
    row_normals = np.empty((2 * n, 3))
    row_heights = np.empty(2 * n)
    x, y, key = np.empty(n), np.empty(n), np.empty(n)
    weakest = np.zeros(3)
    quality = np.inf
    count = 0
    for j in range(n):
        b = generators[j]
        if b[0] == 0.0 and b[1] == 0.0 and b[2] == 0.0:
            continue
        found = plane_heights(generators, b, j + 1, x, y, key, row_normals, row_heights)
        if count + found > heights.shape[0]:
            normals, heights = _grown(normals, heights, 2 * heights.shape[0] + found)
        for k in range(found):
            if row_heights[k] < quality:
                quality = row_heights[k]
                for c in range(3):
                    weakest[c] = row_normals[k, c]
            if row_heights[k] < cutoff:
                for c in range(3):
                    normals[count, c] = row_normals[k, c]
                heights[count] = row_heights[k]
                count += 1
    if quality == np.inf:  # no two generators span a plane: the set is flat
        quality = 0.0
        weakest = null_normal(generators)
        for k in range(2):
            for c in range(3):
                normals[k, c] = weakest[c] if k == 0 else -weakest[c]
            heights[k] = 0.0
        count = 2
    return normals[:count], heights[:count], weakest, quality


@njit(cache=True)
def _grown(normals, heights, capacity):
    """Return copies of both arrays with room for `capacity` rows."""
    more_normals = np.empty((capacity, 3))
    more_heights = np.empty(capacity)
    for k in range(heights.shape[0]):
        more_heights[k] = heights[k]
        for c in range(3):
            more_normals[k, c] = normals[k, c]
    return more_normals, more_heights


@njit(cache=True)
def least_height_across(generators, axis, x, y, key, normals, heights):
    """Find the normal orthogonal to `axis` with the least h.

    Returns its index in `normals`, or -1 when every generator is parallel to the axis.
    The other arguments are those of `plane_heights`.
    """
    found = plane_heights(generators, axis, np.int64(0), x, y, key, normals, heights)
    best = -1
    for k in range(found):
        if best < 0 or heights[k] < heights[best]:
            best = k
    return best
