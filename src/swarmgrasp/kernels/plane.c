/* The least of a curved function over a triangle. Where one linear function is the highest is a convex
 * polygon; there the least of it and the quadratic one is where its slope vanishes, on an edge or at
 * a corner. Trusted are finite numbers and 1 to CUTS functions: some 100 ns for three. */
#include <math.h>
#include <string.h>

#include "plane.h"

/* Keep the part of a polygon in which a linear function is not negative. Returns whether any is lost. */
static int clip(Polygon *polygon, const Cut *side) {
    Polygon left;
    double at[3 + CUTS];
    int below = 0;
    for (int i = 0; i < polygon->count; i++) {
        at[i] = cut_at(side, polygon->at[i]);
        below += at[i] < 0.0;
    }
    if (below == 0)
        return 0;
    left.count = 0;
    for (int i = 0; i < polygon->count && below < polygon->count; i++) {
        int j = i + 1 < polygon->count ? i + 1 : 0;
        const double *p = polygon->at[i], *q = polygon->at[j];
        if (at[i] >= 0.0 && left.count < 3 + CUTS)
            memcpy(left.at[left.count++], p, sizeof left.at[0]);
        if ((at[i] < 0.0) != (at[j] < 0.0) && at[i] != 0.0 && at[j] != 0.0 && left.count < 3 + CUTS) {
            double share = at[i] / (at[i] - at[j]);
            for (int k = 0; k < 2; k++)
                left.at[left.count][k] = p[k] + share * (q[k] - p[k]);
            left.count++;
        }
    }
    polygon->count = left.count;
    memcpy(polygon->at, left.at, (size_t)left.count * sizeof left.at[0]);
    return 1;
}

static void note(double value, const double *d, double *least, double *where) {
    if (value < *least) {
        *least = value;
        where[0] = d[0];
        where[1] = d[1];
    }
}

/* Tell whether a point lies in a polygon, either way around, even if that is next to a line. */
static int is_within(const Polygon *polygon, const double *d) {
    int left = 0, right = 0, above[2] = {0, 0}, below[2] = {0, 0};
    for (int i = 0; i < polygon->count; i++) {
        const double *p = polygon->at[i], *q = polygon->at[i + 1 < polygon->count ? i + 1 : 0];
        double turn = (q[0] - p[0]) * (d[1] - p[1]) - (q[1] - p[1]) * (d[0] - p[0]);
        left |= turn > 0.0;
        right |= turn < 0.0;
        for (int k = 0; k < 2; k++) {
            above[k] |= d[k] <= p[k];
            below[k] |= d[k] >= p[k];
        }
    }
    return !(left && right) && above[0] && below[0] && above[1] && below[1];
}

/* Find the least of one linear function and the quadratic one over a polygon. */
static void least_on_polygon(const Polygon *polygon, const Cut *cut, const double *bend, double *least,
                             double *where) {
    double det = bend[0] * bend[2] - bend[1] * bend[1];
    if (bend[0] > 0.0 && det > 0.0) {
        double d[2] = {(bend[1] * cut->b[1] - bend[2] * cut->b[0]) / det,
                       (bend[1] * cut->b[0] - bend[0] * cut->b[1]) / det};
        if (is_within(polygon, d)) {
            note(cut_at(cut, d) + bend_at(bend, d), d, least, where);
            return;
        }
    }
    for (int i = 0; i < polygon->count; i++) {
        const double *p = polygon->at[i], *q = polygon->at[i + 1 < polygon->count ? i + 1 : 0];
        double e[2] = {q[0] - p[0], q[1] - p[1]};
        double ne[2] = {bend[0] * e[0] + bend[1] * e[1], bend[1] * e[0] + bend[2] * e[1]};
        double slope = cut->b[0] * e[0] + cut->b[1] * e[1] + p[0] * ne[0] + p[1] * ne[1];
        double curve = e[0] * ne[0] + e[1] * ne[1];
        note(cut_at(cut, p) + bend_at(bend, p), p, least, where);
        if (slope < 0.0 && slope + curve > 0.0) {
            double s = -slope / curve, d[2] = {p[0] + s * e[0], p[1] + s * e[1]};
            note(cut_at(cut, d) + bend_at(bend, d), d, least, where);
        }
    }
}

/* Look at one part anew. */
static void look_at(Roof *roof, int k) {
    roof->least[k] = INFINITY;
    least_on_polygon(roof->part + k, roof->cut + k, roof->bend, roof->least + k, roof->where[k]);
}

void roof_begin(Roof *roof, double corner[3][2], const double *bend) {
    roof->cuts = 0;
    memcpy(roof->corner, corner, sizeof roof->corner);
    memcpy(roof->bend, bend, sizeof roof->bend);
}

void roof_add(Roof *roof, const Cut *cut) {
    int last = roof->cuts++;
    Polygon *own = roof->part + last;
    roof->cut[last] = *cut;
    own->count = 3;
    memcpy(own->at, roof->corner, sizeof roof->corner);
    for (int k = 0; k < last; k++) {
        const Cut *other = roof->cut + k;
        Cut over = {cut->a - other->a, {cut->b[0] - other->b[0], cut->b[1] - other->b[1]}};
        Cut under = {-over.a, {-over.b[0], -over.b[1]}};
        if (own->count)
            clip(own, &over);
        if (roof->part[k].count && clip(roof->part + k, &under))
            look_at(roof, k);
    }
    look_at(roof, last);
}

double roof_least(const Roof *roof, double *where) {
    double least = INFINITY;
    for (int k = 0; k < roof->cuts; k++)
        note(roof->least[k], roof->where[k], &least, where);
    return least;
}

double roof_least_with(const Roof *roof, const double *bend) {
    double least = INFINITY, where[2];
    for (int k = 0; k < roof->cuts; k++)
        least_on_polygon(roof->part + k, roof->cut + k, bend, &least, where);
    return least;
}
