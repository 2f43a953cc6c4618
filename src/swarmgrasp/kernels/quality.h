/* The exact quality of a swarm of any size (T1): 0.1 ms for 48 generators, 2 ms for 10^3, 0.3 s for
 * 10^5. Numbers are finite; the caller has seen to that. */
#ifndef SWARMGRASP_QUALITY_H
#define SWARMGRASP_QUALITY_H

#include "facets.h"
#include "sphere.h"

#define SWEPT 48   /* generators up to which sweeping all planes is faster than a search */
#define ZERO 1e-12 /* of sum |b_i|: a quality that counts as none */

/* Find the least h over unit normals, and where, with the load of `sweep`; ZERO sum |b_i| and less
 * is 0. A set that spans no plane has a normal across it, and 0. `sweep` has room for n generators
 * if n <= SWEPT. Returns a status; OUT_OF_BUDGET means that some direction may have less, but none
 * less than the bound. */
Status exact_quality(Sweep *sweep, const double *generators, int n, Work *work, double *quality,
                     double *bound, double *weakest);

/* Round a quality to 0 if it is next to that, for generators of this total size; for one that is
 * INFINITY, of a set that spans no plane, write a normal across it. */
void round_quality(const double *generators, int n, double size, double *quality,
                   double *weakest);

#endif
