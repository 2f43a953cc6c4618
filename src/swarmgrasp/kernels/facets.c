#include <stdlib.h>
#include <string.h>

#include "facets.h"
#include "vectors.h"

#define PARALLEL 1e-14 /* sine of the angle below which two generators count as parallel */
#define LAST 4.0       /* sorts behind all angles */
#define NOISE 1e-15    /* of a product n . b: what is left of 0 where b lies in the facet */
#define ROUNDING 1e-15 /* of sum |b_i|: the error of the running sums */
#define COARSE 1e-12   /* of the quality: the error that calls for a direct sum instead */

int sweep_room(Sweep *sweep, ptrdiff_t n) {
    size_t room = n > 0 ? (size_t)n : 1;
    sweep->flat = malloc(room * (4 + 6 + 2) * sizeof *sweep->flat);
    sweep->order = malloc(room * sizeof *sweep->order);
    if (!sweep->flat || !sweep->order) {
        sweep_free(sweep);
        return -1;
    }
    sweep->normals = sweep->flat + 4 * room;
    sweep->heights = sweep->normals + 6 * room;
    return 0;
}

void sweep_free(Sweep *sweep) {
    free(sweep->flat);
    free(sweep->order);
    memset(sweep, 0, sizeof *sweep);
}

/* Sort indices by the last of each one's four numbers, by Shell's method. */
static void sort_order(const double *flat, int *order, int n) {
    int gap = 1;
    while (9 * gap < 4 * n)
        gap = (9 * gap + 4) / 4;
    for (int i = 0; i < n; i++)
        order[i] = i;
    for (; gap > 0; gap = gap > 1 ? (4 * gap / 9 > 1 ? 4 * gap / 9 : 1) : 0)
        for (int i = gap; i < n; i++) {
            int moved = order[i], j = i;
            double key = flat[4 * moved + 3];
            for (; j >= gap && flat[4 * order[j - gap] + 3] > key; j -= gap)
                order[j] = order[j - gap];
            order[j] = moved;
        }
}

int sweep_plane(Sweep *sweep, const double *generators, int n, const double *axis, int first) {
    /* an orthonormal basis (e, f) of the plane, without branches (Duff et al. 2017) */
    double size = length(axis), x = axis[0] / size, y = axis[1] / size, z = axis[2] / size;
    double sign = copysign(1.0, z), a = -1.0 / (sign + z), b = x * y * a;
    double e[3] = {1.0 + sign * x * x * a, sign * b, -sign * x};
    double f[3] = {b, sign + y * y * a, -y};
    double sum_u = 0.0, sum_v = 0.0, fold_u = 0.0, fold_v = 0.0;
    for (int i = 0; i < n; i++) {
        const double *g = generators + 3 * i;
        double u = dot(g, e), v = dot(g, f), *row = sweep->flat + 4 * i;
        sum_u += u;
        sum_v += v;
        /* flip first, then take the angle: folding an angle modulo pi misorders axis-aligned input */
        if (v < 0.0 || (v == 0.0 && u < 0.0)) {
            u = -u;
            v = -v;
        }
        fold_u += u;
        fold_v += v;
        row[0] = u;
        row[1] = v;
        row[2] = sqrt(u * u + v * v);
        if (row[2] <= PARALLEL * (fabs(g[0]) + fabs(g[1]) + fabs(g[2])))
            row[3] = LAST;
        else
            row[3] = -u / (u >= 0.0 ? u + v : v - u);
    }
    sort_order(sweep->flat, sweep->order, n);
    int found = 0;
    for (int i = 0; i < n; i++) {
        int k = sweep->order[i];
        const double *row = sweep->flat + 4 * k;
        if (row[3] == LAST)
            break;
        double u = row[0], v = row[1];
        if (k >= first) {
            double width = (u * fold_v - v * fold_u) / row[2];
            double skew = (u * sum_v - v * sum_u) / row[2];
            double *normal = sweep->normals + 3 * found;
            for (int c = 0; c < 3; c++) {
                normal[c] = (u * f[c] - v * e[c]) / row[2];
                normal[c + 3] = -normal[c];
            }
            sweep->heights[found] = larger(0.0, 0.5 * (width + skew));
            sweep->heights[found + 1] = larger(0.0, 0.5 * (width - skew));
            found += 2;
        }
        fold_u -= 2.0 * u;
        fold_v -= 2.0 * v;
    }
    return found;
}

/* h(n) term by term: one giant among dwarfs leaves running sums with its own rounding only. */
static double direct_height(const double *generators, int n, const double *normal) {
    double h = 0.0;
    for (int i = 0; i < n; i++) {
        const double *b = generators + 3 * i;
        double x = normal[0] * b[0], y = normal[1] * b[1], z = normal[2] * b[2];
        if (x + y + z > NOISE * (fabs(x) + fabs(y) + fabs(z)))
            h += x + y + z;
    }
    return h;
}

double sweep_facets(Sweep *sweep, const double *generators, int n, double *weakest,
                    double *normals, double *heights, ptrdiff_t *count) {
    double quality = INFINITY, error = 0.0;
    ptrdiff_t total = 0;
    for (int i = 0; i < n; i++)
        error += ROUNDING * length(generators + 3 * i);
    weakest[0] = weakest[1] = weakest[2] = 0.0;
    for (int j = 0; j < n; j++) {
        const double *b = generators + 3 * j;
        if (b[0] == 0.0 && b[1] == 0.0 && b[2] == 0.0)
            continue;
        int found = sweep_plane(sweep, generators, n, b, j + 1);
        for (int k = 0; k < found; k++) {
            const double *normal = sweep->normals + 3 * k;
            if (sweep->heights[k] < quality + error && error > COARSE * quality)
                sweep->heights[k] = direct_height(generators, n, normal);
            if (sweep->heights[k] < quality) {
                quality = sweep->heights[k];
                memcpy(weakest, normal, 3 * sizeof *weakest);
            }
        }
        if (normals) {
            memcpy(normals + 3 * total, sweep->normals, 3 * (size_t)found * sizeof *normals);
            memcpy(heights + total, sweep->heights, (size_t)found * sizeof *heights);
            total += found;
        }
    }
    if (count)
        *count = total;
    return quality;
}

double support(const double *generators, ptrdiff_t n, const double *normal) {
    double h = 0.0;
    for (ptrdiff_t i = 0; i < n; i++)
        h += larger(0.0, dot(normal, generators + 3 * i));
    return h;
}
