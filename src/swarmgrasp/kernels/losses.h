/* Which machines an adversary may take on a triangle of directions (T25). */
#ifndef SWARMGRASP_LOSSES_H
#define SWARMGRASP_LOSSES_H

#include "cell.h"

/* Number machines alike: those whose robots have the same sets at the same places. */
Status number_kinds(Hunt *h);

/* Find which machines are lost for certain on all of a triangle, and which never. The robots of the
 * former leave the list, and its end is returned; `is_safe` (machines,) tells the latter. */
size_t sift_losses(Hunt *h, Triangle *triangle, size_t begin, size_t end, char *is_safe);

/* Tell whether the sums found there already show that no normal of the triangle has less than what is
 * wanted. */
int is_held_plainly(Hunt *h, Triangle *triangle, const char *is_safe);

/* Tell the same by looking at each set of machines that may be lost; whether they `are_many`, so that
 * nothing is known. */
int is_held_by_sets(Hunt *h, Triangle *triangle, size_t begin, size_t end, const char *is_safe,
                    int *are_many);

/* Tell the same, where they are many, by a few linear functions. Returns a status. */
Status is_held_by_cuts(Hunt *h, Triangle *triangle, size_t begin, size_t end, const char *is_safe,
                       int *is_so);

#endif
