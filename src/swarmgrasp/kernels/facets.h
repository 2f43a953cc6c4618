/* Facets of a wrench set, one plane across a generator at a time (T2, T11). */
#ifndef SWARMGRASP_FACETS_H
#define SWARMGRASP_FACETS_H

#include <stddef.h>

/* Room for one sweep over n generators. */
typedef struct {
    double *flat;    /* (n, 4) */
    double *normals; /* (2 n, 3) found, each followed by its negative */
    double *heights; /* (2 n,) h at them */
    int *order;      /* (n,) */
} Sweep;

int sweep_room(Sweep *sweep, ptrdiff_t n);
void sweep_free(Sweep *sweep);

/* Find h at the unit normals orthogonal to `axis` and to one of the generators (n, 3) each, from
 * the one with index `first`. The axis is not zero. Returns how many normals were found;
 * generators parallel to the axis give none. */
int sweep_plane(Sweep *sweep, const double *generators, int n, const double *axis, int first);

/* Find the least h over all facet normals, INFINITY if no two generators span a plane; write its
 * normal to `weakest`. If `normals` and `heights` are given, with room for n (n - 1), write all
 * facets there and their number to `count`. */
double sweep_facets(Sweep *sweep, const double *generators, int n, double *weakest,
                    double *normals, double *heights, ptrdiff_t *count);

/* The support function h(n) = sum max(0, n . b_i). */
double support(const double *generators, ptrdiff_t n, const double *normal);

#endif
