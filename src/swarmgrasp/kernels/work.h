/* The work that a search may still do, and when it looks at the keyboard next.
 *
 * A unit of work is one generator valued along one normal, some 3 ns. Counting them, not seconds,
 * gives the same answer on every machine. */
#ifndef SWARMGRASP_WORK_H
#define SWARMGRASP_WORK_H

#include "status.h"

#define WORK 4e8  /* units that a search may take unless told otherwise: a second or two */
#define PER_ROBOT 2e3 /* and for each robot: some 400 are usual of a million */
#define LOOK 3e5    /* units between two looks at the keyboard: a millisecond */
#define TURNED 25.0 /* units that valuing a robot of uncertain pose takes, per row */

typedef struct {
    double left;  /* units */
    double until; /* units until the next look */
    int (*interrupted)(void);
} Work;

static inline Work work_of(double units, int (*interrupted)(void)) {
    return (Work){units, LOOK, interrupted};
}

/* Note work done. */
static inline void charge(Work *work, double units) {
    work->left -= units;
    work->until -= units;
}

/* Note work done. Returns SOLVED, INTERRUPTED, or OUT_OF_BUDGET if there was less left. */
static inline Status spend(Work *work, double units) {
    charge(work, units);
    if (work->until <= 0.0) {
        work->until = LOOK;
        if (work->interrupted())
            return INTERRUPTED;
    }
    return work->left < 0.0 ? OUT_OF_BUDGET : SOLVED;
}

#endif
