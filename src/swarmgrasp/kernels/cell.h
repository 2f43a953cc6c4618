/* One triangle of directions, and a proof that sets of forces exert enough on all of it. */
#ifndef SWARMGRASP_CELL_H
#define SWARMGRASP_CELL_H

#include "plane.h"
#include "sets.h"

#define EACH 5.0    /* units of work that a robot takes at one normal, */
#define SUMS 9      /* arrays of sums of machines */
#define BASIC 100.0 /* and a triangle besides */

/* A robot that matters on a triangle: what it exerts at the corners, and by which elements; and the same
 * at the corner that halves will have. */
typedef struct {
    int robot;
    int is_safe;  /* whether its machine is never lost on all of the triangle */
    int which[3]; /* of its elements; -1 if its pose is uncertain */
    double at[3];
    int next_which;
    double next_at;
} Active;

/* What a robot exerts in a triangle's middle. */
typedef struct {
    const ForceSet *set;
    int which;           /* of its elements; -1 if its pose is uncertain */
    double force[2];
    double size, way[2]; /* |p| and the unit vector along it, if that is an arc */
} Push;

/* A robot whose best force turns on a triangle: r |p|, with p = |p(m)| f + J d on the plane. */
typedef struct {
    double radius, size;      /* r, |p(m)| */
    double ahead[2], side[2]; /* J'f and J' times f turned by 90 degrees */
} Bend;

/* What is known while triangles are searched. */
typedef struct {
    const Sets *sets;
    const ForceSet *extra;
    double gap, zero, floor, rounding;
    double enough;          /* below which the best is looked for no further */
    double best, normal[3]; /* the least (H + rounding) / D, and its normal */
    double bound;           /* what no triangle that was given up falls below */
    double cells;
    Active *active;         /* those of all triangles on the way to the one at hand */
    size_t room;
    Push *push;             /* (robots,) of those of a triangle */
    int *kinky;             /* (robots,) those of a triangle whose best force jumps, */
    Bend *bend;             /* (robots,) and those whose force turns */
    double *sum;            /* (SUMS, machines), if machines may be lost; so are these: */
    double rest[3];         /* what those that are safe hold at the corners */
    char *is_lost, *is_safe; /* (machines,) now, and on all of a triangle never */
    int *kind;              /* (machines,) the same for machines that are alike */
    int may_take;           /* whether some robot's set leaves 0 out: it may add less than nothing */
    Work *work;
} Hunt;

typedef struct {
    double normal[9]; /* corners: unit vectors */
    double extent[3]; /* D there */
    double fixed[3];  /* the load and the wrenches of robots that exert the same on all of it */
    double bound;     /* what H / D does not fall below */
    int losing;       /* machines that may still be lost */
} Triangle;

static inline int robots_of(const Hunt *h) { return h->sets->count + (h->extra != NULL); }

static inline int machines_of(const Hunt *h) { return h->sets->machines + (h->extra != NULL); }

static inline const ForceSet *set_of(const Hunt *h, int robot) {
    return robot < h->sets->count ? h->sets->set + robot : h->extra;
}

static inline int machine_of(const Hunt *h, int robot) {
    return robot < h->sets->count ? h->sets->machine[robot] : h->sets->machines;
}

/* The value that a triangle must not fall below to be done. */
double wanted(const Hunt *h);

/* Keep a normal with its H and D if it is the weakest so far. */
void offer(Hunt *h, const double *normal, double height, double extent);

/* What a robot's forces at a middle are worth at the corners (3, 3), at least: what it exerts is no
 * less between. */
void hold_at(const Hunt *h, int robot, const double *middle, const double *corner, double *row);

/* Tell whether no normal of a triangle has less than what is wanted, without the machines that are
 * lost. Offers normals on the way. */
int is_held(Hunt *h, Triangle *triangle, size_t begin, size_t end);

#endif
