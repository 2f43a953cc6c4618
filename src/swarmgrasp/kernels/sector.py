"""What a robot can do on one piece: a straight contact and a sector of directions (T8, T10).

A piece is a row (p_x, p_y, q_x, q_y, lo, hi, cos lo, sin lo, cos hi, sin hi): contacts between
the moment arms p and q [m], force directions between lo and hi [rad], 0 <= hi - lo <= pi, and
(q - p) x F >= 0 throughout. At full force its robots exert (cos a, sin a, c x (cos a, sin a)).
A covector v (3,) [1, 1, 1/m] values such a wrench.
"""

import numpy as np
from numba import njit


@njit(cache=True)
def torque_arm(x, y, c, s):
    """Return the torque [m] of the unit force (c, s) at the moment arm (x, y)."""
    return x * s - y * c


@njit(cache=True)
def best_on_piece(piece, v):
    """Maximise v . b over the robots of a piece.

    At a fixed contact v . b is a sinusoid in the direction and it is linear in the contact, so
    only the two ends, and there the sector's ends and the sinusoid's crest, matter.

    Parameters
    ----------
    piece : (10,)
    v : (3,)

    Returns
    -------
    value : float
        sigma_K(v), the support function of the piece at full force.
    c, s, torque : float, float, float [1, 1, m]
        The wrench that attains it.
    """
    c_lo, s_lo, c_hi, s_hi = piece[6], piece[7], piece[8], piece[9]
    value, c, s, end = -np.inf, c_lo, s_lo, 0
    for k in range(2):
        a = v[0] - v[2] * piece[2 * k + 1]
        b = v[1] + v[2] * piece[2 * k]
        at_lo, at_hi = a * c_lo + b * s_lo, a * c_hi + b * s_hi
        if at_lo > value:
            value, c, s, end = at_lo, c_lo, s_lo, k
        if at_hi > value:
            value, c, s, end = at_hi, c_hi, s_hi, k
        crest = np.sqrt(a * a + b * b)
        # Between the ends, and not opposite to them: with lo = hi the first two hold there too.
        inside = c_lo * b - s_lo * a >= 0.0 and a * s_hi - b * c_hi >= 0.0
        if inside and crest > value and at_lo + at_hi >= -1e-9 * crest:
            value, c, s, end = crest, a / crest, b / crest, k
    return value, c, s, torque_arm(piece[2 * end], piece[2 * end + 1], c, s)


@njit(cache=True)
def into(angle, middle):
    """Return the angle turned by whole turns to lie within pi of `middle` [rad]."""
    return angle - 2.0 * np.pi * np.round((angle - middle) / (2.0 * np.pi))
