/* Placement of a newcomer whose force set is given and whose contact alone is chosen, by branch and bound
 * over spans of the boundary (T22).
 *
 * Along a straight span the newcomer's part of H is sigma(p_n(c)), convex in the contact c. So, with D the
 * task's part, a quality t at c obeys two kinds of bounds:
 *   CHORDS     t D(n) <= H(n) + sigma(p_n(c)) for each normal n met, which lies below its chord; a
 *              mixture of two chords is highest at an end.
 *   TRAVELLING for two unit normals a and b whose torques have one sign, without losses and failures: on the way n
 *              turns from a to b so that p_n(c) is linear in c, and D(n) is at least d . n, d the task's
 *              wrench farthest along a + b. So t <= max(v_a D(a) / d . a, v_b D(b) / d . b), v_a what a
 *              leaves at the first end relative to D, v_b what b leaves at the last. Of the unit ball
 *              both quotients are 1 / cos(angle / 2).
 * A search has some dozens of spans; each costs a pass over the normals met. */
#ifndef SWARMGRASP_SPANS_H
#define SWARMGRASP_SPANS_H

#include "pool.h"

typedef enum { CHORDS, TRAVELLING_NORMAL } SpanKind;

/* Contacts of a piece, and what bounds them. */
typedef struct {
    int piece;
    double from, to; /* shares of the way from the piece's first end to its last */
    double bound;    /* what no robot on it exceeds */
    double ask;      /* the share that looks best */
    int known;       /* normals in the pool when it was bounded */
    int asked[2];    /* whether the quality at its ends was asked */
    SpanKind kind;
    int terms;
    double normal[2][3], weight[2];
} Span;

typedef struct {
    double quality, share;
    int piece; /* -1 if none betters the base swarm */
} Stand;

typedef struct {
    Pool pool;              /* the first: see `pool_object.c` */
    const double *ends;     /* (many, 4) moment arms of the pieces' ends [m] */
    int many;
    ForceSet *set;          /* (many,) what the newcomer can exert on each; its arm is not used */
    Element *element;
    double strength;        /* of the newcomer [N] */
    int may_travel;
    Span *span;             /* (spans,) that cover all chosen pieces */
    int spans, span_room;
    double *line;           /* (2, line_room) values at both ends of a span */
    int line_room;
} SpanSearch;

/* Prepare a search, for `units` of work in all: `rows` (..., ELEMENT) are the elements of the newcomer's
 * set on each piece, `counts` (many,) so many each. Returns a status; end it in any case. */
Status spans_begin(SpanSearch *search, const Sets *sets, const double *ends, int many,
                   const double *rows, const double *counts, double units,
                   int (*interrupted)(void));
void spans_end(SpanSearch *search);

/* Find the best robot, on all pieces or on those that are `chosen` (many,), until no bound exceeds the
 * best by more than `gap` of it, or by what rounding hides. Returns SOLVED, OUT_OF_BUDGET, or a fault. */
Status spans_solve(SpanSearch *search, const char *chosen, double gap, int asks, Stand *best);

/* Find the quality with the newcomer at a share of a piece, and the unit normal that attains it. Below
 * `enough` any upper bound will do. */
Status spans_quality(SpanSearch *search, int piece, double share, double enough, double *quality,
                     double *normal);

/* Find what the newcomer at a share of a piece adds along normals (many, 3). */
void spans_gains(const SpanSearch *search, int piece, double share, const double *normals, int many,
                 double *gains);

#endif
