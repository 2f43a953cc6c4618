/* What a robot can exert at its contact: a convex set of forces, by its support function (T20).
 *
 * The set is the hull of points and of arcs about the origin. It is given by its elements, in any
 * order: between two directions, its normal cone, a point or an arc is the farthest. An
 * element is a row (radius, x, y, start, end): a point (x, y) [N] if the radius is 0, or else an arc
 * of that radius [N]; farthest from `start` to `end` [rad], 0 <= end - start <= 2 pi, and the cone of a
 * point is at most a half turn. Trusted are elements that go once around. A robot has up to some ten.
 *
 * Along a normal n, in the metric's coordinates, a force F at the moment arm c is worth F . p with
 * p(n) = (s_1 n_1 - s_3 n_3 c_y, s_2 n_2 + s_3 n_3 c_x), s the scale (T20). */
#ifndef SWARMGRASP_FORCE_SET_H
#define SWARMGRASP_FORCE_SET_H

#include "sector.h"
#include "vectors.h"

#define ELEMENT 5 /* numbers in a row */
#define WHOLE (2.0 * PI - 1e-9) /* width of a cone [rad] that counts as a turn: rounding may leave a gap */

typedef enum {
    POINT,
    NARROW, /* an arc of a half turn at most */
    WIDE,   /* a longer one */
    ROUND,  /* a whole circle */
} Shape;

typedef struct {
    Shape shape;
    double radius, at[2];           /* [N]; an arc is at (0, 0) */
    double start[2], end[2];        /* the ends of its normal cone, as unit vectors, and */
    double middle[2];               /* the middle between them */
} Element;

/* A robot whose contact is `adrift` steers once it knows where it is: it is worth the least of its
 * support functions over all contacts (T26). One that is `turning` is a ray of uncertain direction: it
 * is worth the least over all poses, or 0 (T14). */
typedef struct {
    double arm[2];                  /* of its contact [m] */
    const Element *element;
    int elements;
    int adrift;                     /* straight parts on which its contact lies, or 0: */
    const double *part;             /* (adrift, 4) moment arms of their ends [m] */
    int turning;                    /* pieces of its poses, or 0: */
    const double *piece;            /* (turning, PIECE); see sector.h. Their force is `limit` [N] */
    double limit;
} ForceSet;

static inline double across(const double *a, const double *b) { return a[0] * b[1] - a[1] * b[0]; }

static inline double along(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1]; }

/* Read a row (radius, x, y, start, end). */
static inline Element element_of(const double *row) {
    double width = row[4] - row[3], middle = row[3] + 0.5 * width;
    Element e = {.radius = row[0],
                 .start = {cos(row[3]), sin(row[3])}, .end = {cos(row[4]), sin(row[4])},
                 .middle = {cos(middle), sin(middle)}};
    for (int k = 0; k < 2 && row[0] == 0.0; k++)
        e.at[k] = row[1 + k];
    e.shape = row[0] == 0.0 ? POINT : width <= PI ? NARROW : width < WHOLE ? WIDE : ROUND;
    return e;
}

/* Tell whether a vector lies in an element's normal cone; on its ends, too. Nobody can foresee which side
 * a vector is on: `&` and `|` spare the branches. */
static inline int is_in_cone(const Element *e, const double *p) {
    int after = across(e->start, p) >= 0.0, before = across(p, e->end) >= 0.0;
    int ahead = along(e->middle, p) >= 0.0;
    if (e->shape == ROUND)
        return 1;
    return e->shape == WIDE ? after | before | ahead : after & before & ahead;
}

/* p of a normal, in the metric's coordinates, at a moment arm. */
static inline void lever(const double *scale, const double *arm, const double *n, double *p) {
    p[0] = scale[0] * n[0] - scale[2] * n[2] * arm[1];
    p[1] = scale[1] * n[1] + scale[2] * n[2] * arm[0];
}

/* The support function: the greatest F . p over the set, in the unit of p times N. Writes the force
 * that attains it, and returns in `which` the element, unless these are NULL. */
static inline double support(const ForceSet *set, const double *p, double *force, int *which) {
    double most = -INFINITY, size = sqrt(along(p, p));
    int best = 0;
    for (int k = 0; k < set->elements; k++) {
        const Element *e = set->element + k;
        double value = along(e->at, p);
        if (e->shape != POINT)
            value = is_in_cone(e, p) ? e->radius * size : -INFINITY;
        best = value > most ? k : best;
        most = value > most ? value : most;
    }
    if (which)
        *which = best;
    if (force) {
        const Element *e = set->element + best;
        double turned = size > 0.0 ? e->radius / size : 0.0, still = size > 0.0 ? 0.0 : e->radius;
        for (int k = 0; k < 2; k++)
            force[k] = e->at[k] + turned * p[k] + still * e->middle[k];
    }
    return most;
}

/* The wrench (3,) [N], in the metric's coordinates, of a force at a moment arm. */
static inline void wrench_of(const double *scale, const double *arm, const double *force,
                             double *wrench) {
    wrench[0] = scale[0] * force[0];
    wrench[1] = scale[1] * force[1];
    wrench[2] = scale[2] * across(arm, force);
}

#endif
