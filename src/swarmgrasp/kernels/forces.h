/* The least shares that make a wrench, or the nearest wrench there is (T18). Numbers are finite; time
 * is linear in the robots, times the turns of a plane. */
#ifndef SWARMGRASP_FORCES_H
#define SWARMGRASP_FORCES_H

#include "turning.h"

#define NOTHING 5e-15 /* of the robots' total wrench: what counts as rounding of any wrench */

/* What the shares are worth, and the proof. Vectors are in the metric's coordinates.
 *
 * The first of `normals` that is not at right angles to a robot's generator decides: in front of
 * the plane across it a robot gives the largest share, behind it nothing. Robots in all these planes
 * have the share y.b, clipped. */
typedef struct {
    double needed;    /* the least largest share of the wrench wanted; above 1 it is out of reach */
    double shortfall; /* [N] how far the nearest attainable wrench is from it; 0 if attained */
    double normals[3][3]; /* units, or 0 */
    double price[3];      /* [1/N] y */
} Shares;

#define SHARES 15 /* numbers in it, and whether they are proven */

/* Find the shares (n,) of a wrench wanted beside a load, and what they are worth. The search starts
 * from the first normal in `found`, unless that is 0. */
Status least_shares(Turning *turning, const double *wanted, const double *load, double *shares,
                   Shares *found);

#endif
