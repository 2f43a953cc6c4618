/* The best robot over pieces by bisection on its level, with a proof for each piece; see place.h.
 * Trusted are pieces as sector.h has them, one at least, finite numbers and weights above 0. The pool
 * has some to a few thousand rows; swarms of SMALL robots or fewer have all n (n - 1) facets listed,
 * with GIANT for a strong newcomer, and larger ones a tree and a heap of cells. */
#include <stdlib.h>
#include <string.h>

#include "place.h"
#include "quality.h"
#include "sector.h"
#include "vectors.h"

#define SMALL 60            /* robots up to which listing all facets beats asking for some, */
#define GIANT 300           /* and with a newcomer that is stronger than they are together */
#define TORQUE_FREE 1e-13   /* torque part of a normal, relative to its force part, that is none */
#define ARC_END 1e-14       /* width [rad] at which an interval of directions is empty */
#define PROBE 1e-3          /* where between the best and its bound a rival piece is probed: low */
#define TANGENTS 60         /* steps of the search for the best mixture of two arcs, at most */
#define TIGHT 0.01          /* of the gap between level and best: how far a proof may be off */
#define TILTS 8             /* steps of the search for the deepest cut */
#define MISSED 1e-14        /* of sum |b_i|: a level missed by less is reached */
#define AHEAD 8.0           /* robots still to join that the directions kept should do for */
#define TIGHT_KNOWN 1e-11   /* relative gap to which a criterion's value is found: known poses, */
#define TIGHT_SPREAD 1e-7   /* and uncertain ones */
#define MARGIN 1e-9         /* of a bound, against rounding */
#define STRICT 0.5          /* of what values may be off: robots found lack no more than that */
#define CLEARLY 2.0         /* times what counts as none: that is asked, by any rounding */
#define PER_SWEEP 4.0       /* units of work to sweep a plane, for each robot */
#define PER_ROW 0.5         /* units of work to value a row of the pool, */
#define PER_PIECE 10.0      /* and to bound a piece */

/* Of a piece: a level just above the best is told from it by rounding alone in a COARSE one, and no
 * level is in a SETTLED one. */
enum { OPEN, COARSE, SETTLED };

typedef struct {
    double v[3], size; /* only directions with (v[0], v[1]) . F >= v[2] reach the level */
    int i, j;          /* because these two demands clash elsewhere */
} Arc;

Status search_spend(Search *s, double units) { return spend(&s->work, units); }

/* -- the pool ---------------------------------------------------------------------------- */

static Status add_row(Search *s, const double *normal, double height, double cap) {
    if (s->count == s->room) {
        int room = 2 * s->room;
        Row *grown = realloc(s->pool, (size_t)room * sizeof *grown);
        if (!grown)
            return NO_MEMORY;
        s->pool = grown;
        s->room = room;
    }
    Row *row = s->pool + s->count++;
    int free = fabs(normal[2]) <= TORQUE_FREE * (fabs(normal[0]) + fabs(normal[1]));
    row->m[0] = normal[0] * s->weights[0];
    row->m[1] = normal[1] * s->weights[1];
    row->m[2] = free ? 0.0 : normal[2] * s->weights[2];
    row->height = height;
    row->cap = cap;
    row->slack = s->criterion ? s->rounding * length(normal) : 0.0;
    if (cap < s->pool[s->lowest].cap)
        s->lowest = s->count - 1;
    row->inverse = free ? 1.0 : 1.0 / fabs(row->m[2]);
    return SOLVED;
}

/* Add a normal with what a criterion says of it, at the length at which D is 1. One that the task
 * asks nothing of makes no demand, unless the load is not held there. Returns a status; SOLVED also
 * if there is nothing to add. */
static Status add_normal(Search *s, const double *normal) {
    double unit[3], height, cap;
    double extent = criterion_extent(s->criterion, normal), least = CLEARLY * UNASKED * length(normal);
    Status status = criterion_height(s->criterion, normal, NULL, &height, &cap);
    if (status != SOLVED)
        return status;
    if (extent <= least) {
        if (height >= -ZERO / UNASKED * s->rounding * length(normal))
            return SOLVED;
        extent = least; /* the load alone is what counts */
    }
    for (int k = 0; k < 3; k++)
        unit[k] = normal[k] / extent;
    return add_row(s, unit, height / extent, cap / extent);
}

double search_length(const Search *s, int row) {
    double normal[3];
    if (!s->criterion)
        return 1.0;
    for (int k = 0; k < 3; k++)
        normal[k] = s->pool[row].m[k] / s->weights[k];
    return length(normal);
}

double search_total(const Search *s, const double *normal) {
    if (s->criterion)
        return criterion_total(s->criterion, normal);
    if (s->is_small)
        return dot(s->sweep.load, normal) + total_height(s->generators, s->n, normal);
    double m[3], g[3];
    whiten_normal(&s->tree.white, normal, m);
    tree_gradient(&s->tree, m, 0.0, g);
    return dot(g, m) + total_height(s->extra, s->n - s->in_tree, m);
}

Status search_height(const Search *s, const double *normal, double *height) {
    double cap;
    if (s->criterion)
        return criterion_height(s->criterion, normal, NULL, height, &cap);
    *height = search_total(s, normal);
    return SOLVED;
}

/* -- what a level demands ------------------------------------------------------------------ */

/* Find the tightest bounds on the torque that a level demands of a direction (c, s), and the rows
 * that demand them: twice the same if one demand on the direction alone fails, and then the
 * lower bound is above the upper. */
static void torque_bounds(Search *search, double level, double c, double s, double *lower,
                          double *upper, int *i, int *j) {
    double worst = 0.0;
    int barred = 0;
    charge(&search->work, PER_ROW * search->count);
    *lower = -INFINITY;
    *upper = INFINITY;
    *i = *j = 0;
    for (int k = 0; k < search->count; k++) {
        const Row *row = search->pool + k;
        double need = level - row->height;
        if (need < 0.0)
            continue;
        need = (need - row->m[0] * c - row->m[1] * s) * row->inverse;
        if (row->m[2] > 0.0) {
            if (need > *lower) {
                *lower = need;
                *i = k;
            }
        } else if (row->m[2] < 0.0) {
            if (-need < *upper) {
                *upper = -need;
                *j = k;
            }
        } else if (need > worst) {
            worst = need;
            barred = k;
        }
    }
    if (barred > 0) {
        *lower = 1.0;
        *upper = 0.0;
        *i = *j = barred;
    }
}

/* Cut an interval of directions to the part an arc allows; empty if lo > hi. The arc misses
 * `middle`; where rounding says otherwise, that side of it is kept on which the arc lies. */
static void narrow(const Arc *arc, double middle, double *lo, double *hi) {
    if (arc->v[2] > arc->size || arc->size == 0.0) {
        *lo = 1.0;
        *hi = 0.0;
        return;
    }
    double half = acos(larger(arc->v[2], 0.0) / arc->size), crest = atan2(arc->v[1], arc->v[0]);
    crest -= 2.0 * PI * round((crest - middle) / (2.0 * PI));
    if (crest > middle)
        *lo = middle;
    else
        *hi = middle;
    *lo = larger(*lo, crest - half);
    *hi = smaller(*hi, crest + half);
}

/* -- proofs -------------------------------------------------------------------------------- */

/* Find the mixture of two arcs with the least bound on the piece, but for `enough`. Each arc is
 * the mean of its normals that cancels the torque; the bound is convex in the share of the second
 * arc, and tangents at both ends close in on its least. */
static void prove(const Search *s, const double *piece, const Arc *one, const Arc *two,
                  double enough, Proof *proof) {
    const Arc *arcs[2] = {one, two};
    double mean[2][4] = {{0.0}}, mu = 0.0, best = 0.0;
    for (int a = 0; a < 2; a++) {
        int rows[2] = {arcs[a]->i, arcs[a]->j};
        double share[2], total = 0.0;
        for (int k = 0; k < 2; k++) {
            share[k] = rows[k] >= LIMITS ? s->pool[rows[k]].inverse : 0.0;
            total += share[k];
        }
        for (int k = 0; k < 2; k++) {
            const Row *row = s->pool + rows[k];
            share[k] /= total;
            for (int c = 0; c < 3; c++)
                mean[a][c] += share[k] * row->m[c];
            mean[a][3] += share[k] * row->height;
            proof->row[2 * a + k] = rows[k];
            proof->share[2 * a + k] = share[k];
        }
    }
    /* the ends of an interval that holds the best share, with bound and slope there */
    double ends[2][3];
    proof->bound = INFINITY;
    for (int step = 0; step < TANGENTS; step++) {
        double v[4], wrench[3], bound, slope;
        for (int c = 0; c < 4; c++)
            v[c] = mean[0][c] + mu * (mean[1][c] - mean[0][c]);
        bound = best_on_piece(piece, v, wrench) + v[3];
        if (bound < proof->bound) {
            proof->bound = bound;
            best = mu;
        }
        slope = mean[1][3] - mean[0][3];
        for (int c = 0; c < 3; c++)
            slope += (mean[1][c] - mean[0][c]) * wrench[c];
        if ((step == 0 && slope >= 0.0) || (step == 1 && slope <= 0.0))
            break; /* one of the arcs alone is best */
        double *end = ends[slope > 0.0];
        end[0] = mu;
        end[1] = bound;
        end[2] = slope;
        if (step == 0) {
            mu = 1.0;
            continue;
        }
        double lo = ends[0][0], hi = ends[1][0];
        mu = lo + (ends[1][1] - ends[0][1] - ends[1][2] * (hi - lo)) / (ends[0][2] - ends[1][2]);
        if (ends[0][1] + ends[0][2] * (mu - lo) >= proof->bound - enough)
            break;
        if (step % 3 == 2 || !(mu > lo && mu < hi))
            mu = 0.5 * (lo + hi);
    }
    for (int k = 0; k < 4; k++)
        proof->share[k] *= k > 1 ? best : 1.0 - best;
}

/* Write the best proof from the arc that emptied the interval and those at its ends. */
static void refute(const Search *s, const double *piece, const Arc *arc, const Arc *lo_arc,
                   const Arc *hi_arc, double enough, Proof *proof) {
    prove(s, piece, arc, lo_arc, enough, proof);
    if (hi_arc != lo_arc) {
        Proof other;
        prove(s, piece, arc, hi_arc, enough, &other);
        if (other.bound < proof->bound)
            *proof = other;
    }
}

/* Try one proof on every piece. */
static void share_proof(Search *s, const Proof *proof, Proof *proofs) {
    double mean[4] = {0.0}, highest = 0.0, cap = INFINITY, slack = 0.0, wrench[3];
    charge(&s->work, PER_PIECE * s->many);
    for (int k = 0; k < 4; k++)
        if (proof->share[k] > 0.0) {
            const Row *row = s->pool + proof->row[k];
            highest = larger(highest, row->height);
            cap = smaller(cap, row->cap);
            for (int c = 0; c < 3; c++)
                mean[c] += proof->share[k] * row->m[c];
            mean[3] += proof->share[k] * row->height;
            slack = larger(slack, row->slack);
        }
    for (int k = 0; k < s->many; k++)
        if (proofs[k].bound > smaller(highest, cap)) {
            double bound = best_on_piece(s->pieces + PIECE * k, mean, wrench) + mean[3];
            bound = smaller(larger(bound, highest), cap);
            if (bound < proofs[k].bound) {
                proofs[k] = *proof;
                proofs[k].bound = bound;
                proofs[k].slack = slack;
            }
        }
}

/* -- exact qualities with a newcomer ----------------------------------------------------------- */

static double tightest(const Search *s) {
    return s->criterion->spread ? TIGHT_SPREAD : TIGHT_KNOWN;
}

/* Units of work to sweep the plane across a robot. */
static double sweep_work(const Search *s) { return (PER_SWEEP + 0.1 * s->n) * s->n; }

/* The least quality that rows allow a robot, with what rounding may add, and the row. */
static double least_in_pool(Search *s, const double *wrench, int *at) {
    double least = INFINITY;
    *at = LIMITS;
    charge(&s->work, PER_ROW * s->count);
    for (int k = LIMITS; k < s->count; k++) {
        const Row *row = s->pool + k;
        if (row->height >= least)
            continue;
        double value = row->slack + smaller(row->height + larger(0.0, dot(row->m, wrench)),
                                            row->cap);
        if (value < least) {
            least = value;
            *at = k;
        }
    }
    return least;
}

Status search_quality(Search *s, const double *wrench, double enough, double *quality,
                      double *normal) {
    double generator[3];
    int at;
    *quality = least_in_pool(s, wrench, &at);
    for (int k = 0; k < 3; k++) {
        normal[k] = s->pool[at].m[k] / s->weights[k];
        generator[k] = wrench[k] * s->weights[k];
    }
    if (*quality < enough) {
        *quality -= s->pool[at].slack;
        return SOLVED;
    }
    if (s->is_small) {
        charge(&s->work, sweep_work(s));
        *quality = sweep_least(&s->sweep, s->generators, s->n, generator, 0, *quality, s->error,
                               normal);
        return SOLVED;
    }
    if (s->criterion) {
        double weakest[3], value;
        Status status = criterion_search(s->criterion, generator, tightest(s), *quality,
                                         s->rounding, &s->work, &value, weakest);
        *quality -= s->pool[at].slack;
        if (length(weakest) > 0.0) {
            *quality = value;
            memcpy(normal, weakest, sizeof weakest);
        }
        return status;
    }
    Sphere sphere;
    int extras = s->n - s->in_tree + 1;
    whiten(&s->tree.white, generator, s->extra + 3 * (extras - 1));
    Status status = sphere_search(&sphere, &s->tree, s->extra, extras, &s->open, 0.0, *quality,
                                  ZERO * s->size, &s->work);
    if (sphere.best < *quality)
        *quality = sphere_best(&sphere, normal);
    sphere_free(&sphere);
    return status;
}

Status search_value(Search *s, const double *wrench, double *quality, double *normal) {
    double left = s->work.left;
    s->work.left = WORK + PER_ROBOT * s->n;
    Status status = search_quality(s, wrench, -INFINITY, quality, normal);
    s->work.left = left;
    if (!is_fault(status))
        status = search_spend(s, 0.0);
    return status == OUT_OF_BUDGET ? SOLVED : status;
}

/* Turn a normal that a robot fails away from the robot's wrench, for a deeper cut. At
 * cos(phi) n - sin(phi) b/|b| the robot misses the demand t - h of the level t by sin(phi) |b|
 * more; phi grows in halving steps while that is a gain. Without it a robot much stronger than
 * the others would be cut off a sliver at a time. Returns h at the normal. */
static double tilt(const Search *s, double *normal, double height, double level,
                   const double *generator) {
    double size = length(generator), phi = 0.5 * PI, miss = level - height, best = 0.0;
    double turned[3];
    for (int step = 0; step < TILTS; step++) {
        phi *= 0.5;
        double c = cos(best + phi), d = sin(best + phi) / size;
        for (int k = 0; k < 3; k++)
            turned[k] = c * normal[k] - d * generator[k];
        double h = search_total(s, turned), gain = level - h + d * size * size;
        if (h < level && gain > miss) {
            miss = gain;
            height = h;
            best += phi;
        }
    }
    double c = cos(best), d = sin(best) / size;
    for (int k = 0; k < 3; k++)
        normal[k] = c * normal[k] - d * generator[k];
    return height;
}

/* Ask whether the robot at hand reaches a level: REACHED, SOLVED (a new cut says no), or a fault. */
static Status try_robot(Search *s, const double *wrench, double level, Best *best) {
    double generator[3], normal[3], value, quality, height, slack = MISSED * s->size;
    for (int k = 0; k < 3; k++)
        generator[k] = wrench[k] * s->weights[k];
    if (s->is_small) { /* all facets hold: only normals across the robot can fail */
        int at;
        charge(&s->work, sweep_work(s));
        value = sweep_least(&s->sweep, s->generators, s->n, generator, 0, INFINITY, s->error,
                            normal);
        quality = smaller(value, least_in_pool(s, wrench, &at));
        height = value;
    } else {
        Status status = search_quality(s, wrench, -INFINITY, &quality, normal);
        if (status != SOLVED)
            return status;
        value = quality;
        height = value - larger(0.0, dot(normal, generator));
    }
    if (quality > best->quality) {
        best->quality = quality;
        memcpy(best->wrench, wrench, sizeof best->wrench);
    }
    if (s->criterion)
        slack = larger(slack, s->rounding / larger(criterion_extent(s->criterion, normal), UNASKED));
    if (value >= level - slack)
        return REACHED;
    if (s->criterion) {
        int count = s->count;
        Status status = add_normal(s, normal);
        if (status != SOLVED)
            return status;
        if (s->count == count) /* rounding alone */
            return REACHED;
        return s->pool[s->lowest].cap < level ? CAPPED : SOLVED;
    }
    if (s->is_small)
        height = tilt(s, normal, height, level, generator);
    return add_row(s, normal, height, INFINITY);
}

/* -- the search ------------------------------------------------------------------------------ */

/* Decide whether a piece has a robot that reaches a level; REFUTED comes with its proof. */
static Status reach(Search *s, const double *piece, double level, Best *best, Proof *proof) {
    Arc at_lo, at_hi, arc;
    int is_lo_set = 0, is_hi_set = 0;
    for (int k = 0; k < LIMITS; k++) {
        double sign = 1.0 - 2.0 * k;
        s->pool[k] = (Row){{sign * piece[2 * k + 1], -sign * piece[2 * k], sign}, level, INFINITY,
                           1.0, 0.0};
    }
    double lo = piece[4], hi = piece[5];
    for (;;) {
        Status status = search_spend(s, 0.0);
        if (status != SOLVED)
            return status;
        double middle = 0.5 * (lo + hi), wrench[3] = {cos(middle), sin(middle), 0.0};
        double lower, upper, new_lo = lo, new_hi = hi;
        int i, j;
        torque_bounds(s, level, wrench[0], wrench[1], &lower, &upper, &i, &j);
        if (lower <= upper || (i < LIMITS && j < LIMITS)) {
            wrench[2] = 0.5 * (lower + upper);
            status = try_robot(s, wrench, level, best);
            if (status != SOLVED)
                return status;
            continue;
        }
        const Row *a = s->pool + i, *b = s->pool + j;
        for (int k = 0; k < 2; k++)
            arc.v[k] = a->m[k] * a->inverse + b->m[k] * b->inverse;
        arc.v[2] = (level - a->height) * a->inverse + (level - b->height) * b->inverse;
        arc.size = sqrt(arc.v[0] * arc.v[0] + arc.v[1] * arc.v[1]);
        arc.i = i;
        arc.j = j;
        narrow(&arc, middle, &new_lo, &new_hi);
        if (new_hi - new_lo <= ARC_END) {
            refute(s, piece, &arc, is_lo_set ? &at_lo : &arc, is_hi_set ? &at_hi : &arc,
                   TIGHT * (level - best->quality), proof);
            return REFUTED;
        }
        if (new_lo > lo) {
            at_lo = arc;
            is_lo_set = 1;
        }
        if (new_hi < hi) {
            at_hi = arc;
            is_hi_set = 1;
        }
        lo = new_lo;
        hi = new_hi;
    }
}

/* Bound all pieces by what is known before any search. */
static void first_proofs(Search *s, Proof *proofs) {
    Proof trial = {INFINITY, 0.0, {LIMITS, LIMITS + 1, LIMITS, LIMITS}, {1.0, 0.0, 0.0, 0.0}};
    for (int k = 0; k < s->many; k++)
        proofs[k].bound = INFINITY;
    share_proof(s, &trial, proofs);
    /* no robot lifts n and -n: nothing exceeds the larger h of the two (T17) */
    trial.share[0] = trial.share[1] = 0.5;
    for (int k = 0; k < 2; k++) {
        share_proof(s, &trial, proofs);
        trial.row[0] += 2;
        trial.row[1] += 2;
    }
}

Status search_solve(Search *s, const char *chosen, double gap, Best *best, Proof *proofs) {
    Status status = SOLVED;
    char *progress = calloc((size_t)s->many, 1); /* OPEN */
    if (!progress)
        return NO_MEMORY;
    for (int k = 0; chosen && k < s->many; k++)
        progress[k] = chosen[k] ? OPEN : SETTLED;
    *best = (Best){s->quality, {0.0, 0.0, 0.0}, -1};
    first_proofs(s, proofs);
    for (;;) {
        Proof trial;
        int k = -1;
        for (int j = 0; j < s->many; j++)
            if (progress[j] != SETTLED && (k < 0 || proofs[j].bound > proofs[k].bound
                                || (proofs[j].bound == proofs[k].bound && j == best->piece)))
                k = j;
        if (k < 0)
            break;
        double before = best->quality, high = proofs[k].bound;
        if (high - before <= larger(larger(gap * before, FLOOR * s->size), proofs[k].slack))
            break;
        charge(&s->work, PER_ROW * s->many);
        int is_probe = best->piece >= 0 && best->piece != k && progress[k] == OPEN;
        double share = is_probe ? PROBE : 0.5;
        double level = before + share * (high - before);
        Status outcome = s->pool[s->lowest].cap < level
                             ? CAPPED
                             : reach(s, s->pieces + PIECE * k, level, best, &trial);
        if (best->quality > before)
            best->piece = k;
        if (outcome == CAPPED) {
            int row = s->lowest;
            trial = (Proof){INFINITY, 0.0, {row, row, row, row}, {1.0, 0.0, 0.0, 0.0}};
            share_proof(s, &trial, proofs);
        } else if (outcome == REFUTED) {
            share_proof(s, &trial, proofs);
            if (proofs[k].bound - level > 0.5 * (high - level))
                progress[k] = SETTLED; /* rounding alone holds the bound up */
        } else if (outcome == REACHED) {
            if (best->quality - before < 0.5 * (level - before)) /* by rounding alone */
                progress[k] = is_probe ? COARSE : SETTLED;
        } else {
            status = outcome;
            break;
        }
    }
    free(progress);
    return status;
}

/* -- the base swarm --------------------------------------------------------------------------- */

/* Start the pool with the weakest normal, one that is little stronger also in the opposite
 * direction, and their opposites; writes a quality that no newcomer exceeds. */
static Status begin_pool(Search *s, const double *both, double *most) {
    const double *normals[2] = {s->weakest, both};
    Status status = SOLVED;
    for (int k = 0; k < 2 && status == SOLVED; k++) {
        int count = s->count;
        double opposite[3] = {-normals[k][0], -normals[k][1], -normals[k][2]};
        if (s->criterion) {
            status = add_normal(s, normals[k]);
            if (status == SOLVED)
                status = add_normal(s, opposite);
            for (int j = 0; status == SOLVED && s->count < count + 2; j++) /* nothing is asked there */
                status = add_normal(s, s->criterion->task + 3 * (j % s->criterion->tasks));
        } else {
            status = add_row(s, normals[k], search_total(s, normals[k]), INFINITY);
            if (status == SOLVED)
                status = add_row(s, opposite, search_total(s, opposite), INFINITY);
        }
    }
    Proof *proofs = status == SOLVED ? malloc((size_t)s->many * sizeof *proofs) : NULL;
    if (!proofs)
        return is_fault(status) ? status : NO_MEMORY;
    first_proofs(s, proofs);
    *most = s->quality;
    for (int k = 0; k < s->many; k++)
        *most = larger(*most, proofs[k].bound);
    *most += MARGIN * s->size;
    free(proofs);
    return SOLVED;
}

/* Find the weakest of all facets listed, and keep in the pool those that a newcomer can matter to. */
static Status pool_from_facets(Search *s) {
    const double *both = s->weakest;
    double least = INFINITY, most;
    s->quality = INFINITY;
    for (ptrdiff_t k = 0; k < s->facets; k++)
        if (s->heights[k] < s->quality) {
            s->quality = s->heights[k];
            memcpy(s->weakest, s->normals + 3 * k, sizeof s->weakest);
        }
    round_quality(s->generators, s->n, s->weight, &s->quality, s->weakest);
    for (ptrdiff_t k = 0; k < s->facets; k += 2)
        if (larger(s->heights[k], s->heights[k + 1]) < least) {
            least = larger(s->heights[k], s->heights[k + 1]);
            both = s->normals + 3 * k;
        }
    Status status = begin_pool(s, both, &most);
    for (ptrdiff_t k = 0; k < s->facets && status == SOLVED; k++)
        if (s->heights[k] < most)
            status = add_row(s, s->normals + 3 * k, s->heights[k], INFINITY);
    return status;
}

/* Find the weakest normal, and the directions that a newcomer can matter to. `from` are those of
 * the swarm before its last robot joined, or NULL. */
static Status pool_from_sphere(Search *s, const Sphere *from, double margin) {
    Sphere found;
    double most;
    int extras = s->n - s->in_tree;
    Status status = sphere_search(&found, &s->tree, s->extra, extras, from, margin, INFINITY,
                                  ZERO * s->size, &s->work);
    sphere_free(&s->base);
    s->base = found;
    if (is_fault(status))
        return status;
    s->covered = smaller(from ? s->covered : INFINITY, found.best + margin);
    s->quality = sphere_best(&found, s->weakest);
    round_quality(s->generators, s->n, s->weight, &s->quality, s->weakest);
    s->count = LIMITS;
    status = begin_pool(s, s->weakest, &most);
    if (status != SOLVED)
        return status;
    if (most > s->covered && from)
        return pool_from_sphere(s, NULL, AHEAD * s->strength);
    return sphere_keep(&s->open, &s->base, smaller(most, s->covered));
}

/* Find the weakest normal by a criterion. */
static Status pool_from_criterion(Search *s) {
    double most;
    Status status = criterion_search(s->criterion, NULL, tightest(s), INFINITY, s->rounding,
                                     &s->work, &s->quality, s->weakest);
    if (is_fault(status))
        return status;
    round_quality(s->generators, s->n, s->weight, &s->quality, s->weakest);
    if (status == OUT_OF_BUDGET)
        s->quality = 0.0;
    return begin_pool(s, s->weakest, &most);
}

/* List the facets of the base swarm, or build its tree. */
static Status list_or_build(Search *s) {
    tree_free(&s->tree);
    s->count = LIMITS;
    s->in_tree = s->n;
    s->is_small = s->n <= s->few && !s->criterion;
    if (s->criterion)
        return pool_from_criterion(s);
    if (!s->is_small) {
        Status status = tree_build(&s->tree, s->generators, s->n, s->sweep.load, &s->work);
        if (status != SOLVED)
            return status;
        return pool_from_sphere(s, NULL, s->strength);
    }
    size_t room = (size_t)s->n * (size_t)(s->n > 1 ? s->n - 1 : 1) + 1;
    free(s->normals);
    s->normals = malloc(4 * room * sizeof *s->normals);
    if (!s->normals)
        return NO_MEMORY;
    s->heights = s->normals + 3 * room;
    s->facets = sweep_facets(&s->sweep, s->generators, s->n, s->normals, s->heights);
    return pool_from_facets(s);
}

/* Find what the base swarm is worth, and have the work counted anew for what is asked of it. */
static Status start(Search *s) {
    Status status = list_or_build(s);
    if (!s->criterion)
        s->work.left = s->units;
    return status;
}

/* Note where a newcomer may attach, and how strong it can be. */
static void take_pieces(Search *s, const double *pieces, int many) {
    double arm = 0.0;
    s->pieces = pieces;
    s->many = many;
    for (int k = 0; k < many; k++)
        for (int j = 0; j < 4; j += 2)
            arm = larger(arm, hypot(pieces[PIECE * k + j], pieces[PIECE * k + j + 1]));
    s->strength = hypot(larger(s->weights[0], s->weights[1]), arm * s->weights[2]) * (1.0 + MARGIN);
    s->size = s->weight + s->strength;
    s->error = sweep_error(s->weight);
    s->rounding = STRICT * UNASKED * s->size;
}

Status search_begin(Search *s, const double *generators, int n, const double *load,
                    const Criterion *criterion, const double *weights, const double *pieces,
                    int many, double units, int (*interrupted)(void)) {
    *s = (Search){.generators = generators, .n = n, .criterion = criterion,
                  .units = units,
                  .work = work_of(criterion ? units : WORK + PER_ROBOT * n, interrupted)};
    memcpy(s->weights, weights, sizeof s->weights);
    s->weight = criterion ? criterion->weight : total_size(generators, n);
    take_pieces(s, pieces, many);
    /* one stronger than all the others together takes many exact qualities to place */
    s->few = s->strength > s->weight ? GIANT : SMALL;
    s->room = 256;
    s->pool = calloc((size_t)s->room, sizeof *s->pool);
    if (s->pool)
        s->pool[0].cap = INFINITY;
    Status status = s->pool ? sweep_room(&s->sweep, n <= s->few ? s->few : 0, load) : NO_MEMORY;
    return status == SOLVED ? start(s) : status;
}

/* The facets of a small swarm with one robot more: the old ones, lifted, and those across it. */
static Status join_facets(Search *s, const double *generator) {
    int found = sweep_plane(&s->sweep, s->generators, s->n - 1, generator, 0, s->error);
    size_t room = (size_t)(s->facets + found) + 1;
    double *normals = malloc(4 * room * sizeof *normals), *heights = normals + 3 * room;
    if (!normals)
        return NO_MEMORY;
    memcpy(normals, s->normals, 3 * (size_t)s->facets * sizeof *normals);
    for (ptrdiff_t k = 0; k < s->facets; k++)
        heights[k] = s->heights[k] + larger(0.0, dot(normals + 3 * k, generator));
    memcpy(normals + 3 * s->facets, s->sweep.normals, 3 * (size_t)found * sizeof *normals);
    memcpy(heights + s->facets, s->sweep.heights, (size_t)found * sizeof *heights);
    free(s->normals);
    s->normals = normals;
    s->heights = heights;
    s->facets += found;
    s->count = LIMITS;
    return pool_from_facets(s);
}

Status search_join(Search *s, const double *wrench, const double *pieces, int many) {
    size_t size = 3 * ((size_t)s->n + 1) * sizeof *s->own;
    double *own = realloc(s->own, size), *generator;
    if (!own)
        return NO_MEMORY;
    if (!s->own)
        memcpy(own, s->generators, size - 3 * sizeof *own);
    s->generators = s->own = own;
    generator = own + 3 * s->n++;
    for (int k = 0; k < 3; k++)
        generator[k] = wrench[k] * s->weights[k];
    s->weight += length(generator);
    s->work.left = WORK + PER_ROBOT * s->n;
    take_pieces(s, pieces, many);
    if (s->is_small && s->n <= s->few) {
        s->work.left = s->units;
        return join_facets(s, generator);
    }
    if (s->is_small || s->n - s->in_tree > EXTRAS)
        return start(s);
    whiten(&s->tree.white, generator, s->extra + 3 * (s->n - s->in_tree - 1));
    Sphere before = s->base;
    s->base = (Sphere){0};
    Status status = pool_from_sphere(s, &before, INFINITY);
    s->work.left = s->units;
    sphere_free(&before);
    return status;
}

void search_end(Search *s) {
    free(s->own);
    free(s->pool);
    free(s->normals);
    sweep_free(&s->sweep);
    sphere_free(&s->base);
    sphere_free(&s->open);
    tree_free(&s->tree);
}
