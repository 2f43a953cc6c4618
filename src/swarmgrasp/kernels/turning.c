/* Turns a plane that touches a wrench set until a goal is on the face across its normal, as the
 * simplex method would, but to the best normal of each turn (T18). Trusted are finite numbers and
 * units for normals. A turn is linear in the robots, and a few to some twenty are enough; TURNS end
 * what rounding keeps from it. Memory: 21 words a robot. */
#include <stdlib.h>
#include <string.h>

#include "turning.h"
#include "vectors.h"

#define ROUNDED 2e-15 /* cosine that is rounding; of a part, relative to all robots' total */
#define WIDE 0.01     /* sine between two directions that say well what plane they are in */
#define TURNS 400     /* of the plane, far more than it takes */
#define LARGE 100000  /* robots from which the keyboard is looked at in between */

Status turning_room(Turning *t, const double *generators, ptrdiff_t n, int (*interrupted)(void)) {
    size_t room = n > 0 ? (size_t)n : 1;
    *t = (Turning){.n = n, .interrupted = interrupted};
    t->units = malloc(5 * room * sizeof *t->units);
    t->where = malloc(room * sizeof *t->where);
    t->meetings = malloc(room * sizeof *t->meetings);
    if (!t->units || !t->where || !t->meetings || face_room(&t->face, n)) {
        turning_free(t);
        return NO_MEMORY;
    }
    t->sizes = t->units + 3 * room;
    t->s = t->units + 4 * room;
    double largest = 0.0;
    for (ptrdiff_t k = 0; k < 3 * n; k++)
        largest = larger(largest, fabs(generators[k]));
    frexp(largest, &t->exponent);
    for (ptrdiff_t i = 0; i < n; i++) {
        double *unit = t->units + 3 * i, most = 0.0;
        for (int k = 0; k < 3; k++) {
            unit[k] = ldexp(generators[3 * i + k], -t->exponent);
            most = larger(most, fabs(unit[k]));
        }
        for (int k = 0; k < 3 && most > 0.0; k++)
            unit[k] /= most; /* squares of small numbers are 0 */
        double size = length(unit);
        for (int k = 0; k < 3 && most > 0.0; k++)
            unit[k] /= size;
        t->sizes[i] = most * size;
        t->total += t->sizes[i];
    }
    return SOLVED;
}

void turning_free(Turning *t) {
    free(t->units);
    free(t->where);
    free(t->meetings);
    face_free(&t->face);
    *t = (Turning){0};
}

/* -- the plane across a normal ----------------------------------------------------------------- */

/* Tell who is in front of the plane across a unit normal, in it, or behind; two are known to be in
 * it. `height` is what heights are compared with, beside that of the plane. Returns the corner in
 * front, the sum of those there, and its size. */
static double divide(Turning *t, const double *normal, double height, ptrdiff_t in, ptrdiff_t also,
                     double *corner) {
    double size = 0.0;
    for (ptrdiff_t i = 0; i < t->n; i++) {
        t->s[i] = dot(normal, t->units + 3 * i);
        height += larger(0.0, t->s[i]) * t->sizes[i];
    }
    corner[0] = corner[1] = corner[2] = 0.0;
    t->face.count = 0;
    for (ptrdiff_t i = 0; i < t->n; i++) {
        /* of a giant among dwarfs even a small part is high; of dwarfs no part is, nor is what
         * rounding of a flat set makes */
        double size_i = t->sizes[i], share = size_i > height ? FLAT * height / size_i : FLAT;
        double rounded = smaller(ROUNDED * t->total / size_i, FLAT);
        if (i == in || i == also || fabs(t->s[i]) <= larger(share, rounded)) {
            t->where[i] = 0;
            t->face.robot[t->face.count++] = i;
        } else if (t->s[i] > 0.0) {
            t->where[i] = 1;
            size += t->sizes[i];
            for (int k = 0; k < 3; k++)
                corner[k] += t->sizes[i] * t->units[3 * i + k];
        } else {
            t->where[i] = -1;
        }
    }
    face_lay(&t->face, normal, t->units, t->sizes);
    return size;
}

/* a d - b c without cancellation (Kahan). */
static double difference(double a, double d, double b, double c) {
    double w = b * c;
    return fma(a, d, -w) - fma(b, c, -w);
}

/* The unit normal across two directions, on the side of a hint. Of nearly parallel ones too it is
 * good to the last digits. */
static void normal_across(const double *a, const double *b, const double *hint, double *normal) {
    double size;
    normal[0] = difference(a[1], b[2], a[2], b[1]);
    normal[1] = difference(a[2], b[0], a[0], b[2]);
    normal[2] = difference(a[0], b[1], a[1], b[0]);
    size = length(normal);
    if (dot(normal, hint) < 0.0)
        size = -size;
    for (int k = 0; k < 3; k++)
        normal[k] /= size;
}

/* Turn a vector away from a direction until they are at right angles, and make it a unit. */
static void square_off(double *vector, const double *direction) {
    for (int twice = 0; twice < 2; twice++) {
        double off = direction ? dot(vector, direction) : 0.0, size;
        for (int k = 0; k < 3 && direction; k++)
            vector[k] -= off * direction[k];
        size = length(vector);
        for (int k = 0; k < 3; k++)
            vector[k] /= size;
    }
}

/* -- the search -------------------------------------------------------------------------------- */

/* In the plane of the normal and a tangent: the target, and the corner in front. */
typedef struct {
    double target[2], corner[2];
} Flat;

/* Tell whether the best normal is met no later than at this angle; the corner is that after it. */
static int is_past(const Goal *goal, const Flat *at, double cot) {
    const double *w = at->target, *v = at->corner;
    if (goal->is_ray)
        return v[1] * w[0] - v[0] * w[1] >= 0.0;
    const double x = w[0] - v[0], y = w[1] - v[1];
    return cot * y <= x || cot * x + y <= 0.0; /* the distance falls, or is below 0 */
}

static void take(Flat *at, const Meeting *meeting, double sign) {
    at->corner[0] += sign * meeting->dn;
    at->corner[1] += sign * meeting->dm;
}

static void swap(Meeting *a, Meeting *b) {
    Meeting kept = *a;
    *a = *b;
    *b = kept;
}

static double middle_of(double a, double b, double c) {
    return larger(smaller(a, b), smaller(larger(a, b), c));
}

/* Find the meeting at which the best normal is, or before it; `at` has then the corner before it.
 * NULL if it is after all of them. Sorts no more than it needs to. */
static const Meeting *best_meeting(const Goal *goal, Flat *at, Meeting *low, Meeting *high,
                                   const Meeting **last) {
    const Meeting *found = NULL;
    *last = NULL;
    while (low < high) {
        double cot = middle_of(low->cot, low[(high - low) / 2].cot, high[-1].cot);
        Meeting *before = low, *after = high;
        Flat then = *at;
        for (Meeting *m = low; m < after;) {
            if (m->cot > cot) {
                take(&then, m, 1.0);
                swap(m++, before++);
            } else if (m->cot < cot) {
                swap(m, --after);
            } else {
                m++;
            }
        }
        Flat beyond = then;
        for (const Meeting *m = before; m < after; m++)
            take(&beyond, m, 1.0);
        if (is_past(goal, &beyond, cot)) {
            found = before;
            high = before;
        } else {
            *last = after - 1;
            *at = beyond;
            low = after;
        }
    }
    return found;
}

/* List where the plane meets generators as the normal turns to a tangent, and further. */
static ptrdiff_t list_meetings(Turning *t, const Goal *goal, const double *tangent, Flat *at) {
    const double *w = at->target;
    ptrdiff_t count = 0;
    for (ptrdiff_t i = 0; i < t->n; i++) {
        double size = t->sizes[i], s = t->s[i], g = dot(tangent, t->units + 3 * i);
        if (t->where[i] == 0) {
            if (g > FLAT)
                at->corner[1] += g * size;
            continue;
        }
        if (t->where[i] > 0) {
            at->corner[0] += s * size;
            at->corner[1] += g * size;
        }
        double cot = -g / s;
        if (!goal->is_ray || cot * w[0] + w[1] > ROUNDED * sqrt(cot * cot + 1.0))
            t->meetings[count++] =
                (Meeting){cot, -fabs(s) * size, -t->where[i] * g * size, i};
    }
    return count;
}

/* Turn a unit normal towards a tangent, about an axis at right angles to both or none, to the best
 * normal on the way. Returns the robot it ends across, -1 if it is none, -2 if it cannot turn. */
static ptrdiff_t turn(Turning *t, const Goal *goal, double *normal, const double *tangent,
                      const double *axis) {
    Flat at = {{dot(normal, goal->target), dot(tangent, goal->target)}, {0.0, 0.0}};
    ptrdiff_t count = list_meetings(t, goal, tangent, &at);
    const Meeting *last, *met;
    met = best_meeting(goal, &at, t->meetings, t->meetings + count, &last);
    double across[2], hint[3];
    if (goal->is_ray) {
        met = met ? met : last;
        if (!met)
            return -2;
    } else if (!met || is_past(goal, &at, met->cot)) {
        met = NULL; /* between two meetings, towards the target */
    }
    across[0] = met ? met->cot : at.target[0] - at.corner[0];
    across[1] = met ? 1.0 : at.target[1] - at.corner[1];
    for (int k = 0; k < 3; k++)
        hint[k] = across[0] * normal[k] + across[1] * tangent[k];
    if (met && axis) {
        normal_across(axis, t->units + 3 * met->robot, hint, normal);
    } else {
        memcpy(normal, hint, sizeof hint);
        square_off(normal, met ? t->units + 3 * met->robot : axis);
    }
    return met ? met->robot : -1;
}

/* Where the goal meets the plane that touches the wrench set across a normal, seen from the corner,
 * and what its rounding is relative to. */
static double seen(const Goal *goal, const double *normal, const double *corner, double *reach,
                   double *q) {
    const double *w = goal->target;
    if (goal->is_ray) {
        *reach = dot(normal, corner) / dot(normal, w);
        for (int k = 0; k < 3; k++)
            q[k] = *reach * w[k] - corner[k];
        return *reach;
    }
    *reach = dot(normal, w) - dot(normal, corner);
    for (int k = 0; k < 3; k++)
        q[k] = w[k] - corner[k] - *reach * normal[k];
    return length(w);
}

/* Turn a normal by its rounding, to be across two of those in the plane; a normal across a
 * difference of wrenches has more of it than the height of a flat set allows. Returns 0 if that
 * changes nothing. */
static int straighten(const Turning *t, double *normal) {
    const Face *face = &t->face;
    ptrdiff_t wide = 0;
    double across[3], turned = 0.0;
    for (ptrdiff_t i = 1; i < face->count; i++)
        if (fabs(face->c[2 * i + 1]) > fabs(face->c[2 * wide + 1]))
            wide = i;
    if (face->count < 2 || fabs(face->c[2 * wide + 1]) <= WIDE * face->size[wide])
        return 0;
    normal_across(t->units + 3 * face->robot[face->largest],
                  t->units + 3 * face->robot[wide], normal, across);
    for (int k = 0; k < 3; k++)
        turned = larger(turned, fabs(across[k] - normal[k]));
    if (turned <= 0.5 * ROUNDED)
        return 0;
    memcpy(normal, across, sizeof across);
    return 1;
}

Status find_face(Turning *t, Goal *goal, double *normal, double *q, double *extent, double *reach) {
    ptrdiff_t in = -1, also = -1;
    double rounding = OUTSIDE;
    int is_straight = 0;
    for (int k = 1; k <= TURNS && also != -2; k++) {
        double corner[3], point[3], hint[3], tangent[3];
        Face *face = &t->face;
        if (t->n >= LARGE && t->interrupted())
            return INTERRUPTED;
        *extent = divide(t, normal, goal->size, in, also, corner);
        *extent += seen(goal, normal, corner, reach, point);
        q[0] = dot(point, face->e);
        q[1] = dot(point, face->f);
        Side side = face_side(face, q, *extent);
        if (side.excess <= rounding || k == TURNS) {
            if (is_straight || k == TURNS || !straighten(t, normal))
                break;
            is_straight = 1;
            in = also = -1;
            continue;
        }
        if (k % PATIENCE == 0)
            rounding *= 2.0;
        in = side.axis >= 0 ? face->robot[side.axis] : -1;
        const double *axis = in >= 0 ? t->units + 3 * in : NULL;
        for (int c = 0; c < 3; c++)
            tangent[c] = hint[c] = side.m[0] * face->e[c] + side.m[1] * face->f[c];
        if (axis)
            normal_across(axis, normal, hint, tangent);
        else
            square_off(tangent, normal);
        also = turn(t, goal, normal, tangent, axis);
        if (goal->is_ray && also >= 0 && dot(normal, goal->target) <= goal->least) {
            /* what the ray has along the normal is rounding, and more than so flat a set allows */
            square_off(goal->target, normal);
            memcpy(normal, goal->target, sizeof goal->target);
            in = also = -1;
        }
    }
    return SOLVED;
}
