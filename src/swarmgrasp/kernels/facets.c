/* Sweeps round an axis: the generators' rays in the plane across it, sorted by angle, give h at all
 * normals in that plane from running sums (T2, T11). Trusted are room for n generators, finite numbers
 * and an axis that is not 0. Sorting is quadratic, at its best for n up to a few hundred; all planes
 * take n of that, and have n (n - 1) facets. Memory: 16 words a generator. */
#include <stdlib.h>
#include <string.h>

#include "facets.h"
#include "vectors.h"

#define PARALLEL 1e-14  /* sine of the angle below which two generators count as parallel */
#define SUM_ERROR 1e-15 /* of sum |b_i|: the error of the running sums */
#define INEXACT 1e-12   /* of h: the error that calls for a direct sum instead */

Status sweep_room(Sweep *sweep, ptrdiff_t n, const double *load) {
    size_t room = n > 0 ? (size_t)n : 1;
    *sweep = (Sweep){.load = {load[0], load[1], load[2]}};
    sweep->normals = malloc(9 * room * sizeof *sweep->normals);
    sweep->ray = malloc(2 * room * sizeof *sweep->ray);
    sweep->rank = malloc(room * sizeof *sweep->rank);
    if (!sweep->normals || !sweep->ray || !sweep->rank) {
        sweep_free(sweep);
        return NO_MEMORY;
    }
    sweep->heights = sweep->normals + 6 * room;
    sweep->angle = sweep->heights + 2 * room;
    sweep->sorted = sweep->ray + room;
    return SOLVED;
}

void sweep_free(Sweep *sweep) {
    free(sweep->ray);
    free(sweep->rank);
    free(sweep->normals);
    *sweep = (Sweep){0};
}

/* Sort rays by angle: each goes behind as many as there are before it. Quadratic, but without a
 * branch that could be guessed wrongly, and several comparisons at a time. */
static void sort_rays(Sweep *sweep, int n) {
    const double *angle = sweep->angle;
    int64_t *rank = sweep->rank;
    for (int i = 0; i < n; i++) {
        int64_t before = 0;
        for (int j = 0; j < i; j++) {
            int64_t is_before = angle[j] <= angle[i];
            before += is_before;
            rank[j] += 1 - is_before;
        }
        rank[i] = before;
    }
    for (int i = 0; i < n; i++)
        sweep->sorted[rank[i]] = sweep->ray[i];
}

/* An orthonormal basis (e, f) of a plane, and sums over the generators in it. */
typedef struct {
    double e[3], f[3];
    double sum_u, sum_v;   /* of all */
    double fold_u, fold_v; /* of all, turned to the upper half */
    int rays;              /* those not along the axis */
} Plane;

/* Project the generators to the plane across an axis, and sort them by angle. */
static Plane lay_rays(Sweep *sweep, const double *generators, int n, const double *axis) {
    /* a basis without branches (Duff et al. 2017) */
    double size = length(axis), x = axis[0] / size, y = axis[1] / size, z = axis[2] / size;
    double sign = copysign(1.0, z), a = -1.0 / (sign + z), b = x * y * a;
    Plane plane = {
        .e = {1.0 + sign * x * x * a, sign * b, -sign * x},
        .f = {b, sign + y * y * a, -y},
    };
    /* a load adds as much along n as it takes away along -n: twice its part of the sum does so */
    plane.sum_u = 2.0 * dot(sweep->load, plane.e);
    plane.sum_v = 2.0 * dot(sweep->load, plane.f);
    for (int i = 0; i < n; i++) {
        const double *g = generators + 3 * i;
        double u = dot(g, plane.e), v = dot(g, plane.f);
        plane.sum_u += u;
        plane.sum_v += v;
        /* flip first, then take the angle: folding an angle modulo pi misorders axis-aligned input */
        if (v < 0.0 || (v == 0.0 && u < 0.0)) {
            u = -u;
            v = -v;
        }
        plane.fold_u += u;
        plane.fold_v += v;
        double across = fabs(u) + v;
        if (across > PARALLEL * (fabs(g[0]) + fabs(g[1]) + fabs(g[2]))) {
            sweep->angle[plane.rays] = -u / across;
            sweep->ray[plane.rays++] = (Ray){u, v, i};
        }
    }
    sort_rays(sweep, plane.rays);
    return plane;
}

/* The unit normal across a ray. */
static void normal_across(const Plane *plane, const Ray *ray, double sign, double *normal) {
    double scale = sign / sqrt(ray->u * ray->u + ray->v * ray->v);
    for (int c = 0; c < 3; c++)
        normal[c] = (ray->u * plane->f[c] - ray->v * plane->e[c]) * scale;
}

/* h(n) term by term: one giant among dwarfs leaves running sums with its own rounding only. */
static double direct_height(const Sweep *sweep, const double *generators, int n,
                            const double *normal) {
    double h = dot(sweep->load, normal);
    for (int i = 0; i < n; i++) {
        const double *b = generators + 3 * i;
        double x = normal[0] * b[0], y = normal[1] * b[1], z = normal[2] * b[2];
        if (x + y + z > NOISE * (fabs(x) + fabs(y) + fabs(z)))
            h += x + y + z;
    }
    return h;
}

int sweep_plane(Sweep *sweep, const double *generators, int n, const double *axis, int first,
                double error) {
    Plane plane = lay_rays(sweep, generators, n, axis);
    double fold_u = plane.fold_u, fold_v = plane.fold_v;
    int found = 0;
    for (const Ray *ray = sweep->sorted; ray < sweep->sorted + plane.rays; ray++) {
        if (ray->index >= first) {
            double scale = 0.5 / sqrt(ray->u * ray->u + ray->v * ray->v);
            double width = (ray->u * fold_v - ray->v * fold_u) * scale;
            double skew = (ray->u * plane.sum_v - ray->v * plane.sum_u) * scale;
            normal_across(&plane, ray, 1.0, sweep->normals + 3 * found);
            normal_across(&plane, ray, -1.0, sweep->normals + 3 * found + 3);
            sweep->heights[found] = width + skew;
            sweep->heights[found + 1] = width - skew;
            for (int k = found; k < found + 2; k++)
                if (error > INEXACT * sweep->heights[k])
                    sweep->heights[k] = direct_height(sweep, generators, n,
                                                      sweep->normals + 3 * k);
            found += 2;
        }
        fold_u -= 2.0 * ray->u;
        fold_v -= 2.0 * ray->v;
    }
    return found;
}

double sweep_least(Sweep *sweep, const double *generators, int n, const double *axis, int first,
                   double least, double error, double *normal) {
    Plane plane = lay_rays(sweep, generators, n, axis);
    double fold_u = plane.fold_u, fold_v = plane.fold_v;
    for (const Ray *ray = sweep->sorted; ray < sweep->sorted + plane.rays; ray++) {
        double width = ray->u * fold_v - ray->v * fold_u;
        double skew = ray->u * plane.sum_v - ray->v * plane.sum_u;
        double twice = width - fabs(skew), limit = 2.0 * (least + error);
        /* |u| + v is not less than the ray's length: hardly ever is there a root to take */
        if (ray->index >= first && twice < limit * (fabs(ray->u) + ray->v)) {
            double height = 0.5 * twice / sqrt(ray->u * ray->u + ray->v * ray->v), trial[3];
            normal_across(&plane, ray, skew > 0.0 ? -1.0 : 1.0, trial);
            if (error > INEXACT * least)
                height = direct_height(sweep, generators, n, trial);
            if (height < least) {
                least = height;
                for (int c = 0; c < 3; c++)
                    normal[c] = trial[c];
            }
        }
        fold_u -= 2.0 * ray->u;
        fold_v -= 2.0 * ray->v;
    }
    return least;
}

double sweep_error(double size) { return SUM_ERROR * size; }

static int is_zero(const double *b) { return b[0] == 0.0 && b[1] == 0.0 && b[2] == 0.0; }

double sweep_all(Sweep *sweep, const double *generators, int n, double *weakest) {
    double quality = INFINITY, error = sweep_error(total_size(generators, n));
    weakest[0] = weakest[1] = weakest[2] = 0.0;
    for (int j = 0; j < n; j++)
        if (!is_zero(generators + 3 * j))
            quality = sweep_least(sweep, generators, n, generators + 3 * j, j + 1, quality, error,
                                  weakest);
    return quality;
}

ptrdiff_t sweep_facets(Sweep *sweep, const double *generators, int n, double *normals,
                       double *heights) {
    ptrdiff_t total = 0;
    double error = sweep_error(total_size(generators, n));
    for (int j = 0; j < n; j++)
        if (!is_zero(generators + 3 * j)) {
            size_t found = (size_t)sweep_plane(sweep, generators, n, generators + 3 * j, j + 1,
                                               error);
            memcpy(normals + 3 * total, sweep->normals, 3 * found * sizeof *normals);
            memcpy(heights + total, sweep->heights, found * sizeof *heights);
            total += (ptrdiff_t)found;
        }
    return total;
}

double total_height(const double *generators, ptrdiff_t n, const double *normal) {
    double h = 0.0;
    for (ptrdiff_t i = 0; i < n; i++)
        h += larger(0.0, dot(normal, generators + 3 * i));
    return h;
}
