/* A face of a wrench set: the zonogon of those generators that lie in one plane. The caller says which
 * do, and gives units and sizes that are finite. */
#ifndef SWARMGRASP_FACE_H
#define SWARMGRASP_FACE_H

#include <stddef.h>

#include "status.h"

#define OUTSIDE 1e-14 /* relative excess that is more than rounding */

/* Something that happens at a place on a line. */
typedef struct {
    double at, weight;
    ptrdiff_t index;
} Crossing;

/* Generators in a plane, in an orthonormal basis (e, f) of it, e along the largest. */
typedef struct {
    double e[3], f[3];
    ptrdiff_t count, largest;
    ptrdiff_t *robot;    /* (count,) whose generators they are */
    double *c;           /* (count, 2) coordinates */
    double *size;        /* (count,) */
    double *share;       /* (count,) found, within [0, 1] */
    double *along;       /* (count,) scratch */
    Crossing *crossings; /* (2 count,) scratch */
} Face;

/* The side of a face that a point is beyond, or is nearest to being. */
typedef struct {
    double m[2];    /* its unit normal, in the plane */
    double beyond;  /* how far; below 0 inside */
    double excess;  /* the same relative to the numbers that say so */
    ptrdiff_t axis; /* the generator along it, of the face; -1 at the end of a segment */
} Side;

Status face_room(Face *face, ptrdiff_t n);
void face_free(Face *face);

/* Choose the basis of the plane across a unit normal, and find the coordinates of the generators of
 * robots `face->robot`, which are given by unit vectors (n, 3) and sizes (n,). */
void face_lay(Face *face, const double *normal, const double *units, const double *sizes);

/* Find the side that a point q of the plane is beyond; `extent` is what its rounding is relative
 * to. */
Side face_side(Face *face, const double *q, double extent);

/* Find shares x within [0, 1] with sum x_i c_i = q and the least sum of squares, for a point q of
 * the face. The proof goes to m and y (3,): where m.c_i is not 0, x_i is 1 or 0 by its sign;
 * elsewhere x_i is y.c_i, clipped to [0, 1]. m is the normal of the side that q is on, or 0. */
void face_shares(Face *face, const double *q, double extent, double *m, double *y);

#endif
