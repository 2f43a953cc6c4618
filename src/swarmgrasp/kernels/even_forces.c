/* The forces with the least sum of squares that make a wrench: the dual, in three unknowns (T27).
 *
 * At a price y a robot exerts its force nearest to reach^2 p(y): what y is worth to it less half the
 * square of what that is of its reach is then the most. What is missing of the wrench is the slope
 * of the dual function, which is concave: Newton's method with a search along each step on the
 * slope's sign, which no cancellation touches. On the boundary of the wrench set prices rise without
 * end where some robots have to exert one force and others have a choice; and rounding of large
 * prices is what is missing. So the last steps move forces themselves, and keep them in their sets:
 * how far their sum of squares is from the dual is looked at. */
#include "pushers.h"

#include <string.h>

#define STEPS 80      /* some 10 are usual */
#define LOOKS 60      /* at one step */
#define LONG 4.0      /* of the price: longest step, before it is searched along */
#define LEVEL 0.1    /* of a slope: where it counts as none */
#define MADE 1e-14    /* of the wrench and the total: what is missing where nothing is, */
#define BARELY 1e-10  /* and what may be of the wrench */
#define NEAR 1e-7     /* of the wrench: missing so much, forces are moved themselves, */
#define LATE 8        /* or after so many steps */
#define BROAD 1e-2    /* with so much */
#define MOVES 6
#define GAP 1e-5      /* of the sum of squares: above the dual */
#define DAMPING 1e-17 /* of the curvature */

typedef struct {
    double price[3], missing[3];
    double curvature[6]; /* xx, xy, yy, xz, yz, zz */
} Dual;

/* What a price is worth to a robot: reach^2 p. */
static void asked_of(const Pushers *p, const Pusher *r, const double *price, double *asked) {
    lever(p->scale, r->set.arm, price, asked);
    asked[0] *= r->reach * r->reach;
    asked[1] *= r->reach * r->reach;
}

static void nearest_beyond(const Pusher *r, const double *asked, double *force, double *turn) {
    double wanted[2] = {r->rest[0] + asked[0], r->rest[1] + asked[1]};
    nearest_force(r, wanted, force, turn);
    force[0] -= r->rest[0];
    force[1] -= r->rest[1];
}

/* Find what of a target the forces do not make. */
static void find_missing(const Pushers *p, const double *target, const double *forces,
                         double *missing) {
    memcpy(missing, target, 3 * sizeof *missing);
    for (int i = 0; i < p->count; i++) {
        double wrench[3];
        wrench_of(p->scale, p->pusher[i].set.arm, forces + 2 * (ptrdiff_t)i, wrench);
        for (int c = 0; c < 3; c++)
            missing[c] -= wrench[c];
    }
}

/* Find forces (count, 2) beyond the rests at the price and how they turn (count, 3), what is
 * missing, and the curvature. */
static void look(const Pushers *p, const double *target, Dual *d, double *forces, double *turns) {
    memset(d->curvature, 0, sizeof d->curvature);
    for (int i = 0; i < p->count; i++) {
        const Pusher *r = p->pusher + i;
        double asked[2], *turn = turns + 3 * (ptrdiff_t)i, weight = r->reach * r->reach;
        asked_of(p, r, d->price, asked);
        nearest_beyond(r, asked, forces + 2 * (ptrdiff_t)i, turn);
        const double *s = p->scale, *a = r->set.arm;
        double rx = -s[2] * a[1], ry = s[2] * a[0]; /* torque of forces along x and y */
        double tx = turn[0] * rx + turn[1] * ry, ty = turn[1] * rx + turn[2] * ry;
        d->curvature[0] += weight * s[0] * s[0] * turn[0];
        d->curvature[1] += weight * s[0] * s[1] * turn[1];
        d->curvature[2] += weight * s[1] * s[1] * turn[2];
        d->curvature[3] += weight * s[0] * tx;
        d->curvature[4] += weight * s[1] * ty;
        d->curvature[5] += weight * (rx * tx + ry * ty);
    }
    find_missing(p, target, forces, d->missing);
}

/* Solve curvature x = missing by Cholesky, damped. */
static void newton(const Dual *d, const double *missing, double whole, double *x) {
    const double *m = d->curvature;
    double damp = DAMPING * (m[0] + m[2] + m[5] + 1e-3 * whole);
    double a = sqrt(m[0] + damp), b = m[1] / a, c = m[3] / a;
    double e = sqrt(larger(m[2] - b * b, 0.0) + damp), f = (m[4] - b * c) / e;
    double g = sqrt(larger(m[5] - c * c - f * f, 0.0) + damp);
    double u = missing[0] / a, v = (missing[1] - b * u) / e;
    double w = (missing[2] - c * u - f * v) / g;
    x[2] = w / g;
    x[1] = (v - f * x[2]) / e;
    x[0] = (u - b * x[1] - c * x[2]) / a;
}

/* Find how far along a step the slope changes its sign, nearly; the dual there becomes `d`. */
static Status search(const Pushers *p, const double *target, const double *step, Work *work, Dual *d,
                     double *forces, double *turns) {
    const Dual start = *d;
    double slope = dot(start.missing, step), low = 0.0, high = INFINITY, at = 1.0;
    for (int looks = 0; looks < LOOKS; looks++) {
        Status status = spend(work, 16.0 * p->count);
        if (status != SOLVED)
            return status;
        for (int c = 0; c < 3; c++)
            d->price[c] = start.price[c] + at * step[c];
        look(p, target, d, forces, turns);
        double now = dot(d->missing, step);
        if (fabs(now) <= LEVEL * slope || (now > 0.0 && at > 1e3))
            break;
        if (now > 0.0)
            low = at;
        else
            high = at;
        at = high < INFINITY ? 0.5 * (low + high) : 4.0 * at;
    }
    return SOLVED;
}

/* Move forces within their sets until nothing is missing; tells whether that is so, and their sum of
 * squares the least, nearly. */
static int finish(const Pushers *p, const double *target, const Dual *d, double whole, double extent,
                  const double *turns, const double *forces, double *moved) {
    double missing[3], least = INFINITY, sum = 0.0, above = 0.0, noise = 0.0;
    memcpy(moved, forces, 2 * (size_t)p->count * sizeof *moved);
    for (int moves = 0;; moves++) {
        double step[3], unused[3];
        find_missing(p, target, moved, missing);
        double now = length(missing);
        if (now <= MADE * extent || (now >= 0.5 * least && now <= BARELY * length(target)))
            break;
        if (moves == MOVES)
            return 0;
        least = smaller(least, now);
        newton(d, missing, whole, step);
        for (int i = 0; i < p->count; i++) {
            const Pusher *r = p->pusher + i;
            const double *turn = turns + 3 * (ptrdiff_t)i;
            double *force = moved + 2 * (ptrdiff_t)i, way[2], to[2];
            asked_of(p, r, step, way);
            to[0] = force[0] + turn[0] * way[0] + turn[1] * way[1];
            to[1] = force[1] + turn[1] * way[0] + turn[2] * way[1];
            nearest_beyond(r, to, force, unused);
        }
    }
    for (int i = 0; i < p->count; i++) {
        const Pusher *r = p->pusher + i;
        const double *force = moved + 2 * (ptrdiff_t)i;
        double asked[2], left[2];
        if (r->reach == 0.0)
            continue;
        asked_of(p, r, d->price, asked);
        left[0] = asked[0] - force[0];
        left[1] = asked[1] - force[1];
        double most = support(&r->set, left, NULL, NULL) - along(r->rest, left);
        above += (most - along(left, force)) / (r->reach * r->reach);
        sum += along(force, force) / (r->reach * r->reach);
        noise += 1e-13 * sqrt(along(asked, asked)) / r->reach;
    }
    return above <= GAP * sum + noise;
}

Status even_forces(const Pushers *p, const double *target, const double *normal, Work *work,
                   double *forces, double *price, int *is_found) {
    Dual d = {.price = {0.0}};
    double size = length(target), whole = 0.0, *found = forces + 2 * (ptrdiff_t)p->count;
    double *turns = found + 2 * (ptrdiff_t)p->count;
    for (int i = 0; i < p->count; i++)
        whole += p->pusher[i].size * p->pusher[i].size;
    double extent = size + p->total, first = size / whole;
    *is_found = 0;
    look(p, target, &d, found, turns);
    for (int step = 0; step < STEPS; step++) {
        double missing = length(d.missing), way[3];
        int is_late = step >= LATE && missing <= BROAD * size && step % 2 == 0;
        if (missing <= NEAR * size || is_late) {
            *is_found = finish(p, target, &d, whole, extent, turns, found, forces);
            if (*is_found) {
                memcpy(price, d.price, sizeof d.price);
                return SOLVED;
            }
        }
        newton(&d, d.missing, whole, way);
        if (step == 0)
            for (int c = 0; c < 3; c++)
                way[c] = normal[c] / length(normal) * first;
        if (!(dot(way, d.missing) > 0.0))
            for (int c = 0; c < 3; c++)
                way[c] = d.missing[c] / missing * first;
        double longest = LONG * larger(length(d.price), first), far = length(way);
        for (int c = 0; c < 3 && far > longest; c++)
            way[c] *= longest / far;
        Status status = search(p, target, way, work, &d, found, turns);
        if (status != SOLVED)
            return status;
    }
    return SOLVED;
}
