/* Generators grouped by direction, so that whole groups count at once (T12).
 *
 * A generator's direction is a point (u, v) of one of the six faces of a cube, squares
 * [-1, 1]^2. A node holds a rectangle of such points and the sum of its generators: where a
 * normal has one sign on the rectangle's corners, the node counts as that one vector, or not
 * at all.
 *
 * Everything happens in whitened coordinates c_i = M b_i, with M such that sum c c' / |c| is
 * near the identity: needles, flat sets and one giant among dwarfs then look like any other
 * set. A normal m there is the normal n = M' m here, and m . c_i = n . b_i.
 */
#ifndef SWARMGRASP_TREE_H
#define SWARMGRASP_TREE_H

#include <stddef.h>

#include "work.h"

#define ON_PLANE 1e-14 /* sine of the angle within which a generator counts as crossed */

typedef struct {
    double sum[3];     /* of the generators below */
    double middle[2];  /* of the rectangle */
    double half[2];    /* its half width, a little more against rounding */
    int face;          /* twice the largest component, and 1 more if that is negative */
    int skip;          /* the next node that is not below this one */
    int first, count;  /* generators; count is 0 for a node with nodes below */
} Node;

/* M: m00, m10, m11, m20, m21, m22. */
typedef struct {
    double m[6];
} Whitening;

typedef struct {
    int size;             /* generators that are left: not zero, parallel neighbours added up */
    double *vectors;      /* (size, 3) whitened, sorted */
    int nodes;
    Node *node;           /* (nodes,) each before those below it */
    Whitening white;
    double load[3];       /* a steady wrench, whitened: h(n) = n . load + sum max(0, n . b_i) */
    double weight;        /* sum |c_i|, and the load's size */
} Tree;

/* Build the tree of `count` generators (count, 3) and a load (3,), whatever work that takes; after a
 * fault there is none. */
Status tree_build(Tree *tree, const double *generators, ptrdiff_t count, const double *load,
                  Work *work);
void tree_free(Tree *tree);

/* Find M for generators (count, 3). */
void whitening_of(Whitening *white, const double *generators, ptrdiff_t count);

/* Turn a generator to whitened coordinates; a whitened normal back; and a normal there. */
void whiten(const Whitening *white, const double *b, double *c);
void normal_of(const Whitening *white, const double *m, double *n);
void whiten_normal(const Whitening *white, const double *n, double *m);

/* Write the gradient of h at m, the load and the sum of the c_i with m . c_i > 0, to g. Of generators in
 * crossed leaves those count as 0 that are so but for `rounding`, relative to their terms. Returns how
 * many nodes and generators were looked at. */
int tree_gradient(const Tree *tree, const double *m, double rounding, double *g);

/* List the generators that change sign over the triangle with corners (3, 3), at most `room` of
 * them, and add up in g the load and those that are positive on it. Returns how many were listed, or
 * -1 if there are more, and writes how many nodes and generators were looked at. */
int tree_crossed(const Tree *tree, const double *corners, int room, double *listed, double *g,
                 int *looked);

#endif
