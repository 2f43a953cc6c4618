/* What a robot can do on one piece: a straight contact and a sector of directions (T8, T10).
 *
 * A piece is a row (p_x, p_y, q_x, q_y, lo, hi, cos lo, sin lo, cos hi, sin hi): contacts
 * between the moment arms p and q [m], force directions between lo and hi [rad],
 * 0 <= hi - lo <= pi, and (q - p) x F >= 0 throughout. At full force its robots exert
 * (cos a, sin a, c x (cos a, sin a)) [1, 1, m]. A covector v [1, 1, 1/m] values such a wrench. */
#ifndef SWARMGRASP_SECTOR_H
#define SWARMGRASP_SECTOR_H

#include "vectors.h"

#define PIECE 10 /* numbers in a row */

/* Maximise v . b over the robots of a piece; write the (c, s, torque) that attains it.
 *
 * At a fixed contact v . b is a sinusoid in the direction, and it is linear in the contact: only
 * the two ends, and there the sector's ends and the sinusoid's crest, matter. */
static inline double best_on_piece(const double *piece, const double *v, double *wrench) {
    double c_lo = piece[6], s_lo = piece[7], c_hi = piece[8], s_hi = piece[9];
    double value = -INFINITY, c = c_lo, s = s_lo;
    int end = 0;
    for (int k = 0; k < 4; k += 2) {
        double a = v[0] - v[2] * piece[k + 1], b = v[1] + v[2] * piece[k];
        double at_lo = a * c_lo + b * s_lo, at_hi = a * c_hi + b * s_hi;
        double crest = sqrt(a * a + b * b);
        if (at_lo > value) {
            value = at_lo;
            c = c_lo;
            s = s_lo;
            end = k;
        }
        if (at_hi > value) {
            value = at_hi;
            c = c_hi;
            s = s_hi;
            end = k;
        }
        /* between the ends, and not opposite to them: with lo = hi the first two hold there too */
        if (crest > value && c_lo * b >= s_lo * a && a * s_hi >= b * c_hi
            && at_lo + at_hi >= -1e-9 * crest) {
            value = crest;
            c = a / crest;
            s = b / crest;
            end = k;
        }
    }
    wrench[0] = c;
    wrench[1] = s;
    wrench[2] = piece[end] * s - piece[end + 1] * c;
    return value;
}

#endif
