/* The least factor by which the wrench set holds a vector: a simplex of three rows, whose columns
 * are all wrenches of the set and whose prices are normals: the best column is the support (T27). */
#include "pushers.h"

#include <string.h>

#define STEPS 300     /* some 30 are usual */
#define GONE 1e-12    /* level of an aid at which the vector is made without it */
#define PIVOT 1e-9    /* part of a column that takes an aid's place */
#define TIED 1e-13    /* levels that count as one */
#define LOST 1e-11    /* of the target: what columns that are all but parallel do not make */
#define SUNK 1e-9     /* level below 0 that is rounding */
#define DEAR 1e3      /* cost of an aid that is left, relative to the price of the others, at first, */
#define DEARER 30.0   /* and by how much it grows where the target is on a border of all that is made */
#define DEAREST 1e9
#define SETTLED 1e-6  /* of a height */
#define BEYOND 1e-13  /* of the total: what rounding leaves of no height */

/* Three columns that make the target, with levels of 0 or more. Aids are unit vectors that no robot
 * makes. */
typedef struct {
    Column column[3];
    int is_aid[3];
    double level[3];
    double inverse[3][3]; /* rows */
} Basis;

/* Find the rows of the inverse, and the levels, refined: columns become nearly parallel where a set is
 * round. Tells whether the columns make the target, at levels of 0 or more but for rounding. */
static int solve(Basis *b, const double *target) {
    double rest[3] = {target[0], target[1], target[2]};
    for (int k = 0; k < 3; k++) {
        double *row = b->inverse[k];
        cross(b->column[(k + 1) % 3].wrench, b->column[(k + 2) % 3].wrench, row);
        double size = dot(row, b->column[k].wrench);
        for (int c = 0; c < 3; c++)
            row[c] /= size;
        b->level[k] = 0.0;
    }
    for (int pass = 0; pass < 3; pass++) {
        double change[3];
        for (int k = 0; k < 3; k++)
            b->level[k] += change[k] = dot(b->inverse[k], rest);
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++)
                rest[c] -= change[k] * b->column[k].wrench[c];
        if (pass == 1)
            for (int c = 0; c < 3; c++) { /* afresh: of the sum, rounding is what is left */
                rest[c] = target[c];
                for (int k = 0; k < 3; k++)
                    rest[c] -= b->level[k] * b->column[k].wrench[c];
            }
    }
    double sum = 1.0, least = 0.0;
    for (int k = 0; k < 3; k++) {
        sum += fabs(b->level[k]) * length(b->column[k].wrench);
        least = smaller(least, b->level[k]);
    }
    return length(rest) <= LOST * sum && least >= -SUNK * sum;
}

/* Find the normal along which each column is worth its cost. */
static void price(const Basis *b, const double *cost, double *normal) {
    memset(normal, 0, 3 * sizeof *normal);
    for (int pass = 0; pass < 3; pass++) {
        double left[3];
        for (int k = 0; k < 3; k++)
            left[k] = cost[k] - dot(normal, b->column[k].wrench);
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 3; c++)
                normal[c] += left[k] * b->inverse[k][c];
    }
}

/* Find what the robots do best along a normal, and of what is across all of them as much as they
 * are; so that what rounding has across them needs nobody. */
static double best_along(const Pushers *p, const double *normal, Column *best) {
    double height = push_along(p, normal, best);
    for (int k = 0; k < p->flats; k++) {
        double part = dot(p->flat[k], normal);
        height += p->total * fabs(part);
        for (int c = 0; c < 3; c++)
            best->wrench[c] += copysign(p->total, part) * p->flat[k][c];
    }
    return height;
}

/* The column that gives way to another, but for one that cannot: an aid of level 0 where that is
 * possible, or else the first whose level falls to 0; -1 if none does. */
static int leaving(const Basis *b, const double *wrench, int kept) {
    double part[3], most = 0.0, least = INFINITY;
    int at = -1;
    for (int k = 0; k < 3; k++) {
        part[k] = k == kept ? 0.0 : dot(b->inverse[k], wrench);
        if (b->is_aid[k] && b->level[k] <= GONE && fabs(part[k]) > larger(most, PIVOT)) {
            most = fabs(part[k]);
            at = k;
        }
    }
    double size = fabs(part[0]) + fabs(part[1]) + fabs(part[2]);
    for (int k = 0; k < 3 && most == 0.0; k++)
        if (part[k] > FLAT * size)
            least = smaller(least, (larger(b->level[k], 0.0) * (1.0 + TIED) + TIED) / part[k]);
    for (int k = 0; k < 3 && least < INFINITY; k++) /* of those all but first, the best */
        if (part[k] > larger(most, FLAT * size) && larger(b->level[k], 0.0) <= least * part[k]) {
            most = part[k];
            at = k;
        }
    return at;
}

/* Let a column enter in the place of another, which takes its own; tells whether the columns make
 * the target. */
static int enter(Basis *b, int out, Column *next, const double *target) {
    Column gone = b->column[out];
    b->column[out] = *next;
    b->is_aid[out] = 0;
    *next = gone;
    return solve(b, target);
}

/* Add up the forces of the columns at their levels. */
static void mix(const Basis *b, int count, Column *found) {
    memset(found->wrench, 0, sizeof found->wrench);
    for (int i = 0; i < 2 * count; i++)
        found->force[i] = 0.0;
    for (int k = 0; k < 3; k++) {
        double level = larger(b->level[k], 0.0);
        if (b->is_aid[k])
            continue;
        for (int c = 0; c < 3; c++)
            found->wrench[c] += level * b->column[k].wrench[c];
        for (int i = 0; i < 2 * count; i++)
            found->force[i] += level * b->column[k].force[i];
    }
}

Status least_factor(const Pushers *p, const double *target, Work *work, Column *found,
                    double *factor, double *proven, double *normal) {
    Basis b;
    double *spare = p->room + 2 * (ptrdiff_t)p->count * 3;
    for (int k = 0; k < 3; k++) {
        b.column[k] = (Column){.wrench = {0.0}, .force = p->room + 2 * (ptrdiff_t)p->count * k};
        b.column[k].wrench[k] = copysign(1.0, target[k]);
        b.is_aid[k] = 1;
    }
    double dear_by = DEAR;
    *factor = INFINITY;
    *proven = 0.0;
    memcpy(normal, target, 3 * sizeof *normal);
    Column next = {.force = spare};
    solve(&b, target);
    for (int step = 0; step < STEPS; step++) {
        Status status = spend(work, 16.0 * p->count + 100.0);
        if (status != SOLVED)
            return status;
        double n[3], of_aids[3] = {0.0}, aided = 0.0, sum = 0.0, cost[3], reach;
        int aids = 0;
        for (int k = 0; k < 3; k++) {
            aids += b.is_aid[k];
            aided += b.is_aid[k] ? larger(b.level[k], 0.0) : 0.0;
            sum += b.is_aid[k] ? 0.0 : larger(b.level[k], 0.0);
            cost[k] = b.is_aid[k] ? 0.0 : 1.0;
        }
        price(&b, cost, n);
        if (aids) {
            double dear[3] = {1.0 - cost[0], 1.0 - cost[1], 1.0 - cost[2]};
            price(&b, dear, of_aids);
            double size = length(of_aids), much = dear_by * larger(length(n), 1.0) / size;
            for (int c = 0; c < 3; c++)
                n[c] = aided > GONE ? (step ? of_aids[c] / size : target[c])
                                    : n[c] + much * of_aids[c];
        }
        double height = best_along(p, n, &next);
        if (aids && aided > GONE) {
            if (step && height <= BEYOND * p->total) { /* nobody pushes that way */
                memcpy(normal, n, sizeof n);
                return SOLVED;
            }
        } else {
            reach = dot(n, target);
            if (height > 0.0 && reach / height > *proven) {
                *proven = reach / height;
                memcpy(normal, n, sizeof n);
            }
            *factor = sum;
            if (sum - *proven <= CLOSE * sum)
                break;
            if (aids && height < 1.0 + SETTLED && dear_by < DEAREST) {
                dear_by *= DEARER;
                continue;
            }
        }
        int is_better = aids || height > 1.0, out = is_better ? leaving(&b, next.wrench, -1) : -1;
        const Basis before = b;
        if (out >= 0 && !enter(&b, out, &next, target)) { /* columns that are all but in a plane */
            next = b.column[out];
            b = before;
            int other = leaving(&b, next.wrench, out);
            out = other >= 0 && enter(&b, other, &next, target) ? other : -1;
            if (out < 0)
                b = before;
        }
        if (out < 0)
            break;
    }
    mix(&b, p->count, found);
    return SOLVED;
}
