/* The motion of an object in wind and water, pushed by robots that answer to orders with a delay.
 *
 * A state is a row of 6 + 2 n numbers: the pose x, y [m], psi [rad] of the outline's origin in the
 * earth's frame; the velocity u, v [m/s], r [rad/s] relative to the water, in the object's frame; the
 * n robots' forces [N], along their angles and perhaps negative; and these angles [rad], in the
 * object's frame. docs/simulation.md has the equations.
 *
 * The object goes by the fourth-order method of Runge and Kutta. The robots need no method: between
 * two orders their way has a closed form, exact at the middle and at the end of each step. Each run is
 * worked out by itself, so that its numbers do not depend on how many there are.
 *
 * Trusted: numbers are finite, masses make a positive definite matrix, lengths and areas are
 * positive. For 1 to 10^6 runs of 0 to 10^3 robots. */
#ifndef SWARMGRASP_MOTION_H
#define SWARMGRASP_MOTION_H

#include "work.h"

#define BODY 6    /* numbers of a state before those of the robots */
#define STREAM 4  /* velocity x, y of the air and x, y of the water in the earth's frame [m/s] */
#define EXERTED 9 /* three wrenches in the object's frame: of the robots, the wind and the water */
#define AT_ONCE 1e300 /* a rate that is no bound: without a lag, an order holds from its instant on */

/* The object: what it weighs, and what it shows to wind and water. Points are from the origin that
 * moments are taken about. Numbers alone: callers hand over an array. */
typedef struct {
    double inverse[9];           /* of the mass matrix about the origin */
    double mass, x, y;           /* with what is attached, and its centre [kg, m, m] */
    double added[2];             /* masses that the water adds ahead and abeam [kg], */
    double added_x, added_y;     /* and where [m] */
    double damping[9];           /* linear, of the velocity over the ground */
    double length;               /* over all [m] */
    double midship_x, midship_y; /* [m] */
    double air;                  /* half its density [kg/m^3] */
    double frontal, lateral;     /* areas above water, the lateral one times CD_t [m^2] */
    double bow, stern, cross;    /* CD_l,AF(0), CD_l,AF(pi), delta */
    double air_x;                /* of the lateral area's centre, forward of midship [m] */
    double ahead, abeam;         /* half density times area times coefficient under water [kg/m] */
    double water_x;              /* of that lateral area's centre, forward of midship [m] */
} Afloat;

/* How a robot's angle follows orders. */
typedef enum {
    FIXED,  /* not at all */
    SECTOR, /* within a sector, so that angles are numbers: never through the gap */
    AROUND, /* the shorter way around */
    FREE,   /* force and angle together, straight from one force to the other */
} Following;

typedef struct {
    double x, y;                /* where it holds the object, from the origin [m] */
    double efficiency;          /* part of its force that arrives at the object */
    double lag, rate;           /* of the force [s, N/s] */
    double turn_lag, turn_rate; /* of the angle [s, rad/s] */
    double following;           /* a Following */
    double keeps;               /* 1 if its force keeps its direction to the earth, */
    double c, s;                /* which is that of its angle at this heading: cosine, sine */
} Driver;

/* Move runs on, in place: states (runs, 6 + 2 n), by orders (runs, n, 2) of forces and angles, in
 * streams (runs, 4) beside loads (runs, 3) [N, N, N m] in the object's frame, which all stay as they
 * are for `steps` steps of `step` seconds. On a fault some have been moved. */
Status motion_advance(const Afloat *hull, const Driver *driver, int n, int runs, double *state,
                      const double *order, const double *stream, const double *load, double step,
                      long steps, Work *work);

/* Write what acts on the object in states: rows (runs, 9). */
void motion_exerted(const Afloat *hull, const Driver *driver, int n, int runs, const double *state,
                    const double *stream, double *row);

#endif
