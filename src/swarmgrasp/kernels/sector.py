"""What a robot can do on one piece: a straight contact and a sector of directions (T8, T10).

A piece is a row (p_x, p_y, q_x, q_y, lo, hi, cos lo, sin lo, cos hi, sin hi): contacts between
the moment arms p and q [m], force directions between lo and hi [rad], 0 <= hi - lo <= pi, and
(q - p) x F >= 0 throughout. At full force its robots exert (cos a, sin a, c x (cos a, sin a)).
A covector v (3,) [1, 1, 1/m] values such a wrench.
"""

import math

import numpy as np

from swarmgrasp.kernels.facets import inner


@inner
def best_on_piece(piece, v):
    """Maximise v . b over the robots of a piece.

    At a fixed contact v . b is a sinusoid in the direction and it is linear in the contact, so
    only the two ends, and there the sector's ends and the sinusoid's crest, matter.

    Parameters
    ----------
    piece : (10,)
    v : (3,) or longer

    Returns
    -------
    value : float
        sigma_K(v), the support function of the piece at full force.
    c, s, torque : float, float, float [1, 1, m]
        The wrench that attains it.
    """
    c_lo, s_lo, c_hi, s_hi = piece[6], piece[7], piece[8], piece[9]
    value, c, s, end = -np.inf, c_lo, s_lo, 0
    for k in range(0, 4, 2):
        a = v[0] - v[2] * piece[k + 1]
        b = v[1] + v[2] * piece[k]
        at_lo, at_hi = a * c_lo + b * s_lo, a * c_hi + b * s_hi
        if at_lo > value:
            value, c, s, end = at_lo, c_lo, s_lo, k
        if at_hi > value:
            value, c, s, end = at_hi, c_hi, s_hi, k
        crest = math.sqrt(a * a + b * b)
        # Between the ends, and not opposite to them: with lo = hi the first two hold there too.
        inside = c_lo * b >= s_lo * a and a * s_hi >= b * c_hi and at_lo + at_hi >= -1e-9 * crest
        if inside and crest > value:
            value, c, s, end = crest, a / crest, b / crest, k
    return value, c, s, piece[end] * s - piece[end + 1] * c
