/* How a kernel's work ended. Every kernel that may fail returns one of these and nothing else; what
 * it finds goes to where its arguments point. `python/binding.c` turns faults into exceptions. */
#ifndef SWARMGRASP_STATUS_H
#define SWARMGRASP_STATUS_H

typedef enum {
    SOLVED,        /* what was asked is found */
    OUT_OF_BUDGET, /* the work is spent: what was found stands, but need not be the best */
    REACHED,       /* of a level: some robot reaches it, */
    REFUTED,       /* a proof says that none does, */
    CAPPED,        /* or no newcomer can */
    NO_MEMORY,     /* from here on faults: nothing was found, and all that is left is to clean up */
    INTERRUPTED,   /* from the keyboard */
    UNSORTED,      /* rows are not in the order that is wanted */
} Status;

static inline int is_fault(Status status) { return status >= NO_MEMORY; }

#endif
