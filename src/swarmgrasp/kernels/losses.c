/* Losses on a triangle: most machines are lost on all of it or nowhere, and the few sets of the others
 * are proven one by one. Machines alike are one kind, of which only the number lost matters: otherwise
 * copies would leave sets that never part. A pass over the triangle's robots each. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "losses.h"
#include "triangle.h"

#define SETS 8   /* sets of machines, at most, that are looked at one by one, */
#define KINDS 10 /* of so many kinds of machines at most */
#define TRIES 3  /* cuts made where there are more */

/* The sums of machines, in `Hunt.sum`, arrays (machines,) each: what they exert at most at the corners,
 * and so on all of the triangle, the greatest of that, what they hold at least, the least of that, and
 * room to reorder. */
enum { REACH = 0, MOST = 3, HELD = 4, LEAST = 7, SCRATCH = 8 };

static double *sum_of(const Hunt *h, int which) {
    return h->sum + (ptrdiff_t)which * machines_of(h);
}

/* -- machines alike ----------------------------------------------------------------------------- */

typedef struct {
    uint64_t mark;
    int machine;
} Marked;

static int by_mark(const void *a, const void *b) {
    const Marked *x = a, *y = b;
    if (x->mark != y->mark)
        return x->mark < y->mark ? -1 : 1;
    return x->machine - y->machine;
}

static uint64_t mark_of(const void *bytes, size_t size, uint64_t mark) {
    const unsigned char *at = bytes;
    while (size--)
        mark = (mark ^ *at++) * 1099511628211u;
    return mark;
}

/* A number that robots alike share. */
static uint64_t mark_set(const ForceSet *set) {
    uint64_t mark = mark_of(set->arm, sizeof set->arm, 14695981039346656037u);
    for (int k = 0; k < set->elements; k++) {
        mark = mark_of(&set->element[k].radius, sizeof(double), mark);
        mark = mark_of(set->element[k].at, 2 * sizeof(double), mark);
        mark = mark_of(set->element[k].start, 2 * sizeof(double), mark);
    }
    mark = mark_of(set->part, (size_t)set->adrift * (PART - 1) * sizeof(double), mark);
    return mark_of(set->piece, (size_t)set->turning * PIECE * sizeof(double), mark);
}

static int are_alike(const ForceSet *a, const ForceSet *b) {
    if (a->elements != b->elements || a->adrift != b->adrift || a->turning != b->turning
        || a->limit != b->limit || memcmp(a->arm, b->arm, sizeof a->arm))
        return 0;
    for (int k = 0; k < a->elements; k++) {
        const Element *x = a->element + k, *y = b->element + k;
        if (x->shape != y->shape || x->radius != y->radius || memcmp(x->at, y->at, sizeof x->at)
            || memcmp(x->start, y->start, sizeof x->start) || memcmp(x->end, y->end, sizeof x->end))
            return 0;
    }
    return !memcmp(a->part, b->part, (size_t)a->adrift * (PART - 1) * sizeof(double))
           && !memcmp(a->piece, b->piece, (size_t)a->turning * PIECE * sizeof(double));
}

Status number_kinds(Hunt *h) {
    size_t machines = (size_t)machines_of(h), robots = (size_t)robots_of(h);
    Marked *marked = calloc(machines + 1, sizeof *marked);
    int *first = calloc(machines + 1, sizeof *first), *member = calloc(robots + 1, sizeof *member);
    Status status = marked && first && member ? SOLVED : NO_MEMORY;
    if (status == SOLVED) {
        for (size_t g = 0; g < machines; g++)
            marked[g].machine = (int)g;
        for (size_t i = 0; i < robots; i++) {
            marked[machine_of(h, (int)i)].mark += mark_set(set_of(h, (int)i));
            first[machine_of(h, (int)i) + 1]++;
        }
        for (size_t g = 0; g < machines; g++)
            first[g + 1] += first[g];
        for (size_t i = robots; i-- > 0;) /* the robots of g end where those of g + 1 began */
            member[--first[machine_of(h, (int)i) + 1]] = (int)i;
        qsort(marked, machines, sizeof *marked, by_mark);
        for (size_t k = 0; k < machines; k++) {
            int g = marked[k].machine, last = k ? marked[k - 1].machine : g, count;
            int end = g + 2 <= (int)machines ? first[g + 2] : (int)robots;
            int end_last = last + 2 <= (int)machines ? first[last + 2] : (int)robots;
            count = end - first[g + 1];
            int alike = k && marked[k].mark == marked[k - 1].mark && count == end_last - first[last + 1];
            for (int i = 0; i < count && alike; i++)
                alike = are_alike(set_of(h, member[first[g + 1] + i]),
                                  set_of(h, member[first[last + 1] + i]));
            h->kind[g] = alike ? h->kind[last] : g;
        }
    }
    free(marked);
    free(first);
    free(member);
    return status;
}

static const double even[3] = {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};

/* -- one triangle ------------------------------------------------------------------------------- */

/* What a robot of uncertain pose exerts at the corners at most, and so on all of a triangle: of its poses
 * take one, or one straight part of its contacts, which is convex. */
static void reach_at(const Hunt *h, int robot, const double *middle, const double *corner, double *row) {
    const ForceSet *set = set_of(h, robot);
    const double *scale = h->sets->scale, *part = NULL;
    double least = INFINITY, v[3], at[3], worst[3] = {0.0};
    for (int k = 0; k < 3; k++)
        v[k] = -middle[k] * scale[k] * set->limit;
    for (int r = 0; r < set->turning; r++) {
        double value = -best_on_piece(set->piece + (ptrdiff_t)PIECE * r, v, at);
        if (value < least) {
            least = value;
            for (int k = 0; k < 3; k++)
                worst[k] = at[k] * scale[k] * set->limit;
        }
    }
    for (int r = 0; r < set->adrift; r++) {
        const double *other = set->part + (ptrdiff_t)(PART - 1) * r;
        double value = worst_on_part(scale, set, other, middle, NULL, NULL);
        if (value < least) {
            least = value;
            part = other;
        }
    }
    for (int j = 0; j < 3; j++)
        row[j] = part ? worst_on_part(scale, set, part, corner + 3 * j, NULL, NULL)
                      : larger(0.0, dot(worst, corner + 3 * j));
}

/* Add up what machines exert at most at the corners, and what the forces at a mixture of these hold on all
 * of a triangle. */
static void add_up(Hunt *h, const Triangle *triangle, size_t begin, size_t end, const double *share) {
    int machines = machines_of(h);
    double middle[3] = {0.0};
    memset(h->sum, 0, (size_t)SCRATCH * (size_t)machines * sizeof *h->sum);
    memset(h->rest, 0, sizeof h->rest);
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++)
            middle[k] += share[j] * triangle->normal[3 * j + k];
    for (size_t a = begin; a < end; a++) {
        const Active *robot = h->active + a;
        int g = machine_of(h, robot->robot);
        double row[3], reach[3] = {robot->at[0], robot->at[1], robot->at[2]};
        hold_at(h, robot->robot, middle, triangle->normal, row);
        if (robot->is_safe) { /* some robots of its machine may be gone from the list */
            add(h->rest, row);
            continue;
        }
        if (robot->which[0] < 0)
            reach_at(h, robot->robot, middle, triangle->normal, reach);
        for (int j = 0; j < 3; j++) {
            sum_of(h, REACH + j)[g] += reach[j];
            sum_of(h, HELD + j)[g] += row[j];
        }
    }
    for (int g = 0; g < machines; g++) {
        const double *most = h->sum + g, *held = sum_of(h, HELD) + g;
        sum_of(h, MOST)[g] = larger(most[0], larger(most[machines], most[2 * machines]));
        sum_of(h, LEAST)[g] = smaller(held[0], smaller(held[machines], held[2 * machines]));
    }
}

size_t sift_losses(Hunt *h, Triangle *triangle, size_t begin, size_t end, char *is_safe) {
    int machines = machines_of(h), taken = 0;
    double *most = sum_of(h, MOST), *least = sum_of(h, LEAST), *room = sum_of(h, SCRATCH);
    double held, rival;
    add_up(h, triangle, begin, end, even);
    memcpy(room, least, (size_t)machines * sizeof *room);
    add_greatest(room, machines, triangle->losing, &held); /* so many always exert as much */
    memcpy(room, most, (size_t)machines * sizeof *room);
    add_greatest(room, machines, triangle->losing + 1, &rival);
    for (int g = 0; g < machines; g++) {
        is_safe[g] = most[g] <= 0.0 || most[g] < held;
        taken += h->is_lost[g] = least[g] > rival;
    }
    if (!taken)
        return end;
    size_t kept = begin;
    for (size_t a = begin; a < end; a++)
        if (!h->is_lost[machine_of(h, h->active[a].robot)])
            h->active[kept++] = h->active[a];
    for (int g = 0; g < machines; g++)
        if (h->is_lost[g]) {
            for (int k = 0; k < SCRATCH; k++)
                sum_of(h, k)[g] = 0.0;
            is_safe[g] = 1;
            h->is_lost[g] = 0;
        }
    triangle->losing -= taken;
    if (triangle->losing == 0)
        memset(is_safe, 1, (size_t)machines);
    return kept;
}

/* What robots hold at the corners, less the worst loss of that there and what is wanted. Whoever is lost,
 * the others hold what they do, and the sum of the greatest is convex: it is no more between. */
static void row_of(Hunt *h, const Triangle *triangle, const char *is_safe, double target, double *row) {
    int machines = machines_of(h);
    double *room = sum_of(h, SCRATCH), last;
    for (int j = 0; j < 3; j++) {
        const double *held = sum_of(h, HELD + j);
        row[j] = dot(triangle->fixed, triangle->normal + 3 * j) + h->rest[j]
                 - target * triangle->extent[j];
        for (int g = 0; g < machines; g++) {
            row[j] += held[g];
            room[g] = is_safe[g] ? 0.0 : held[g];
        }
        row[j] -= add_greatest(room, machines, triangle->losing, &last);
    }
}

int is_held_plainly(Hunt *h, Triangle *triangle, const char *is_safe) {
    double target = wanted(h), reach = target, row[3];
    row_of(h, triangle, is_safe, target, row);
    for (int j = 0; j < 3; j++)
        if (row[j] < 0.0)
            reach = smaller(reach, triangle->extent[j] > 0.0 ? target + row[j] / triangle->extent[j] : 0.0);
    triangle->bound = larger(triangle->bound, reach);
    return reach >= target;
}

Status is_held_by_cuts(Hunt *h, Triangle *triangle, size_t begin, size_t end, const char *is_safe,
                       int *is_so) {
    double rows[TRIES][3], share[3], target = wanted(h);
    memcpy(share, even, sizeof share);
    *is_so = 0;
    for (int t = 0; t < TRIES; t++) {
        double before = t ? relax(rows, t, share) : -INFINITY, normal[3] = {0.0}, height, cap;
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                normal[k] += share[j] * triangle->normal[3 * j + k];
        Status status = sets_height(h->sets, normal, h->extra, &height, &cap);
        if (status != SOLVED)
            return status;
        offer(h, normal, height, sets_extent(h->sets, normal));
        charge(h->work, EACH * (robots_of(h) + (double)(end - begin)) + machines_of(h));
        add_up(h, triangle, begin, end, share);
        row_of(h, triangle, is_safe, target, rows[t]);
        double value = dot(rows[t], share);
        if (value < 0.0 || value <= before)
            return SOLVED;
        if (relax(rows, t + 1, share) >= 0.0) {
            *is_so = hold(rows, t + 1) >= 0.0;
            return SOLVED;
        }
    }
    return SOLVED;
}

/* Sets of machines to lose: so many of each kind. */
typedef struct {
    int kinds;
    int first[KINDS], count[KINDS]; /* of the machines of a kind, */
    int *machine;                   /* in an array */
} Choice;

/* Count the ways to take `left` machines of the kinds from k on; with `fewer`, or less. */
static int ways(const Choice *choice, int k, int left, int fewer) {
    int sum = 0;
    if (k == choice->kinds)
        return left == 0 || fewer;
    for (int n = 0; n <= choice->count[k] && n <= left && sum <= SETS; n++)
        sum += ways(choice, k + 1, left - n, fewer);
    return sum;
}

/* Go through these ways. Tells whether the triangle is held in all of them. */
static int is_held_by_all(Hunt *h, Triangle *triangle, size_t begin, size_t end, const Choice *choice,
                          int k, int left, int fewer) {
    if (k == choice->kinds)
        return (left && !fewer) || is_held(h, triangle, begin, end);
    int is_so = 1;
    for (int n = 0; n <= choice->count[k] && n <= left; n++) {
        if (n)
            h->is_lost[choice->machine[choice->first[k] + n - 1]] = 1;
        if (is_so)
            is_so = is_held_by_all(h, triangle, begin, end, choice, k + 1, left - n, fewer);
    }
    for (int n = 0; n < choice->count[k]; n++)
        h->is_lost[choice->machine[choice->first[k] + n]] = 0;
    return is_so;
}

int is_held_by_sets(Hunt *h, Triangle *triangle, size_t begin, size_t end, const char *is_safe,
                    int *are_many) {
    int machines = machines_of(h), member[KINDS * SETS], total = 0, open = 0;
    Choice choice = {.kinds = 0, .machine = member};
    *are_many = 0;
    for (int g = 0; g < machines; g++)
        open += !is_safe[g];
    if (open <= triangle->losing && !h->may_take) { /* all of them */
        for (int g = 0; g < machines; g++)
            h->is_lost[g] = !is_safe[g];
        int is_so = is_held(h, triangle, begin, end);
        memset(h->is_lost, 0, (size_t)machines);
        return is_so;
    }
    for (int g = 0; g < machines && triangle->losing; g++) {
        if (is_safe[g])
            continue;
        int k = 0;
        while (k < choice.kinds && h->kind[member[choice.first[k]]] != h->kind[g])
            k++;
        if (k < choice.kinds && choice.count[k] >= triangle->losing)
            continue; /* more of a kind than may be lost */
        if (k == KINDS || (k < choice.kinds && choice.count[k] == SETS)) {
            *are_many = 1;
            return 0;
        }
        if (k == choice.kinds) {
            choice.first[k] = SETS * k;
            choice.count[choice.kinds++] = 0;
        }
        member[choice.first[k] + choice.count[k]++] = g;
        total++;
    }
    int losing = triangle->losing < total ? triangle->losing : total;
    *are_many = ways(&choice, 0, losing, h->may_take) > SETS;
    if (*are_many)
        return 0;
    return is_held_by_all(h, triangle, begin, end, &choice, 0, losing, h->may_take);
}
