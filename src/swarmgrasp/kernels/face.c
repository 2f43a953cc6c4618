/* Sides of a zonogon, and the shares of least squares that make a point of it (T18). Trusted are the
 * room for n generators, unit vectors, and that the point is in the face, but for rounding. Up to FEW
 * generators all sides are looked at, quadratic; more are sorted. Newton's method takes a few steps,
 * each linear but for a sort. Memory: 12 words a generator. */
#include <stdlib.h>

#include "face.h"
#include "vectors.h"

#define FEW 32         /* generators up to which every side is looked at */
#define EVEN_RAY 1e-14 /* sine of the angle below which a generator counts as along a side */
#define ON_SIDE 1e-13  /* relative distance from a side that is none */
#define SLIVER 100.0   /* length to width of a face that ends like a segment */
#define STEPS 100      /* of Newton's method, far more than it takes */
#define DWARF 1e-4     /* size, of the largest, to which what is rounding to it may be much */
#define PASSES 3       /* of refinement */
#define RESIDUAL 4e-16 /* relative residual that is rounding */
#define SINGULAR 1e-14 /* of a pivot: what rounding leaves of 0 */

Status face_room(Face *face, ptrdiff_t n) {
    size_t room = n > 0 ? (size_t)n : 1;
    *face = (Face){0};
    face->robot = malloc(room * sizeof *face->robot);
    face->c = malloc(5 * room * sizeof *face->c);
    face->crossings = malloc(2 * room * sizeof *face->crossings);
    if (!face->robot || !face->c || !face->crossings) {
        face_free(face);
        return NO_MEMORY;
    }
    face->size = face->c + 2 * room;
    face->share = face->c + 3 * room;
    face->along = face->c + 4 * room;
    return SOLVED;
}

void face_free(Face *face) {
    free(face->robot);
    free(face->c);
    free(face->crossings);
    *face = (Face){0};
}

static double dot2(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1]; }

void face_lay(Face *face, const double *normal, const double *units, const double *sizes) {
    const double x[3] = {1.0, 0.0, 0.0}, z[3] = {0.0, 0.0, 1.0};
    const double *along = fabs(normal[2]) < 0.8 ? z : x;
    double most = 0.0;
    face->largest = 0;
    for (ptrdiff_t i = 0; i < face->count; i++)
        if (sizes[face->robot[i]] > most) {
            face->largest = i;
            most = sizes[face->robot[i]];
            along = units + 3 * face->robot[i];
        }
    double off = dot(along, normal), size;
    for (int k = 0; k < 3; k++)
        face->e[k] = along[k] - off * normal[k];
    size = length(face->e);
    for (int k = 0; k < 3; k++)
        face->e[k] /= size;
    cross(normal, face->e, face->f);
    for (ptrdiff_t i = 0; i < face->count; i++) {
        const double *unit = units + 3 * face->robot[i];
        face->size[i] = sizes[face->robot[i]];
        face->c[2 * i] = face->size[i] * dot(unit, face->e);
        face->c[2 * i + 1] = face->size[i] * dot(unit, face->f);
    }
}

/* Look at the two sides with normals m and -m; keep the one that q is farthest beyond. */
static void look_at(const Face *face, const double *m, ptrdiff_t axis, const double *q,
                    double extent, Side *best) {
    double reach[2] = {0.0, 0.0}, along = dot2(m, q);
    for (ptrdiff_t i = 0; i < face->count; i++) {
        double p = dot2(m, face->c + 2 * i);
        if (fabs(p) > EVEN_RAY * face->size[i])
            reach[p < 0.0] += fabs(p);
    }
    for (int k = 0; k < 2; k++) {
        double sign = k ? -1.0 : 1.0, whole = extent + reach[k];
        double beyond = sign * along - reach[k], excess = whole > 0.0 ? beyond / whole : 0.0;
        if (excess > best->excess)
            *best = (Side){{sign * m[0], sign * m[1]}, beyond, excess, axis};
    }
}

/* Look at the sides along one generator. */
static void look_across(const Face *face, ptrdiff_t axis, const double *q, double extent,
                        Side *best) {
    const double *c = face->c + 2 * axis;
    double size = sqrt(dot2(c, c));
    const double m[2] = {-c[1] / size, c[0] / size};
    if (size > 0.0)
        look_at(face, m, axis, q, extent, best);
}

static int by_place(const void *a, const void *b) {
    double x = ((const Crossing *)a)->at, y = ((const Crossing *)b)->at;
    return (x > y) - (x < y);
}

/* The generator along the side that the ray from the face's centre to q leaves by; -1 if there is
 * none. Of all m with m.(q - centre) = 1 its normal has the least sum of |m.c_i|: a weighted
 * median. */
static ptrdiff_t crossed_side(Face *face, const double *q) {
    double ray[2] = {q[0], q[1]}, half = 0.0, size;
    ptrdiff_t count = 0;
    for (ptrdiff_t i = 0; i < face->count; i++) {
        ray[0] -= 0.5 * face->c[2 * i];
        ray[1] -= 0.5 * face->c[2 * i + 1];
    }
    size = sqrt(dot2(ray, ray));
    for (ptrdiff_t i = 0; i < face->count && size > 0.0; i++) {
        const double *c = face->c + 2 * i;
        double along = dot2(c, ray) / size, across = (c[1] * ray[0] - c[0] * ray[1]) / size;
        if (fabs(across) > EVEN_RAY * face->size[i]) {
            face->crossings[count++] = (Crossing){-along / across, fabs(across), i};
            half += 0.5 * fabs(across);
        }
    }
    if (count == 0)
        return -1;
    qsort(face->crossings, (size_t)count, sizeof *face->crossings, by_place);
    ptrdiff_t k = 0;
    for (double sum = face->crossings[0].weight; sum < half && k + 1 < count;)
        sum += face->crossings[++k].weight;
    return face->crossings[k].index;
}

Side face_side(Face *face, const double *q, double extent) {
    Side best = {{0.0, 0.0}, -INFINITY, -INFINITY, -1};
    if (face->count == 0) {
        double size = sqrt(dot2(q, q));
        if (size > 0.0)
            best = (Side){{q[0] / size, q[1] / size}, size, size / extent, -1};
        return best;
    }
    if (face->count <= FEW) {
        for (ptrdiff_t i = 0; i < face->count; i++)
            look_across(face, i, q, extent, &best);
    } else {
        ptrdiff_t axis = crossed_side(face, q);
        look_across(face, face->largest, q, extent, &best); /* it may be a segment */
        if (axis >= 0)
            look_across(face, axis, q, extent, &best);
    }
    if (best.excess < 1.0 / SLIVER) { /* it may be a segment, or a sliver, and q beyond its end */
        const double along[2] = {1.0, 0.0};
        Side end = {{0.0, 0.0}, 0.0, larger(OUTSIDE, SLIVER * best.excess), -1};
        double enough = end.excess;
        look_at(face, along, -1, q, extent, &end);
        if (end.excess > enough)
            best = end;
    }
    return best;
}

/* -- the least sum of squares ------------------------------------------------------------------ */

static double clip(double x) { return smaller(larger(x, 0.0), 1.0); }

/* Find the price of shares x_i = clip(price d_i) of numbers (n,) with sum x_i d_i = target: it rises
 * until those that are clipped at it were so before. */
static double price_along(const double *d, ptrdiff_t n, double target) {
    double sign = target < 0.0 ? -1.0 : 1.0, price = -1.0, next = 0.0;
    while (next > price) {
        double rest = sign * target, squares = 0.0;
        price = next;
        for (ptrdiff_t i = 0; i < n; i++) {
            double x = sign * d[i];
            if (x > 0.0 && price * x >= 1.0)
                rest -= x;
            else if (x > 0.0)
                squares += x * x;
        }
        if (squares > 0.0)
            next = rest / squares;
    }
    return sign * price;
}

/* Share out a point on a side: whoever is in front of it gives all, whoever is behind nothing, and
 * those along it share the rest. */
static void share_side(Face *face, const Side *side, const double *q, double *y) {
    const double *m = side->m, t[2] = {-m[1], m[0]};
    double rest = dot2(t, q);
    ptrdiff_t kept = 0;
    for (ptrdiff_t i = 0; i < face->count; i++) {
        double p = dot2(m, face->c + 2 * i), d = dot2(t, face->c + 2 * i);
        if (fabs(p) > EVEN_RAY * face->size[i]) {
            face->share[i] = p > 0.0;
            rest -= face->share[i] * d;
        } else {
            face->share[i] = -1.0;
            face->along[kept++] = d;
        }
    }
    double price = price_along(face->along, kept, rest);
    kept = 0;
    for (ptrdiff_t i = 0; i < face->count; i++)
        if (face->share[i] < 0.0)
            face->share[i] = clip(price * face->along[kept++]);
    y[0] = price * t[0];
    y[1] = price * t[1];
}

/* What is missing, q - sum x_i c_i, and what its rounding is relative to. */
static double missing(const Face *face, const double *q, double *left) {
    double whole = fabs(q[0]) + fabs(q[1]);
    left[0] = q[0];
    left[1] = q[1];
    for (ptrdiff_t i = 0; i < face->count; i++) {
        left[0] -= face->share[i] * face->c[2 * i];
        left[1] -= face->share[i] * face->c[2 * i + 1];
        whole += face->share[i] * face->size[i];
    }
    return whole;
}

/* Newton's direction: H d = left, with H the sum of c c' over those between 0 and 1. Where these all
 * have one direction, first along it and then, with nothing left there, across it: returns 0, as
 * then, and without any of them, d is a direction only. */
static int newton_direction(const Face *face, const double *left, double rounding, double *d) {
    double h[3] = {0.0};
    for (ptrdiff_t i = 0; i < face->count; i++) {
        const double *c = face->c + 2 * i;
        if (face->share[i] > 0.0 && face->share[i] < 1.0) {
            h[0] += c[0] * c[0];
            h[1] += c[0] * c[1];
            h[2] += c[1] * c[1];
        }
    }
    int p = h[0] < h[2]; /* the pivot, and the other one */
    double pivot = p ? h[2] : h[0], other = p ? h[0] : h[2];
    d[0] = left[0];
    d[1] = left[1];
    if (pivot <= 0.0)
        return 0;
    double factor = h[1] / pivot, rest = other - factor * h[1];
    if (rest > larger(SINGULAR * other, EVEN_RAY * EVEN_RAY * pivot)) {
        d[1 - p] = (left[1 - p] - factor * left[p]) / rest;
        d[p] = (left[p] - h[1] * d[1 - p]) / pivot;
        return 1;
    }
    double along = (left[p] + factor * left[1 - p]) / (1.0 + factor * factor);
    int is_along = fabs(along) > rounding;
    d[p] = is_along ? along / (pivot * (1.0 + factor * factor)) : left[p] - along;
    d[1 - p] = is_along ? factor * d[p] : left[1 - p] - factor * along;
    return is_along;
}

/* Climb as far along d as it goes. The slope falls, in linear pieces: a robot makes it fall while
 * its share is between 0 and 1. */
static double best_step(Face *face, const double *y, const double *left, const double *d) {
    double rise = dot2(left, d), fall = 0.0, step = 0.0, size = sqrt(dot2(d, d));
    ptrdiff_t count = 0, free = 0;
    for (ptrdiff_t i = 0; i < face->count; i++) {
        double pace = dot2(d, face->c + 2 * i), x = dot2(y, face->c + 2 * i);
        double begin = (pace > 0.0 ? -x : 1.0 - x) / pace, end = (pace > 0.0 ? 1.0 - x : -x) / pace;
        if (fabs(pace) <= NOISE * size * face->size[i] || end <= 0.0)
            continue;
        face->crossings[count++] = (Crossing){larger(begin, 0.0), pace * pace, 1};
        face->crossings[count++] = (Crossing){end, -pace * pace, -1};
    }
    qsort(face->crossings, (size_t)count, sizeof *face->crossings, by_place);
    for (const Crossing *at = face->crossings; at < face->crossings + count; at++) {
        double drop = fall * (at->at - step);
        if (drop >= rise)
            return step + rise / fall;
        rise -= drop;
        step = at->at;
        free += at->index;
        fall = free ? fall + at->weight : 0.0;
    }
    return step; /* nobody can give more */
}

/* Share out a point inside the face, by Newton's method on the dual: x_i = clip(y.c_i). */
static void share_inside(Face *face, const double *q, double *y) {
    double left[2], d[2], whole, rounding;
    int more = 0; /* steps after what is rounding to giants, and may be much to dwarfs */
    for (ptrdiff_t i = 0; i < face->count; i++)
        if (face->size[i] < DWARF)
            more = PASSES;
    for (int k = 0; k < STEPS; k++) {
        double blur = 0.0; /* what rounding of y does */
        for (ptrdiff_t i = 0; i < face->count; i++) {
            face->share[i] = clip(dot2(y, face->c + 2 * i));
            if (face->share[i] > 0.0 && face->share[i] < 1.0)
                blur += face->size[i] * face->size[i];
        }
        whole = missing(face, q, left);
        rounding = RESIDUAL * (whole + blur * sqrt(dot2(y, y)));
        if (sqrt(dot2(left, left)) <= rounding && more-- == 0)
            break;
        newton_direction(face, left, rounding, d);
        double step = best_step(face, y, left, d);
        if (!(step * (fabs(d[0]) + fabs(d[1])) > 0.0))
            break;
        y[0] += step * d[0];
        y[1] += step * d[1];
    }
    /* the shares take up what a large y leaves */
    for (int k = 0; k < PASSES && newton_direction(face, left, RESIDUAL * whole, d); k++) {
        for (ptrdiff_t i = 0; i < face->count; i++)
            if (face->share[i] > 0.0 && face->share[i] < 1.0)
                face->share[i] = clip(face->share[i] + dot2(d, face->c + 2 * i));
        whole = missing(face, q, left);
    }
}

/* Share out a point inside the parallelogram of two, directly; what rounding leaves, once more. */
static void share_two(Face *face, const double *q, double *y) {
    const double *a = face->c, *b = face->c + 2;
    double area = a[0] * b[1] - a[1] * b[0], *x = face->share, left[2];
    x[0] = x[1] = 0.0;
    for (int k = 0; k < PASSES; k++) {
        missing(face, q, left);
        x[0] = clip(x[0] + (left[0] * b[1] - left[1] * b[0]) / area);
        x[1] = clip(x[1] + (a[0] * left[1] - a[1] * left[0]) / area);
    }
    y[0] = (x[0] * b[1] - x[1] * a[1]) / area;
    y[1] = (x[1] * a[0] - x[0] * b[0]) / area;
}

void face_shares(Face *face, const double *q, double extent, double *m, double *y) {
    double largest = 0.0, target[2] = {q[0], q[1]}, price[2] = {0.0, 0.0};
    for (int k = 0; k < 3; k++)
        m[k] = y[k] = 0.0;
    for (ptrdiff_t i = 0; i < face->count; i++)
        largest = larger(largest, face->size[i]);
    if (largest == 0.0)
        return;
    for (ptrdiff_t i = 0; i < face->count; i++) {
        face->c[2 * i] /= largest;
        face->c[2 * i + 1] /= largest;
        face->size[i] /= largest;
    }
    target[0] /= largest;
    target[1] /= largest;
    Side side = face_side(face, target, extent / largest);
    if (side.excess >= -ON_SIDE) {
        share_side(face, &side, target, price);
        for (int k = 0; k < 3; k++)
            m[k] = side.m[0] * face->e[k] + side.m[1] * face->f[k];
    } else if (face->count == 2) {
        share_two(face, target, price);
    } else {
        share_inside(face, target, price);
    }
    for (int k = 0; k < 3; k++)
        y[k] = (price[0] * face->e[k] + price[1] * face->f[k]) / largest;
}
