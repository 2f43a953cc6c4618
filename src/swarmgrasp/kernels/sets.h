/* The quality of robots that have force sets, by a criterion (T20, T21, T25, T26).
 *
 * H(n) is the load's part and what each robot can exert along n, without the `losing` machines that
 * add most; a machine is the robots of one group. If failures are named, it is the least after any. The quality is the least H(n) / D(n), where D is the
 * support function of the task: |n| for the unit ball. For 2 to 10^5 robots. */
#ifndef SWARMGRASP_SETS_H
#define SWARMGRASP_SETS_H

#include "force_set.h"
#include "work.h"

/* Rounding may change H by so much of `weight`: no gap below that is closed. */
#define SETS_FLOOR 1e-13
/* And so much of it may be added to H where the task asks for next to nothing. */
#define SETS_ROUNDING 4e-15
/* Units of work for each robot, beside `WORK`, that a search may take: 10^4 are usual of 10^5. */
#define SETS_PER_ROBOT 1e5
#define PART 5 /* numbers in a row of `Robots.part` */
#define POSE (PIECE + 2) /* and in one of `Robots.pose` */

/* Robots as arrays. */
typedef struct {
    int count;
    const double *arm;      /* (count, 2) moment arms of their contacts [m] */
    const double *row;      /* (..., ELEMENT) elements, robot by robot, */
    const double *elements; /* (count,) so many each; what has none and no poses exerts nothing */
    const double *machine;  /* (count,) which each belongs to: 0 1 2 ... */
    int parts;
    const double *part;     /* (parts, PART) the robot, and the ends of a straight part on which its
                               contact lies, as moment arms; sorted by robot */
    int poses;
    const double *pose;     /* (poses, POSE) the robot, its limit [N], and a piece; sorted by robot */
    int failures;
    const double *failure;  /* (failures, count) which robots each takes: 1, the others 0 */
} Robots;

typedef struct {
    int count;
    ForceSet *set;          /* (count,) of the robots */
    int *machine;           /* (count,) which each belongs to, below */
    int machines;
    int failures;           /* of which the worst happens before any loss, or 0 */
    char *fails;            /* (failures, count) which robots each takes */
    double scale[3];        /* turns wrenches into the metric's coordinates [1, 1, 1/m] */
    int losing;
    double load[3];         /* [N] in the metric's coordinates */
    int is_polytope;        /* D is the greatest n . v over rows of `task`, or 0; otherwise the */
    int tasks;              /* length of (n . v) over its rows: an ellipsoid. No rows: the unit ball */
    const double *task;     /* (tasks, 3) in the metric's coordinates, the longest row about 1 */
    double weight;          /* sum of the largest |wrench| of each, and the load's size [N] */
    Element *element;       /* what the sets point to, */
    double *place;          /* and their parts and pieces */
} Sets;

/* Complete sets whose scale, losses, load and task are set, with robots, whose arrays are copied.
 * Returns a status. End them in any case. */
Status sets_begin(Sets *sets, const Robots *robots);
void sets_end(Sets *sets);

/* The largest |wrench| [N] of a robot, or a little more. */
double largest_wrench(const double *scale, const ForceSet *set);

/* The same as `exert` for a robot of uncertain pose, or of no forces. */
double exert_at_worst(const double *scale, const ForceSet *set, const double *normal, double *wrench,
                      double *force, double *arm);

/* What a robot can exert along a normal of any length, in its worst pose; below 0 if it always
 * exerts something. Writes the wrench (3,) [N] that does, its force (2,) [N] and the moment arm (2,) [m]
 * of its contact, unless NULL. */
static inline double exert(const double *scale, const ForceSet *set, const double *normal,
                           double *wrench, double *force, double *arm) {
    double p[2], f[2];
    if (set->turning || set->adrift || !set->elements)
        return exert_at_worst(scale, set, normal, wrench, force, arm);
    lever(scale, set->arm, normal, p);
    if (!wrench && !force && !arm)
        return support(set, p, NULL, NULL);
    double value = support(set, p, f, NULL);
    for (int k = 0; k < 2; k++) {
        if (force)
            force[k] = f[k];
        if (arm)
            arm[k] = set->arm[k];
    }
    if (wrench)
        wrench_of(scale, set->arm, f, wrench);
    return value;
}

/* Find what a robot can exert along a normal if its contact is on one straight part (4,), known only
 * to itself; writes that contact's moment arm (2,) [m], and the force (2,) [N], unless NULL. */
double worst_on_part(const double *scale, const ForceSet *set, const double *part,
                     const double *normal, double *arm, double *force);

/* Add up the positive ones of the `most` greatest terms, which are reordered; writes the last of them,
 * 0 if it is not positive or there are fewer. */
double add_greatest(double *terms, int count, int most, double *last);

/* Find H at a normal of any length, with the robots and one more, a machine of its own, or NULL; the H
 * before the last loss, which no newcomer exceeds, goes to `cap`: INFINITY if none is lost. */
Status sets_height(const Sets *sets, const double *normal, const ForceSet *extra, double *height,
                   double *cap);

/* Copy sets as a failure leaves them; free `set` and `machine`. Returns a status. */
Status sets_after(const Sets *sets, int failure, Sets *left);

/* The task's support function. */
double sets_extent(const Sets *sets, const double *normal);

/* The task's wrench (3,) that is farthest along a normal of any length: the slope of its support
 * function. It is 0 where that is. */
void sets_farthest(const Sets *sets, const double *normal, double *wrench);

/* Find the least H / D, with one more robot or NULL, to a relative `gap`. A value of `below` or more
 * is not wanted: it is then `below`, and the normal is zero. Less than `enough` will do, even if it is not
 * the least; the bound is 0 then. `start` (starts, 3) are normals to look at
 * first. What is 0 but for rounding is 0, and the first to be found; so is what a load leaves that is
 * not held. Writes a unit normal that attains the value, and what no direction falls below. Returns a
 * status; OUT_OF_BUDGET means that the bound may be far below. */
Status sets_search(const Sets *sets, const ForceSet *extra, double gap, double below, double enough,
                   const double *start, int starts, Work *work, double *value, double *bound,
                   double *normal);

#endif
