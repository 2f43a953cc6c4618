/* Vectors in three dimensions, and memory that may run out. */
#ifndef SWARMGRASP_VECTORS_H
#define SWARMGRASP_VECTORS_H

#include <math.h>
#include <stddef.h>

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

static inline double larger(double a, double b) { return a > b ? a : b; }

static inline double smaller(double a, double b) { return a < b ? a : b; }

#endif
