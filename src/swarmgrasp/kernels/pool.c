/* The normals that a search has met, and a heap of its open parts. Trusted are unit normals. Each normal
 * costs a pass over the robots, and one over those met before. */
#include <stdlib.h>
#include <string.h>

#include "place.h"
#include "pool.h"
#include "quality.h"

#define SAME 1e-14  /* distance between unit normals that are one: on ridges they differ by little */
#define NOTHING 1.5 /* times what counts as 0: what normals leave that were asked where it is 0 */

int has_room(void **things, int *room, int count, size_t size) {
    if (count < *room)
        return 1;
    int more = 2 * *room + 64;
    void *grown = realloc(*things, (size_t)more * size);
    if (!grown)
        return 0;
    *things = grown;
    *room = more;
    return 1;
}

Status pool_begin(Pool *pool, const Sets *sets, double strength, double units,
                  int (*interrupted)(void)) {
    *pool = (Pool){.sets = sets, .size = sets->weight + strength, .least_cap = INFINITY,
                   .work = work_of(units, interrupted)};
    double bound, opposite[3];
    Status status = sets_search(sets, NULL, EXACT, INFINITY, 0.0, NULL, 0, &pool->work, &pool->quality,
                                &bound, pool->weakest);
    if (is_fault(status))
        return status;
    if (!(bound > 0.0))
        pool->quality = 0.0; /* nothing more is known */
    for (int c = 0; c < 3; c++)
        opposite[c] = -pool->weakest[c];
    status = pool_meet(pool, pool->weakest);
    if (!is_fault(status))
        status = pool_meet(pool, opposite);
    for (int c = 0; c < 6 && !is_fault(status); c++) {
        double axis[3] = {0.0};
        axis[c / 2] = c % 2 ? -1.0 : 1.0;
        status = pool_meet(pool, axis);
    }
    return is_fault(status) ? status : SOLVED;
}

void pool_end(Pool *pool) {
    free(pool->row);
    free(pool->open);
}

Status pool_meet(Pool *pool, const double *normal) {
    for (int k = 0; k < pool->count; k++) {
        double apart = 0.0;
        for (int i = 0; i < 3; i++)
            apart += (pool->row[k].normal[i] - normal[i]) * (pool->row[k].normal[i] - normal[i]);
        if (apart <= SAME * SAME)
            return SOLVED;
    }
    if (!has_room((void **)&pool->row, &pool->room, pool->count, sizeof *pool->row))
        return NO_MEMORY;
    Known *at = pool->row + pool->count;
    memcpy(at->normal, normal, sizeof at->normal);
    Status status = sets_height(pool->sets, normal, NULL, &at->height, &at->cap);
    if (status != SOLVED)
        return status;
    at->extent = sets_extent(pool->sets, normal);
    if (at->extent <= UNASKED)
        at->extent = 0.0;
    double cap = at->extent > 0.0 ? larger(at->cap, 0.0) / at->extent : INFINITY;
    if (cap < pool->least_cap) {
        pool->least_cap = cap;
        pool->capped = pool->count;
    }
    pool->count++;
    return spend(&pool->work, pool->sets->count);
}

Status pool_open(Pool *pool, double bound, int part) {
    if (!has_room((void **)&pool->open, &pool->open_room, pool->opens, sizeof *pool->open))
        return NO_MEMORY;
    int k = pool->opens++;
    for (; k > 0 && pool->open[(k - 1) / 2].bound < bound; k = (k - 1) / 2)
        pool->open[k] = pool->open[(k - 1) / 2];
    pool->open[k] = (Open){bound, part};
    return SOLVED;
}

int pool_take(Pool *pool) {
    Open *open = pool->open, last = open[--pool->opens];
    int top = open[0].part, k = 0;
    for (int child; (child = 2 * k + 1) < pool->opens; k = child) {
        if (child + 1 < pool->opens && open[child + 1].bound > open[child].bound)
            child++;
        if (open[child].bound <= last.bound)
            break;
        open[k] = open[child];
    }
    open[k] = last;
    return top;
}

double enough_for(const Pool *pool, double best, double gap) {
    double most = best + larger(gap * best, FLOOR * pool->size);
    return larger(most, NOTHING * ZERO * pool->size);
}
