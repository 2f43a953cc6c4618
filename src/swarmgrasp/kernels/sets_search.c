/* The least H / D of sets of forces, by branch and bound over triangles of directions (T12, T21). What
 * robots exert at the middle of a triangle bounds H on all of it from below.
 * Trusted are the sets as `sets_begin` leaves them. Recursion ends DEPTH halvings down; the robots on
 * the way down are kept, a few times their number in all. */
#include <stdlib.h>
#include <string.h>

#include "quality.h"
#include "sets.h"
#include "triangle.h"

#define TRIES 3       /* cuts made in a triangle before it is split */
#define AROUND 64     /* directions looked at to begin with */
#define DEPTH 110     /* halvings until a triangle is a point, and more */
#define BASIC 20.0    /* units of work that a triangle takes besides */
#define EACH 6.0      /* and a robot at one normal */
#define UNKNOWN 1e300 /* a value, as long as there is none */
#define ASKED 4e-15   /* share of a task's size at and below which it asks for nothing */

/* A robot that matters on a triangle: what it exerts at the corners, and by which elements. */
typedef struct {
    int robot;
    int which[3];
    double at[3];
} Active;

typedef struct {
    const Sets *sets;
    const ForceSet *extra;
    double gap, zero, floor;
    double best, normal[3]; /* the least H / D, and its normal */
    double bound;           /* what no triangle that was left falls below */
    Active *active;         /* those of all triangles on the way to the one at hand */
    size_t room;
    double *sum;            /* (3, machines + 1) */
    Work *work;
} Hunt;

typedef struct {
    double normal[9]; /* corners */
    double extent[3]; /* D there */
    double fixed[3];  /* the load and the wrenches of robots that exert the same on all of it */
    double bound;     /* that its whole had */
} Triangle;

static int robots_of(const Hunt *h) { return h->sets->count + (h->extra != NULL); }

static int machines_of(const Hunt *h) { return h->sets->machines + (h->extra != NULL); }

static const ForceSet *set_of(const Hunt *h, int robot) {
    return robot < h->sets->count ? h->sets->set + robot : h->extra;
}

static int machine_of(const Hunt *h, int robot) {
    return robot < h->sets->count ? h->sets->machine[robot] : h->sets->machines;
}

/* Note what a robot exerts at a corner. */
static void value_at(const Hunt *h, Active *robot, int corner, const double *normal) {
    const ForceSet *set = set_of(h, robot->robot);
    if (set->turning || set->adrift || !set->elements) {
        robot->at[corner] = exert(h->sets->scale, set, normal, NULL, NULL, NULL);
        robot->which[corner] = set->turning || set->adrift ? -1 : 0;
        return;
    }
    double p[2];
    lever(h->sets->scale, set->arm, normal, p);
    robot->at[corner] = support(set, p, NULL, robot->which + corner);
}

/* Keep a normal with its H and D if it is the weakest so far. A load that is not held where the task
 * asks for nothing counts as the worst there is. */
static void offer(Hunt *h, const double *normal, double height, double extent) {
    double size = length(normal), value;
    if (extent <= ASKED * size) {
        if (height >= -h->zero * size)
            return;
        extent = ASKED * size;
    }
    value = height <= h->zero * extent ? 0.0 : height / extent;
    if (value < h->best) {
        h->best = value;
        memcpy(h->normal, normal, sizeof h->normal);
    }
}

/* The value that a triangle must not fall below to be done. */
static double wanted(const Hunt *h) {
    double best = smaller(h->best, UNKNOWN);
    return best - larger(h->gap * best, h->floor);
}

/* What a robot's forces at a middle are worth at the corners, at least. */
static void rows_of_robot(const Hunt *h, const Triangle *triangle, int robot, const double *middle,
                          double *row) {
    const ForceSet *set = set_of(h, robot);
    const double *scale = h->sets->scale;
    double wrench[3], force[2], arm[2], p[2];
    if (!set->adrift && !set->turning) {
        exert(scale, set, middle, wrench, NULL, NULL);
        for (int j = 0; j < 3; j++)
            row[j] = dot(wrench, triangle->normal + 3 * j);
        return;
    }
    if (set->turning) { /* the least over its poses is concave, as long as it is positive */
        double sum = 0.0, v[3];
        for (int j = 0; j < 3; j++) {
            double least = INFINITY;
            for (int k = 0; k < 3; k++)
                v[k] = -triangle->normal[3 * j + k] * scale[k] * set->limit;
            for (int r = 0; r < set->turning; r++) {
                double at[3];
                least = smaller(least, -best_on_piece(set->piece + (ptrdiff_t)PIECE * r, v, at));
            }
            row[j] = least;
            sum += least;
        }
        if (sum <= 0.0)
            row[0] = row[1] = row[2] = 0.0;
        return;
    }
    row[0] = row[1] = row[2] = INFINITY;
    for (int r = 0; r < set->adrift; r++) {
        const double *part = set->part + (ptrdiff_t)(PART - 1) * r;
        worst_on_part(scale, set, part, middle, arm, force);
        for (int j = 0; j < 3; j++)
            for (int end = 0; end < 4; end += 2) {
                lever(scale, part + end, triangle->normal + 3 * j, p);
                row[j] = smaller(row[j], along(p, force));
            }
    }
}

/* What is held at the corners by the forces at a middle, less the worst loss there and what is wanted.
 * What a machine exerts is convex along a triangle, so what is lost is no more than at the corners. */
static void cut(Hunt *h, const Triangle *triangle, size_t begin, size_t end, const double *share,
                double *row) {
    double middle[3] = {0.0}, target = wanted(h), last;
    int machines = machines_of(h);
    for (int j = 0; j < 3; j++) {
        row[j] = dot(triangle->fixed, triangle->normal + 3 * j);
        for (int k = 0; k < 3; k++)
            middle[k] += share[j] * triangle->normal[3 * j + k];
    }
    for (size_t a = begin; a < end; a++) {
        double own[3];
        rows_of_robot(h, triangle, h->active[a].robot, middle, own);
        add(row, own);
    }
    for (int j = 0; j < 3; j++) {
        if (h->sets->losing) {
            memset(h->sum, 0, (size_t)machines * sizeof *h->sum);
            for (size_t a = begin; a < end; a++)
                h->sum[machine_of(h, h->active[a].robot)] += h->active[a].at[j];
            row[j] -= add_greatest(h->sum, machines, h->sets->losing, &last);
        }
        row[j] -= target * triangle->extent[j];
    }
}

/* Tell whether no normal of a triangle has less than what is wanted. */
static int is_held(Hunt *h, Triangle *triangle, size_t begin, size_t end) {
    double rows[TRIES][3], share[3] = {1.0 / 3, 1.0 / 3, 1.0 / 3}, target = wanted(h);
    for (int t = 0; t < TRIES; t++) {
        double before = t ? relax(rows, t, share) : -INFINITY;
        cut(h, triangle, begin, end, share, rows[t]);
        double value = dot(rows[t], share), least = INFINITY;
        charge(h->work, EACH * (double)(end - begin));
        for (int j = 0; j < 3; j++)
            least = smaller(least, triangle->extent[j] > 0.0 ? rows[t][j] / triangle->extent[j] : INFINITY);
        triangle->bound = larger(triangle->bound, least + target);
        if (value < 0.0 || value <= before)
            return 0;
        if (relax(rows, t + 1, share) >= 0.0)
            return hold(rows, t + 1) >= 0.0;
    }
    return 0;
}

/* Of the robots on a triangle keep those that matter, and add up the wrenches of those that exert the
 * same corner of their set on all of it. Returns the new end. */
static size_t sift(Hunt *h, Triangle *triangle, size_t begin, size_t end) {
    size_t kept = begin;
    for (size_t a = begin; a < end; a++) {
        const Active *robot = h->active + a;
        const ForceSet *set = set_of(h, robot->robot);
        int which = robot->which[0];
        int is_one = which >= 0 && which == robot->which[1] && which == robot->which[2]
                     && h->sets->losing == 0;
        if (is_one && set->elements == 0)
            continue;
        if (is_one && set->element[which].shape == POINT) {
            double wrench[3];
            wrench_of(h->sets->scale, set->arm, set->element[which].at, wrench);
            add(triangle->fixed, wrench);
            continue;
        }
        h->active[kept++] = *robot;
    }
    return kept;
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
        value_at(h, copy, corner, normal);
    }
    return explore(h, &half, end, end + (end - begin), depth - 1);
}

/* What is held at a corner: H. */
static double height_at(Hunt *h, const Triangle *triangle, size_t begin, size_t end, int corner) {
    double height = dot(triangle->fixed, triangle->normal + 3 * corner), last;
    int machines = machines_of(h);
    if (h->sets->losing)
        memset(h->sum, 0, (size_t)machines * sizeof *h->sum);
    for (size_t a = begin; a < end; a++) {
        height += h->active[a].at[corner];
        if (h->sets->losing)
            h->sum[machine_of(h, h->active[a].robot)] += h->active[a].at[corner];
    }
    return h->sets->losing ? height - add_greatest(h->sum, machines, h->sets->losing, &last) : height;
}

/* Search a triangle for normals with less than the best. */
static Status explore(Hunt *h, Triangle *triangle, size_t begin, size_t end, int depth) {
    double height[3];
    Status status = spend(h->work, EACH * (double)(end - begin) + BASIC);
    if (status != SOLVED) {
        h->bound = smaller(h->bound, triangle->bound);
        return status;
    }
    end = sift(h, triangle, begin, end);
    for (int j = 0; j < 3; j++) {
        height[j] = height_at(h, triangle, begin, end, j);
        offer(h, triangle->normal + 3 * j, height[j], triangle->extent[j]);
    }
    if (h->best <= 0.0 || is_held(h, triangle, begin, end))
        return SOLVED;
    double edge, normal[3], size;
    int from = longest_edge(triangle->normal, &edge), to = (from + 1) % 3;
    if (depth == 0 || edge <= SMALLEST) {
        h->bound = smaller(h->bound, triangle->bound);
        return SOLVED;
    }
    for (int k = 0; k < 3; k++)
        normal[k] = triangle->normal[3 * from + k] + triangle->normal[3 * to + k];
    size = length(normal);
    for (int k = 0; k < 3; k++)
        normal[k] /= size;
    double target = wanted(h);
    int is_first = height[from] - target * triangle->extent[from]
                   > height[to] - target * triangle->extent[to];
    status = explore_half(h, triangle, begin, end, is_first ? from : to, normal, depth);
    if (status == OUT_OF_BUDGET)
        h->bound = smaller(h->bound, triangle->bound);
    if (status == SOLVED && h->best > 0.0)
        status = explore_half(h, triangle, begin, end, is_first ? to : from, normal, depth);
    return status;
}

/* Look at directions: those given, or some spread evenly. */
static Status look_around(Hunt *h, const double *start, int starts) {
    for (int k = 0; k < (starts ? starts : AROUND) && h->best > 0.0; k++) {
        double normal[3], height, cap;
        if (starts)
            memcpy(normal, start + 3 * k, sizeof normal);
        else
            on_spiral(k, AROUND, normal);
        Status status = sets_height(h->sets, normal, h->extra, &height, &cap);
        if (status != SOLVED)
            return status;
        offer(h, normal, height, sets_extent(h->sets, normal));
        status = spend(h->work, EACH * robots_of(h) + BASIC);
        if (status != SOLVED)
            return status;
    }
    return SOLVED;
}

/* Search one of the eight triangles that all directions are divided into. */
static Status explore_octant(Hunt *h, int octant) {
    Triangle triangle = {.bound = 0.0};
    memcpy(triangle.fixed, h->sets->load, sizeof triangle.fixed);
    for (int j = 0; j < 3; j++) {
        triangle.normal[3 * j + j] = octant >> j & 1 ? -1.0 : 1.0;
        triangle.extent[j] = sets_extent(h->sets, triangle.normal + 3 * j);
    }
    for (int i = 0; i < robots_of(h); i++) {
        h->active[i] = (Active){.robot = i};
        for (int j = 0; j < 3; j++)
            value_at(h, h->active + i, j, triangle.normal + 3 * j);
    }
    return explore(h, &triangle, 0, (size_t)robots_of(h), DEPTH);
}

Status sets_search(const Sets *sets, const ForceSet *extra, double gap, double below,
                   const double *start, int starts, Work *work, double *value, double *bound,
                   double *normal) {
    double weight = sets->weight + (extra ? largest_wrench(sets->scale, extra) : 0.0);
    Hunt h = {.sets = sets, .extra = extra, .gap = gap, .zero = ZERO * weight,
              .floor = SETS_FLOOR * weight, .best = below, .bound = INFINITY, .work = work};
    h.room = 2 * (size_t)robots_of(&h) + 64;
    h.active = malloc(h.room * sizeof *h.active);
    h.sum = malloc(((size_t)machines_of(&h) + 1) * sizeof *h.sum);
    Status status = h.active && h.sum ? look_around(&h, start, starts) : NO_MEMORY;
    if (status == OUT_OF_BUDGET)
        h.bound = 0.0;
    for (int octant = 0; octant < 8 && status == SOLVED && h.best > 0.0; octant++)
        status = explore_octant(&h, octant);
    free(h.active);
    free(h.sum);
    double size = length(h.normal);
    *value = h.best;
    *bound = status == OUT_OF_BUDGET ? 0.0 : larger(0.0, smaller(h.bound, wanted(&h)));
    for (int k = 0; k < 3; k++)
        normal[k] = size > 0.0 ? h.normal[k] / size : 0.0;
    return status;
}
