/* Placement by bisection on the level, with arcs of directions (T9) and their proofs (T10).
 *
 * A new robot b = (cos a, sin a, tau) [1, 1, m] at full force raises h(n) by max(0, m . b), where
 * m is the covector of the normal n. It reaches level t when m . b >= t - h(n) for every normal
 * with h(n) < t. For one direction a, every such demand bounds the torque from one side.
 *
 * The pool holds what is known of the base swarm: some or all of its facets, and normals met on
 * the way. Its first two rows stand for the piece at hand, tau >= p x F and tau <= q x F. */
#ifndef SWARMGRASP_PLACE_H
#define SWARMGRASP_PLACE_H

#include "criterion.h"
#include "facets.h"
#include "sphere.h"

#define FLOOR 1e-13 /* of the size: a gap between bound and best that is not worth closing */
#define LIMITS 2    /* pool rows kept for the piece at hand */
#define EXTRAS 32   /* robots that may join before a tree is built anew */

/* A normal and what it demands. */
typedef struct {
    double m[3];    /* covector [N, N, N/m]; m[2] is 0 if it says nothing of the torque */
    double height;  /* h at the unit normal, or H where the criterion's D is 1 [N] */
    double cap;     /* what no newcomer lifts it beyond [N] */
    double inverse; /* 1 / |m[2]|, or 1 */
    double slack;   /* by which rounding may change the height: a robot that lacks less is not cut */
} Row;

/* A convex combination of pool rows that bounds a piece. */
typedef struct {
    double bound;
    double slack; /* by which rounding may change the bound */
    int row[4];
    double share[4];
} Proof;

typedef struct {
    const double *generators;   /* (n, 3) [N] of the base swarm, in the metric's coordinates */
    double *own;                /* the same, once a robot has joined */
    int n;
    const double *pieces;       /* (many, PIECE) where the newcomer may attach */
    int many;
    double weights[3];          /* turn its unit wrench [1, 1, m] into the metric's coordinates */
    double weight;              /* sum |b_i| [N] */
    double strength;            /* the newcomer's largest wrench [N] */
    double size;                /* both together */
    double error;               /* of a sum over the generators [N] */
    double quality, weakest[3]; /* of the base swarm */
    int few;                    /* robots up to which all facets are listed */
    int is_small;               /* whether all facets are listed, and the pool has what matters */
    double *normals, *heights;  /* (facets, 3), (facets,): all of them */
    ptrdiff_t facets;
    Sweep sweep;
    Tree tree;                  /* otherwise: of the first robots */
    int in_tree;
    double extra[3 * (EXTRAS + 1)]; /* the others, and one to try, in the tree's coordinates */
    Sphere base, open;          /* the directions on which h may be less than `covered`, and */
    double covered;             /* those that the next newcomer can matter to */
    Row *pool;
    int count, room;
    int lowest;                 /* the row with the least cap */
    const Criterion *criterion; /* other than the nominal quality, or NULL */
    double rounding;            /* by which H may be off [N] */
    double units;              /* units of work */
    Work work;                  /* for all that is asked until a robot joins */
} Search;

/* The best robot: its quality, (c, s, torque), and its piece; -1 if none betters the base. */
typedef struct {
    double quality, wrench[3];
    int piece;
} Best;

/* Prepare a search beside a load (3,) [N], or for a criterion, which has the robots and the load
 * itself; robots cannot join that one. Solving and breaking ties take `units` of work at most, and as
 * many again after each robot that joins; by a criterion so does the base swarm's quality, which is 0
 * if they are not enough. Any other quality takes WORK. Returns a status; end it in any case. */
Status search_begin(Search *search, const double *generators, int n, const double *load,
                    const Criterion *criterion, const double *weights, const double *pieces,
                    int many, double units, int (*interrupted)(void));
void search_end(Search *search);

/* Let a robot (c, s, torque) join the base swarm, and ask for the next; what is known is kept. */
Status search_join(Search *search, const double *wrench, const double *pieces, int many);

/* Find the best robot, on all pieces or on those that are `chosen` (many,), until no bound exceeds
 * the best by more than `gap` of it, or by what rounding hides; writes a proof per piece. Returns
 * SOLVED, OUT_OF_BUDGET, or a fault. */
Status search_solve(Search *search, const char *chosen, double gap, Best *best, Proof *proofs);

/* Compute the exact quality with one more robot (c, s, torque) that the pieces allow, or a weaker
 * one, at the unit normal written. Below `enough` any upper bound will do. */
Status search_quality(Search *search, const double *wrench, double enough, double *quality,
                      double *normal);

/* The same to the end, but for WORK of its own. Returns SOLVED or a fault. */
Status search_value(Search *search, const double *wrench, double *quality, double *normal);

/* Note work done. Returns SOLVED, OUT_OF_BUDGET or INTERRUPTED. */
Status search_spend(Search *search, double units);

/* The length of a pool row's normal: 1, but for a criterion with a task. */
double search_length(const Search *search, int row);

/* h of the base swarm at a normal of any length; for a criterion, H without any loss. */
double search_total(const Search *search, const double *normal);

/* Find the same, for a criterion after the losses. */
Status search_height(const Search *search, const double *normal, double *height);

/* Tell whether other robots may be as good as the best one, with at least the target quality. */
int search_is_tied(const Search *search, const Best *best, const Proof *proofs, double target);

/* Of the robots with at least the target quality take the one that lifts the rest of h most
 * (T17). When the weakest facet cannot be raised, or the contact does not matter to it, a whole
 * set of robots shares the best quality; of these the one is taken that makes the soft minimum
 * of h over directions greatest, so that the robots to come are not stuck where this one could
 * not help. */
Status search_break_tie(Search *search, const Proof *proofs, double target, Best *best);

#endif
