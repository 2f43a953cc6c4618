/* The least shares of a wrench: along the ray to it if it is in reach, else of the nearest wrench
 * (T18). Trusted are finite numbers and a `Turning` with room. A wrench that only the robots in a
 * plane make is asked of those alone, then perhaps of those on a line: three deep at most. */
#include <stdlib.h>
#include <string.h>

#include "forces.h"
#include "vectors.h"

#define OWN 1e-15       /* relative rounding of a wrench */
#define SAME 1e-12      /* relative distance from a wrench that is none */
#define LOST 1e-10      /* relative distance that is told, of a wrench in reach */
#define SLIGHT 1e-14    /* relative height that is rounding */
#define LEAST 1e-12     /* cosine between a normal and a ray that is rounding */
#define NEAR_ENOUGH 0.1 /* cosine from which a normal is worth starting from */
#define FARTHEST 1e20   /* how far out a wrench matters, relative to the total */

/* A vector's length, also if its square is out of range. */
static double span(const double *v) {
    double most = larger(fabs(v[0]), larger(fabs(v[1]), fabs(v[2])));
    if (most == 0.0)
        return 0.0;
    const double u[3] = {v[0] / most, v[1] / most, v[2] / most};
    return most * length(u);
}

/* Share out the point q of the face that the robots are divided by, times a scale. Returns how much
 * the robots in the plane add to its height: they are in it to within rounding. */
static double share_out(Turning *t, const double *q, double extent, double scale, double *shares,
                        Shares *found) {
    double height = 0.0;
    Face *face = &t->face;
    face_shares(face, q, extent, found->normals[1], found->price);
    for (ptrdiff_t i = 0; i < t->n; i++)
        shares[i] = t->where[i] > 0 ? scale : 0.0;
    for (ptrdiff_t k = 0; k < face->count; k++) {
        ptrdiff_t i = face->robot[k];
        shares[i] = scale * face->share[k];
        height += face->share[k] * t->s[i] * t->sizes[i];
    }
    for (int k = 0; k < 3; k++)
        found->price[k] = ldexp(scale * found->price[k], -t->exponent);
    return height;
}

/* Move the point of the ray that is on a face back into it, by what rounding may have moved it: the
 * ray may meet the face at a small angle. Returns how far along the ray. */
static double slide_in(Turning *t, const Goal *goal, const double *normal, double *q,
                       double extent) {
    const double *w = goal->target, ray[2] = {dot(w, t->face.e), dot(w, t->face.f)};
    double moved = 0.0;
    for (int k = 0; k < PATIENCE; k++) {
        Side side = face_side(&t->face, q, extent);
        double along = side.m[0] * ray[0] + side.m[1] * ray[1], step = -side.beyond / along;
        if (side.excess <= OUTSIDE || !(fabs(step) * dot(normal, w) <= SLIGHT * extent))
            break;
        moved += step;
        q[0] += step * ray[0];
        q[1] += step * ray[1];
    }
    return moved;
}

/* What is missing of a wrench; returns its size. */
static double miss_of(const Turning *t, const double *w, const double *shares, double *miss) {
    memcpy(miss, w, 3 * sizeof *miss);
    for (ptrdiff_t i = 0; i < t->n; i++)
        for (int k = 0; k < 3; k++)
            miss[k] -= shares[i] * t->sizes[i] * t->units[3 * i + k];
    return span(miss);
}

/* Find the shares of a wrench and the proof: REACHED, or REFUTED if it is out of reach; sets `needed`. */
static Status share_along(Turning *t, const double *w, double size, double noise, double *shares,
                          Shares *found) {
    double *normal = found->normals[0], q[2], extent, reach, miss[3];
    Goal goal = {1, {w[0] / size, w[1] / size, w[2] / size}, 0.0, larger(LEAST, noise / size)};
    if (!(dot(normal, goal.target) > NEAR_ENOUGH))
        memcpy(normal, goal.target, sizeof goal.target);
    Status status = find_face(t, &goal, normal, q, &extent, &reach);
    if (status != SOLVED)
        return status;
    reach += slide_in(t, &goal, normal, q, extent);
    found->needed = reach > 0.0 ? size / reach : INFINITY;
    if (found->needed > 1.0 + SAME)
        return REFUTED;
    double more = share_out(t, q, extent, smaller(found->needed, 1.0), shares, found);
    if (fabs(more) > OWN * reach) { /* the face is a little farther out, or nearer */
        more /= dot(normal, goal.target);
        q[0] += more * dot(goal.target, t->face.e);
        q[1] += more * dot(goal.target, t->face.f);
        found->needed = size / (reach + more);
        face_lay(&t->face, normal, t->units, t->sizes);
        share_out(t, q, extent, smaller(found->needed, 1.0), shares, found);
    }
    double missed = miss_of(t, w, shares, miss);
    if (missed > LOST * size + NOTHING * t->total + noise)
        found->shortfall = ldexp(missed, t->exponent);
    return REACHED;
}

/* Find the shares of a wrench that the robots in the plane make by themselves. */
static Status share_in_plane(Turning *t, const double *wrench, double *shares, Shares *found) {
    const double none[3] = {0.0};
    const Face *face = &t->face;
    Turning part = {0};
    Shares inner = {0};
    ptrdiff_t n = face->count;
    double *own = malloc((4 * (size_t)n + 1) * sizeof *own);
    Status status = own ? SOLVED : NO_MEMORY;
    for (ptrdiff_t k = 0; k < n && own; k++)
        for (int c = 0; c < 3; c++)
            own[3 * k + c] = t->sizes[face->robot[k]] * t->units[3 * face->robot[k] + c];
    if (status == SOLVED)
        status = turning_room(&part, own, n, t->interrupted);
    if (status == SOLVED)
        status = least_shares(&part, wrench, none, own + 3 * n, &inner);
    if (status == SOLVED) {
        for (ptrdiff_t k = 0; k < n; k++)
            shares[face->robot[k]] = own[3 * n + k];
        memcpy(found->normals[1], inner.normals, sizeof inner.normals[0] * 2);
        for (int c = 0; c < 3; c++)
            found->price[c] = ldexp(inner.price[c], -t->exponent);
    }
    turning_free(&part);
    free(own);
    return status;
}

/* Find the shares of the attainable wrench that is nearest to one out of reach. */
static Status share_nearest(Turning *t, const double *w, double size, double noise,
                            double *shares, Shares *found) {
    double q[2], extent, reach, made[3], miss[3];
    double shrink = smaller(1.0, FARTHEST * t->total / size);
    Goal goal = {0, {w[0], w[1], w[2]}, size, 0.0};
    for (int k = 0; k < 3 && t->total > 0.0; k++)
        goal.target[k] *= shrink;
    Status status = find_face(t, &goal, found->normals[0], q, &extent, &reach);
    if (status != SOLVED)
        return status;
    share_out(t, q, extent, 1.0, shares, found);
    double shortfall = miss_of(t, w, shares, miss);
    if (shortfall > SAME * size + NOTHING * t->total + noise)
        found->shortfall = ldexp(shortfall, t->exponent);
    if (t->face.count == 0 || memchr(t->where, 1, (size_t)t->n))
        return SOLVED;
    for (int k = 0; k < 3; k++) /* nobody has to give all: the face is that of no wrench, too */
        made[k] = w[k] - miss[k];
    return share_in_plane(t, made, shares, found);
}

Status least_shares(Turning *t, const double *wanted, const double *load, double *shares,
                   Shares *found) {
    double w[3], size, noise;
    for (int k = 0; k < 3; k++)
        w[k] = ldexp(wanted[k] - load[k], -t->exponent);
    size = span(w);
    noise = ldexp(OWN * (span(wanted) + span(load)), -t->exponent);
    found->needed = found->shortfall = 0.0;
    memset(found->normals[1], 0, 2 * sizeof found->normals[1]);
    memset(found->price, 0, sizeof found->price);
    memset(shares, 0, (size_t)t->n * sizeof *shares);
    if (size <= noise) {
        memset(found->normals[0], 0, sizeof found->normals[0]);
        return SOLVED;
    }
    Status status = share_along(t, w, size, noise, shares, found);
    if (status == REFUTED)
        status = share_nearest(t, w, size, noise, shares, found);
    return status == REACHED ? SOLVED : status;
}
