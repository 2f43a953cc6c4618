/* The exact quality: all planes swept for small swarms, a search on the sphere for large ones (T1).
 * Trusted are finite numbers, and room in the sweep if it is used. */
#include "quality.h"
#include "vectors.h"

/* A unit vector across the largest generator; the last axis if there is none. */
static void across_largest(const double *generators, int n, double *normal) {
    double b[3] = {1.0, 0.0, 0.0}, most = 0.0;
    for (int i = 0; i < n; i++)
        if (length(generators + 3 * i) > most) {
            most = length(generators + 3 * i);
            for (int k = 0; k < 3; k++)
                b[k] = generators[3 * i + k] / most;
        }
    double axis[3] = {0.0, 0.0, 1.0};
    if (fabs(b[2]) > 0.8) { /* nearly along it */
        axis[1] = 1.0;
        axis[2] = 0.0;
    }
    double along = dot(axis, b), size;
    for (int k = 0; k < 3; k++)
        normal[k] = axis[k] - along * b[k];
    size = length(normal);
    for (int k = 0; k < 3; k++)
        normal[k] /= size;
}

void round_quality(const double *generators, int n, double size, double *quality,
                   double *weakest) {
    if (*quality == INFINITY)
        across_largest(generators, n, weakest);
    if (*quality == INFINITY || *quality <= ZERO * size)
        *quality = 0.0;
}

Status exact_quality(Sweep *sweep, const double *generators, int n, Work *work, double *quality,
                     double *bound, double *weakest) {
    double size = total_size(generators, n);
    Status status = SOLVED;
    if (n <= SWEPT) {
        *quality = *bound = sweep_all(sweep, generators, n, weakest);
    } else {
        Tree tree;
        Sphere sphere;
        status = tree_build(&tree, generators, n, sweep->load, work);
        if (status != SOLVED)
            return status;
        status = sphere_search(&sphere, &tree, NULL, 0, NULL, 0.0, INFINITY, ZERO * size, work);
        *quality = sphere.best;
        *bound = sphere.bound;
        if (*quality < INFINITY)
            sphere_best(&sphere, weakest);
        sphere_free(&sphere);
        tree_free(&tree);
    }
    round_quality(generators, n, size, quality, weakest);
    *bound = larger(0.0, smaller(*bound, *quality));
    return status;
}
