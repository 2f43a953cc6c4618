"""Placement by bisection on the level, with arcs of directions (T9) and their proofs (T10).

A new robot b = (cos a, sin a, tau) [1, 1, m] at full force raises h(n) by max(0, m . b), where m
is the covector of the normal n. It reaches level t when m . b >= t - h(n) for every normal with
h(n) < t. For one direction a, every such demand bounds the torque from one side.

The pool holds what is known of the base swarm, its facets and the normals met on the way, in rows
(m_x, m_y, m_t, h, 1/|m_t|); a normal that says nothing of the torque has m_t = 0 and a 1 in the
last place. Rows 0 and 1 stand for the piece at hand, tau >= p x F and tau <= q x F.
An arc is a row (v_x, v_y, need, i, j): only directions with v . F >= need can reach the level,
because the demands of pool rows i and j clash elsewhere.
A proof is four pool rows and the weights of a convex combination of their normals.
"""

import math

import numpy as np
from numba import njit, types

from swarmgrasp.kernels.facets import inner, plane_heights
from swarmgrasp.kernels.sector import best_on_piece

SOLVED, REACHED, REFUTED, OUT_OF_ROOM = 0, 1, 2, 3
PIECE_ROWS = 2
"""Pool rows kept for the limits of the piece at hand."""
TORQUE_FREE = 1e-13
"""Torque part of a normal, relative to its force part, that counts as none."""
ARC_END = 1e-14
"""Width [rad] at which an interval of directions counts as empty."""
PROBE = 0.1
"""Where between the best robot and its bound a rival piece is probed: low, to refute it at once."""
HALVINGS = 48
"""Steps of the search for the best mixture of two arcs."""
TILTS = 8
"""Steps of the search for the deepest cut."""


@inner
def torque_bounds(pool, count, level, c, s):
    """Find the tightest bounds on the torque [m] that a level demands of a direction (c, s).

    Returns
    -------
    lower, upper : float [m]
    i, j : int
        The pool rows that demand them; twice the same if its demand on the direction alone
        fails, and then lower > upper.
    """
    lower, upper = -np.inf, np.inf
    i = j = barred = 0
    worst = 0.0
    for k in range(count):
        need = level - pool[k, 3]
        if need < 0.0:
            continue
        need = (need - pool[k, 0] * c - pool[k, 1] * s) * pool[k, 4]
        if pool[k, 2] > 0.0:
            if need > lower:
                lower, i = need, k
        elif pool[k, 2] < 0.0:
            if -need < upper:
                upper, j = -need, k
        elif need > worst:
            worst, barred = need, k
    if barred > 0:
        return 1.0, 0.0, barred, barred
    return lower, upper, i, j


@inner
def narrow(arc, lo, middle, hi):
    """Return the part of the directions [lo, hi] that an arc allows; empty if lo > hi.

    The arc misses `middle`; where rounding says otherwise, that side of it is kept on which
    the arc lies.
    """
    size = math.sqrt(arc[0] * arc[0] + arc[1] * arc[1])
    if arc[2] > size or size == 0.0:
        return 1.0, 0.0
    half = math.acos(max(arc[2], 0.0) / size)
    crest = math.atan2(arc[1], arc[0])
    while crest < middle - math.pi:
        crest += 2.0 * math.pi
    while crest > middle + math.pi:
        crest -= 2.0 * math.pi
    if crest > middle:
        lo = middle
    else:
        hi = middle
    return max(lo, crest - half), min(hi, crest + half)


@inner
def prove(pool, piece, one, two, rows, shares):
    """Find the mixture of two arcs with the least bound on the piece (T10).

    Each arc is the mean of its normals that cancels the torque. The bound sigma_K(v) + h is
    convex in the share mu of the second arc; the sign of its slope is bisected. Two arcs may be
    the same. Writes the proof, rows and shares (4,) each, and returns its bound [N].
    """
    means = np.zeros((2, 4))
    v = np.empty(4)
    for a in range(2):
        arc = one if a == 0 else two
        total = 0.0
        for k in range(2 * a, 2 * a + 2):
            rows[k] = arc[3 + k - 2 * a]
            shares[k] = pool[int(rows[k]), 4] if rows[k] >= PIECE_ROWS else 0.0
            total += shares[k]
        for k in range(2 * a, 2 * a + 2):
            shares[k] /= total
            for c in range(4):
                means[a, c] += shares[k] * pool[int(rows[k]), c]
    bound, best = np.inf, 0.0
    lo, mu, hi = 0.0, 0.0, 1.0
    for step in range(HALVINGS):
        for c in range(4):
            v[c] = means[0, c] + mu * (means[1, c] - means[0, c])
        value, c, s, torque = best_on_piece(piece, v)
        if value + v[3] < bound:
            bound, best = value + v[3], mu
        slope = means[1, 3] - means[0, 3] + (means[1, 0] - means[0, 0]) * c
        slope += (means[1, 1] - means[0, 1]) * s + (means[1, 2] - means[0, 2]) * torque
        if slope > 0.0:
            hi = mu
        else:
            lo = mu
        mu = 1.0 if step == 0 else 0.5 * (lo + hi)
    for k in range(4):
        shares[k] *= best if k > 1 else 1.0 - best
    return bound


@inner
def refute(pool, piece, arc, lo_arc, hi_arc, rows, shares):
    """Write the best proof from the arc that emptied the interval and those at its ends."""
    trial_rows, trial_shares = np.empty(4), np.empty(4)
    bound = np.inf
    for k in range(3):
        other = arc if k == 0 else lo_arc if k == 1 else hi_arc
        trial = prove(pool, piece, arc, other, trial_rows, trial_shares)
        if trial < bound:
            bound = trial
            for c in range(4):
                rows[c], shares[c] = trial_rows[c], trial_shares[c]


@inner
def quality_with(generators, pool, count, weights, c, s, torque, work):
    """Compute the exact quality with a new robot, and what is weakest across its own wrench.

    Returns
    -------
    quality : float [N]
    across : float [N]
        The least h at normals orthogonal to the new robot, inf if there is none.
    index : int
        The row of `work` that attains it, -1 if there is none.
    """
    flat, order, normals, heights, axis = work
    axis[0], axis[1], axis[2] = c * weights[0], s * weights[1], torque * weights[2]
    found = plane_heights(generators, axis, np.int64(0), flat, order, normals, heights)
    across, index = np.inf, -1
    for k in range(found):
        if heights[k] < across:
            across, index = heights[k], k
    quality = across
    for k in range(PIECE_ROWS, count):
        gain = pool[k, 0] * c + pool[k, 1] * s + pool[k, 2] * torque
        quality = min(quality, pool[k, 3] + max(0.0, gain))
    return quality, across, index


@inner
def store_normal(row, normal, height, weights):
    """Write a pool row; `weights` (3,) [N, N, N/m] turn a normal into a covector."""
    free = abs(normal[2]) <= TORQUE_FREE * (abs(normal[0]) + abs(normal[1]))
    row[0], row[1] = normal[0] * weights[0], normal[1] * weights[1]
    row[2] = 0.0 if free else normal[2] * weights[2]
    row[3] = height
    row[4] = 1.0 if free else 1.0 / abs(row[2])


@inner
def tilt(generators, normal, height, level, axis):
    """Turn a normal that a robot fails away from the robot's wrench, for a deeper cut.

    At cos(phi) n - sin(phi) b/|b| the robot misses the demand t - h of the level t by sin(phi) |b|
    more; phi grows in halving steps while that is a gain. Without it a robot much stronger than
    the others would be cut off a sliver at a time. Modifies `normal` (3,); returns h at it.
    """
    size = math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2])
    phi, miss, best = 0.5 * math.pi, level - height, 0.0
    for _ in range(TILTS):
        phi *= 0.5
        c, s = math.cos(best + phi), math.sin(best + phi) / size
        x, y = c * normal[0] - s * axis[0], c * normal[1] - s * axis[1]
        z = c * normal[2] - s * axis[2]
        h = 0.0
        for i in range(generators.shape[0]):
            h += max(0.0, x * generators[i, 0] + y * generators[i, 1] + z * generators[i, 2])
        if h < level and level - h + s * size * size > miss:
            miss, height, best = level - h + s * size * size, h, best + phi
    c, s = math.cos(best), math.sin(best) / size
    for k in range(3):
        normal[k] = c * normal[k] - s * axis[k]
    return height


@inner
def reach(generators, pool, count, weights, level, slack, piece, work, best, rows, shares):
    """Decide whether a piece has a robot that reaches a level (T9).

    Parameters
    ----------
    slack : float [N]
        Rounding by which a level may be missed.
    best : (4,)
        Best quality so far and its (c, s, torque); modified in place when bettered.
    rows, shares : (4,), (4,)
        Overwritten with the proof when the level is refuted.

    Returns
    -------
    status : int
        REACHED, REFUTED or OUT_OF_ROOM.
    count : int
        Pool rows now.
    """
    arcs = np.zeros((3, 5))  # the last one, and those that set lo and hi
    for k in range(PIECE_ROWS):
        sign = 1.0 - 2.0 * k
        pool[k, 0], pool[k, 1], pool[k, 2] = sign * piece[2 * k + 1], -sign * piece[2 * k], sign
        pool[k, 3], pool[k, 4] = level, 1.0
    lo, hi = piece[4], piece[5]
    is_lo_set = is_hi_set = False
    while True:
        middle = 0.5 * (lo + hi)
        c, s = math.cos(middle), math.sin(middle)
        lower, upper, i, j = torque_bounds(pool, count, level, c, s)
        if lower <= upper or (i < PIECE_ROWS and j < PIECE_ROWS):
            torque = 0.5 * (lower + upper)
            quality, across, index = quality_with(
                generators, pool, count, weights, c, s, torque, work
            )
            if quality > best[0]:
                best[0], best[1], best[2], best[3] = quality, c, s, torque
            if across >= level - slack:
                return REACHED, count
            if count == pool.shape[0]:
                return OUT_OF_ROOM, count
            height = tilt(generators, work[2][index], across, level, work[4])
            store_normal(pool[count], work[2][index], height, weights)
            count += 1
            continue
        arc = arcs[0]
        for k in range(2):
            arc[k] = pool[i, k] * pool[i, 4] + pool[j, k] * pool[j, 4]
        arc[2] = (level - pool[i, 3]) * pool[i, 4] + (level - pool[j, 3]) * pool[j, 4]
        arc[3], arc[4] = i, j
        new_lo, new_hi = narrow(arc, lo, middle, hi)
        if new_hi - new_lo <= ARC_END:
            lo_arc = arcs[1] if is_lo_set else arc
            hi_arc = arcs[2] if is_hi_set else arc
            refute(pool, piece, arc, lo_arc, hi_arc, rows, shares)
            return REFUTED, count
        is_lo_set, is_hi_set = is_lo_set or new_lo > lo, is_hi_set or new_hi < hi
        for k in range(5):
            if new_lo > lo:
                arcs[1, k] = arc[k]
            if new_hi < hi:
                arcs[2, k] = arc[k]
        lo, hi = new_lo, new_hi


@inner
def share_proof(pool, pieces, proof_rows, proof_shares, bounds, rows, shares):
    """Try one proof on every piece; modifies bounds, rows and shares where it is better."""
    mean = np.zeros(4)
    highest = 0.0
    for k in range(4):
        if proof_shares[k] > 0.0:
            row = int(proof_rows[k])
            highest = max(highest, pool[row, 3])
            for c in range(4):
                mean[c] += proof_shares[k] * pool[row, c]
    for k in range(pieces.shape[0]):
        if bounds[k] > highest:
            bound = max(highest, best_on_piece(pieces[k], mean)[0] + mean[3])
            if bound < bounds[k]:
                bounds[k] = bound
                for c in range(4):
                    rows[k, c], shares[k, c] = proof_rows[c], proof_shares[c]


@inner
def work_space(n):
    """Return the arrays that `quality_with` needs for n generators."""
    order = np.empty(n, dtype=np.int64)
    return np.empty((4, n)), order, np.empty((2 * n, 3)), np.empty(2 * n), np.empty(3)


@njit(cache=True)
def solve(generators, pool, count, weights, pieces, first, best, gap, floor, slack):
    """Find the globally best robot over all pieces, with a proof per piece.

    Parameters
    ----------
    generators : (n, 3) [N]
    pool : (m, 5)
        Its rows from PIECE_ROWS to `count` hold all facets of the base swarm with h below any
        quality that can be reached; more are added in place.
    count : int
    weights : (3,) [N, N, N/m]
        Turn a unit wrench [1, 1, m] of the newcomer into the metric's coordinates.
    pieces : (k, 10)
    first : (f, 2, 4)
        Rows and shares of proofs to begin with.
    best : (5,)
        The base swarm's quality, three zeros, and -1; overwritten with the quality and
        (c, s, torque) of the best robot, and its piece (-1 if none betters the base).
    gap, floor : float, float [N]
        Stop when bound - best <= max(gap * best, floor).
    slack : float [N]
        Rounding by which a level may be missed.

    Returns
    -------
    status : int
        SOLVED or OUT_OF_ROOM; bounds hold in either case.
    count : int
        Pool rows now.
    bounds : (k,) [N]
    rows, shares : (k, 4), (k, 4)
        The proof of each bound: pool rows, and weights that sum to 1.
    """
    many = pieces.shape[0]
    work = work_space(generators.shape[0])
    bounds, settled = np.empty(many), np.zeros(many)
    rows, shares = np.zeros((many, 4)), np.zeros((many, 4))
    trial_rows, trial_shares = np.empty(4), np.empty(4)
    for k in range(many):
        bounds[k] = np.inf
    for k in range(first.shape[0]):
        share_proof(pool, pieces, first[k, 0], first[k, 1], bounds, rows, shares)
    while True:
        k = -1
        for j in range(many):
            is_next = k < 0 or bounds[j] > bounds[k] or (bounds[j] == bounds[k] and j == best[4])
            if is_next and settled[j] == 0.0:
                k = j
        if k < 0 or bounds[k] - best[0] <= max(gap * best[0], floor):
            return SOLVED, count, bounds, rows, shares
        share = PROBE if best[4] >= 0.0 and best[4] != k else 0.5
        before, high = best[0], bounds[k]
        level = before + share * (high - before)
        outcome, count = reach(
            generators, pool, count, weights, level, slack, pieces[k], work,
            best, trial_rows, trial_shares,
        )  # fmt: skip
        if best[0] > before:
            best[4] = k
        if outcome == OUT_OF_ROOM:
            return OUT_OF_ROOM, count, bounds, rows, shares
        if outcome == REFUTED:
            share_proof(pool, pieces, trial_rows, trial_shares, bounds, rows, shares)
            if bounds[k] - level > 0.5 * (high - level):
                settled[k] = 1.0  # rounding alone holds the bound up
        elif best[0] - before < 0.5 * (level - before):
            settled[k] = 1.0  # reached by rounding alone


@njit(cache=True)
def qualities_with(generators, pool, count, weights, robots):
    """Compute the exact quality with each of many new robots, one at a time.

    Parameters
    ----------
    generators, pool, count, weights
        As for `solve`.
    robots : (r, 3) [1, 1, m]
        Unit wrenches (c, s, torque).

    Returns
    -------
    (r,) [N]
    """
    work = work_space(generators.shape[0])
    qualities = np.empty(robots.shape[0])
    for k in range(robots.shape[0]):
        c, s, torque = robots[k, 0], robots[k, 1], robots[k, 2]
        qualities[k] = quality_with(generators, pool, count, weights, c, s, torque, work)[0]
    return qualities


def compile_ahead() -> None:
    """Compile `solve` for the types it is called with, so that another process finds it cached."""
    row, table = types.float64[::1], types.float64[:, ::1]
    number, count = types.float64, types.int64
    cube = types.float64[:, :, ::1]
    solve.compile((table, table, count, row, table, cube, row, number, number, number))
