/* The quality of robots that have force sets, by a criterion (T20, T21, T25, T26).
 *
 * H(n) is the load's part and what each robot can exert along n, without the `losing` machines that
 * add most; a machine is the robots of one group. The quality is the least H(n) / D(n), where D is the
 * support function of the task: |n| for the unit ball. For 2 to 10^5 robots. */
#ifndef SWARMGRASP_SETS_H
#define SWARMGRASP_SETS_H

#include "force_set.h"
#include "work.h"

typedef struct {
    int count;
    ForceSet *set;          /* (count,) of the robots */
    int *machine;           /* (count,) which each belongs to: 0 1 2 ..., all of them in use */
    int machines;
    double scale[3];        /* turns wrenches into the metric's coordinates [1, 1, 1/m] */
    int losing;
    double load[3];         /* [N] in the metric's coordinates */
    int is_polytope;        /* D is the greatest n . v over rows of `task`, or 0; otherwise the */
    int tasks;              /* length of (n . v) over its rows: an ellipsoid. No rows: the unit ball */
    const double *task;     /* (tasks, 3) in the metric's coordinates, the longest row about 1 */
    double weight;          /* sum of the largest |wrench| of each, and the load's size [N] */
    Element *element;       /* what the sets point to */
} Sets;

/* Find H at a normal of any length, with the robots and one more, a machine of its own, or NULL; the H
 * before the last loss, which no newcomer exceeds, goes to `cap`: INFINITY if none is lost. */
Status sets_height(const Sets *sets, const double *normal, const ForceSet *extra, double *height,
                   double *cap);

/* The task's support function. */
double sets_extent(const Sets *sets, const double *normal);

/* Find the least H / D, with one more robot or NULL, to a relative `gap`. A value of `below` or more
 * is not wanted: it is then `below`, and the normal is zero. `start` (starts, 3) are normals to look at
 * first. What is 0 but for rounding is 0, and the first to be found; so is what a load leaves that is
 * not held. Writes a unit normal that attains the value, and what no direction falls below. Returns a
 * status; OUT_OF_BUDGET means that the bound may be far below. */
Status sets_search(const Sets *sets, const ForceSet *extra, double gap, double below,
                   const double *start, int starts, Work *work, double *value, double *bound,
                   double *normal);

#endif
