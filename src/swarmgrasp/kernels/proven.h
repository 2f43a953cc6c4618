/* A quick check of shares and of the proof that they are the least, before they are handed out;
 * proven.c says what it trusts. */
#ifndef SWARMGRASP_PROVEN_H
#define SWARMGRASP_PROVEN_H

#include "forces.h"

/* Tell whether the shares (n,) of a wrench wanted beside a load are what is said of them. The check
 * of answers asks the same, and allows twice as much for rounding. */
int shares_are_proven(const Turning *turning, const double *wanted, const double *load,
                     const double *shares, const Shares *found);

#endif
