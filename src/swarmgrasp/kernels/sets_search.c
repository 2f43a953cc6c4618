/* The least H / D of sets of forces, by branch and bound over triangles of directions (T12, T21).
 * Trusted are the sets as `sets_begin` leaves them. Recursion ends DEPTH halvings down; the robots on
 * the way down are kept, a few times their number in all. Some 100 triangles are usual, 10^4 where
 * minima lie on a curve. */
#include <stdlib.h>
#include <string.h>

#include "losses.h"
#include "quality.h"
#include "triangle.h"

#define AROUND 26    /* directions looked at to begin with, the axes among them: upright robots and
                        rings are weakest there */
#define STEPS 40     /* and steps down from the best of them, */
#define STEP 0.3     /* the first of which turns so far [rad] */
#define SHORT 1e-4   /* and the last */
#define DEPTH 110    /* halvings until a triangle is a point, and more */

/* Where minima lie on a curve, the gap decides how many triangles there are: it gets wider. */
static const struct {
    double cells, gap;
} ladder[] = {{3000.0, 1e-8}, {6000.0, 1e-7}};

/* Tell whether the best will do. */
static int is_enough(const Hunt *h) { return h->best <= 0.0 || h->best < h->enough; }

/* Find what a robot exerts at a corner, and by which element. */
static double value_at(const Hunt *h, int robot, const double *normal, int *which) {
    const ForceSet *set = set_of(h, robot);
    double p[2];
    *which = -1;
    if (set->turning || set->adrift || !set->elements)
        return exert(h->sets->scale, set, normal, NULL, NULL, NULL);
    lever(h->sets->scale, set->arm, normal, p);
    return support(set, p, NULL, which);
}

/* Of the robots on a triangle keep those that matter, and add up the wrenches of those that exert the
 * same corner of their set on all of it and are never lost. Returns the new end. */
static size_t sift(Hunt *h, Triangle *triangle, size_t begin, size_t end, const char *is_safe) {
    size_t kept = begin;
    for (size_t a = begin; a < end; a++) {
        Active *robot = h->active + a;
        const ForceSet *set = set_of(h, robot->robot);
        int which = robot->which[0];
        robot->is_safe |= is_safe && is_safe[machine_of(h, robot->robot)];
        if (which >= 0 && which == robot->which[1] && which == robot->which[2]
            && set->element[which].shape == POINT
            && (!is_safe || robot->is_safe)) {
            double wrench[3];
            wrench_of(h->sets->scale, set->arm, set->element[which].at, wrench);
            add(triangle->fixed, wrench);
            continue;
        }
        if (kept++ < a)
            h->active[kept - 1] = *robot;
    }
    return kept;
}

/* Give up a triangle that is a point. What is wanted there is held but for rounding, as where the
 * robots and the task both come to nothing; or its bound is all that is known. */
static Status give_up(Hunt *h, const Triangle *triangle, double edge) {
    double height, cap, weight = h->floor / SETS_FLOOR;
    Status status = sets_height(h->sets, triangle->normal, h->extra, &height, &cap);
    if (status == SOLVED && height + (edge + SETS_FLOOR) * weight < wanted(h) * triangle->extent[0])
        h->bound = smaller(h->bound, triangle->bound);
    return status;
}

static Status explore(Hunt *h, Triangle *triangle, size_t begin, size_t end, int depth);

/* Search the half of a triangle in which the middle of an edge replaces a corner. */
static Status explore_half(Hunt *h, const Triangle *whole, size_t begin, size_t end, int corner,
                           const double *normal, int depth) {
    Triangle half = *whole;
    size_t wanted_room = end + (end - begin);
    if (wanted_room > h->room) {
        Active *grown = realloc(h->active, 2 * wanted_room * sizeof *grown);
        if (!grown)
            return NO_MEMORY;
        h->active = grown;
        h->room = 2 * wanted_room;
    }
    memcpy(half.normal + 3 * corner, normal, 3 * sizeof *normal);
    half.extent[corner] = sets_extent(h->sets, normal);
    for (size_t a = begin; a < end; a++) {
        Active *copy = h->active + end + (a - begin);
        *copy = h->active[a];
        copy->at[corner] = copy->next_at;
        copy->which[corner] = copy->next_which;
    }
    return explore(h, &half, end, end + (end - begin), depth - 1);
}

/* Tell whether no normal of a triangle has less than what is wanted. */
static Status is_done(Hunt *h, Triangle *triangle, size_t begin, size_t *end, int *is_so) {
    int are_many;
    if (!triangle->losing) {
        *end = sift(h, triangle, begin, *end, NULL);
        *is_so = is_held(h, triangle, begin, *end);
        return SOLVED;
    }
    *end = sift_losses(h, triangle, begin, *end, h->is_safe);
    charge(h->work, EACH * (double)(*end - begin) + machines_of(h));
    *is_so = is_held_plainly(h, triangle, h->is_safe);
    if (*is_so)
        return SOLVED;
    *end = sift(h, triangle, begin, *end, h->is_safe);
    *is_so = is_held_by_sets(h, triangle, begin, *end, h->is_safe, &are_many);
    return are_many ? is_held_by_cuts(h, triangle, begin, *end, h->is_safe, is_so) : SOLVED;
}

/* Search a triangle for normals with less than the best. */
static Status explore(Hunt *h, Triangle *triangle, size_t begin, size_t end, int depth) {
    Status status = spend(h->work, EACH * (double)(end - begin) + BASIC);
    if (status != SOLVED) {
        h->bound = smaller(h->bound, triangle->bound);
        return status;
    }
    h->cells += 1.0;
    for (size_t k = 0; k < sizeof ladder / sizeof *ladder; k++)
        if (h->cells > ladder[k].cells)
            h->gap = larger(h->gap, ladder[k].gap);
    int is_so;
    status = is_done(h, triangle, begin, &end, &is_so);
    if (status != SOLVED || is_so || is_enough(h))
        return status;
    double edge, normal[3], size;
    int from = longest_edge(triangle->normal, &edge), to = (from + 1) % 3;
    if (depth == 0 || edge <= SMALLEST)
        return give_up(h, triangle, edge);
    for (int k = 0; k < 3; k++)
        normal[k] = triangle->normal[3 * from + k] + triangle->normal[3 * to + k];
    size = length(normal);
    for (int k = 0; k < 3; k++)
        normal[k] /= size;
    for (size_t a = begin; a < end; a++)
        h->active[a].next_at = value_at(h, h->active[a].robot, normal, &h->active[a].next_which);
    status = explore_half(h, triangle, begin, end, from, normal, depth);
    if (status == OUT_OF_BUDGET)
        h->bound = smaller(h->bound, triangle->bound);
    if (status == SOLVED && !is_enough(h))
        status = explore_half(h, triangle, begin, end, to, normal, depth);
    return status;
}

/* -- where to begin ----------------------------------------------------------------------------- */

/* Find H at a normal, and its slope: the wrench that attains it. */
static double slope_at(Hunt *h, const double *normal, double *slope) {
    const Sets *sets = h->sets;
    int machines = machines_of(h), losing = sets->losing;
    double height = dot(sets->load, normal), last = 0.0, *sum = h->sum;
    memcpy(slope, sets->load, sizeof sets->load);
    if (losing) {
        memset(sum, 0, (size_t)machines * sizeof *sum);
        for (int i = 0; i < robots_of(h); i++)
            sum[machine_of(h, i)] += exert(sets->scale, set_of(h, i), normal, NULL, NULL, NULL);
        memcpy(sum + machines, sum, (size_t)machines * sizeof *sum);
        add_greatest(sum + machines, machines, losing, &last);
        for (int g = 0; g < machines; g++) { /* the lost, of equal ones the first */
            h->is_lost[g] = sum[g] > last || (sum[g] == last && last > 0.0);
            losing -= sum[g] > last;
        }
        for (int g = 0; g < machines; g++)
            if (h->is_lost[g] && sum[g] == last && losing-- <= 0)
                h->is_lost[g] = 0;
    }
    for (int i = 0; i < robots_of(h); i++) {
        double wrench[3];
        if (losing != sets->losing && h->is_lost[machine_of(h, i)])
            continue;
        height += exert(sets->scale, set_of(h, i), normal, wrench, NULL, NULL);
        add(slope, wrench);
    }
    if (sets->losing)
        memset(h->is_lost, 0, (size_t)machines);
    return height;
}

/* Walk down from the best normal along the sphere, by ever shorter steps. */
static Status descend(Hunt *h) {
    double step = STEP, slope[3], rise[3], normal[3], at[3];
    memcpy(at, h->normal, sizeof at);
    double height = slope_at(h, at, slope), extent = sets_extent(h->sets, at);
    for (int t = 0; t < STEPS && step > SHORT && !is_enough(h); t++) {
        double value = extent > 0.0 ? height / extent : 0.0, inward, size;
        sets_farthest(h->sets, at, rise);
        for (int k = 0; k < 3; k++)
            rise[k] = slope[k] - value * rise[k];
        inward = dot(rise, at);
        for (int k = 0; k < 3; k++)
            rise[k] -= inward * at[k];
        size = length(rise);
        if (size <= h->zero)
            break;
        for (int k = 0; k < 3; k++)
            normal[k] = at[k] - step / size * rise[k];
        size = length(normal);
        for (int k = 0; k < 3; k++)
            normal[k] /= size;
        double fresh[3], before = h->best, there = slope_at(h, normal, fresh);
        offer(h, normal, there, sets_extent(h->sets, normal));
        if (h->best < before) {
            memcpy(at, normal, sizeof at);
            memcpy(slope, fresh, sizeof slope);
            height = there;
            extent = sets_extent(h->sets, at);
            step *= 1.5;
        } else {
            step *= 0.5;
        }
        Status status = spend(h->work, EACH * robots_of(h) + BASIC);
        if (status != SOLVED)
            return status;
    }
    return SOLVED;
}

/* Look at directions: those given, or some spread evenly. */
static Status look_around(Hunt *h, const double *start, int starts) {
    for (int k = 0; k < (starts ? starts : AROUND) && !is_enough(h); k++) {
        double normal[3], slope[3];
        if (starts)
            memcpy(normal, start + 3 * k, sizeof normal);
        else if (k < 6)
            for (int i = 0; i < 3; i++)
                normal[i] = i == k / 2 ? 1.0 - 2.0 * (k % 2) : 0.0;
        else
            on_spiral(k - 6, AROUND - 6, normal);
        offer(h, normal, slope_at(h, normal, slope), sets_extent(h->sets, normal));
        Status status = spend(h->work, EACH * robots_of(h) + BASIC);
        if (status != SOLVED)
            return status;
    }
    return length(h->normal) > 0.0 ? descend(h) : SOLVED;
}

/* -- all directions ----------------------------------------------------------------------------- */

/* Search one of the eight triangles that all directions are divided into. */
static Status explore_octant(Hunt *h, int octant) {
    Triangle triangle = {.bound = 0.0, .losing = h->sets->losing};
    memcpy(triangle.fixed, h->sets->load, sizeof triangle.fixed);
    for (int j = 0; j < 3; j++) {
        triangle.normal[3 * j + j] = octant >> j & 1 ? -1.0 : 1.0;
        triangle.extent[j] = sets_extent(h->sets, triangle.normal + 3 * j);
    }
    for (int i = 0; i < robots_of(h); i++) {
        h->active[i] = (Active){.robot = i};
        for (int j = 0; j < 3; j++)
            h->active[i].at[j] = value_at(h, i, triangle.normal + 3 * j, h->active[i].which + j);
    }
    return explore(h, &triangle, 0, (size_t)robots_of(h), DEPTH);
}

/* Tell whether a set of forces leaves 0 out. */
static int leaves_out_zero(const ForceSet *set) {
    for (int k = 0; k < set->elements; k++) {
        const Element *e = set->element + k;
        double back[2] = {-e->at[0], -e->at[1]}, least = -NOISE * sqrt(along(e->at, e->at));
        if (e->shape == POINT
            && (along(e->at, e->start) < least || along(e->at, e->end) < least
                || (least < 0.0 && is_in_cone(e, back))))
            return 1;
    }
    return 0;
}

/* Make room for the work. */
static Status begin_hunt(Hunt *h) {
    size_t robots = (size_t)robots_of(h), machines = (size_t)machines_of(h);
    h->room = 3 * robots + 64;
    h->active = malloc(h->room * sizeof *h->active);
    h->push = malloc((robots + 1) * sizeof *h->push);
    h->kinky = malloc((robots + 1) * sizeof *h->kinky);
    h->bend = malloc((robots + 1) * sizeof *h->bend);
    if (!h->active || !h->push || !h->kinky || !h->bend)
        return NO_MEMORY;
    for (size_t i = 0; i < robots; i++)
        h->may_take |= leaves_out_zero(set_of(h, (int)i));
    if (!h->sets->losing)
        return SOLVED;
    h->sum = malloc((SUMS * machines + 1) * sizeof *h->sum);
    h->is_lost = calloc(machines + 1, 1);
    h->is_safe = calloc(machines + 1, 1);
    h->kind = calloc(machines + 1, sizeof *h->kind);
    return h->sum && h->is_lost && h->is_safe && h->kind ? number_kinds(h) : NO_MEMORY;
}

static void end_hunt(Hunt *h) {
    free(h->active);
    free(h->push);
    free(h->kinky);
    free(h->bend);
    free(h->sum);
    free(h->is_lost);
    free(h->is_safe);
    free(h->kind);
}

/* Search sets without failures. */
static Status search(const Sets *sets, const ForceSet *extra, double gap, double below, double enough,
                     const double *start, int starts, Work *work, double *value, double *bound,
                     double *normal) {
    double weight = sets->weight + (extra ? largest_wrench(sets->scale, extra) : 0.0), cap;
    Hunt h = {.sets = sets, .extra = extra, .gap = gap, .zero = ZERO * weight, .work = work,
              .floor = SETS_FLOOR * weight, .rounding = SETS_ROUNDING * weight, .best = below, .enough = enough,
              .bound = INFINITY};
    Status status = begin_hunt(&h);
    if (status == SOLVED)
        status = look_around(&h, start, starts);
    if (status == OUT_OF_BUDGET)
        h.bound = 0.0;
    for (int octant = 0; octant < 8 && !is_fault(status) && !is_enough(&h); octant++)
        if (status == SOLVED)
            status = explore_octant(&h, octant);
        else
            h.bound = 0.0; /* not looked at */
    end_hunt(&h);
    if (h.best < enough)
        h.bound = 0.0;
    double size = length(h.normal);
    *value = h.best;
    *bound = larger(0.0, smaller(h.bound, wanted(&h)));
    for (int k = 0; k < 3; k++)
        normal[k] = size > 0.0 ? h.normal[k] / size : 0.0;
    if (size > 0.0 && h.best > 0.0 && !is_fault(status)) { /* without what rounding might add */
        double height, extent = sets_extent(sets, normal);
        Status valued = sets_height(sets, normal, extra, &height, &cap);
        if (is_fault(valued))
            return valued;
        *value = height / extent;
        *bound = smaller(*bound, *value);
    }
    return status;
}

Status sets_search(const Sets *sets, const ForceSet *extra, double gap, double below, double enough,
                   const double *start, int starts, Work *work, double *value, double *bound,
                   double *normal) {
    Status status = SOLVED;
    if (!sets->failures)
        return search(sets, extra, gap, below, enough, start, starts, work, value, bound, normal);
    *value = below;
    *bound = INFINITY;
    memset(normal, 0, 3 * sizeof *normal);
    for (int f = 0; f < sets->failures && !is_fault(status) && (f == 0 || *value > enough); f++) {
        Sets left;
        double least, reach, weakest[3];
        Status found = sets_after(sets, f, &left);
        if (found == SOLVED)
            found = search(&left, extra, gap, *value, enough, start, starts, work, &least, &reach,
                           weakest);
        free(left.set);
        free(left.machine);
        if (is_fault(found))
            return found;
        status = found == OUT_OF_BUDGET ? found : status;
        *bound = smaller(*bound, reach);
        if (length(weakest) > 0.0) {
            *value = least;
            memcpy(normal, weakest, sizeof weakest);
        }
    }
    return status;
}
