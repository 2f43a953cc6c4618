/* Of robots as good as the best, the one that lifts the rest of h most, by a grid over the rival
 * pieces and finer ones around the best of it (T17). Trusted are the proofs and the best robot that
 * `search_solve` wrote. A few hundred candidates, or one for each piece, each worth DIRECTIONS numbers. */
#include <stdlib.h>
#include <string.h>

#include "place.h"
#include "sector.h"
#include "vectors.h"

#define CANDIDATES 144   /* size of the first grid over all tied pieces together */
#define ZOOMS 3          /* how often a finer grid is laid around the best candidate */
#define FINE_SIDE 5      /* side of the finer grid */
#define FINER 0.4        /* its step, relative to the one before */
#define DIRECTIONS 64    /* number of directions the soft minimum is taken over */
#define LANES 8          /* of them at a time */
#define SOFTNESS 0.5     /* added to h, relative to its mean, before the power is taken */
#define UNTURNED 1e-6    /* torque part of a proof's mean normal below which the contact is idle */
#define CAPPED_BY 1e-9   /* how near to what no newcomer exceeds, relatively, the best counts as it */
#define SCANNED 0.3      /* units of work to pass over a candidate */
#define CHECKS 12        /* exact qualities of a large swarm that a grid may cost */

typedef struct {
    int piece;
    double along, across;           /* shares of the contact and of the sector */
    double wrench[3], score;
} Candidate;

/* h over directions, divided by its mean; and what a robot adds per unit wrench. */
typedef struct {
    double height[DIRECTIONS], m[3][DIRECTIONS];
} Field;

int search_is_tied(const Search *s, const Best *best, const Proof *proofs, double target) {
    /* The best robot of a piece maximises v . b, v the mean normal of its proof. It is unique
     * unless v vanishes or says nothing of the torque. */
    if (best->piece < 0)
        return 1;
    if (s->pool[s->lowest].cap * (1.0 - CAPPED_BY) <= best->quality)
        return 1; /* no newcomer does better, and many do as well */
    for (int k = 0; k < s->many; k++)
        if (proofs[k].bound >= target) {
            double turn = 0.0;
            for (int i = 0; i < 4; i++)
                if (proofs[k].share[i] > 0.0)
                    turn += proofs[k].share[i] * s->pool[proofs[k].row[i]].m[2];
            if (fabs(turn) <= UNTURNED * s->weights[2])
                return 1;
        }
    return 0;
}

/* Evaluate h at directions spread evenly over the sphere. */
static void fill_field(const Search *s, Field *field) {
    double mean = 0.0;
    for (int k = 0; k < DIRECTIONS; k++) {
        double n[3];
        on_spiral(k, DIRECTIONS, n);
        field->height[k] = search_total(s, n);
        mean += field->height[k] / DIRECTIONS;
        for (int c = 0; c < 3; c++)
            field->m[c][k] = n[c] * s->weights[c];
    }
    /* few robots, or none: the newcomer's own size sets the scale */
    mean = larger(mean, 0.25 * hypot(s->weights[0], s->weights[1]));
    for (int k = 0; k < DIRECTIONS; k++) {
        field->height[k] = field->height[k] / mean + SOFTNESS;
        for (int c = 0; c < 3; c++)
            field->m[c][k] /= mean;
    }
}

/* The sum of h^-8 over directions with a robot: the less, the higher the soft minimum of h. */
static double score_of(const Field *field, const double *wrench) {
    double sums[LANES] = {0.0}, score = 0.0;
    for (int k = 0; k < DIRECTIONS; k += LANES)
        for (int l = 0; l < LANES; l++) {
            double gain = field->m[0][k + l] * wrench[0] + field->m[1][k + l] * wrench[1]
                          + field->m[2][k + l] * wrench[2];
            double low = 1.0 / (field->height[k + l] + (gain > 0.0 ? gain : 0.0));
            low *= low;
            low *= low;
            sums[l] += low * low;
        }
    for (int l = 0; l < LANES; l++)
        score += sums[l];
    return score;
}

static void place_candidate(const Search *s, const Field *field, Candidate *c) {
    const double *p = s->pieces + PIECE * c->piece;
    double angle = p[4] + c->across * (p[5] - p[4]);
    double x = p[0] + c->along * (p[2] - p[0]), y = p[1] + c->along * (p[3] - p[1]);
    c->wrench[0] = cos(angle);
    c->wrench[1] = sin(angle);
    c->wrench[2] = x * c->wrench[1] - y * c->wrench[0];
    c->score = score_of(field, c->wrench);
}

static double share_of(int k, int count) { return count > 1 ? (double)k / (count - 1) : 0.5; }

/* Lay a grid over the rival pieces. Returns the number of candidates; writes the step. */
static int lay_grid(const Search *s, const Field *field, const int *rivals, int count,
                    Candidate *grid, double *step) {
    int each = CANDIDATES / count > 1 ? CANDIDATES / count : 1, found = 0;
    int side = (int)round(sqrt((double)each));
    side = side > 1 ? side : 1;
    for (int r = 0; r < count; r++) {
        const double *p = s->pieces + PIECE * rivals[r];
        int is_point = p[0] == p[2] && p[1] == p[3], is_ray = p[4] == p[5];
        int contacts = is_point ? 1 : is_ray ? each : side;
        int sectors = is_ray ? 1 : is_point ? each : side;
        for (int i = 0; i < contacts; i++)
            for (int j = 0; j < sectors; j++) {
                grid[found] = (Candidate){rivals[r], share_of(i, contacts),
                                          share_of(j, sectors), {0.0}, 0.0};
                place_candidate(s, field, grid + found++);
            }
    }
    *step = 1.0 / side;
    return found;
}

static int lay_finer(const Search *s, const Field *field, const Candidate *at, double step,
                     Candidate *grid) {
    int found = 0;
    for (int i = 0; i < FINE_SIDE; i++)
        for (int j = 0; j < FINE_SIDE; j++) {
            Candidate *c = grid + found++;
            *c = *at;
            c->along += step * (2.0 * share_of(i, FINE_SIDE) - 1.0);
            c->across += step * (2.0 * share_of(j, FINE_SIDE) - 1.0);
            c->along = smaller(larger(c->along, 0.0), 1.0);
            c->across = smaller(larger(c->across, 0.0), 1.0);
            place_candidate(s, field, c);
        }
    return found;
}

Status search_break_tie(Search *s, const Proof *proofs, double target, Best *best) {
    Field field;
    int rivals_count = 0;
    Status status = SOLVED;
    int *rivals = malloc((size_t)s->many * sizeof *rivals);
    Candidate *grid = malloc(((size_t)s->many + 2 * CANDIDATES) * sizeof *grid), at = {0};
    if (!rivals || !grid) {
        status = NO_MEMORY;
        goto done;
    }
    for (int k = 0; k < s->many; k++)
        if (proofs[k].bound >= target)
            rivals[rivals_count++] = k;
    fill_field(s, &field);
    double least = best->piece >= 0 ? score_of(&field, best->wrench) : INFINITY, step = 0.0;
    int count = rivals_count ? lay_grid(s, &field, rivals, rivals_count, grid, &step) : 0;
    for (int zoom = 0; zoom <= ZOOMS && count > 0; zoom++) {
        int is_found = 0, checks = s->is_small ? count : CHECKS;
        while (checks-- > 0 && !is_found) { /* the best score first: mostly one check is enough */
            Candidate *c = grid;
            for (int k = 1; k < count; k++)
                if (grid[k].score < c->score)
                    c = grid + k;
            if (c->score >= least)
                break;
            double quality, normal[3];
            status = search_spend(s, SCANNED * count);
            if (status == SOLVED)
                status = search_quality(s, c->wrench, target, &quality, normal);
            if (status == OUT_OF_BUDGET)
                count = checks = 0;
            else if (status != SOLVED)
                goto done;
            else if (quality >= target) {
                at = *c;
                least = c->score;
                best->quality = quality;
                best->piece = c->piece;
                memcpy(best->wrench, c->wrench, sizeof best->wrench);
                is_found = 1;
            }
            c->score = INFINITY;
        }
        if (!is_found && zoom == 0)
            break; /* no candidate is better than the search's own */
        step *= zoom == 0 ? 1.0 : FINER;
        count = lay_finer(s, &field, &at, step, grid);
    }
    if (best->piece < 0) { /* nothing helps, and nothing was found that does no harm: anywhere */
        const double *p = s->pieces;
        double angle = 0.5 * (p[4] + p[5]), normal[3];
        best->piece = 0;
        best->wrench[0] = cos(angle);
        best->wrench[1] = sin(angle);
        best->wrench[2] = 0.5 * ((p[0] + p[2]) * best->wrench[1] - (p[1] + p[3]) * best->wrench[0]);
        status = search_quality(s, best->wrench, -INFINITY, &best->quality, normal);
    }
done:
    free(rivals);
    free(grid);
    return status;
}
