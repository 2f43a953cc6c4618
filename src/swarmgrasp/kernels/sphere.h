/* The least of a support function over all directions, by branch and bound (T12). The tree outlives the
 * search; nothing is checked. For tens to 10^6 generators. */
#ifndef SWARMGRASP_SPHERE_H
#define SWARMGRASP_SPHERE_H

#include "tree.h"
#include "work.h"

#define PLANES 3 /* cuts that a cell keeps */

/* A triangle of directions and what bounds h on it, in whitened coordinates. */
typedef struct {
    double bound;           /* no unit normal in the triangle has a smaller h, but for rounding */
    double corner[9];       /* unit in whitened coordinates */
    double cut[PLANES][3];  /* gradients of h: each g . m <= h(m) everywhere */
    int cuts;
} Cell;

/* The directions still open, and the best one so far. */
typedef struct {
    const Tree *tree;
    const double *extra;    /* (extras, 3) more generators, whitened */
    int extras;
    double weight;          /* sum |c_i|, with them */
    double error;           /* of h near the best normal, that is rounding */
    double best, normal[3]; /* least h so far, and the normal, whitened */
    double bound;           /* what no direction falls below, but for rounding */
    Work *work;
    Cell *cell;             /* a heap, least bound first */
    int cells, room;
} Sphere;

/* Find the least h(n) over unit normals, of a tree and a few generators more.
 *
 * `from` are cells of an earlier run to begin with, which had the first of these only, or NULL for
 * all directions. `margin`: keep the cells in which h may be less than the least h + margin, for
 * later runs; 0 keeps none. A value of `below` or more is not wanted, and `best` is then `below`;
 * one of `zero` or less is as good as 0, and the first to be found.
 *
 * The best is INFINITY if the generators span no plane. Returns a status; OUT_OF_BUDGET means
 * that `bound` may be below the best. Free the sphere in any case. */
Status sphere_search(Sphere *sphere, const Tree *tree, const double *extra, int extras,
                  const Sphere *from, double margin, double below, double zero,
                  Work *work);

/* Return the least h found, and write its unit normal. */
double sphere_best(const Sphere *sphere, double *normal);

/* Copy the cells on which h may be less than `most`. */
Status sphere_keep(Sphere *kept, const Sphere *sphere, double most);

void sphere_free(Sphere *sphere);

#endif
