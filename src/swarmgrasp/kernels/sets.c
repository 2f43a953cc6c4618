/* Robots as sets of forces: what each exerts along a normal, and what all do but for losses (T20, T25,
 * T26). Trusted are the arrays' sizes, finite numbers, robots in order, and elements that go once
 * around. A height costs a pass over the robots. */
#include <stdlib.h>
#include <string.h>

#include "sets.h"

#define FEW 8 /* losses, and borders of a robot's elements, that need no memory of their own */

/* -- robots ------------------------------------------------------------------------------------- */

double largest_wrench(const double *scale, const ForceSet *set) {
    double most = 0.0, wide = larger(scale[0], scale[1]);
    int ends = set->adrift ? 2 * set->adrift : 1;
    for (int e = 0; e < ends; e++) {
        const double *arm = set->adrift ? set->part + 2 * e : set->arm;
        for (int k = 0; k < set->elements; k++) {
            const Element *at = set->element + k;
            double wrench[3];
            wrench_of(scale, arm, at->at, wrench);
            most = larger(most, at->shape == POINT ? length(wrench)
                                                   : at->radius * hypot(wide, scale[2] * hypot(arm[0], arm[1])));
        }
    }
    for (int r = 0; r < set->turning; r++)
        for (int end = 0; end < 4; end++) {
            const double *piece = set->piece + (ptrdiff_t)PIECE * r;
            double wrench[3];
            wrench_of(scale, piece + (end & 2), piece + 6 + 2 * (end & 1), wrench);
            most = larger(most, set->limit * length(wrench));
        }
    return most;
}

/* Fill in where a robot may be: rows that begin with its number go to `place`, without that. Returns
 * how many are its. */
static int take_places(const double *row, int rows, int width, int skipped, int robot, int *next,
                       double **place) {
    int first = *next;
    for (; *next < rows && row[(ptrdiff_t)width * *next] == (double)robot; ++*next) {
        memcpy(*place, row + (ptrdiff_t)width * *next + skipped,
               (size_t)(width - skipped) * sizeof **place);
        *place += width - skipped;
    }
    return *next - first;
}

Status sets_begin(Sets *sets, const Robots *robots) {
    size_t count = (size_t)robots->count, all = 0, places;
    for (size_t i = 0; i < count; i++)
        all += (size_t)robots->elements[i];
    places = (size_t)robots->parts * (PART - 1) + (size_t)robots->poses * (POSE - 2);
    sets->set = calloc(count + 1, sizeof *sets->set);
    sets->machine = calloc(count + 1, sizeof *sets->machine);
    sets->element = malloc((all + 1) * sizeof *sets->element);
    sets->place = malloc((places + 1) * sizeof *sets->place);
    sets->fails = malloc((size_t)robots->failures * count + 1);
    if (!sets->set || !sets->machine || !sets->element || !sets->place || !sets->fails)
        return NO_MEMORY;
    sets->failures = robots->failures;
    for (size_t k = 0; k < (size_t)robots->failures * count; k++)
        sets->fails[k] = robots->failure[k] != 0.0;
    Element *element = sets->element;
    double *place = sets->place;
    const double *row = robots->row;
    int part = 0, pose = 0;
    sets->count = robots->count;
    sets->machines = 0;
    sets->weight = length(sets->load);
    for (int i = 0; i < robots->count; i++) {
        ForceSet *set = sets->set + i;
        set->arm[0] = robots->arm[2 * (ptrdiff_t)i];
        set->arm[1] = robots->arm[2 * (ptrdiff_t)i + 1];
        set->element = element;
        set->elements = (int)robots->elements[i];
        for (int k = 0; k < set->elements; k++, row += ELEMENT)
            *element++ = element_of(row);
        set->part = place;
        set->adrift = take_places(robots->part, robots->parts, PART, 1, i, &part, &place);
        set->piece = place;
        if (pose < robots->poses)
            set->limit = robots->pose[(ptrdiff_t)POSE * pose + 1];
        set->turning = take_places(robots->pose, robots->poses, POSE, 2, i, &pose, &place);
        sets->machine[i] = (int)robots->machine[i];
        if (sets->machine[i] >= sets->machines)
            sets->machines = sets->machine[i] + 1;
        sets->weight += largest_wrench(sets->scale, set);
    }
    return SOLVED;
}

void sets_end(Sets *sets) {
    free(sets->set);
    free(sets->machine);
    free(sets->element);
    free(sets->place);
    free(sets->fails);
    sets->set = NULL;
    sets->machine = NULL;
    sets->element = NULL;
    sets->place = NULL;
    sets->fails = NULL;
}

/* The least support along a straight part, over the shares s of the way. It is convex, and smooth
 * but where p crosses the border of an element's cone; an arc's least is where p is nearest to 0. */
static double least_along(const ForceSet *set, const double *from, const double *step, double *s) {
    double least = INFINITY, size = along(step, step);
    for (int k = -1; k < set->elements; k++)
        for (int end = 0; end < 2; end++) {
            double t, p[2];
            if (k < 0) {
                t = end;
            } else {
                const Element *e = set->element + k;
                const double *border = end ? e->end : e->start;
                double turn = across(border, step);
                t = turn != 0.0 ? -across(border, from) / turn : 0.0;
            }
            if (!(t >= 0.0 && t <= 1.0))
                continue;
            p[0] = from[0] + t * step[0];
            p[1] = from[1] + t * step[1];
            double value = support(set, p, NULL, NULL);
            if (value < least) {
                least = value;
                *s = t;
            }
        }
    double t = size > 0.0 ? -along(from, step) / size : 0.0;
    if (t > 0.0 && t < 1.0) {
        double p[2] = {from[0] + t * step[0], from[1] + t * step[1]};
        double value = support(set, p, NULL, NULL);
        if (value < least) {
            least = value;
            *s = t;
        }
    }
    return least;
}

#define ASIDE 1e-7 /* of a straight part: how far beside the worst contact forces are taken */

double worst_on_part(const double *scale, const ForceSet *set, const double *part,
                     const double *normal, double *arm, double *force) {
    double from[2], to[2], step[2], s = 0.0, ends[2][2], slope[2];
    lever(scale, part, normal, from);
    lever(scale, part + 2, normal, to);
    step[0] = to[0] - from[0];
    step[1] = to[1] - from[1];
    double least = least_along(set, from, step, &s);
    if (!force)
        return least;
    for (int side = 0; side < 2; side++) {
        double t = side ? smaller(1.0, s + ASIDE) : larger(0.0, s - ASIDE);
        double p[2] = {from[0] + t * step[0], from[1] + t * step[1]};
        support(set, p, ends[side], NULL);
        slope[side] = along(ends[side], step);
    }
    /* the mixture of the two that is worth the same at both ends, if there is one */
    double share = slope[0] < 0.0 && slope[1] > 0.0 ? slope[0] / (slope[0] - slope[1])
                                                    : slope[0] >= 0.0 ? 0.0 : 1.0;
    for (int k = 0; k < 2; k++) {
        force[k] = ends[0][k] + share * (ends[1][k] - ends[0][k]);
        arm[k] = part[k] + s * (part[k + 2] - part[k]);
    }
    return least;
}

/* The least n . b over the poses of a ray of uncertain direction; writes that pose. */
static double worst_pose(const double *scale, const ForceSet *set, const double *normal, double *force,
                         double *arm) {
    double v[3], least = INFINITY;
    for (int k = 0; k < 3; k++)
        v[k] = -normal[k] * scale[k] * set->limit;
    for (int r = 0; r < set->turning; r++) {
        const double *piece = set->piece + (ptrdiff_t)PIECE * r;
        double at[3], value = -best_on_piece(piece, v, at);
        if (value < least) {
            double here = piece[0] * at[1] - piece[1] * at[0];
            int end = fabs(here - at[2]) <= fabs(piece[2] * at[1] - piece[3] * at[0] - at[2]) ? 0 : 2;
            least = value;
            for (int k = 0; k < 2; k++) {
                force[k] = at[k] * set->limit;
                arm[k] = piece[end + k];
            }
        }
    }
    return least;
}

double exert_at_worst(const double *scale, const ForceSet *set, const double *normal, double *wrench,
                      double *force, double *arm) {
    double f[2] = {0.0, 0.0}, c[2] = {set->arm[0], set->arm[1]}, value = 0.0;
    if (set->turning) {
        value = worst_pose(scale, set, normal, f, c);
        if (value <= 0.0)
            value = f[0] = f[1] = 0.0;
    } else if (set->adrift) {
        value = INFINITY;
        for (int r = 0; r < set->adrift; r++) {
            const double *part = set->part + (ptrdiff_t)(PART - 1) * r;
            double at[2], by[2], here = worst_on_part(scale, set, part, normal, at, by);
            if (here < value) {
                value = here;
                memcpy(c, at, sizeof c);
                memcpy(f, by, sizeof f);
            }
        }
    }
    if (wrench)
        wrench_of(scale, c, f, wrench);
    if (force)
        memcpy(force, f, sizeof f);
    if (arm)
        memcpy(arm, c, sizeof c);
    return value;
}

/* -- all of them -------------------------------------------------------------------------------- */

double add_greatest(double *terms, int count, int most, double *last) {
    double sum = 0.0;
    int low = 0, high = count, want = most < count ? most : count;
    *last = 0.0;
    while (high - low > 1 && want > low && want < high) { /* the greatest come first */
        double pivot = terms[low + (high - low) / 2];
        int i = low, j = high - 1;
        while (i <= j) {
            while (terms[i] > pivot)
                i++;
            while (terms[j] < pivot)
                j--;
            if (i <= j) {
                double swap = terms[i];
                terms[i++] = terms[j];
                terms[j--] = swap;
            }
        }
        if (want <= j + 1)
            high = j + 1;
        else if (want >= i)
            low = i;
        else
            break;
    }
    for (int k = 0; k < want; k++) {
        double term = larger(0.0, terms[k]);
        sum += term;
        *last = k == 0 ? term : smaller(*last, term);
    }
    if (want < most)
        *last = 0.0;
    return sum;
}

/* H without the robots that a failure takes, of what robots exert; `sum` (machines,) is room. */
static double height_after(const Sets *sets, const char *fails, const double *exerted, int robots,
                           int machines, double *sum, double *last) {
    double height = 0.0;
    memset(sum, 0, (size_t)machines * sizeof *sum);
    for (int i = 0; i < robots; i++)
        if (!fails || i == sets->count || !fails[i]) {
            height += exerted[i];
            sum[i < sets->count ? sets->machine[i] : sets->machines] += exerted[i];
        }
    return height - add_greatest(sum, machines, sets->losing, last);
}

Status sets_height(const Sets *sets, const double *normal, const ForceSet *extra, double *height,
                   double *cap) {
    int machines = sets->machines + (extra != NULL), robots = sets->count + (extra != NULL);
    double load = dot(sets->load, normal), total = 0.0, last;
    int is_plain = !sets->losing && !sets->failures;
    double *exerted = is_plain ? NULL : malloc(((size_t)robots + (size_t)machines + 1) * sizeof *exerted);
    if (!is_plain && !exerted)
        return NO_MEMORY;
    for (int i = 0; i < robots; i++) {
        double value = exert(sets->scale, i < sets->count ? sets->set + i : extra, normal, NULL, NULL, NULL);
        total += value;
        if (exerted)
            exerted[i] = value;
    }
    *height = is_plain ? load + total : INFINITY;
    *cap = INFINITY;
    for (int f = 0; exerted && f < (sets->failures ? sets->failures : 1); f++) {
        const char *fails = sets->failures ? sets->fails + (ptrdiff_t)f * sets->count : NULL;
        double left = load + height_after(sets, fails, exerted, robots, machines, exerted + robots, &last);
        *height = smaller(*height, left);
        if (sets->losing)
            *cap = smaller(*cap, left + last);
    }
    free(exerted);
    return SOLVED;
}

Status sets_after(const Sets *sets, int failure, Sets *left) {
    const char *fails = sets->fails + (ptrdiff_t)failure * sets->count;
    *left = *sets;
    left->failures = left->count = 0;
    left->set = malloc(((size_t)sets->count + 1) * sizeof *left->set);
    left->machine = malloc(((size_t)sets->count + 1) * sizeof *left->machine);
    if (!left->set || !left->machine)
        return NO_MEMORY;
    for (int i = 0; i < sets->count; i++)
        if (!fails[i]) {
            left->set[left->count] = sets->set[i];
            left->machine[left->count++] = sets->machine[i];
        }
    return SOLVED;
}

double sets_extent(const Sets *sets, const double *normal) {
    double extent = 0.0;
    if (sets->tasks == 0)
        return length(normal);
    for (int k = 0; k < sets->tasks; k++) {
        double reach = dot(sets->task + (ptrdiff_t)3 * k, normal);
        if (sets->is_polytope)
            extent = larger(extent, reach);
        else
            extent += reach * reach;
    }
    return sets->is_polytope ? extent : sqrt(extent);
}

void sets_farthest(const Sets *sets, const double *normal, double *wrench) {
    double extent = sets_extent(sets, normal), most = 0.0;
    memset(wrench, 0, 3 * sizeof *wrench);
    if (!(extent > 0.0))
        return;
    for (int k = 0; k < sets->tasks; k++) {
        const double *row = sets->task + (ptrdiff_t)3 * k;
        double reach = dot(row, normal);
        if (sets->is_polytope && reach > most) {
            most = reach;
            memcpy(wrench, row, 3 * sizeof *wrench);
        } else if (!sets->is_polytope) {
            for (int i = 0; i < 3; i++)
                wrench[i] += reach / extent * row[i];
        }
    }
    for (int i = 0; i < 3 && sets->tasks == 0; i++)
        wrench[i] = normal[i] / extent;
}
