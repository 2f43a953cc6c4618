/* Branch and bound over triangles of directions, least bound first, with gradients of h as cuts (T12).
 * Trusted are a tree that is built, and whitened generators beside it. Some hundred to some thousand
 * cells of 160 bytes, as many as facets nearly as weak as the weakest; below a cell that few
 * generators cross, recursion DEPTH deep in room of 0.6 MB. */
#include <stdlib.h>
#include <string.h>

#include "sphere.h"
#include "triangle.h"
#include "vectors.h"

#define LISTED 12        /* generators a triangle may be crossed by for its vertices to be listed */
#define LOCAL 256        /* or to be searched on its own, with what matters there; */
#define FEW 32           /* so many in a young search, where a look that sees more costs most */
#define LONG 1000        /* cells until a search is no longer young */
#define TRIES 2          /* cuts made in a cell before it is split */
#define WORTH 0.4        /* share of the gap that a cut should close for another to be tried */
#define FUTILE 0.1       /* gap, relative to h and the edge squared, that only splitting closes */
#define BASIC 20.0       /* units of work that a cell takes besides */
#define EVALUATION 4e-15 /* of sum |c_i|: what evaluations may differ by; */
#define IDLE 100.0       /* times that: below the bound by more, a cut holds nothing up */
#define DEPTH 100        /* halvings until a cell is a point, and more */

/* What matters on a cell: the generators that change sign on it, and the sum of those that are
 * positive on all of it. */
typedef struct {
    double *vectors; /* (count, 3) */
    int count;
    double sum[3];
} Local;

/* |M' m|: the length of the normal that m stands for. */
static double size_of(const Tree *tree, const double *m) {
    double n[3];
    normal_of(&tree->white, m, n);
    return length(n);
}

/* -- the heap ---------------------------------------------------------------------------- */

static Status push(Sphere *s, const Cell *cell) {
    if (s->cells == s->room) {
        int room = s->room ? 2 * s->room : 64;
        Cell *grown = realloc(s->cell, (size_t)room * sizeof *grown);
        if (!grown)
            return NO_MEMORY;
        s->cell = grown;
        s->room = room;
    }
    int i = s->cells++;
    while (i > 0 && s->cell[(i - 1) / 2].bound > cell->bound) {
        s->cell[i] = s->cell[(i - 1) / 2];
        i = (i - 1) / 2;
    }
    s->cell[i] = *cell;
    return SOLVED;
}

static void pop(Sphere *s, Cell *cell) {
    *cell = s->cell[0];
    const Cell *last = s->cell + --s->cells;
    int i = 0;
    for (;;) {
        int k = 2 * i + 1;
        if (k >= s->cells)
            break;
        if (k + 1 < s->cells && s->cell[k + 1].bound < s->cell[k].bound)
            k++;
        if (s->cell[k].bound >= last->bound)
            break;
        s->cell[i] = s->cell[k];
        i = k;
    }
    s->cell[i] = *last;
}

/* -- values ------------------------------------------------------------------------------ */

/* Evaluate h at m, write its gradient there, and keep the best h / |n|. In a cell where that is
 * known, `local` says what matters there; otherwise it is NULL. */
static double evaluate(Sphere *s, const Local *local, const double *m, double rounding, double *g) {
    const double *b, *end;
    if (local) {
        memcpy(g, local->sum, sizeof local->sum);
        b = local->vectors;
        end = b + 3 * local->count;
    } else {
        charge(s->work, tree_gradient(s->tree, m, rounding, g));
        b = s->extra;
        end = b + 3 * s->extras;
    }
    charge(s->work, (double)(end - b) / 3.0);
    for (; b < end; b += 3)
        if (dot(m, b) > 0.0)
            add(g, b);
    double value = larger(0.0, dot(g, m)), size = size_of(s->tree, m);
    if (value / size < s->best) {
        s->best = value / size;
        s->error = EVALUATION * s->weight * length(m) / size;
        memcpy(s->normal, m, sizeof s->normal);
    }
    return value;
}

/* -- the relaxation in one cell ------------------------------------------------------------ */

/* What a cut says at the corners, and so between them. */
static void at_corners(const double *scaled, const double *g, double *row) {
    for (int j = 0; j < 3; j++)
        row[j] = dot(g, scaled + 3 * j);
}

/* Keep the cuts that hold the bound up. */
static void drop_idle(Cell *cell, double cuts[][3], double rows[][3], int count,
                      const double *share, double bound, double error) {
    cell->cuts = 0;
    for (int k = 0; k < count; k++)
        if (cell->cuts < PLANES && dot(rows[k], share) >= bound - IDLE * error) {
            memcpy(cell->cut[cell->cuts], cuts[k], sizeof cuts[k]);
            memmove(rows[cell->cuts++], rows[k], sizeof rows[k]);
        }
}

/* Raise the bound of a cell with the cuts it has, and more at the points where they are least. */
static void tighten(Sphere *s, Cell *cell, const Local *local, const double *scaled,
                    double wanted, int tries) {
    double cuts[PLANES + 1][3], rows[PLANES + 1][3], share[3] = {1.0 / 3, 1.0 / 3, 1.0 / 3};
    double bound = -INFINITY;
    for (int k = 0; k < cell->cuts; k++)
        at_corners(scaled, cell->cut[k], rows[k]);
    if (cell->cuts) {
        bound = relax(rows, cell->cuts, share);
        cell->bound = larger(cell->bound, bound);
    }
    for (int t = 0; t < tries && cell->bound < wanted; t++) {
        double m[3] = {0.0}, value, before = bound;
        int count = cell->cuts;
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                m[k] += share[j] * scaled[3 * j + k];
        memcpy(cuts, cell->cut, sizeof cell->cut);
        evaluate(s, local, m, 0.0, cuts[count]);
        at_corners(scaled, cuts[count], rows[count]);
        value = dot(rows[count], share);
        if (value <= bound + s->error)
            break; /* the cuts meet h here */
        bound = relax(rows, count + 1, share);
        drop_idle(cell, cuts, rows, count + 1, share, bound, s->error);
        cell->bound = larger(cell->bound, bound);
        if (value - before < WORTH * (wanted - before))
            break;
    }
}

/* -- the end of a cell ------------------------------------------------------------------- */

/* Of some generators, keep those that change sign on a cell, `most` of them, and add up those that
 * are positive on it. Returns 0 if there are more. */
static int sift(const Cell *cell, const double *from, int count, int most, Local *local) {
    const double *v = cell->corner;
    for (const double *b = from; b < from + 3 * count; b += 3) {
        double first = dot(v, b), second = dot(v + 3, b), third = dot(v + 6, b);
        double near = ON_PLANE * (fabs(b[0]) + fabs(b[1]) + fabs(b[2]));
        if (first > near && second > near && third > near) {
            add(local->sum, b);
        } else if (!(first < -near && second < -near && third < -near)) {
            if (local->count == most)
                return 0;
            memcpy(local->vectors + 3 * local->count++, b, 3 * sizeof *b);
        }
    }
    return 1;
}

/* Find what matters on a cell. Returns 0 if more than `most` generators do. */
static int look_closer(const Sphere *s, const Cell *cell, int most, Local *local) {
    int looked;
    local->count = tree_crossed(s->tree, cell->corner, most, local->vectors, local->sum, &looked);
    charge(s->work, looked + s->extras);
    return local->count >= 0 && sift(cell, s->extra, s->extras, most, local);
}

/* Evaluate h at every vertex in a triangle that few generators cross: the triangle is done. */
static void list_vertices(Sphere *s, const Cell *cell, const Local *local) {
    const double *c = local->vectors;
    double ignored[3];
    int count = local->count;
    charge(s->work, 0.5 * count * count * count);
    for (int a = 0; a < count; a++)
        for (int b = a + 1; b < count; b++) {
            double m[3];
            const double *p = c + 3 * a, *q = c + 3 * b;
            cross(p, q, m);
            if (length(m) <= NO_VERTEX * length(p) * length(q))
                continue;
            int side = is_inside(cell->corner, m);
            if (side == 0)
                continue;
            double turn = dot(m, p) / dot(p, p), value;
            for (int k = 0; k < 3; k++)
                m[k] = side * (m[k] - turn * p[k]);
            value = dot(local->sum, m);
            for (int k = 0; k < count; k++)
                value += k == a || k == b ? 0.0 : larger(0.0, dot(c + 3 * k, m));
            if (value < s->best * size_of(s->tree, m))
                evaluate(s, NULL, m, NOISE, ignored);
        }
}

/* Halve a triangle at the middle of its longest edge. */
static void halve(const Cell *cell, Cell *one, Cell *two) {
    double middle[3], edge;
    int at = longest_edge(cell->corner, &edge), to = (at + 1) % 3;
    const double *p = cell->corner + 3 * at, *q = cell->corner + 3 * to;
    for (int k = 0; k < 3; k++)
        middle[k] = p[k] + q[k];
    double size = length(middle);
    for (int k = 0; k < 3; k++)
        middle[k] /= size;
    *one = *two = *cell;
    memcpy(one->corner + 3 * at, middle, sizeof middle);
    memcpy(two->corner + 3 * to, middle, sizeof middle);
}

/* Corners as multiples of which every unit normal of the cell is a sum with shares >= 1. */
static void scale_corners(const Tree *tree, const Cell *cell, double *scaled) {
    for (int j = 0; j < 3; j++) {
        double size = size_of(tree, cell->corner + 3 * j);
        for (int k = 0; k < 3; k++)
            scaled[3 * j + k] = cell->corner[3 * j + k] / size;
    }
}

static double edge_of(const Cell *cell) {
    double edge;
    longest_edge(cell->corner, &edge);
    return edge;
}

/* The tries that a cell is worth: none if only splitting can close the gap. */
static int tries_for(const Sphere *s, const Cell *cell) {
    double edge = edge_of(cell);
    return s->best - cell->bound < FUTILE * s->best * edge * edge ? 0 : TRIES;
}

/* The bound at which a cell is done. */
static double enough(const Sphere *s) {
    return s->best - s->error;
}

/* Search a cell to its end, knowing what matters on it. `room` is for what matters on its parts,
 * down to so many halvings. Returns a status. */
static Status finish(Sphere *s, const Cell *cell, const Local *local, double *room, int depth) {
    Cell own = *cell, halves[2];
    double scaled[9];
    Status status = spend(s->work, BASIC + local->count);
    if (local->count <= LISTED) {
        list_vertices(s, cell, local);
        return status;
    }
    scale_corners(s->tree, cell, scaled);
    tighten(s, &own, local, scaled, s->best, tries_for(s, cell));
    if (own.bound >= enough(s) || edge_of(cell) <= SMALLEST || depth == 0)
        return status;
    halve(&own, halves, halves + 1);
    for (int k = 0; k < 2; k++) {
        scale_corners(s->tree, halves + k, scaled);
        tighten(s, halves + k, NULL, scaled, s->best, 0);
    }
    int first = halves[1].bound < halves[0].bound;
    for (int k = 0; k < 2 && status == SOLVED; k++) {
        const Cell *half = halves + (k ? 1 - first : first);
        Local part = {.vectors = room};
        memcpy(part.sum, local->sum, sizeof part.sum);
        if (half->bound < enough(s) && sift(half, local->vectors, local->count, LOCAL, &part))
            status = finish(s, half, &part, room + 3 * part.count, depth - 1);
    }
    return status;
}

/* -- the search ---------------------------------------------------------------------------- */

static void centre_of(const Cell *cell, double *centre) {
    for (int k = 0; k < 3; k++)
        centre[k] = cell->corner[k] + cell->corner[3 + k] + cell->corner[6 + k];
}

/* Fill the heap with all directions, or with those of an earlier run. */
static Status begin(Sphere *s, const Sphere *from, double margin) {
    if (from) {
        for (int k = 0; k < from->cells; k++) {
            Cell cell = from->cell[k];
            double scaled[9], centre[3];
            cell.bound = 0.0;
            scale_corners(s->tree, &cell, scaled);
            centre_of(&cell, centre);
            for (int j = from->extras; j < s->extras; j++) /* each adds m . b or more */
                if (dot(centre, s->extra + 3 * j) > 0.0)
                    for (int i = 0; i < cell.cuts; i++)
                        add(cell.cut[i], s->extra + 3 * j);
            tighten(s, &cell, NULL, scaled, s->best, 0);
            if (cell.bound < s->best + margin && push(s, &cell))
                return NO_MEMORY;
        }
        return SOLVED;
    }
    for (int k = 0; k < 8; k++) {
        Cell cell = {.bound = 0.0, .cuts = 0};
        double x = k & 1 ? -1.0 : 1.0, y = k & 2 ? -1.0 : 1.0, z = k & 4 ? -1.0 : 1.0;
        double corner[9] = {x, 0, 0, 0, y, 0, 0, 0, z};
        if (x * y * z < 0.0) { /* counter-clockwise */
            corner[0] = corner[4] = 0.0;
            corner[1] = y;
            corner[3] = x;
        }
        memcpy(cell.corner, corner, sizeof corner);
        if (push(s, &cell))
            return NO_MEMORY;
    }
    return SOLVED;
}

Status sphere_search(Sphere *s, const Tree *tree, const double *extra, int extras,
                  const Sphere *from, double margin, double below, double zero,
                  Work *work) {
    memset(s, 0, sizeof *s);
    s->work = work;
    s->tree = tree;
    s->extra = extra;
    s->extras = extras;
    s->weight = tree->weight;
    for (int k = 0; k < extras; k++)
        s->weight += length(extra + 3 * k);
    s->best = below;
    Sphere kept = {0};
    double *room = malloc(3 * LOCAL * (DEPTH + 2) * sizeof *room);
    Status status = room ? begin(s, from, margin) : NO_MEMORY;
    for (long round = 1; status == SOLVED && s->cells > 0; round++) {
        s->bound = s->cell[0].bound;
        double scaled[9];
        Cell cell, halves[2];
        Local local = {.vectors = room};
        if (s->cell[0].bound >= enough(s) || s->best <= zero)
            break;
        status = spend(work, BASIC);
        if (status == OUT_OF_BUDGET && s->best == INFINITY)
            status = SOLVED; /* one direction at least is looked at */
        if (status != SOLVED)
            break;
        pop(s, &cell);
        if (look_closer(s, &cell, round < LONG ? FEW : LOCAL, &local)) {
            status = finish(s, &cell, &local, room + 3 * local.count, DEPTH);
            if (margin > 0.0 && push(&kept, &cell))
                status = NO_MEMORY;
            continue;
        }
        scale_corners(tree, &cell, scaled);
        tighten(s, &cell, NULL, scaled, s->best, tries_for(s, &cell));
        if (cell.bound >= s->best || edge_of(&cell) <= SMALLEST) {
            if (cell.bound < s->best + margin)
                status = push(&kept, &cell);
            continue;
        }
        halve(&cell, halves, halves + 1);
        for (int k = 0; k < 2 && status == SOLVED; k++) {
            scale_corners(tree, halves + k, scaled);
            tighten(s, halves + k, NULL, scaled, s->best, 0);
            if (halves[k].bound < s->best + margin)
                status = push(s, halves + k);
        }
    }
    if (status != OUT_OF_BUDGET)
        s->bound = s->best;
    for (int k = 0; k < kept.cells && !is_fault(status); k++)
        if (push(s, kept.cell + k))
            status = NO_MEMORY;
    sphere_free(&kept);
    free(room);
    return status;
}

double sphere_best(const Sphere *s, double *normal) {
    normal_of(&s->tree->white, s->normal, normal);
    double size = length(normal);
    for (int k = 0; k < 3; k++)
        normal[k] /= size;
    return s->best;
}

Status sphere_keep(Sphere *kept, const Sphere *s, double most) {
    sphere_free(kept);
    kept->extras = s->extras;
    for (int k = 0; k < s->cells; k++)
        if (s->cell[k].bound < most && push(kept, s->cell + k))
            return NO_MEMORY;
    return SOLVED;
}

void sphere_free(Sphere *s) {
    free(s->cell);
    s->cell = NULL;
    s->cells = s->room = 0;
}
