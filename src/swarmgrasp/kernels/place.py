"""Placement by bisection on the level, with arcs of directions (T9) and their proofs (T10).

A new robot b = (cos a, sin a, tau) [1, 1, m] at full force raises h(n) by max(0, m . b), where m
is the covector of the normal n. It reaches level t when m . b >= t - h(n) for every normal with
h(n) < t. For one direction a, every such demand bounds the torque from one side.

The pool holds what is known of the base swarm, its facets and the normals met on the way, in rows
(m_x, m_y, m_t, h, 1/|m_t|); the last entry is 0 where a normal says nothing of the torque.
An arc is a row (v_x, v_y, need, i, j): only directions with v . F >= need can reach the level,
because of pool rows i and j (-1: none, the piece's own limit on the torque took part).
A proof is the pool rows and weights of a convex combination of normals, (4,) each.
"""

import numpy as np
from numba import njit

from swarmgrasp.kernels.facets import least_height_across
from swarmgrasp.kernels.sector import best_on_piece, into, torque_arm

SOLVED = 0
REACHED, REFUTED, OUT_OF_ROOM = 0, 1, 2
TORQUE_FREE = 1e-13
"""Torque part of a covector, relative to its force part, that counts as none."""
ROUNDING = 1e-14
"""A level missed by less than this share of sum |b_i| counts as reached."""
ARC_END = 1e-14
"""Width [rad] at which an interval of directions counts as empty."""
OPPOSITE = -1.0 + 1e-12
"""Cosine below which two normals count as opposite."""
PROBE = 0.1
"""Where between the best robot and its bound a rival piece is probed: low, to refute it at once."""


@njit(cache=True)
def store_normal(row, normal, height, weights):
    """Write one pool row; `weights` (3,) [N, N, N m or scaled] turn a normal into a covector."""
    row[0] = normal[0] * weights[0]
    row[1] = normal[1] * weights[1]
    row[2] = normal[2] * weights[2]
    row[3] = height
    torque = abs(row[2])
    free = TORQUE_FREE * (abs(normal[0]) + abs(normal[1])) >= abs(normal[2])
    row[4] = 0.0 if free else 1.0 / torque


@njit(cache=True)
def torque_bounds(pool, count, level, piece, c, s):
    """Find the tightest bounds on the torque [m] that a level demands of a direction (c, s).

    Returns
    -------
    lower, upper : float [m]
    i, j : int
        The pool rows that demand them, -1 for the piece itself.
    barred : int
        A row whose demand on the direction alone fails, or -1.
    """
    lower = torque_arm(piece[0], piece[1], c, s)
    upper = torque_arm(piece[2], piece[3], c, s)
    i = j = barred = -1
    worst = 0.0
    for k in range(count):
        need = level - pool[k, 3]
        if need <= 0.0:
            continue
        need -= pool[k, 0] * c + pool[k, 1] * s
        if pool[k, 4] == 0.0:
            if need > worst:
                worst, barred = need, k
        elif pool[k, 2] > 0.0:
            if need * pool[k, 4] > lower:
                lower, i = need * pool[k, 4], k
        elif -need * pool[k, 4] < upper:
            upper, j = -need * pool[k, 4], k
    return lower, upper, i, j, barred


@njit(cache=True)
def clash(pool, level, piece, i, j, arc):
    """Add a demand from below (row i) and one from above (row j) so that the torque cancels.

    Writes the arc; -1 stands for the piece's own limits, tau >= p x F and tau <= q x F.
    """
    arc[0] = piece[1] if i < 0 else pool[i, 0] * pool[i, 4]
    arc[1] = -piece[0] if i < 0 else pool[i, 1] * pool[i, 4]
    arc[2] = 0.0 if i < 0 else (level - pool[i, 3]) * pool[i, 4]
    arc[0] += -piece[3] if j < 0 else pool[j, 0] * pool[j, 4]
    arc[1] += piece[2] if j < 0 else pool[j, 1] * pool[j, 4]
    arc[2] += 0.0 if j < 0 else (level - pool[j, 3]) * pool[j, 4]
    arc[3], arc[4] = i, j


@njit(cache=True)
def average(pool, arc, mean):
    """Write the mean (m_x, m_y, m_t, h) of an arc's normals; return their two shares."""
    i, j = int(arc[3]), int(arc[4])
    share = 1.0 if i >= 0 else 0.0
    if i >= 0 and j >= 0:  # so that the torque cancels
        share = pool[i, 4] / (pool[i, 4] + pool[j, 4])
    for c in range(4):
        mean[c] = 0.0
        if i >= 0:
            mean[c] += share * pool[i, c]
        if j >= 0:
            mean[c] += (1.0 - share) * pool[j, c]
    return share, 1.0 - share


@njit(cache=True)
def prove(pool, piece, one, two, rows, shares):
    """Find the combination of two arcs with the least bound on the piece (T10).

    The bound sigma_K(v) + h is convex in the share mu of the second arc; the sign of its slope
    is bisected. Two arcs may be the same. Writes the proof, rows and shares (4,) each, and
    returns its bound [N].
    """
    mean_one, mean_two, step, v = np.empty(4), np.empty(4), np.empty(4), np.empty(4)
    i_one, j_one = average(pool, one, mean_one)
    i_two, j_two = average(pool, two, mean_two)
    bound = best_on_piece(piece, mean_one)[0] + mean_one[3]
    share = 0.0
    if one[3] != two[3] or one[4] != two[4]:
        for c in range(4):
            step[c] = mean_two[c] - mean_one[c]
        lo, hi = 0.0, 2.0  # the first trial is mu = 1
        for _ in range(48):
            mu = 0.5 * (lo + hi)
            for k in range(4):
                v[k] = mean_one[k] + mu * step[k]
            value, c, s, torque = best_on_piece(piece, v)
            if value + v[3] < bound:
                bound, share = value + v[3], mu
            if step[0] * c + step[1] * s + step[2] * torque + step[3] > 0.0 or mu == 1.0:
                hi = mu
            else:
                lo = mu
    rows[0], rows[1], rows[2], rows[3] = one[3], one[4], two[3], two[4]
    shares[0], shares[1] = (1.0 - share) * i_one, (1.0 - share) * j_one
    shares[2], shares[3] = share * i_two, share * j_two
    return bound


@njit(cache=True)
def narrowed(arc, lo, middle, hi):
    """Return the part of the directions [lo, hi] that an arc allows; empty if lo > hi.

    The arc misses `middle`; where rounding says otherwise, that side of it is kept on which
    the arc lies.
    """
    size = np.sqrt(arc[0] ** 2 + arc[1] ** 2)
    if arc[2] > size or size == 0.0:
        return 1.0, 0.0
    half = np.arccos(max(arc[2], 0.0) / size)
    crest = into(np.arctan2(arc[1], arc[0]), middle)
    if crest > middle:
        return max(middle, crest - half), min(hi, crest + half)
    return max(lo, crest - half), min(middle, crest + half)


@njit(cache=True)
def value_of(generators, pool, count, weights, c, s, torque, work):
    """Compute the exact quality with a new robot, and the least h across its own wrench.

    Returns
    -------
    quality : float [N]
    across : float [N]
        The least h at normals orthogonal to the new robot, inf if there is none.
    index : int
        The row of `work.normals` that attains it, -1 if there is none.
    """
    axis = np.empty(3)
    axis[0], axis[1], axis[2] = c * weights[0], s * weights[1], torque * weights[2]
    index = least_height_across(generators, axis, *work)
    across = work[4][index] if index >= 0 else np.inf
    quality = across
    for k in range(count):
        gain = pool[k, 0] * c + pool[k, 1] * s + pool[k, 2] * torque
        quality = min(quality, pool[k, 3] + max(0.0, gain))
    return quality, across, index


@njit(cache=True)
def reach(generators, pool, count, weights, level, slack, piece, work, best, rows, shares):
    """Decide whether a piece has a robot that reaches a level (T9).

    Parameters
    ----------
    slack : float [N]
        Rounding by which a level may be missed.
    best : (4,)
        Best quality so far and its (c, s, torque); modified in place when bettered.
    rows, shares : (4,)
        Overwritten with the proof when the level is refuted.

    Returns
    -------
    status : int
        REACHED, REFUTED or OUT_OF_ROOM.
    count : int
        Pool rows now.
    """
    lo, hi = piece[4], piece[5]
    arc = np.empty(5)
    lo_arc, hi_arc = np.empty(5), np.empty(5)  # what set lo and hi; -1: the sector itself
    lo_arc[3] = lo_arc[4] = hi_arc[3] = hi_arc[4] = -1.0
    while True:
        middle = 0.5 * (lo + hi)
        c, s = np.cos(middle), np.sin(middle)
        lower, upper, i, j, barred = torque_bounds(pool, count, level, piece, c, s)
        if barred < 0 and (lower <= upper or (i < 0 and j < 0)):
            torque = 0.5 * (lower + upper)
            quality, across, index = value_of(generators, pool, count, weights, c, s, torque, work)
            if quality > best[0]:
                best[0], best[1], best[2], best[3] = quality, c, s, torque
            if across >= level - slack:
                return REACHED, count
            if count == pool.shape[0]:
                return OUT_OF_ROOM, count
            store_normal(pool[count], work[3][index], across, weights)
            count += 1
            continue
        if barred >= 0:
            arc[0], arc[1], arc[2] = pool[barred, 0], pool[barred, 1], level - pool[barred, 3]
            arc[3], arc[4] = barred, -1.0
        else:
            clash(pool, level, piece, i, j, arc)
        new_lo, new_hi = narrowed(arc, lo, middle, hi)
        if new_hi - new_lo <= ARC_END:
            refute(pool, piece, arc, lo_arc, hi_arc, rows, shares)
            return REFUTED, count
        for k in range(5):
            if new_lo > lo:
                lo_arc[k] = arc[k]
            if new_hi < hi:
                hi_arc[k] = arc[k]
        lo, hi = new_lo, new_hi


@njit(cache=True)
def refute(pool, piece, arc, lo_arc, hi_arc, rows, shares):
    """Write the best proof from the arc that emptied the interval and those at its ends."""
    more_rows, more_shares = np.empty(4), np.empty(4)
    bound = np.inf
    for k in range(3):
        other = arc if k == 0 else lo_arc if k == 1 else hi_arc
        if other[3] < 0.0 and other[4] < 0.0:
            continue
        more = prove(pool, piece, arc, other, more_rows, more_shares)
        if more < bound:
            bound = more
            for c in range(4):
                rows[c], shares[c] = more_rows[c], more_shares[c]


@njit(cache=True)
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


@njit(cache=True)
def fill_pool(pool, normals, heights, quality, weights, pieces, bounds, rows, shares):
    """Bound every piece by the weakest normal and its opposite; store what can still matter.

    Writes the first bounds with their proofs, and the pool; returns its number of rows.
    """
    weakest = 0
    for k in range(heights.shape[0]):
        if heights[k] < heights[weakest]:
            weakest = k
    store_normal(pool[0], normals[weakest], heights[weakest], weights)
    count = 1
    for k in range(heights.shape[0]):  # T17: a set as weak at n as at -n gains from no one robot
        along = 0.0
        for c in range(3):
            along += normals[k, c] * normals[weakest, c]
        if along < OPPOSITE and (count == 1 or heights[k] < pool[1, 3]):
            store_normal(pool[1], normals[k], heights[k], weights)
            count = 2
    pair = pool[1, 3] if count == 2 else np.inf  # half each bounds the piece by the larger h
    highest = quality
    for k in range(pieces.shape[0]):
        bounds[k] = pool[0, 3] + max(0.0, best_on_piece(pieces[k], pool[0])[0])
        for c in range(4):
            rows[k, c], shares[k, c] = -1.0, 0.0
        rows[k, 0], shares[k, 0] = 0.0, 1.0
        if pair < bounds[k]:
            bounds[k] = pair
            rows[k, 1], shares[k, 0], shares[k, 1] = 1.0, 0.5, 0.5
        highest = max(highest, bounds[k])
    for k in range(heights.shape[0]):
        if heights[k] < highest:
            store_normal(pool[count], normals[k], heights[k], weights)
            count += 1
    return count


@njit(cache=True)
def solve(generators, normals, heights, quality, weights, pieces, gap, floor, room):
    """Find the globally best robot over all pieces, with a proof per piece.

    Parameters
    ----------
    generators : (n, 3) [N]
    normals, heights : (m, 3), (m,)
        Facets of the base swarm: all with h below any quality that can be reached.
    quality : float [N]
        Exact quality of the base swarm: no newcomer makes it worse.
    weights : (3,) [N, N, N/m]
        Turn a unit wrench [1, 1, m] of the newcomer into the metric's coordinates.
    pieces : (k, 10)
    gap, floor : float, float [N]
        Stop when bound - best <= max(gap * best, floor).
    room : int
        How many normals may be added to the pool.

    Returns
    -------
    status : int
        SOLVED or OUT_OF_ROOM; bounds hold in either case.
    best : (5,)
        Quality and (c, s, torque) of the best robot, and its piece (-1: none betters `quality`).
    bounds : (k,) [N]
    rows, shares : (k, 4), (k, 4)
        The proof of each bound: pool rows (-1: none) and weights that sum to 1.
    pool : (p, 5)
    """
    n, many = generators.shape[0], pieces.shape[0]
    work = (np.empty(n), np.empty(n), np.empty(n), np.empty((2 * n, 3)), np.empty(2 * n))
    size = np.sqrt(weights[0] ** 2 + weights[1] ** 2)
    for i in range(n):
        size += np.sqrt(generators[i, 0] ** 2 + generators[i, 1] ** 2 + generators[i, 2] ** 2)
    pool = np.empty((heights.shape[0] + 2 + room, 5))
    bounds, settled = np.empty(many), np.zeros(many)
    rows, shares = np.empty((many, 4)), np.empty((many, 4))
    count = fill_pool(pool, normals, heights, quality, weights, pieces, bounds, rows, shares)
    proof_rows, proof_shares = np.empty(4), np.empty(4)
    best = np.zeros(5)
    best[0], best[4] = quality, -1.0
    while True:
        k = -1
        for j in range(many):
            if settled[j] == 0.0 and (k < 0 or bounds[j] > bounds[k]):
                k = j
        if k < 0 or bounds[k] - best[0] <= max(gap * best[0], floor):
            return SOLVED, best, bounds, rows, shares, pool[:count]
        share = PROBE if best[4] >= 0 and k != best[4] else 0.5
        before, high = best[0], bounds[k]
        level = before + share * (high - before)
        outcome, count = reach(
            generators, pool, count, weights, level, ROUNDING * size, pieces[k], work,
            best, proof_rows, proof_shares,
        )  # fmt: skip
        if best[0] > before:
            best[4] = k
        if outcome == OUT_OF_ROOM:
            return OUT_OF_ROOM, best, bounds, rows, shares, pool[:count]
        if outcome == REACHED:
            if best[0] - before < 0.5 * (level - before):  # by rounding alone
                settled[k] = 1.0
        else:
            share_proof(pool, pieces, proof_rows, proof_shares, bounds, rows, shares)
            if bounds[k] - level > 0.5 * (high - level):  # held up by rounding alone
                settled[k] = 1.0
