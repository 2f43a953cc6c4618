"""Among equally good robots, the one that lifts the rest of h most (T17).

When the weakest facet cannot be raised, or the contact does not matter for it, a whole set of
robots shares the best quality. Of these the one is taken that makes the soft minimum of h over
directions greatest, so that the robots to come are not stuck where this one could not help.
"""

import numpy as np
from numba import njit

from swarmgrasp.kernels.place import value_of
from swarmgrasp.kernels.sector import torque_arm

CANDIDATES = 600
"""Size of the first grid over all pieces together."""
REFINEMENTS = 12
"""Halvings of the grid's step around the best candidate."""


@njit(cache=True)
def softness(directions, decay, sharpness, weights, c, s, torque):
    """Sum exp(-sharpness h) over directions with a new robot: the less, the better.

    `decay` (d,) holds exp(-sharpness h) of the base swarm.
    """
    b0, b1, b2 = c * weights[0], s * weights[1], torque * weights[2]
    total = 0.0
    for k in range(directions.shape[0]):
        gain = directions[k, 0] * b0 + directions[k, 1] * b1 + directions[k, 2] * b2
        total += decay[k] * np.exp(-sharpness * gain) if gain > 0.0 else decay[k]
    return total


@njit(cache=True)
def robot_at(piece, along, across):
    """Return (c, s, torque) at shares of the contact's way p to q and of the sector lo to hi."""
    angle = piece[4] + across * (piece[5] - piece[4])
    c, s = np.cos(angle), np.sin(angle)
    from_p = torque_arm(piece[0], piece[1], c, s)
    from_q = torque_arm(piece[2], piece[3], c, s)
    return c, s, from_p + along * (from_q - from_p)


@njit(cache=True)
def grid_of(pieces, bounds, target):
    """Lay a grid over all pieces whose bound is at least `target`.

    Returns
    -------
    (g, 3)
        Piece, share along the contact, share across the sector.
    """
    many = 0
    for k in range(pieces.shape[0]):
        many += bounds[k] >= target
    each = max(1, CANDIDATES // max(many, 1))
    grid = np.empty((each * many + 9 * many, 3))
    count = 0
    for k in range(pieces.shape[0]):
        if bounds[k] < target:
            continue
        piece = pieces[k]
        is_point = piece[0] == piece[2] and piece[1] == piece[3]
        is_ray = piece[4] == piece[5]
        contacts = 1 if is_point else (min(each, 65) if is_ray else int(np.sqrt(0.5 * each)) + 1)
        sectors = 1 if is_ray else (min(each, 65) if is_point else each // contacts + 1)
        for i in range(contacts):
            for j in range(sectors):
                if count < grid.shape[0]:
                    grid[count, 0] = k
                    grid[count, 1] = 0.5 if contacts == 1 else i / (contacts - 1)
                    grid[count, 2] = 0.5 if sectors == 1 else j / (sectors - 1)
                    count += 1
    return grid[:count]


@njit(cache=True)
def break_tie(generators, pool, weights, pieces, bounds, best, target, directions, sharpness):
    """Find the robot of at least the target quality that lifts the rest of h most.

    Parameters
    ----------
    generators, pool, weights, pieces, bounds, best
        As taken and given by `solve`.
    target : float [N]
    directions : (d, 3)
        Unit vectors over which the soft minimum is taken.
    sharpness : float [1/N]

    Returns
    -------
    (5,)
        Quality and (c, s, torque) of the robot, and its piece.
    """
    n, count = generators.shape[0], pool.shape[0]
    work = (np.empty(n), np.empty(n), np.empty(n), np.empty((2 * n, 3)), np.empty(2 * n))
    decay = np.zeros(directions.shape[0])
    for k in range(directions.shape[0]):
        for i in range(n):
            reach = 0.0
            for c in range(3):
                reach += directions[k, c] * generators[i, c]
            decay[k] += max(0.0, reach)
    lowest = np.inf
    for k in range(directions.shape[0]):
        lowest = min(lowest, decay[k])
    for k in range(directions.shape[0]):
        decay[k] = np.exp(-sharpness * (decay[k] - lowest))
    answer = np.empty(5)
    for k in range(5):
        answer[k] = best[k]
    least = np.inf
    if best[4] >= 0.0:
        least = softness(directions, decay, sharpness, weights, best[1], best[2], best[3])
    grid = grid_of(pieces, bounds, target)
    scores = np.empty(grid.shape[0])
    for k in range(grid.shape[0]):
        c, s, torque = robot_at(pieces[int(grid[k, 0])], grid[k, 1], grid[k, 2])
        scores[k] = softness(directions, decay, sharpness, weights, c, s, torque)
    at = np.zeros(3)
    for k in np.argsort(scores):
        if scores[k] >= least:
            return answer
        c, s, torque = robot_at(pieces[int(grid[k, 0])], grid[k, 1], grid[k, 2])
        quality = value_of(generators, pool, count, weights, c, s, torque, work)[0]
        if quality >= target:
            least = scores[k]
            answer[0], answer[1], answer[2], answer[3] = quality, c, s, torque
            answer[4] = at[0] = grid[k, 0]
            at[1], at[2] = grid[k, 1], grid[k, 2]
            break
    else:
        return answer
    step = 1.0 / max(2.0, np.sqrt(0.5 * grid.shape[0]))
    piece = pieces[int(at[0])]
    for _ in range(REFINEMENTS):
        for move in range(4):
            along = at[1] + (step if move == 0 else -step if move == 1 else 0.0)
            across = at[2] + (step if move == 2 else -step if move == 3 else 0.0)
            along, across = min(max(along, 0.0), 1.0), min(max(across, 0.0), 1.0)
            c, s, torque = robot_at(piece, along, across)
            score = softness(directions, decay, sharpness, weights, c, s, torque)
            if score < least:
                quality = value_of(generators, pool, count, weights, c, s, torque, work)[0]
                if quality >= target:
                    least = score
                    at[1], at[2] = along, across
                    answer[0], answer[1], answer[2], answer[3] = quality, c, s, torque
        step *= 0.5
    return answer
