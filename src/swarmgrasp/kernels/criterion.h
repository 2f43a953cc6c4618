/* What a swarm is asked to withstand: h(n) after the worst loss of some robots, in the worst
 * poses they may have, beside a load, and relative to a task (T14, T15, T16).
 *
 * A robot adds max(0, low_i(n)), where low_i(n) = n . b_i if its wrench is known, or the least
 * n . b over all it may be. H(n) is the load's part and the sum over the robots without the
 * `losing` largest; the quality is the least H(n) / D(n), where D is the support function of the
 * task: |n| for the unit ball. */
#ifndef SWARMGRASP_CRITERION_H
#define SWARMGRASP_CRITERION_H

#include "sector.h"
#include "work.h"

/* Rounding may change H by so much of sum |b_i|: values are compared as if the robots could do so
 * much more in every direction. So a value is known to this / D of sum |b_i|, which it never
 * exceeds, and where D is no larger, relative to the normal and to the task's size, the task asks
 * for nothing. */
#define UNASKED 4e-15
#define SPREAD_ROW (PIECE + 2) /* numbers in a row of a robot whose pose is uncertain */

typedef struct {
    int points;           /* robots whose wrench is known */
    const double *point;  /* (points, 3) [N] in the metric's coordinates */
    int spread;           /* robots whose wrench is one of a set */
    int *first;           /* (spread + 1,) their rows: robot u has those from first[u] on */
    const double *rows;   /* (..., SPREAD_ROW): the robot, its limit [N], and a piece (see sector.h) */
    double scale[3];      /* turns wrenches into the metric's coordinates [1, 1, 1/m] */
    int losing;
    double load[3];       /* [N] in the metric's coordinates */
    int is_polytope;      /* D is the greatest n . v over rows of `task`, or 0; otherwise the */
    int tasks;            /* length of (n . v) over its rows: an ellipsoid. No rows: the unit ball */
    const double *task;   /* (tasks, 3) in the metric's coordinates, the longest row about 1 */
    double weight;        /* sum |b_i|, and the load's size [N] */
    int frames;           /* vectors that span what matters, for the whitening of directions: */
    double *frame;        /* (frames, 3) [N] */
} Criterion;

/* Complete a criterion whose arrays are set: find `first`, `weight` and `frame`. Returns a status;
 * UNSORTED if rows are not sorted by robot, 0 1 2 ... End it in any case. */
Status criterion_begin(Criterion *criterion, int rows);
void criterion_end(Criterion *criterion);

/* Find H at a normal of any length, with the robots and one more generator, or NULL; the H before
 * the last loss, which no newcomer exceeds, goes to `cap`: INFINITY if none is lost. */
Status criterion_height(const Criterion *criterion, const double *normal, const double *extra,
                        double *height, double *cap);

/* What H would be if no robot were lost. */
double criterion_total(const Criterion *criterion, const double *normal);

/* The task's support function, and the length below which it counts as none. */
double criterion_extent(const Criterion *criterion, const double *normal);

/* Find the least H / D, with one more generator or NULL, to a relative `gap`: no direction has
 * less than (1 - gap) times the value, but for what `rounding` [N] may add to H. A value of `below`
 * or more is not wanted: it is then `below`, and the normal is zero. What is 0 but for rounding is 0,
 * and the first to be found; so is what a load leaves that is not held. Writes a unit normal that
 * attains it. Returns a status; OUT_OF_BUDGET means that some direction may have less. */
Status criterion_search(const Criterion *criterion, const double *extra, double gap, double below,
                        double rounding, Work *work, double *value, double *normal);

#endif
