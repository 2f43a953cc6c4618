/* Robots that have force sets, and the forces by which they make a wrench (T27).
 *
 * What a robot exerts is its rest, the force of its set nearest to 0 (0 itself for all but those
 * that always exert some), and a part of the way from there to the boundary of its set: its share.
 * The least largest share s is the gauge of W, the wrenches of all robots beyond their rests: the
 * greatest n . w / h(n), h the support function of W.
 *
 * Forces are in a unit of their own and so are wrenches, both powers of 2, in which the strongest
 * robot's are about 1. Numbers are finite; the elements of a set go once around. For 0 to 10^6
 * robots; time is linear in them, times some 30 normals for the least share and 10 prices for the
 * least squares. */
#ifndef SWARMGRASP_PUSHERS_H
#define SWARMGRASP_PUSHERS_H

#include "force_set.h"
#include "work.h"

#define SLACK 1e-6  /* by so much of itself the largest share may grow for the least squares */
#define CLOSE 1e-10 /* gap, relative, at which a share or a nearest wrench is found */
#define FLAT 1e-12  /* sine, or part of a wrench, that is rounding */

/* A straight side of a set, from the end of one element to the beginning of the next; perhaps of
 * length 0. */
typedef struct {
    double normal[2], from[2], way[2], length;
} Border;

typedef struct {
    ForceSet set;      /* elements in their order around it */
    const Border *border;  /* (set.elements,) what follows each */
    int is_flat;       /* a segment or a point */
    double rest[2];
    double reach;      /* of its forces beyond the rest; 0 if it has no choice */
    double size;       /* of its wrenches beyond the rest, at most */
} Pusher;

typedef struct {
    int count;
    Pusher *pusher;       /* (count,) */
    double scale[3];      /* turns forces in their unit into wrenches in theirs */
    double force, wrench; /* the units [N] */
    double total;         /* sum of the sizes */
    double rest[3];       /* wrench of all rests */
    int flats;            /* directions across all wrenches beyond the rests, 0 to 3: */
    double flat[3][3];    /* units, at right angles */
    Element *element;     /* what the pushers point to, */
    Border *border;
    double *room;         /* and forces (PLACES, count, 2) */
} Pushers;

#define PLACES 5


/* What the robots are asked, and do: a wrench beyond their rests, and forces beyond them that make
 * it. */
typedef struct {
    double wrench[3];
    double *force;        /* (count, 2) */
} Column;

/* What forces are worth, and the proof. Vectors are in the metric's coordinates. */
typedef struct {
    double needed;        /* the least largest share of the wrench wanted; above 1 it is out of reach */
    double shortfall;     /* [N] how far the nearest attainable wrench is from it; 0 if attained */
    double normals[2][3]; /* units, or 0: of what is nearest, and where that does not tell the largest
                             share, of the wrench made */
    double price[3];      /* [1/N] by which the sum of squares is the least */
    int is_even;          /* whether it is known to be */
    int is_proven;        /* whether the rest is proven but for rounding */
} Push;

/* Begin with arms (count, 2) [m], elements (rows, ELEMENT) [N], robot by robot, and how many of them
 * each has, at least 1. End them in any case. Returns a status. */
Status pushers_begin(Pushers *pushers, const double *scale, int count, const double *arm,
                     const double *rows, const double *elements);
void pushers_end(Pushers *pushers);

/* Find forces (count, 2) [N] and shares (count,) for a wrench (3,) [N] that the robots are to make,
 * which is the difference of others, of the size `around` together. Returns a status. */
Status push(Pushers *pushers, const double *wanted, double around, Work *work, double *forces,
            double *shares, Push *found);

/* -- parts ---------------------------------------------------------------------------------------- */

/* Find the forces that are best along a normal of any length; returns h. */
double push_along(const Pushers *pushers, const double *normal, Column *best);

/* The force of a robot nearest to another, and how it changes with it: xx, xy, yy. */
void nearest_force(const Pusher *pusher, const double *wanted, double *force, double *turn);

/* The part of the way from its rest to the boundary of its set. */
double share_of(const Pusher *pusher, const double *force);

/* Find the least factor by which W holds a unit vector, with forces beyond the rests that make it,
 * and a normal (3,) and what it proves. The factor is INFINITY if W does not reach that way: along
 * the unit normal it has nothing then. */
Status least_factor(const Pushers *pushers, const double *target, Work *work, Column *found,
                    double *factor, double *proven, double *normal);

/* Find the wrench of W nearest to another, the forces that make it, and a unit normal beyond which W
 * has no more than `beyond`. */
Status nearest_wrench(const Pushers *pushers, const double *target, Work *work, Column *found,
                      double *normal, double *beyond);

/* Find those forces beyond the rests that make a wrench of W with the least sum of squares of what
 * each is of its reach, and the price that proves them, starting along a normal. `forces` has room
 * for (PLACES, count, 2). Tells in `is_found` whether they make it. */
Status even_forces(const Pushers *pushers, const double *target, const double *normal, Work *work,
                   double *forces, double *price, int *is_found);

#endif
