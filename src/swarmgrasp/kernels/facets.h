/* Facets of a wrench set, one plane across a generator at a time (T2, T11). Numbers are finite, and the
 * room is for as many generators as are given: nothing is checked. For up to a few hundred. */
#ifndef SWARMGRASP_FACETS_H
#define SWARMGRASP_FACETS_H

#include <stddef.h>
#include <stdint.h>

#include "status.h"

/* A generator in the plane, turned to the upper half. */
typedef struct {
    double u, v;
    int index;
} Ray;

/* Room for one sweep over n generators, and the steady wrench beside them:
 * h(n) = n . load + sum max(0, n . b_i). */
typedef struct {
    double load[3];
    Ray *ray;        /* (n,) */
    Ray *sorted;     /* (n,) by angle */
    double *angle;   /* (n,) what grows with it, from -1 to 1 */
    int64_t *rank;   /* (n,) */
    double *normals; /* (2 n, 3) found, each followed by its negative */
    double *heights; /* (2 n,) h at them */
} Sweep;

Status sweep_room(Sweep *sweep, ptrdiff_t n, const double *load);
void sweep_free(Sweep *sweep);

/* Find h at the unit normals orthogonal to `axis` and to one of the generators (n, 3) each, from
 * the one with index `first`. The axis is not zero. Returns how many normals were found;
 * generators parallel to the axis give none. `error` is that of a sum over the generators, see
 * `sweep_error`: where it matters, h is added up directly. */
int sweep_plane(Sweep *sweep, const double *generators, int n, const double *axis, int first,
                double error);

/* Find the least h at these normals and its normal, if it is below `least`; return the lower of
 * the two. Below 0, where a load is not held, any value will do. */
double sweep_least(Sweep *sweep, const double *generators, int n, const double *axis, int first,
                   double least, double error, double *normal);
double sweep_error(double size); /* size: the sum of |b_i| */

/* Find the least h over all facet normals, INFINITY if no two generators span a plane. */
double sweep_all(Sweep *sweep, const double *generators, int n, double *weakest);

/* List all facet normals, at most n (n - 1), each followed by its negative, and h at them. Returns
 * how many there are. */
ptrdiff_t sweep_facets(Sweep *sweep, const double *generators, int n, double *normals,
                       double *heights);

/* The sum of max(0, n . b_i). */
double total_height(const double *generators, ptrdiff_t n, const double *normal);

#endif
