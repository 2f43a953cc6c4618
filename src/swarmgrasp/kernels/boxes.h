/* Placement of a newcomer of one fixed direction, one-way or two-way, beside robots with force sets, by
 * branch and bound over boxes of contacts and directions (T23).
 *
 * The wrenches of a box lie in the hull of a few corners, and whatever bounds the quality linearly over
 * these bounds it in the box. Three kinds of normals n do, at a level t >= 0 below which bounds are of no
 * interest; phi is what the newcomer adds, D the task's part:
 *   MET         t D(n) <= H(n) + phi(n . b), convex in b.
 *   DEMANDED    If H(n) <= t D(n), a one-way newcomer that betters t pushes along n, and phi is linear.
 *   TRAVELLING  n(b) = b x g, to which the newcomer adds nothing: t D(n(b)) <= h(n(b)), where h is
 *               convex: what is left of H without machines that may be lost, those that add most.
 *   FLAT        m, and another across it: h is nothing along both and along -m, and so along all between,
 *               of which one is across whatever b: no newcomer gives the swarm any quality.
 * A convex combination of the others, from a matrix game, bounds the box. A search has up to some thousands
 * of boxes; each costs a pass over the normals met, and a few hundred heights. */
#ifndef SWARMGRASP_BOXES_H
#define SWARMGRASP_BOXES_H

#include "pool.h"
#include "sector.h"

#define CORNERS 6 /* wrenches whose hull holds those of a box; normals that bound one, at most */
#define LOST 4    /* machines to be lost, at most, for normals to travel */
#define ENOUGH 400   /* exact qualities after which a search stops whose bound is */
#define CLOSE 1e-4   /* so near, relatively */

typedef enum { MET, DEMANDED, TRAVELLING, FLAT } Kind;

typedef struct {
    Kind kind;
    double vector[3]; /* the unit normal, in the metric's coordinates, or g */
    double weight;
    int lost[LOST];   /* machines that a travelling or flat one goes without, or -1 */
} Term;

/* Robots of a piece between two contacts, and two directions at most a right angle apart. */
typedef struct {
    int piece;
    double from, to; /* shares of the way from the piece's first end to its last */
    double lo, hi;   /* [rad] */
    double bound;    /* what none of them exceeds */
    double ask[2];   /* the share and the direction that look best */
    int known;       /* normals in the pool when it was bounded */
    int terms;
    Term term[CORNERS];
} Box;

typedef struct {
    double quality, share, direction;
    int piece; /* -1 if none betters the base swarm */
} Place;

typedef struct {
    Pool pool;                  /* the first: see `pool_object.c` */
    const double *pieces;       /* (many, PIECE) */
    int many;
    double limit, reverse;      /* of the newcomer [N] */
    int is_convex;              /* whether h is: no failures, few losses, known poses */
    int is_flat;                /* whether h is nothing on half of a great circle, and */
    Term flat[2];               /* its end and its middle */
    double *kink;               /* (kinks, 3) wrenches across which h may have an edge */
    int kinks;
    Box *box;                   /* (boxes,) that cover all chosen pieces */
    int boxes, room;
    double *row;                /* room for a game: (rows, CORNERS + 1), */
    int *used, rows_room;       /* and (rows,) */
    double *exerted;            /* (machines + 1,) room for what they exert along a normal */
} BoxSearch;

/* Prepare a search, for `units` of work in all. Returns a status; end it in any case. */
Status boxes_begin(BoxSearch *search, const Sets *sets, const double *pieces, int many, double limit,
                   double reverse, double units, int (*interrupted)(void));
void boxes_end(BoxSearch *search);

/* Find the best robot, on all pieces or on those that are `chosen` (many,), until no bound exceeds the
 * best by more than `gap` of it, or by what rounding hides. Returns SOLVED, OUT_OF_BUDGET, or a fault. */
Status boxes_solve(BoxSearch *search, const char *chosen, double gap, int asks, Place *best);

/* Find the quality with the newcomer at a moment arm to a relative gap, and the unit normal that attains
 * it. Returns a status; OUT_OF_BUDGET means that it may be far less. */
Status boxes_quality(BoxSearch *search, const double *arm, double direction, double gap,
                     double *quality, double *normal);

#endif
