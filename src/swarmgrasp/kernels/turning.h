/* A plane that turns about the wrench set of robots, to the face that a ray leaves by or that is
 * nearest to a wrench. Generators are finite, normals units: nothing is checked. */
#ifndef SWARMGRASP_TURNING_H
#define SWARMGRASP_TURNING_H

#include "face.h"

#define FLAT 1e-12  /* cosine, or share of the height, within which a generator is in the plane */
#define PATIENCE 20 /* steps after which a search begins to take more for rounding */

/* Where the plane across a turning normal meets a generator. */
typedef struct {
    double cot;    /* of the angle turned until then */
    double dn, dm; /* what the corner in front gains, along the normal before and the tangent */
    ptrdiff_t robot;
} Meeting;

/* Robots that are to make a wrench, and room for the work. Lengths are in a unit of their own. */
typedef struct {
    ptrdiff_t n;
    int exponent;       /* the unit is 2^exponent N */
    double *units;      /* (n, 3) directions of the generators */
    double *sizes;      /* (n,) */
    double total;       /* their sum */
    double *s;          /* (n,) components of the directions along a normal */
    signed char *where; /* (n,) in front of the plane across it 1, in the plane 0, behind -1 */
    Meeting *meetings;  /* (n,) */
    Face face;          /* of those in the plane */
    int (*interrupted)(void);
} Turning;

/* What is looked for: where the ray along a wrench leaves the wrench set, or the point nearest to
 * the wrench. */
typedef struct {
    int is_ray;
    double target[3]; /* the wrench; of a ray a unit vector */
    double size;      /* of the wrench; of a ray 0 */
    double least;     /* cosine between a normal and the ray below which rounding decides */
} Goal;

Status turning_room(Turning *turning, const double *generators, ptrdiff_t n,
                    int (*interrupted)(void));
void turning_free(Turning *turning);

/* Turn the normal until the goal is on the face across it; a ray may be moved by what is rounding.
 * Leaves the robots divided by the plane across the normal. q (2,) is where the goal meets the face,
 * seen from the corner; `extent` is what its rounding is relative to, and `reach` how far
 * out the goal is: along the ray, or from the face to the wrench. */
Status find_face(Turning *turning, Goal *goal, double *normal, double *q, double *extent,
                 double *reach);

#endif
