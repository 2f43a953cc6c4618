/* Vectors in three dimensions, and a few numbers. Nothing is checked. */
#ifndef SWARMGRASP_VECTORS_H
#define SWARMGRASP_VECTORS_H

#include <math.h>
#include <stddef.h>

#define PI 3.14159265358979323846
#define NOISE 1e-15 /* of a product of vectors at right angles: what rounding leaves of 0 */

static inline double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const double *a, const double *b, double *out) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void add(double *a, const double *b) {
    a[0] += b[0];
    a[1] += b[1];
    a[2] += b[2];
}

static inline double length(const double *a) { return sqrt(dot(a, a)); }

/* The sum of |b_i| of generators (n, 3). */
static inline double total_size(const double *generators, ptrdiff_t n) {
    double size = 0.0;
    for (ptrdiff_t i = 0; i < n; i++)
        size += length(generators + 3 * i);
    return size;
}

/* The k-th of some unit vectors spread evenly over the sphere, on a Fibonacci spiral. */
static inline void on_spiral(int k, int count, double *v) {
    double z = 1.0 - (2.0 * k + 1.0) / count, radius = sqrt(1.0 - z * z);
    double turn = k * PI * (3.0 - sqrt(5.0));
    v[0] = radius * cos(turn);
    v[1] = radius * sin(turn);
    v[2] = z;
}

static inline double larger(double a, double b) { return a > b ? a : b; }

static inline double smaller(double a, double b) { return a < b ? a : b; }

#endif
