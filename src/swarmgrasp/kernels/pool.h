/* What searches for a newcomer beside robots with force sets share: the normals met, and which parts of
 * its places are open, the one with the greatest bound on top (T22, T23).
 *
 * A search has some dozens of normals, or some thousands, and up to some thousands of parts. */
#ifndef SWARMGRASP_POOL_H
#define SWARMGRASP_POOL_H

#include "sets.h"

#define EXACT 1e-9    /* gap of a quality that is not only looked at by a search for a wider one */
#define ASKS 1500     /* exact qualities that a search may take unless told otherwise */
#define SMALLEST_PART 1e-12 /* share of a piece, or an angle [rad], that only rounding could split */

/* A normal met, and what the base swarm holds along it; D counts as 0 where nothing is asked. */
typedef struct {
    double normal[3], height, cap, extent;
} Known;

/* A part that is open, by its number. */
typedef struct {
    double bound;
    int part;
} Open;

typedef struct {
    const Sets *sets;           /* the base swarm */
    double size;                /* of all wrenches together [N]: what rounding is relative to */
    double quality, weakest[3]; /* of the base swarm */
    Known *row;                 /* normals met */
    int count, room;
    double least_cap;           /* relative to D, and the row that has it */
    int capped;
    Open *open;                 /* a heap */
    int opens, open_room;
    int asks;                   /* exact qualities left */
    Work work;
} Pool;

/* Begin with a few normals, for `units` of work in all, beside a newcomer whose largest wrench is
 * `strength` [N]. Returns a status; end it in any case. */
Status pool_begin(Pool *pool, const Sets *sets, double strength, double units,
                  int (*interrupted)(void));
void pool_end(Pool *pool);

/* Add a unit normal, unless it is there. */
Status pool_meet(Pool *pool, const double *normal);

/* Open a part, and take the one with the greatest bound. */
Status pool_open(Pool *pool, double bound, int part);
int pool_take(Pool *pool);

/* What a bound may be for a part to be closed, to a relative gap beside the best quality. */
double enough_for(const Pool *pool, double best, double gap);

/* Make room for one more of some things. Returns whether there is. */
int has_room(void **things, int *room, int count, size_t size);

/* Put a row with its value into a list of the lowest, which is full at `room`. Returns the new count. */
static inline int keep_lowest(int *kept, double *value, int count, int room, int row, double here) {
    int j = count < room ? count++ : room;
    if (j == room && !(here < value[--j]))
        return count;
    for (; j > 0 && here < value[j - 1]; j--) {
        value[j] = value[j - 1];
        kept[j] = kept[j - 1];
    }
    value[j] = here;
    kept[j] = row;
    return count;
}

/* The quality that H allows along a normal met: where nothing is asked any, unless a load is not held. */
static inline double allowed(const Known *at, double height) {
    return at->extent > 0.0 ? height / at->extent : height < 0.0 ? 0.0 : INFINITY;
}

static inline double between(double a, double b, double share) { return a + share * (b - a); }

/* The moment arm at a share of the way from the first of two ends (4,) to the last. */
static inline void arm_at(const double *ends, double share, double *arm) {
    for (int k = 0; k < 2; k++)
        arm[k] = share == 1.0 ? ends[2 + k] : between(ends[k], ends[2 + k], share);
}

#endif
