/* A newcomer of fixed direction by branch and bound over boxes, with a matrix game for each (T23). Trusted
 * are pieces as `Pieces` makes them, and a positive limit. A game goes on where it was as rows come in: played
 * anew each time, with 24 rows at first, games took twice the time. */
#include <stdlib.h>
#include <string.h>

#include "boxes.h"
#include "place.h"
#include "quality.h"

#define NEARER 0.05     /* gap of a quality that is asked, relative to that of the search */
#define STARTS 3       /* normals at which it begins */
#define PARALLEL 1e-9   /* sine of the angle between wrenches that have no common plane */
#define FIRST 8         /* rows that a game begins with: few, as 6 are enough in the end, */
#define FRESH 8         /* that come in at a time, */
#define ACTIVE 96       /* and that it has at most */
#define GIVEN (CORNERS + 1) /* columns of its tableau before theirs: slacks, and what is to be shared */
#define LOWER 1e-11     /* of the range of worths: a row that is lower by more comes in */
#define PIVOTS 60       /* until more rows come in; the combination is good at any time */
#define LOWEST 6        /* normals through which others travel */
#define BESIDE 3.0      /* diameters of a box within which its wrenches are across such a normal */
#define EDGES 3         /* of h through one of them */
#define TRAVELLERS (LOWEST * EDGES + CORNERS) /* normals that travel, at most */
#define ON_EDGE 1e-6    /* sine of the angle between a normal and a wrench across it */
#define ACROSS 1e-5     /* sine of the angle between a wrench and g below which rounding turns b x g */
#define TURNED_OFF 0.02 /* of the mean, up to which a travelling normal may all but vanish */
#define MIDDLE 0.2      /* share of a box within which it is not cut near its ends */
#define FEW_POINTS 4    /* corners of a force set up to which all lines between them are edges */
#define FLATS 16        /* wrenches that differ, up to which a flat swarm is looked for */
#define NOTHING 1e-13   /* of all wrenches together: what counts as none where it is */
#define PASS 2.0        /* units of work that a normal takes in a box */

/* -- what is known ------------------------------------------------------------------------------ */

static double phi(const BoxSearch *s, double x) { return larger(s->limit * x, -s->reverse * x); }

/* What a newcomer with the unit wrench b reaches at most, by one normal. */
static double reach_of(const BoxSearch *s, const Known *at, const double *b) {
    return allowed(at, at->height + phi(s, dot(at->normal, b)));
}

/* List the wrenches across which h may have an edge: corners of force sets, and lines between them. */
static Status list_kinks(BoxSearch *s) {
    const Sets *sets = s->pool.sets;
    size_t most = 1;
    for (int i = 0; i < sets->count; i++)
        most += (size_t)sets->set[i].elements + FEW_POINTS * FEW_POINTS;
    s->kink = malloc(3 * most * sizeof *s->kink);
    if (!s->kink)
        return NO_MEMORY;
    for (int i = 0; i < sets->count; i++) {
        const ForceSet *set = sets->set + i;
        for (int k = 0; k < set->elements; k++)
            for (int j = -1; j < (set->elements <= FEW_POINTS ? k : 0); j++) {
                if (set->element[k].shape != POINT || (j >= 0 && set->element[j].shape != POINT))
                    continue;
                double force[2] = {set->element[k].at[0], set->element[k].at[1]};
                if (j >= 0) {
                    force[0] -= set->element[j].at[0];
                    force[1] -= set->element[j].at[1];
                }
                double *kink = s->kink + 3 * (ptrdiff_t)s->kinks, size;
                wrench_of(sets->scale, set->arm, force, kink);
                size = length(kink);
                if (size == 0.0)
                    continue;
                for (int c = 0; c < 3; c++)
                    kink[c] /= size;
                s->kinks++;
            }
    }
    return SOLVED;
}

static void find_lost(BoxSearch *s, const double *normal, int *lost);
static double height_without(const Sets *sets, const int *lost, const double *normal);

/* Tell whether h is nothing at a normal m, its opposite, and another across it, without those machines
 * that add most at one of them; keep them if so. */
static int keep_flat(BoxSearch *s, const double *m, const double *across) {
    const double *probe[2] = {m, across}, back[3] = {-m[0], -m[1], -m[2]};
    double nothing = NOTHING * s->pool.size;
    for (int k = 0; k < 3 && !s->is_flat; k++) {
        int lost[LOST];
        find_lost(s, k < 2 ? probe[k] : back, lost);
        s->is_flat = height_without(s->pool.sets, lost, m) <= nothing
                     && height_without(s->pool.sets, lost, back) <= nothing
                     && height_without(s->pool.sets, lost, across) <= nothing;
        for (int i = 0; i < 2; i++) {
            s->flat[i] = (Term){.kind = FLAT, .weight = 1.0};
            memcpy(s->flat[i].vector, probe[i], sizeof s->flat[i].vector);
            memcpy(s->flat[i].lost, lost, sizeof lost);
        }
    }
    return s->is_flat;
}

/* Set `across` to a unit vector at right angles to two; returns whether there is one. */
static int unit_across(const double *a, const double *b, double sign, double *across) {
    cross(a, b, across);
    double size = length(across);
    for (int c = 0; c < 3; c++)
        across[c] *= size > 0.0 ? sign / size : 0.0;
    return size > PARALLEL;
}

/* Look for normals by which no newcomer gives any quality: across the wrenches of the robots that are
 * left, of which there are few, and across the load. */
static Status find_flat(BoxSearch *s) {
    const Sets *sets = s->pool.sets;
    double way[FLATS + 4][3], load = length(sets->load), m[3], across[3];
    int ways = 0;
    if (!s->is_convex || sets->tasks || s->pool.quality > ZERO * s->pool.size)
        return SOLVED;
    for (int k = 0; k < s->kinks && ways <= FLATS; k++) {
        int is_new = 1;
        for (int j = 0; j < ways && is_new; j++)
            is_new = unit_across(way[j], s->kink + 3 * (ptrdiff_t)k, 1.0, m);
        if (is_new)
            memcpy(way[ways++], s->kink + 3 * (ptrdiff_t)k, sizeof way[0]);
    }
    if (ways > FLATS)
        return SOLVED;
    for (int c = 0; c < 3 && load > 0.0; c++)
        way[ways][c] = sets->load[c] / load;
    ways += load > 0.0;
    for (int k = 0; k < 3; k++, ways++)
        for (int c = 0; c < 3; c++)
            way[ways][c] = c == k;
    for (int i = 0; i < ways; i++)
        for (int j = 0; j < i; j++) {
            double height, cap, back[3];
            if (!unit_across(way[i], way[j], 1.0, m))
                continue;
            for (int c = 0; c < 3; c++)
                back[c] = -m[c];
            Status status = sets_height(sets, m, NULL, &height, &cap);
            if (status != SOLVED || height > NOTHING * s->pool.size)
                continue;
            status = sets_height(sets, back, NULL, &height, &cap);
            if (status != SOLVED || height > NOTHING * s->pool.size)
                continue;
            for (int k = 0; k < 2 * ways; k++)
                if (unit_across(m, way[k / 2], k & 1 ? -1.0 : 1.0, across) && keep_flat(s, m, across))
                    return SOLVED;
        }
    return SOLVED;
}

Status boxes_begin(BoxSearch *s, const Sets *sets, const double *pieces, int many, double limit,
                   double reverse, double units, int (*interrupted)(void)) {
    double most = 0.0;
    for (int k = 0; k < 2 * many; k++) {
        const double *arm = pieces + PIECE * (ptrdiff_t)(k / 2) + 2 * (k & 1);
        most = larger(most, sets->scale[2] * hypot(arm[0], arm[1]));
    }
    most = larger(limit, reverse) * hypot(larger(sets->scale[0], sets->scale[1]), most);
    *s = (BoxSearch){.pieces = pieces, .many = many, .limit = limit, .reverse = reverse,
                     .is_convex = sets->losing <= LOST && sets->failures == 0};
    for (int i = 0; i < sets->count; i++)
        if (sets->set[i].adrift || sets->set[i].turning)
            s->is_convex = 0;
    Status status = pool_begin(&s->pool, sets, most, units, interrupted);
    if (status == SOLVED)
        status = list_kinks(s);
    s->exerted = malloc(((size_t)sets->machines + 1) * sizeof *s->exerted);
    if (!s->exerted)
        return NO_MEMORY;
    return status == SOLVED ? find_flat(s) : status;
}

void boxes_end(BoxSearch *s) {
    void *all[] = {s->kink, s->box, s->row, s->used, s->exerted};
    pool_end(&s->pool);
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        free(all[k]);
}

/* Of the normals across a unit wrench and an edge of h, find one with the least H / D. */
static Status find_across(BoxSearch *s, const double *b, double *value, double *normal) {
    Status status = SOLVED;
    *value = INFINITY;
    for (int k = 0; k < 2 * s->kinks && status == SOLVED; k++) {
        double n[3], height, cap;
        cross(b, s->kink + 3 * (ptrdiff_t)(k / 2), n);
        double size = (k & 1 ? -1.0 : 1.0) * length(n);
        if (!(fabs(size) > PARALLEL))
            continue;
        for (int c = 0; c < 3; c++)
            n[c] /= size;
        status = sets_height(s->pool.sets, n, NULL, &height, &cap);
        if (status != SOLVED)
            return status;
        double extent = sets_extent(s->pool.sets, n);
        double here = extent > UNASKED ? height / extent : height < 0.0 ? 0.0 : INFINITY;
        if (here < *value) {
            *value = here;
            memcpy(normal, n, sizeof n);
        }
        status = spend(&s->pool.work, s->pool.sets->count);
    }
    return status;
}

Status boxes_quality(BoxSearch *s, const double *arm, double direction, double gap,
                     double *quality, double *normal) {
    double c = cos(direction), sn = sin(direction), b[3], force[2] = {c, sn}, bound;
    double start[STARTS][3], low[STARTS];
    double ahead[ELEMENT] = {0.0, s->limit * c, s->limit * sn, direction - 0.5 * PI,
                             direction + 0.5 * PI};
    double astern[ELEMENT] = {0.0, -s->reverse * c, -s->reverse * sn, direction + 0.5 * PI,
                              direction + 1.5 * PI};
    Element element[2] = {element_of(ahead), element_of(astern)};
    ForceSet set = {.arm = {arm[0], arm[1]}, .element = element, .elements = 2};
    wrench_of(s->pool.sets->scale, arm, force, b);
    Status status = find_across(s, b, quality, normal);
    if (status != SOLVED)
        return status;
    if (*quality <= ZERO * s->pool.size) {
        *quality = 0.0;
        return SOLVED;
    }
    int kept[STARTS], starts = 0;
    if (*quality < INFINITY)
        starts = keep_lowest(kept, low, starts, STARTS, -1, *quality);
    for (int k = 0; k < s->pool.count; k++) {
        double value = reach_of(s, s->pool.row + k, b);
        if (value < INFINITY)
            starts = keep_lowest(kept, low, starts, STARTS, k, value);
    }
    for (int k = 0; k < starts; k++)
        memcpy(start[k], kept[k] < 0 ? normal : s->pool.row[kept[k]].normal, sizeof start[k]);
    return sets_search(s->pool.sets, &set, gap, INFINITY, 0.0, start[0], starts, &s->pool.work, quality,
                       &bound, normal);
}

/* -- games -------------------------------------------------------------------------------------- */

/* The game of a box at a level, as a tableau that grows. */
typedef struct {
    double level;
    int kept;                  /* rows in `used`; the others cannot matter: */
    double least_top, lowest;  /* they are worth more than the least of what rows are worth at most */
    double unit;               /* worths beyond the lowest, by this, are the game's, and 1 more */
    int actives, active[ACTIVE];
    int basis[CORNERS];
    double t[CORNERS + 1][GIVEN + ACTIVE]; /* the last row: prices */
} Game;

/* Of rows (count, CORNERS + 1), A and D, the worth of a mixture of corners at a level. */
static double worth(const double *row, double level, const double *share) {
    double sum = 0.0;
    for (int i = 0; i < CORNERS; i++)
        sum += share[i] * row[i];
    return sum - level * row[CORNERS];
}

/* Note which of some more rows may matter. */
static void sift_rows(BoxSearch *s, Game *g, int from, int to) {
    for (int k = from; k < to; k++) {
        const double *row = s->row + (ptrdiff_t)k * (CORNERS + 1);
        double top = row[0];
        for (int i = 1; i < CORNERS; i++)
            top = larger(top, row[i]);
        g->least_top = smaller(g->least_top, top - g->level * row[CORNERS]);
    }
    for (int k = from; k < to; k++) {
        const double *row = s->row + (ptrdiff_t)k * (CORNERS + 1);
        double low = row[0];
        for (int i = 1; i < CORNERS; i++)
            low = smaller(low, row[i]);
        low -= g->level * row[CORNERS];
        if (low > g->least_top)
            continue;
        g->lowest = smaller(g->lowest, low);
        s->used[g->kept++] = k;
    }
}

/* Let a row into the game, where it stands as by all pivots so far. */
static void let_in(const BoxSearch *s, Game *g, int which) {
    const double *row = s->row + (ptrdiff_t)which * (CORNERS + 1);
    int column = GIVEN + g->actives;
    double entry[CORNERS];
    for (int i = 0; i < CORNERS; i++)
        entry[i] = 1.0 + (row[i] - g->level * row[CORNERS] - g->lowest) / g->unit;
    for (int i = 0; i <= CORNERS; i++) {
        double sum = i == CORNERS ? 1.0 : 0.0;
        for (int k = 0; k < CORNERS; k++)
            sum += g->t[i][k] * entry[k];
        g->t[i][column] = sum;
    }
    g->active[g->actives++] = which;
}

/* Begin with the rows that are lowest for an even mixture of corners. */
static void begin_game(const BoxSearch *s, Game *g) {
    double even[CORNERS], value[FIRST];
    int first[FIRST], count = 0;
    g->unit = g->least_top > g->lowest ? g->least_top - g->lowest : 1.0;
    g->actives = 0;
    for (int i = 0; i <= CORNERS; i++) {
        for (int k = 0; k < CORNERS; k++)
            g->t[i][k] = i == k;
        g->t[i][CORNERS] = i < CORNERS;
    }
    for (int i = 0; i < CORNERS; i++) {
        even[i] = 1.0 / CORNERS;
        g->basis[i] = i;
    }
    for (int k = 0; k < g->kept; k++)
        count = keep_lowest(first, value, count, FIRST, s->used[k],
                            worth(s->row + (ptrdiff_t)s->used[k] * (CORNERS + 1), g->level, even));
    for (int k = 0; k < count; k++)
        let_in(s, g, first[k]);
}

static void pivot(Game *g, int row, int column) {
    int width = GIVEN + g->actives;
    double by = 1.0 / g->t[row][column];
    for (int j = 0; j < width; j++)
        g->t[row][j] *= by;
    for (int i = 0; i <= CORNERS; i++) {
        double share = g->t[i][column];
        if (i == row || share == 0.0)
            continue;
        for (int j = 0; j < width; j++)
            g->t[i][j] -= share * g->t[row][j];
    }
    g->basis[row] = column;
}

/* Play the game of the rows that are in: the simplex method. */
static void play(Game *g) {
    for (int turn = 0; turn < PIVOTS; turn++) {
        int column = -1, row = -1;
        double most = 1e-11, step = INFINITY;
        const double *price = g->t[CORNERS];
        for (int j = 0; j < GIVEN + g->actives; j++)
            if (j != CORNERS && price[j] > most) {
                most = price[j];
                column = j;
            }
        if (column < 0)
            return;
        for (int i = 0; i < CORNERS; i++)
            if (g->t[i][column] > 1e-9 && g->t[i][CORNERS] < step * g->t[i][column]) {
                step = g->t[i][CORNERS] / g->t[i][column];
                row = i;
            }
        if (row < 0)
            return;
        pivot(g, row, column);
    }
}

/* Read the weights of the rows that are used, whose sum is 1, and the shares of the corners that do best
 * against them. Returns how many rows have a weight. */
static int read_game(const Game *g, int *chosen, double *weight, double *share) {
    int found = 0;
    double sum = 0.0, all = 0.0;
    for (int i = 0; i < CORNERS; i++) {
        double q = g->t[i][CORNERS];
        if (g->basis[i] >= GIVEN && q > 0.0) {
            chosen[found] = g->active[g->basis[i] - GIVEN];
            weight[found++] = q;
            sum += q;
        }
        share[i] = larger(0.0, -g->t[CORNERS][i]);
        all += share[i];
    }
    for (int k = 0; k < found; k++)
        weight[k] /= sum;
    for (int i = 0; i < CORNERS; i++)
        share[i] = all > 0.0 ? share[i] / all : 1.0 / CORNERS;
    return found;
}

/* Find the weights of rows whose greatest sum over the corners is least, at most CORNERS of them, and the
 * shares of the corners that do best against them: rows that are low come in until none is lower than
 * the game is worth. Returns how many rows have a weight. */
static int balance(BoxSearch *s, Game *g, int *chosen, double *weight, double *share) {
    while (1) {
        int fresh[FRESH], more = 0;
        double value[FRESH], game = INFINITY;
        play(g);
        int found = read_game(g, chosen, weight, share);
        for (int k = 0; k < g->actives; k++)
            game = smaller(game, worth(s->row + (ptrdiff_t)g->active[k] * (CORNERS + 1), g->level, share));
        for (int k = 0; k < g->kept; k++) {
            double here = worth(s->row + (ptrdiff_t)s->used[k] * (CORNERS + 1), g->level, share);
            if (here < game - LOWER * g->unit)
                more = keep_lowest(fresh, value, more, FRESH, s->used[k], here);
        }
        if (!more || g->actives + more > ACTIVE)
            return found;
        for (int k = 0; k < more; k++)
            let_in(s, g, fresh[k]);
    }
}

/* -- boxes -------------------------------------------------------------------------------------- */

/* The corners of a box, unit forces or little longer: contact by contact, in three directions. */
static void corners_of(const BoxSearch *s, const Box *box, double (*corner)[3], double (*force)[2]) {
    double half = 0.5 * (box->hi - box->lo), more = 1.0 / cos(half);
    double angle[3] = {box->lo, box->lo + half, box->hi};
    for (int i = 0; i < CORNERS; i++) {
        double arm[2], size = i % 3 == 1 ? more : 1.0;
        arm_at(s->pieces + PIECE * (ptrdiff_t)box->piece, i < 3 ? box->from : box->to, arm);
        force[i][0] = size * cos(angle[i % 3]);
        force[i][1] = size * sin(angle[i % 3]);
        wrench_of(s->pool.sets->scale, arm, force[i], corner[i]);
    }
}

/* Find the machines that add most along a normal, as many as may be lost. */
static void find_lost(BoxSearch *s, const double *normal, int *lost) {
    const Sets *sets = s->pool.sets;
    for (int k = 0; k < LOST; k++)
        lost[k] = -1;
    if (!sets->losing)
        return;
    memset(s->exerted, 0, (size_t)sets->machines * sizeof *s->exerted);
    for (int i = 0; i < sets->count; i++)
        s->exerted[sets->machine[i]] += exert(sets->scale, sets->set + i, normal, NULL, NULL, NULL);
    for (int k = 0; k < sets->losing; k++) {
        double most = 0.0;
        for (int m = 0; m < sets->machines; m++)
            if (s->exerted[m] > most) {
                most = s->exerted[m];
                lost[k] = m;
            }
        if (lost[k] >= 0)
            s->exerted[lost[k]] = 0.0;
    }
}

/* h at a normal, without some machines. */
static double height_without(const Sets *sets, const int *lost, const double *normal) {
    double height = dot(sets->load, normal);
    for (int i = 0; i < sets->count; i++) {
        int is_lost = 0;
        for (int k = 0; k < LOST; k++)
            is_lost |= lost[k] == sets->machine[i];
        if (!is_lost)
            height += exert(sets->scale, sets->set + i, normal, NULL, NULL, NULL);
    }
    return height;
}

/* Write a row of the normals b x g, which at a level is worth no less than any quality above it (T23):
 * with N the normals at the corners and d the task's wrench farthest along their sum, t D(n) <= h(n)
 * gives t c <= sum mu (h(N) - level d . N) + level c with c the least d . N. Returns whether there is
 * one. */
static Status travel(BoxSearch *s, double (*corner)[3], const double *g, double level, double *row,
                     Term *term, int *is_row) {
    double normal[CORNERS][3], sum[3] = {0.0}, d[3], least = INFINITY, mean = 0.0;
    *is_row = 0;
    *term = (Term){.kind = TRAVELLING, .vector = {g[0], g[1], g[2]}};
    for (int i = 0; i < CORNERS; i++) {
        cross(corner[i], g, normal[i]);
        add(sum, normal[i]);
        mean += length(normal[i]) / CORNERS;
    }
    if (!(length(sum) > TURNED_OFF * mean && mean > ACROSS * length(g) * length(corner[0])))
        return SOLVED;
    sets_farthest(s->pool.sets, sum, d);
    for (int i = 0; i < CORNERS; i++)
        least = smaller(least, dot(d, normal[i]));
    if (!(least > TURNED_OFF * mean))
        return SOLVED;
    find_lost(s, sum, term->lost);
    for (int i = 0; i < CORNERS; i++)
        row[i] = (height_without(s->pool.sets, term->lost, normal[i]) - level * dot(d, normal[i])) / least
                 + level;
    row[CORNERS] = 1.0;
    *is_row = 1;
    return spend(&s->pool.work, (double)CORNERS * s->pool.sets->count);
}

/* Tell whether a newcomer that betters a level pushes along a normal met. */
static int is_demanded(const BoxSearch *s, const Known *at, double level) {
    return s->reverse == 0.0 && at->height <= level * at->extent && (at->extent > 0.0 || at->height < 0.0);
}

/* Bound a box by weights of rows, first those of the pool and then travelling ones, and keep them. */
static void keep_terms(const BoxSearch *s, Box *box, const Term *travelling, int found, const int *chosen,
                       const double *weight, double level) {
    double asked = 0.0, most = -INFINITY;
    for (int i = 0; i < CORNERS; i++) {
        double sum = 0.0;
        for (int k = 0; k < found; k++)
            sum += weight[k] * s->row[(ptrdiff_t)chosen[k] * (CORNERS + 1) + i];
        most = larger(most, sum);
    }
    for (int k = 0; k < found; k++)
        asked += weight[k] * s->row[(ptrdiff_t)chosen[k] * (CORNERS + 1) + CORNERS];
    double bound = asked > UNASKED ? most / asked : most < 0.0 ? 0.0 : INFINITY;
    bound = larger(bound, level);
    if (bound >= box->bound)
        return;
    box->bound = bound;
    box->terms = found;
    for (int k = 0; k < found; k++) {
        Term *term = box->term + k;
        if (chosen[k] >= s->pool.count) {
            *term = travelling[chosen[k] - s->pool.count];
        } else {
            const Known *at = s->pool.row + chosen[k];
            *term = (Term){.kind = is_demanded(s, at, level) ? DEMANDED : MET};
            memcpy(term->vector, at->normal, sizeof term->vector);
        }
        term->weight = weight[k];
    }
}

/* Make room for a game of so many rows. */
static int make_room(BoxSearch *s, size_t rows) {
    free(s->row);
    free(s->used);
    s->row = malloc(rows * (CORNERS + 1) * sizeof *s->row);
    s->used = malloc(rows * sizeof *s->used);
    int is_made = s->row && s->used;
    s->rows_room = is_made ? (int)rows : 0;
    return is_made;
}

/* Write the rows of the pool for corners: forces at either end. */
static void write_rows(BoxSearch *s, const Box *box, double (*force)[2], double level) {
    double arm[2][2];
    for (int end = 0; end < 2; end++)
        arm_at(s->pieces + PIECE * (ptrdiff_t)box->piece, end ? box->to : box->from, arm[end]);
    for (int k = 0; k < s->pool.count; k++) {
        const Known *at = s->pool.row + k;
        double *row = s->row + (ptrdiff_t)k * (CORNERS + 1), p[2];
        int is_linear = is_demanded(s, at, level);
        for (int i = 0; i < CORNERS; i++) {
            if (i % 3 == 0)
                lever(s->pool.sets->scale, arm[i / 3], at->normal, p);
            double x = along(p, force[i]);
            row[i] = at->height + (is_linear ? s->limit * x : phi(s, x));
        }
        row[CORNERS] = at->extent;
    }
}

/* Write the rows of normals that travel across a box: those of the box it is a part of, and those through
 * the lowest normals that its wrenches are across. Counts them in `many`. */
static Status write_travelling(BoxSearch *s, double (*corner)[3], const double *middle, double wide,
                               double level, const Term *before, int befores, Term *term, int *many) {
    int low[LOWEST], lows = 0, is_row;
    double value[LOWEST], *row = s->row + (ptrdiff_t)s->pool.count * (CORNERS + 1);
    Status status = SOLVED;
    *many = 0;
    for (int k = 0; k < s->pool.count; k++) {
        const Known *known = s->pool.row + k;
        if (fabs(dot(known->normal, middle)) > BESIDE * wide || known->extent <= 0.0)
            continue;
        lows = keep_lowest(low, value, lows, LOWEST, k, reach_of(s, known, middle));
    }
    for (int k = 0; k < befores && status == SOLVED; k++)
        if (before[k].kind == TRAVELLING) {
            status = travel(s, corner, before[k].vector, level, row + *many * (CORNERS + 1), term + *many,
                            &is_row);
            *many += is_row;
        }
    for (int l = 0; l < lows && status == SOLVED; l++) {
        const double *normal = s->pool.row[low[l]].normal;
        int edges = 0;
        for (int k = 0; k <= s->kinks && edges < EDGES && status == SOLVED; k++) {
            double g[3], *kink = s->kink + 3 * (ptrdiff_t)k, there[3];
            if (k < s->kinks) {
                if (fabs(dot(kink, normal)) > ON_EDGE)
                    continue;
                memcpy(g, kink, sizeof g);
            } else if (edges == 0) {
                cross(normal, middle, g);
            } else {
                break;
            }
            cross(middle, g, there);
            double sign = dot(there, normal) < 0.0 ? -1.0 : 1.0;
            for (int c = 0; c < 3; c++)
                g[c] *= sign;
            edges++;
            status = travel(s, corner, g, level, row + *many * (CORNERS + 1), term + *many, &is_row);
            *many += is_row;
        }
    }
    return status;
}

/* Note what robots in a box reach at most at a level, and where they look best. */
static Status bound_box(BoxSearch *s, Box *box, double level, double enough) {
    double corner[CORNERS][3], force[CORNERS][2], middle[3] = {0.0}, wide = 0.0;
    double weight[CORNERS], share[CORNERS];
    int chosen[CORNERS], found, befores = box->terms, many;
    Term before[CORNERS], term[TRAVELLERS];
    if (s->is_flat) {
        box->bound = 0.0;
        box->known = s->pool.count;
        box->terms = 2;
        memcpy(box->term, s->flat, sizeof s->flat);
        return SOLVED;
    }
    if (s->pool.count + TRAVELLERS > s->rows_room && !make_room(s, 2 * (size_t)s->pool.count + TRAVELLERS))
        return NO_MEMORY;
    memcpy(before, box->term, sizeof before);
    corners_of(s, box, corner, force);
    for (int i = 0; i < CORNERS; i++)
        for (int c = 0; c < 3; c++)
            middle[c] += corner[i][c] / CORNERS;
    for (int i = 0; i < CORNERS; i++) {
        double off[3] = {corner[i][0] - middle[0], corner[i][1] - middle[1], corner[i][2] - middle[2]};
        wide = larger(wide, 2.0 * length(off));
    }
    box->known = s->pool.count;
    box->terms = 0;
    box->bound = INFINITY;
    Game game;
    game.level = level;
    game.kept = 0;
    game.least_top = game.lowest = INFINITY;
    write_rows(s, box, force, level);
    sift_rows(s, &game, 0, s->pool.count);
    begin_game(s, &game);
    found = balance(s, &game, chosen, weight, share);
    keep_terms(s, box, NULL, found, chosen, weight, level);
    Status status = spend(&s->pool.work, PASS * s->pool.count);
    if (s->is_convex && box->bound > enough && status == SOLVED) {
        status = write_travelling(s, corner, middle, wide, level, before, befores, term, &many);
        if (many && !is_fault(status)) {
            double lowest = game.lowest;
            sift_rows(s, &game, s->pool.count, s->pool.count + many);
            if (game.lowest < lowest)
                begin_game(s, &game);
            found = balance(s, &game, chosen, weight, share);
            keep_terms(s, box, term, found, chosen, weight, level);
        }
    }
    if (s->pool.least_cap <= box->bound) { /* no newcomer does better, anywhere */
        box->bound = s->pool.least_cap;
        box->terms = 1;
        box->term[0] = (Term){.kind = MET, .weight = 1.0};
        memcpy(box->term[0].vector, s->pool.row[s->pool.capped].normal, sizeof box->term[0].vector);
    }
    double beyond = 0.0, f[2] = {0.0}, mid = 0.5 * (box->lo + box->hi);
    for (int i = 0; i < CORNERS; i++) {
        beyond += i < 3 ? 0.0 : share[i];
        f[0] += share[i] * force[i][0];
        f[1] += share[i] * force[i][1];
    }
    double c = cos(mid), sn = sin(mid);
    box->ask[0] = between(box->from, box->to, beyond);
    box->ask[1] = mid + atan2(c * f[1] - sn * f[0], c * f[0] + sn * f[1]);
    return status;
}

/* -- the search --------------------------------------------------------------------------------- */

/* Bound a box, and open it if that is too much. */
static Status put_box(BoxSearch *s, int at, double level, double enough) {
    Box *box = s->box + at;
    Status status = bound_box(s, box, level, enough), put;
    if (is_fault(status) || box->bound <= enough)
        return status;
    put = pool_open(&s->pool, box->bound, at);
    return put == SOLVED ? status : put;
}

/* The same with one more. */
static Status add_box(BoxSearch *s, const Box *box, double level, double enough) {
    if (!has_room((void **)&s->box, &s->room, s->boxes, sizeof *s->box))
        return NO_MEMORY;
    s->box[s->boxes] = *box;
    return put_box(s, s->boxes++, level, enough);
}

/* Ask the quality where a box looks best. */
static Status ask(BoxSearch *s, const Box *box, double gap, Place *best) {
    double arm[2], quality, normal[3];
    arm_at(s->pieces + PIECE * (ptrdiff_t)box->piece, box->ask[0], arm);
    Status status = boxes_quality(s, arm, box->ask[1], larger(EXACT, NEARER * gap), &quality, normal);
    s->pool.asks--;
    if (status != SOLVED)
        return status;
    if (quality > best->quality)
        *best = (Place){quality, box->ask[0], box->ask[1], box->piece};
    return pool_meet(&s->pool, normal);
}

/* Cut a box across its longer side, where it was asked if that is not near an end. Returns whether it
 * could be; it is the first half then. */
static int cut(const BoxSearch *s, Box *box, Box *other) {
    const double *p = s->pieces + PIECE * (ptrdiff_t)box->piece;
    double longest = s->pool.sets->scale[2] * hypot(p[2] - p[0], p[3] - p[1]) * (box->to - box->from);
    int is_across = longest > box->hi - box->lo;
    double first = is_across ? box->from : box->lo, last = is_across ? box->to : box->hi;
    double at = box->ask[!is_across], width = last - first;
    if (!(width > SMALLEST_PART))
        return 0;
    if (at < first + MIDDLE * width || at > last - MIDDLE * width)
        at = between(first, last, 0.5);
    *other = *box;
    if (is_across)
        box->to = other->from = at;
    else
        box->hi = other->lo = at;
    return 1;
}

/* Add the boxes of a piece, each a right angle wide at most. */
static Status add_piece(BoxSearch *s, int piece, double level, double enough) {
    const double *p = s->pieces + PIECE * (ptrdiff_t)piece;
    int parts = p[5] - p[4] > 0.5 * PI ? 2 : 1;
    Status status = SOLVED;
    for (int k = 0; k < parts && !is_fault(status); k++) {
        Box box = {.piece = piece, .to = p[0] == p[2] && p[1] == p[3] ? 0.0 : 1.0};
        box.lo = k ? between(p[4], p[5], 0.5) : p[4];
        box.hi = k + 1 < parts ? between(p[4], p[5], 0.5) : p[5];
        status = add_box(s, &box, level, enough);
    }
    return status;
}

Status boxes_solve(BoxSearch *s, const char *chosen, double gap, int asks, Place *best) {
    Pool *pool = &s->pool;
    *best = (Place){.quality = pool->quality, .piece = -1};
    s->boxes = pool->opens = 0;
    pool->asks = asks;
    double enough = enough_for(pool, best->quality, gap);
    double level = between(best->quality, enough, 0.5);
    Status status = SOLVED;
    for (int k = 0; k < s->many && !is_fault(status); k++)
        if (!chosen || chosen[k])
            status = add_piece(s, k, level, enough);
    while (status == SOLVED && pool->opens && pool->open[0].bound > enough) {
        int at = pool_take(pool);
        Box *box = s->box + at, other;
        if (box->known < pool->count) {
            status = put_box(s, at, level, enough);
            continue;
        }
        int is_close = box->bound <= best->quality * (1.0 + CLOSE);
        if (pool->asks <= 0 || (is_close && asks - pool->asks >= ENOUGH))
            return OUT_OF_BUDGET;
        status = ask(s, box, gap, best);
        enough = enough_for(pool, best->quality, gap);
        level = between(best->quality, enough, 0.5);
        if (status != SOLVED || !cut(s, box, &other))
            continue;
        status = put_box(s, at, level, enough);
        if (!is_fault(status))
            status = add_box(s, &other, level, enough);
    }
    return status;
}
