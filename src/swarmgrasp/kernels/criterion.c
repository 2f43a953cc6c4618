/* The least H / D by branch and bound over triangles of directions: the robots that matter on a
 * triangle bound H there from below, and few of them have their vertices listed (T14, T15, T16).
 * Trusted are the arrays' sizes, finite numbers, 0 <= losing <= robots + 1, and a task whose longest
 * row is about 1; the order of the rows is checked. Recursion ends DEPTH halvings down; the robots on
 * the way down are kept, a few times their number in all. */
#include <stdlib.h>
#include <string.h>

#include "criterion.h"
#include "quality.h"
#include "tree.h"
#include "triangle.h"
#include "vectors.h"

#define LISTED 12       /* planes that may cross a triangle for its vertices to be listed */
#define TRIES 3         /* cuts made in a triangle before it is split */
#define TASKS 0.1       /* share of the task's rows in what directions are whitened by */
#define AROUND 128      /* directions looked at to begin with, */
#define ALONG 8         /* and robots and rows of a task that may push along each other */
#define DEPTH 110       /* halvings until a triangle is a point, and more */
#define BASIC 20.0      /* units of work that a triangle takes besides */
#define EXACT 1e-12     /* relative gap to which the quality of worst poses is found */
#define UNKNOWN 1e300   /* a value, as long as there is none */

/* A robot that matters on a triangle: low at its corners. */
typedef struct {
    int robot;
    int is_crossing;
    double at[3];
} Active;

typedef struct {
    const Criterion *aim;
    const double *extra;
    Whitening white;        /* how directions are whitened */
    double gap, zero, rounding;
    double best, normal[3]; /* the least (H + rounding) / D, and its normal, */
    double value;           /* and H / D there, or 0 if rounding hides it */
    double polished;        /* the best that is known to be least around its normal */
    double rest;            /* triangles until polishing another is worth it */
    Active *active;  /* those of all triangles on the way to the one at hand */
    size_t room;
    double *top;     /* (losing + 1,) the largest terms, greatest first */
    double triangles;
    double each;            /* units of work to value a robot, on the average */
    Work *work;
} Hunt;

/* A triangle: its corners as normals and, whitened, as unit vectors; and what is common there. */
typedef struct {
    double normal[9], white[9];
    double extent[3]; /* D at the corners */
    double fixed[3];  /* the load and known generators that are positive on all of it */
} Triangle;

/* -- robots ------------------------------------------------------------------------------ */

static int robots_of(const Criterion *aim) { return aim->points + aim->spread; }

/* The least n . b over the wrenches of an uncertain robot, and which it is, unless that is NULL. */
static double spread_low(const Criterion *aim, int u, const double *normal, double *generator) {
    double least = INFINITY, wrench[3];
    for (int r = aim->first[u]; r < aim->first[u + 1]; r++) {
        const double *row = aim->rows + (ptrdiff_t)SPREAD_ROW * r;
        double v[3], value;
        for (int k = 0; k < 3; k++)
            v[k] = -normal[k] * aim->scale[k] * row[1];
        value = -best_on_piece(row + 2, v, wrench);
        if (value < least) {
            least = value;
            for (int k = 0; generator && k < 3; k++)
                generator[k] = wrench[k] * aim->scale[k] * row[1];
        }
    }
    return least;
}

/* The generator of a robot whose wrench is known; NULL for an uncertain one. */
static const double *known(const Criterion *aim, const double *extra, int robot) {
    if (robot < aim->points)
        return aim->point + (ptrdiff_t)3 * robot;
    return robot == robots_of(aim) ? extra : NULL;
}

static double low(const Criterion *aim, const double *extra, int robot, const double *normal) {
    const double *b = known(aim, extra, robot);
    return b ? dot(b, normal) : spread_low(aim, robot - aim->points, normal, NULL);
}

/* Note a term among the `losing` largest, greatest first; returns what falls out. */
static double note_largest(double *top, int losing, double term) {
    for (int k = 0; k < losing && term > 0.0; k++)
        if (term > top[k]) {
            double swap = top[k];
            top[k] = term;
            term = swap;
        }
    return term;
}

static void clear(double *top, int losing) {
    for (int k = 0; k < losing; k++)
        top[k] = 0.0;
}

Status criterion_height(const Criterion *aim, const double *normal, const double *extra,
                        double *height, double *cap) {
    double few[8];
    double *top = aim->losing <= 8 ? few : malloc((size_t)aim->losing * sizeof *top);
    if (!top)
        return NO_MEMORY;
    clear(top, aim->losing);
    *height = dot(aim->load, normal);
    for (int i = 0; i < robots_of(aim) + (extra != NULL); i++)
        *height += note_largest(top, aim->losing, larger(0.0, low(aim, extra, i, normal)));
    *cap = aim->losing ? *height + top[aim->losing - 1] : INFINITY;
    if (top != few)
        free(top);
    return SOLVED;
}

double criterion_total(const Criterion *aim, const double *normal) {
    double height = dot(aim->load, normal);
    for (int i = 0; i < robots_of(aim); i++)
        height += larger(0.0, low(aim, NULL, i, normal));
    return height;
}

double criterion_extent(const Criterion *aim, const double *normal) {
    double extent = 0.0;
    if (aim->tasks == 0)
        return length(normal);
    for (int k = 0; k < aim->tasks; k++) {
        double along = dot(aim->task + (ptrdiff_t)3 * k, normal);
        if (aim->is_polytope)
            extent = larger(extent, along);
        else
            extent += along * along;
    }
    return aim->is_polytope ? extent : sqrt(extent);
}

/* Add the wrenches at the ends of an uncertain robot's contacts and directions to the frame. Returns
 * the largest of them. */
static double frame_row(Criterion *aim, const double *row) {
    const double *piece = row + 2;
    double most = 0.0;
    for (int end = 0; end < 4; end++) {
        const double *arm = piece + (end & 2), *turn = piece + 6 + 2 * (end & 1);
        double wrench[3] = {turn[0], turn[1], arm[0] * turn[1] - arm[1] * turn[0]};
        double *b = aim->frame + (ptrdiff_t)3 * aim->frames++;
        for (int k = 0; k < 3; k++)
            b[k] = wrench[k] * aim->scale[k] * row[1];
        most = larger(most, length(b));
    }
    return most;
}

Status criterion_begin(Criterion *aim, int rows) {
    int u = -1;
    size_t room = (size_t)aim->points + 4 * (size_t)rows + (size_t)aim->tasks + 1;
    double most = 0.0;
    aim->frame = malloc(3 * room * sizeof *aim->frame);
    aim->first = calloc((size_t)rows + 2, sizeof *aim->first);
    if (!aim->frame || !aim->first)
        return NO_MEMORY;
    memcpy(aim->frame, aim->point, 3 * (size_t)aim->points * sizeof *aim->frame);
    aim->frames = aim->points;
    aim->weight = total_size(aim->point, aim->points) + length(aim->load);
    for (int r = 0; r < rows; r++) {
        const double *row = aim->rows + (ptrdiff_t)SPREAD_ROW * r;
        if (row[0] == u + 1.0) {
            aim->first[++u] = r;
            aim->weight += most;
            most = 0.0;
        }
        if (u < 0 || row[0] != (double)u)
            return UNSORTED;
        most = larger(most, frame_row(aim, row));
    }
    aim->weight += most;
    aim->spread = u + 1;
    aim->first[aim->spread] = rows;
    for (int k = 0; k < 3 * aim->tasks; k++)
        aim->frame[3 * aim->frames + k] = TASKS * aim->weight / aim->tasks * aim->task[k];
    aim->frames += aim->tasks;
    memcpy(aim->frame + 3 * aim->frames++, aim->load, sizeof aim->load);
    return SOLVED;
}

void criterion_end(Criterion *aim) {
    free(aim->first);
    free(aim->frame);
    aim->first = NULL;
    aim->frame = NULL;
}

/* -- values ------------------------------------------------------------------------------ */

/* Keep a normal with its H and D if it is the weakest so far. A load that is not held where the
 * task asks for nothing counts as the worst there is. */
static void offer(Hunt *h, const double *normal, double height, double extent) {
    double size = length(normal), value;
    if (extent <= UNASKED * size) {
        if (height >= -h->zero * size)
            return;
        extent = UNASKED * size;
    }
    value = (height + h->rounding * size) / extent;
    if (value < h->best) {
        h->best = value;
        h->value = height <= larger(h->rounding * size, h->zero * extent) ? 0.0 : height / extent;
        memcpy(h->normal, normal, sizeof h->normal);
    }
}

/* H from the robots that matter on a triangle, at a normal in it; two of them cross it there. */
static double height_at(Hunt *h, const Triangle *triangle, size_t begin, size_t end,
                        const double *normal, int one, int two) {
    int losing = h->aim->losing;
    double height = dot(triangle->fixed, normal);
    clear(h->top, losing);
    for (size_t a = begin; a < end; a++) {
        int robot = h->active[a].robot;
        if (robot != one && robot != two)
            height += note_largest(h->top, losing,
                                   larger(0.0, low(h->aim, h->extra, robot, normal)));
    }
    return height;
}

/* The value that a triangle must not fall below to be done. */
static double wanted(const Hunt *h) {
    double best = smaller(h->best, UNKNOWN);
    return best - larger(h->gap * best, h->rounding);
}

/* -- bounds ------------------------------------------------------------------------------ */

/* What the robots that are positive at a mixture of the corners hold at each corner, less the
 * worst loss there and what is wanted. Each low_i is at least the mixture of its values at the
 * corners (T14), whichever robots are lost, and others do not take away: H is nowhere less. */
static void cut(Hunt *h, const Triangle *triangle, size_t begin, size_t end, const double *slack,
                const double *share, double *row) {
    int losing = h->aim->losing;
    double target = wanted(h);
    for (int j = 0; j < 3; j++) {
        row[j] = dot(triangle->fixed, triangle->normal + 3 * j) - target * triangle->extent[j]
                 + slack[j];
        clear(h->top, losing);
        for (size_t a = begin; a < end; a++) {
            const Active *robot = h->active + a;
            if (!robot->is_crossing || dot(robot->at, share) > 0.0) {
                double term = robot->at[j];
                row[j] += term > 0.0 ? note_largest(h->top, losing, term) : term;
            }
        }
    }
}

/* Tell whether no normal of a triangle has less than what is wanted. */
static int is_held(Hunt *h, const Triangle *triangle, size_t begin, size_t end) {
    double rows[TRIES][3], slack[3], middle[3], share[3] = {1.0 / 3, 1.0 / 3, 1.0 / 3};
    /* n is at least as long as its part along the middle; corners may be much longer */
    for (int k = 0; k < 3; k++)
        middle[k] = triangle->normal[k] + triangle->normal[3 + k] + triangle->normal[6 + k];
    for (int j = 0; j < 3; j++)
        slack[j] = h->rounding * dot(middle, triangle->normal + 3 * j) / length(middle);
    for (int t = 0; t < TRIES; t++) {
        double before = t ? relax(rows, t, share) : -INFINITY;
        cut(h, triangle, begin, end, slack, share, rows[t]);
        double value = dot(rows[t], share);
        if (value < 0.0 || value <= before)
            return 0;
        if (relax(rows, t + 1, share) >= 0.0)
            return hold(rows, t + 1) >= 0.0;
    }
    return 0;
}

/* -- one triangle -------------------------------------------------------------------------- */

/* Tell whether an uncertain robot can do nothing on a triangle: some wrench of its set cannot. */
static int is_idle(const Hunt *h, const Triangle *triangle, int robot) {
    double middle[3], b[3];
    for (int k = 0; k < 3; k++)
        middle[k] = triangle->normal[k] + triangle->normal[3 + k] + triangle->normal[6 + k];
    spread_low(h->aim, robot - h->aim->points, middle, b);
    for (int j = 0; j < 3; j++)
        if (dot(b, triangle->normal + 3 * j) > 0.0)
            return 0;
    return 1;
}

/* Of the robots on a triangle keep those that matter, and add up those known ones that are
 * positive everywhere and never among the largest. Returns the new end; counts those that change
 * sign and are not known. */
static size_t sift(Hunt *h, Triangle *triangle, size_t begin, size_t end, int *others) {
    int losing = h->aim->losing;
    size_t kept = begin;
    clear(h->top, losing);
    for (size_t a = begin; a < end && losing; a++) {
        const double *at = h->active[a].at;
        note_largest(h->top, losing, smaller(at[0], smaller(at[1], at[2])));
    }
    double least = losing ? h->top[losing - 1] : INFINITY; /* so many always have as much */
    *others = 0;
    for (size_t a = begin; a < end; a++) {
        Active robot = h->active[a];
        const double *at = robot.at, *b = known(h->aim, h->extra, robot.robot);
        double low_end = smaller(at[0], smaller(at[1], at[2]));
        double high_end = larger(at[0], larger(at[1], at[2]));
        double near = b ? ON_PLANE * (fabs(b[0]) + fabs(b[1]) + fabs(b[2])) : 0.0;
        if (b ? high_end < -near : high_end <= 0.0 && is_idle(h, triangle, robot.robot))
            continue;
        if (b && low_end > near && high_end < least) {
            add(triangle->fixed, b);
            continue;
        }
        robot.is_crossing = !(low_end > near);
        *others += !b && robot.is_crossing;
        h->active[kept++] = robot;
    }
    return kept;
}

/* The generator of a known robot, whitened. */
static void whitened(const Hunt *h, const Active *robot, double *c) {
    whiten(&h->white, known(h->aim, h->extra, robot->robot), c);
}

/* Of the known robots that change sign, find one for each plane, LISTED at most. Returns how many,
 * or -1 if there are more. */
static int find_planes(const Hunt *h, size_t begin, size_t end, const Active **planes) {
    double across[LISTED][3], m[3];
    int count = 0;
    for (size_t a = begin; a < end; a++) {
        double c[3];
        int k = 0;
        if (!h->active[a].is_crossing)
            continue;
        whitened(h, h->active + a, c);
        for (; k < count; k++) {
            cross(across[k], c, m);
            if (length(m) <= NO_VERTEX * length(across[k]) * length(c))
                break;
        }
        if (k < count)
            continue;
        if (count == LISTED)
            return -1;
        memcpy(across[count], c, sizeof c);
        planes[count++] = h->active + a;
    }
    return count;
}

/* Tell whether all planes of the known robots that change sign meet in one direction, as those of
 * robots do whose wrenches lie in a plane. Writes the two robots that span it. */
static int meet_in_one(const Hunt *h, size_t begin, size_t end, const Active **pair) {
    double p[3], q[3], m[3] = {0.0};
    int count = 0;
    for (size_t a = begin; a < end; a++) {
        if (!h->active[a].is_crossing)
            continue;
        whitened(h, h->active + a, count ? q : p);
        if (count == 0) {
            pair[count++] = h->active + a;
        } else if (count == 1) {
            cross(p, q, m);
            if (length(m) > NO_VERTEX * length(p) * length(q))
                pair[count++] = h->active + a;
        } else if (fabs(dot(m, q)) > NO_VERTEX * length(m) * length(q)) {
            return 0;
        }
    }
    return count == 2;
}

/* Offer a normal in a triangle, or next to it, that two robots' planes cross. Next to it others may
 * change sign: if it looks weakest all robots are asked. */
static void offer_vertex(Hunt *h, const Triangle *triangle, size_t begin, size_t end,
                         const double *normal, int one, int two) {
    double extent = criterion_extent(h->aim, normal), size = length(normal);
    double height = height_at(h, triangle, begin, end, normal, one, two);
    if (height + h->rounding * size >= h->best * larger(extent, UNASKED * size))
        return;
    height = dot(h->aim->load, normal);
    clear(h->top, h->aim->losing);
    for (int i = 0; i < robots_of(h->aim) + (h->extra != NULL); i++)
        if (i != one && i != two)
            height += note_largest(h->top, h->aim->losing,
                                   larger(0.0, low(h->aim, h->extra, i, normal)));
    offer(h, normal, height, extent);
}

/* Turn a normal across a generator, where rounding left it next to that: of one much stronger than
 * the others the rest would count for more than they do. */
static void lay_across(const double *b, double *normal) {
    double along = dot(normal, b) / dot(b, b);
    for (int k = 0; k < 3; k++)
        normal[k] -= along * b[k];
}

/* Evaluate H where the planes of two robots meet, if that is in a triangle. */
static void try_vertex(Hunt *h, const Triangle *triangle, size_t begin, size_t end,
                       const Active *one, const Active *two) {
    double p[3], q[3], m[3], normal[3];
    whitened(h, one, p);
    whitened(h, two, q);
    cross(p, q, m);
    if (length(m) <= NO_VERTEX * length(p) * length(q))
        return;
    int side = is_inside(triangle->white, m);
    if (side == 0)
        return;
    double turn = dot(m, p) / dot(p, p);
    for (int k = 0; k < 3; k++)
        m[k] = side * (m[k] - turn * p[k]);
    normal_of(&h->white, m, normal);
    const double *b = known(h->aim, h->extra, one->robot);
    const double *c = known(h->aim, h->extra, two->robot);
    lay_across(dot(b, b) > dot(c, c) ? b : c, normal);
    offer_vertex(h, triangle, begin, end, normal, one->robot, two->robot);
}

/* Evaluate H where the plane of a robot meets the edges of a triangle. */
static void try_edges(Hunt *h, const Triangle *triangle, size_t begin, size_t end,
                      const Active *one) {
    for (int j = 0; j < 3; j++) {
        int to = (j + 1) % 3;
        double from_low = one->at[j], to_low = one->at[to], normal[3];
        if (from_low * to_low >= 0.0)
            continue;
        for (int k = 0; k < 3; k++)
            normal[k] = fabs(to_low) * triangle->normal[3 * j + k]
                        + fabs(from_low) * triangle->normal[3 * to + k];
        const double *b = known(h->aim, h->extra, one->robot);
        if (b)
            lay_across(b, normal);
        offer_vertex(h, triangle, begin, end, normal, one->robot, one->robot);
    }
}

/* Finish a triangle that few planes cross, or many that meet in one direction, by listing its
 * vertices: H is concave between the planes of the known robots, as long as the others do not
 * change sign; so its least is at a vertex. Those on the triangle's edges count too: there may be no
 * others, if all generators lie in a plane. Returns whether that could be done. */
static int list_vertices(Hunt *h, const Triangle *triangle, size_t begin, size_t end) {
    const Active *planes[LISTED], *pair[2] = {NULL, NULL};
    int count = find_planes(h, begin, end, planes);
    charge(h->work, h->each * (double)(end - begin) * larger(1.0, 0.5 * count * count));
    for (int a = 0; a < count; a++)
        for (int b = a + 1; b < count; b++)
            try_vertex(h, triangle, begin, end, planes[a], planes[b]);
    if (count < 0) {
        if (!meet_in_one(h, begin, end, pair))
            return 0;
        try_vertex(h, triangle, begin, end, pair[0], pair[1]);
    }
    for (size_t a = begin; a < end; a++)
        if (h->active[a].is_crossing)
            try_edges(h, triangle, begin, end, h->active + a);
    return 1;
}

static Status explore(Hunt *h, Triangle *triangle, size_t begin, size_t end, int depth);
static Status polish(Hunt *h);

/* Search the half of a triangle in which the middle of an edge replaces a corner. */
static Status explore_half(Hunt *h, const Triangle *whole, size_t begin, size_t end, int corner,
                           const double *white, const double *normal, int depth) {
    Triangle half = *whole;
    size_t wanted_room = end + (end - begin);
    if (wanted_room > h->room) {
        Active *grown = realloc(h->active, 2 * wanted_room * sizeof *grown);
        if (!grown)
            return NO_MEMORY;
        h->active = grown;
        h->room = 2 * wanted_room;
    }
    memcpy(half.white + 3 * corner, white, 3 * sizeof *white);
    memcpy(half.normal + 3 * corner, normal, 3 * sizeof *normal);
    half.extent[corner] = criterion_extent(h->aim, normal);
    for (size_t a = begin; a < end; a++) {
        Active *copy = h->active + end + (a - begin);
        *copy = h->active[a];
        copy->at[corner] = low(h->aim, h->extra, copy->robot, normal);
    }
    return explore(h, &half, end, end + (end - begin), depth - 1);
}

/* Search a triangle for normals with less than the best. */
static Status explore(Hunt *h, Triangle *triangle, size_t begin, size_t end, int depth) {
    int others, losing = h->aim->losing;
    double height[3];
    h->triangles += 1.0;
    Status status = spend(h->work, h->each * (double)(end - begin) + BASIC);
    if (status == SOLVED && h->best < h->polished && h->rest-- <= 0.0)
        status = polish(h);
    if (status != SOLVED)
        return status;
    end = sift(h, triangle, begin, end, &others);
    for (int j = 0; j < 3; j++) {
        height[j] = dot(triangle->fixed, triangle->normal + 3 * j);
        clear(h->top, losing);
        for (size_t a = begin; a < end; a++)
            height[j] += note_largest(h->top, losing, larger(0.0, h->active[a].at[j]));
        offer(h, triangle->normal + 3 * j, height[j], triangle->extent[j]);
    }
    if (h->best <= h->zero || is_held(h, triangle, begin, end))
        return SOLVED;
    if (others == 0 && list_vertices(h, triangle, begin, end))
        return SOLVED;
    double edge, white[3], normal[3], size;
    int from = longest_edge(triangle->white, &edge), to = (from + 1) % 3;
    if (depth == 0 || edge <= SMALLEST)
        return SOLVED;
    for (int k = 0; k < 3; k++)
        white[k] = triangle->white[3 * from + k] + triangle->white[3 * to + k];
    size = length(white);
    for (int k = 0; k < 3; k++) {
        white[k] /= size;
        normal[k] = (triangle->normal[3 * from + k] + triangle->normal[3 * to + k]) / size;
    }
    /* the half with the weaker end first: a low value early saves the rest */
    double target = wanted(h);
    int is_first = height[from] - target * triangle->extent[from]
                   > height[to] - target * triangle->extent[to];
    status = explore_half(h, triangle, begin, end, is_first ? from : to, white, normal, depth);
    if (status == SOLVED && h->best > h->zero)
        status = explore_half(h, triangle, begin, end, is_first ? to : from, white, normal, depth);
    return status;
}

static int least_of(int a, int b) { return a < b ? a : b; }

/* Look at the normal across a robot along which a task asks most. Of one that only rounding keeps from
 * pushing straight along the task, H vanishes there while D is next to nothing, which no triangle is
 * small enough to show ("criteria", seed 9258). */
static Status look_across(Hunt *h, const double *b, const double *row) {
    double n[3], height, cap, square = dot(b, b);
    memcpy(n, row, sizeof n);
    for (int t = 0; t < 2; t++) { /* the second time, what rounding left */
        double share = dot(n, b) / square, size;
        for (int k = 0; k < 3; k++)
            n[k] -= share * b[k];
        size = length(n);
        if (size == 0.0)
            return SOLVED;
        for (int k = 0; k < 3; k++)
            n[k] /= size;
    }
    Status status = criterion_height(h->aim, n, h->extra, &height, &cap);
    if (status == SOLVED)
        offer(h, n, height, criterion_extent(h->aim, n));
    return status;
}

/* Look at directions spread evenly: a low value to begin with keeps the search out of valleys that
 * are not the deepest. */
static Status look_around(Hunt *h) {
    const Criterion *aim = h->aim;
    int robots = aim->is_polytope ? least_of(aim->points + (h->extra != NULL), ALONG) : 0;
    for (int i = 0; i < robots; i++)
        for (int k = 0; k < least_of(aim->tasks, ALONG); k++) {
            const double *b = i < aim->points ? known(aim, h->extra, i) : h->extra;
            Status status = look_across(h, b, aim->task + (ptrdiff_t)3 * k);
            if (status != SOLVED)
                return status;
        }
    for (int k = 0; k < AROUND && h->best > h->zero; k++) {
        double white[3], normal[3], height, cap;
        on_spiral(k, AROUND, white);
        normal_of(&h->white, white, normal);
        Status status = criterion_height(h->aim, normal, h->extra, &height, &cap);
        if (status != SOLVED)
            return status;
        offer(h, normal, height, criterion_extent(h->aim, normal));
    }
    return spend(h->work, AROUND * (h->each * robots_of(h->aim) + BASIC));
}

static void swap_corners(double *corners, int width) {
    for (int k = 0; k < width; k++) {
        double swap = corners[k];
        corners[k] = corners[width + k];
        corners[width + k] = swap;
    }
}

/* Search one of the eight triangles that all directions are divided into. */
static Status explore_octant(Hunt *h, int octant, int count) {
    const Criterion *aim = h->aim;
    Triangle triangle = {.white = {0.0}};
    memcpy(triangle.fixed, aim->load, sizeof triangle.fixed);
    for (int j = 0; j < 3; j++) {
        triangle.white[3 * j + j] = octant >> j & 1 ? -1.0 : 1.0;
        normal_of(&h->white, triangle.white + 3 * j, triangle.normal + 3 * j);
        triangle.extent[j] = criterion_extent(aim, triangle.normal + 3 * j);
    }
    if ((octant ^ octant >> 1 ^ octant >> 2) & 1) { /* counter-clockwise */
        swap_corners(triangle.white, 3);
        swap_corners(triangle.normal, 3);
        swap_corners(triangle.extent, 1);
    }
    for (int i = 0; i < count; i++) {
        h->active[i] = (Active){.robot = i};
        for (int j = 0; j < 3; j++)
            h->active[i].at[j] = low(aim, h->extra, i, triangle.normal + 3 * j);
    }
    return explore(h, &triangle, 0, (size_t)count, DEPTH);
}

/* Search all directions for values below the best. */
static Status explore_all(Hunt *h) {
    int count = robots_of(h->aim) + (h->extra != NULL);
    h->room = 2 * (size_t)count + 64;
    h->active = malloc(h->room * sizeof *h->active);
    h->top = malloc(((size_t)h->aim->losing + 1) * sizeof *h->top);
    Status status = h->active && h->top ? SOLVED : NO_MEMORY;
    for (int octant = 0; octant < 8 && status == SOLVED && h->best > h->zero; octant++)
        status = explore_octant(h, octant, count);
    free(h->active);
    free(h->top);
    return status;
}

/* Lower the best to the least that the robots have in the poses that are worst at its normal, which
 * is exact and takes a few triangles; and again with those that are worst there. Without this a
 * search creeps down into every valley by ever smaller steps. */
static Status polish(Hunt *h) {
    int count = robots_of(h->aim) + (h->extra != NULL);
    double *point = malloc(3 * (size_t)count * sizeof *point), before, height, cap;
    Criterion fixed = *h->aim;
    Status status;
    if (!point)
        return NO_MEMORY;
    fixed.points = count;
    fixed.point = point;
    fixed.spread = 0;
    h->rest = 0.0;
    do {
        for (int i = 0; i < count; i++) {
            const double *b = known(h->aim, h->extra, i);
            if (b)
                memcpy(point + 3 * i, b, 3 * sizeof *b);
            else
                spread_low(h->aim, i - h->aim->points, h->normal, point + 3 * i);
        }
        Hunt part = {.aim = &fixed, .white = h->white, .gap = EXACT, .zero = h->zero, .rounding = h->rounding,
                     .best = h->best, .polished = -INFINITY, .each = 1.0, .work = h->work};
        before = h->best;
        status = explore_all(&part);
        h->rest += part.triangles;
        if (part.best < before && !is_fault(status)) { /* in poses that are worse there, even less */
            Status valued = criterion_height(h->aim, part.normal, h->extra, &height, &cap);
            if (valued == SOLVED)
                offer(h, part.normal, height, criterion_extent(h->aim, part.normal));
            else
                status = valued;
        }
    } while (status == SOLVED && h->best < before - EXACT * fabs(before) && h->best > h->zero);
    h->polished = h->best;
    free(point);
    return status;
}

/* Whiten directions by what matters: the robots, uncertain ones by their ends, task and load. */
static Status choose_whitening(Hunt *h) {
    const Criterion *aim = h->aim;
    size_t size = 3 * (size_t)aim->frames;
    double *frame = malloc((size + 3) * sizeof *frame);
    if (!frame)
        return NO_MEMORY;
    memcpy(frame, aim->frame, size * sizeof *frame);
    if (h->extra)
        memcpy(frame + size, h->extra, 3 * sizeof *frame);
    whitening_of(&h->white, frame, aim->frames + (h->extra != NULL));
    free(frame);
    return SOLVED;
}

Status criterion_search(const Criterion *aim, const double *extra, double gap, double below,
                        double rounding, Work *work, double *value, double *normal) {
    int robots = robots_of(aim);
    Hunt h = {.aim = aim, .extra = extra, .gap = gap, .zero = ZERO / UNASKED * rounding, .best = below,
              .rounding = rounding, .work = work};
    h.polished = aim->spread ? below : -INFINITY;
    h.each = robots ? (aim->points + TURNED * aim->first[aim->spread]) / robots : 1.0;
    Status status = choose_whitening(&h);
    if (status == SOLVED)
        status = look_around(&h);
    if (status == SOLVED)
        status = explore_all(&h);
    double size = length(h.normal);
    *value = size > 0.0 ? h.value : below;
    for (int k = 0; k < 3; k++)
        normal[k] = size > 0.0 ? h.normal[k] / size : 0.0;
    return status;
}
