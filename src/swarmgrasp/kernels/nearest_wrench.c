/* The nearest wrench to one out of reach: Wolfe's method, whose corners are supports (T27). */
#include "pushers.h"

#include <string.h>

#define CORNERS 4
#define STEPS 1000   /* some 20 are usual */
#define SQUARE 1e-9  /* sine between directions that span a plane */
#define ENOUGH 1e-12 /* of the total: a gap that is none */

/* Find the affine combination of corners nearest to a target: by directions from the first corner,
 * each across those before. Tells whether the corners are independent. */
static int nearest_affine(const Column *corner, int count, const double *target, double *weight) {
    double unit[3][3], to[3], part[3][3] = {{0.0}}, along_unit[3];
    for (int c = 0; c < 3; c++)
        to[c] = target[c] - corner[0].wrench[c];
    for (int k = 0; k + 1 < count; k++) {
        double v[3];
        for (int c = 0; c < 3; c++)
            v[c] = corner[k + 1].wrench[c] - corner[0].wrench[c];
        double size = length(v);
        for (int twice = 0; twice < 2; twice++)
            for (int j = 0; j < k; j++) {
                double on = dot(v, unit[j]);
                part[j][k] += on;
                for (int c = 0; c < 3; c++)
                    v[c] -= on * unit[j][c];
            }
        part[k][k] = length(v);
        if (!(part[k][k] > FLAT * size))
            return 0;
        for (int c = 0; c < 3; c++)
            unit[k][c] = v[c] / part[k][k];
        along_unit[k] = dot(to, unit[k]);
        for (int c = 0; c < 3; c++)
            to[c] -= along_unit[k] * unit[k][c];
    }
    weight[0] = 1.0;
    for (int k = count - 2; k >= 0; k--) {
        double left = along_unit[k];
        for (int j = k + 1; j + 1 < count; j++)
            left -= part[k][j] * weight[j + 1];
        weight[k + 1] = left / part[k][k];
        weight[0] -= weight[k + 1];
    }
    return 1;
}

/* Turn a unit normal square to what the corners span: near to the target its own rounding is what
 * matters. */
static void square(const Column *corner, int count, double *normal) {
    double unit[3][3], turned[3] = {normal[0], normal[1], normal[2]};
    for (int k = 0; k + 1 < count; k++) {
        double *v = unit[k], size = 0.0;
        for (int c = 0; c < 3; c++)
            v[c] = corner[k + 1].wrench[c] - corner[0].wrench[c];
        size = length(v);
        for (int j = 0; j < 2 * k; j++) {
            double on = dot(v, unit[j % k]);
            for (int c = 0; c < 3; c++)
                v[c] -= on * unit[j % k][c];
        }
        double left = length(v);
        if (!(left > SQUARE * size))
            return;
        for (int c = 0; c < 3; c++)
            v[c] /= left;
        double on = dot(turned, v);
        for (int c = 0; c < 3; c++)
            turned[c] -= on * v[c];
    }
    double left = length(turned);
    for (int c = 0; c < 3 && left > 0.5; c++)
        normal[c] = turned[c] / left;
}

/* Leave out a corner; its place goes last, to be used again. */
static void leave_out(Column *corner, double *weight, int *count, int which) {
    Column gone = corner[which];
    for (int k = which; k + 1 < CORNERS + 1; k++)
        corner[k] = corner[k + 1];
    corner[CORNERS] = gone;
    for (int k = which; k + 1 < *count; k++)
        weight[k] = weight[k + 1];
    --*count;
}

/* Find the point nearest to the target in the hull of the corners; those it does not need are left
 * out. The last is new, with weight 0. Tells whether it is of use. */
static int approach(Column *corner, double *weight, int *count, const double *target) {
    for (;;) {
        double best[CORNERS], step = 1.0;
        int first = -1;
        if (!nearest_affine(corner, *count, target, best))
            return 0;
        for (int k = 0; k < *count; k++)
            if (best[k] < 0.0 && weight[k] <= step * (weight[k] - best[k])) {
                step = weight[k] / (weight[k] - best[k]);
                first = k;
            }
        for (int k = 0; k < *count; k++)
            weight[k] += step * (best[k] - weight[k]);
        if (first < 0)
            return 1;
        leave_out(corner, weight, count, first);
    }
}

Status nearest_wrench(const Pushers *p, const double *target, Work *work, Column *found,
                      double *normal, double *beyond) {
    Column corner[CORNERS + 1];
    double weight[CORNERS + 1] = {1.0}, least = INFINITY, n[3];
    int count = 1;
    for (int k = 0; k <= CORNERS; k++)
        corner[k].force = p->room + 2 * (ptrdiff_t)p->count * k;
    push_along(p, target, &corner[0]);
    for (int step = 0; step < STEPS; step++) {
        double at[3] = {0.0};
        Status status = spend(work, 16.0 * p->count + 100.0);
        if (status != SOLVED)
            return status;
        for (int k = 0; k < count; k++)
            for (int c = 0; c < 3; c++)
                at[c] += weight[k] * corner[k].wrench[c];
        for (int c = 0; c < 3; c++)
            n[c] = target[c] - at[c];
        double away = length(n);
        if (!(away > 0.0))
            break;
        for (int c = 0; c < 3; c++)
            n[c] /= away;
        square(corner, count, n);
        Column *next = corner + count;
        double gap = push_along(p, n, next) - dot(n, at);
        if (gap < least) {
            least = gap;
            *beyond = gap;
            memcpy(normal, n, sizeof n);
            memcpy(found->wrench, at, sizeof at);
            for (int i = 0; i < 2 * p->count; i++) {
                found->force[i] = 0.0;
                for (int k = 0; k < count; k++)
                    found->force[i] += weight[k] * corner[k].force[i];
            }
        }
        if (gap <= ENOUGH * p->total || count == CORNERS)
            break;
        weight[count++] = 0.0;
        if (!approach(corner, weight, &count, target))
            break;
    }
    return SOLVED;
}
