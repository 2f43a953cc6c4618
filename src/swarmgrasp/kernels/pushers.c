/* Force sets as those who push need them: their sides, rests, nearest forces and shares. */
#include "pushers.h"

#include <stdlib.h>
#include <string.h>

#define ON_WAY 1e-12 /* of its reach: distance of a side from the rest that is none */

/* -- one robot ------------------------------------------------------------------------------------ */

/* The first and the last force of an element, counter-clockwise. */
static void ends_of(const Element *e, double *first, double *last) {
    for (int c = 0; c < 2; c++) {
        first[c] = e->shape == POINT ? e->at[c] : e->radius * e->start[c];
        last[c] = e->shape == POINT ? e->at[c] : e->radius * e->end[c];
    }
}

void nearest_force(const Pusher *pusher, const double *wanted, double *force, double *turn) {
    int is_out = pusher->is_flat;
    double least = INFINITY;
    for (int k = 0; k < pusher->set.elements; k++) {
        const Element *e = pusher->set.element + k;
        const Border *s = pusher->border + k;
        double size = e->shape == POINT ? 0.0 : sqrt(along(wanted, wanted));
        if (size > e->radius && is_in_cone(e, wanted)) {
            double off = size - e->radius, x = wanted[0] / size, y = wanted[1] / size;
            double bend = e->radius / size;
            is_out = 1;
            if (off * off < least) {
                least = off * off;
                force[0] = e->radius * x;
                force[1] = e->radius * y;
                turn[0] = bend * y * y;
                turn[1] = -bend * x * y;
                turn[2] = bend * x * x;
            }
        }
        double from[2] = {wanted[0] - s->from[0], wanted[1] - s->from[1]};
        double on = along(from, s->way), at = smaller(larger(on, 0.0), s->length);
        double off[2] = {from[0] - at * s->way[0], from[1] - at * s->way[1]};
        is_out |= along(from, s->normal) > 0.0;
        if (along(off, off) < least) {
            int is_free = on > 0.0 && on < s->length;
            least = along(off, off);
            force[0] = s->from[0] + at * s->way[0];
            force[1] = s->from[1] + at * s->way[1];
            turn[0] = is_free * s->way[0] * s->way[0];
            turn[1] = is_free * s->way[0] * s->way[1];
            turn[2] = is_free * s->way[1] * s->way[1];
        }
    }
    if (!is_out) {
        force[0] = wanted[0];
        force[1] = wanted[1];
        turn[0] = turn[2] = 1.0;
        turn[1] = 0.0;
    }
}

double share_of(const Pusher *pusher, const double *force) {
    double off[2] = {force[0] - pusher->rest[0], force[1] - pusher->rest[1]}, most = 0.0;
    if (pusher->reach == 0.0 || along(off, off) == 0.0)
        return 0.0;
    for (int k = 0; k < pusher->set.elements; k++) {
        const Element *e = pusher->set.element + k;
        const Border *s = pusher->border + k;
        double away[2] = {s->from[0] - pusher->rest[0], s->from[1] - pusher->rest[1]};
        if (pusher->is_flat) {
            double whole = s->length + along(away, s->way);
            if (whole > ON_WAY * pusher->reach)
                most = larger(most, along(off, s->way) / whole);
            continue;
        }
        double whole = along(away, s->normal);
        if (whole > ON_WAY * pusher->reach)
            most = larger(most, along(off, s->normal) / whole);
        if (e->shape == POINT)
            continue;
        /* the way from the rest, (force - rest) / share, ends on the arc: |rest + way| = radius */
        double left = e->radius * e->radius - along(pusher->rest, pusher->rest);
        double half = along(pusher->rest, off);
        double share = (half + sqrt(half * half + left * along(off, off))) / left;
        double end[2] = {share * pusher->rest[0] + off[0], share * pusher->rest[1] + off[1]};
        if (is_in_cone(e, end))
            most = larger(most, share);
    }
    return most;
}

/* -- all of them ---------------------------------------------------------------------------------- */

double push_along(const Pushers *pushers, const double *normal, Column *best) {
    double height = 0.0, sum[3] = {0.0}; /* of forces, and of their moments */
    for (int i = 0; i < pushers->count; i++) {
        const Pusher *r = pushers->pusher + i;
        double *force = best->force + 2 * (ptrdiff_t)i, p[2];
        lever(pushers->scale, r->set.arm, normal, p);
        support(&r->set, p, force, NULL);
        force[0] -= r->rest[0];
        force[1] -= r->rest[1];
        double worth = along(force, p);
        if (!(worth > 0.0)) {
            force[0] = force[1] = 0.0;
            continue;
        }
        height += worth;
        sum[0] += force[0];
        sum[1] += force[1];
        sum[2] += across(r->set.arm, force);
    }
    for (int c = 0; c < 3; c++)
        best->wrench[c] = pushers->scale[c] * sum[c];
    return height;
}

/* The order of directions around the circle. */
static double turn_of(const double *row) {
    double turn = fmod(row[3], 2.0 * PI);
    return turn < 0.0 ? turn + 2.0 * PI : turn;
}

/* Put a robot's rows in order around its set, as elements in the unit of forces, with their sides. */
static void order(Pusher *pusher, const double *rows, int count, double unit, Element *element,
                  Border *border) {
    for (int k = 0; k < count; k++) {
        int at = k;
        const double *row = rows + ELEMENT * (ptrdiff_t)k;
        double scaled[ELEMENT] = {row[0] / unit, row[1] / unit, row[2] / unit, row[3], row[4]};
        double turn = turn_of(row);
        while (at > 0 && border[at - 1].length > turn) { /* where their turns are kept meanwhile */
            element[at] = element[at - 1];
            border[at] = border[at - 1];
            at--;
        }
        element[at] = element_of(scaled);
        border[at].length = turn;
    }
    for (int k = 0; k < count; k++) {
        const Element *e = element + k, *next = element + (k + 1) % count;
        double first[2], last[2], to[2], unused[2];
        ends_of(e, unused, last);
        ends_of(next, to, unused);
        for (int c = 0; c < 2; c++) {
            first[c] = to[c] - last[c];
            border[k].from[c] = last[c];
            border[k].normal[c] = e->end[c];
        }
        double length = sqrt(along(first, first));
        border[k].length = e->shape == ROUND ? 0.0 : length;
        for (int c = 0; c < 2; c++)
            border[k].way[c] = border[k].length > 0.0 ? first[c] / length : 0.0;
    }
    pusher->set.element = element;
    pusher->set.elements = count;
    pusher->border = border;
    pusher->is_flat = count <= 2 && element[0].shape == POINT && element[count - 1].shape == POINT;
}

/* Find a robot's rest and reach. */
static void settle(Pusher *pusher) {
    const double nothing[2] = {0.0, 0.0};
    double turn[3], most = 0.0, far = 0.0;
    nearest_force(pusher, nothing, pusher->rest, turn);
    for (int pass = 0; pass < 2; pass++) {
        for (int k = 0; k < pusher->set.elements; k++) {
            const Element *e = pusher->set.element + k;
            double at[3][2];
            ends_of(e, at[0], at[1]);
            for (int c = 0; c < 2; c++)
                at[2][c] = e->shape == POINT ? e->at[c] : e->radius * e->middle[c];
            for (int j = 0; j < 3; j++) {
                double off[2] = {at[j][0] - pusher->rest[0], at[j][1] - pusher->rest[1]};
                most = larger(most, sqrt(along(off, off)));
                far = larger(far, sqrt(along(at[j], at[j])));
            }
        }
        if (pass == 0 && sqrt(along(pusher->rest, pusher->rest)) <= ON_WAY * far)
            pusher->rest[0] = pusher->rest[1] = most = 0.0;
        else
            break;
    }
    pusher->reach = most > ON_WAY * far ? most : 0.0;
}

/* The part of a unit vector across those before; returns its length. */
static double across_all(double *v, double before[][3], int count) {
    for (int twice = 0; twice < 2; twice++)
        for (int k = 0; k < count; k++) {
            double part = dot(v, before[k]);
            for (int c = 0; c < 3; c++)
                v[c] -= part * before[k][c];
        }
    return length(v);
}

/* Find the directions across all wrenches beyond the rests. */
static void find_flats(Pushers *pushers) {
    double axis[3][3];
    int axes = 0;
    for (; axes < 3; axes++) {
        double most = axes ? FLAT : 0.0;
        for (int i = 0; i < pushers->count; i++) {
            const Pusher *r = pushers->pusher + i;
            for (int k = 0; k < 2 && r->reach > 0.0; k++) {
                const double way[2] = {k == 0, k == 1};
                double v[3];
                wrench_of(pushers->scale, r->set.arm, r->is_flat ? r->border[0].way : way, v);
                double size = length(v);
                for (int c = 0; c < 3 && size > 0.0; c++)
                    v[c] /= size;
                double left = size > 0.0 ? across_all(v, axis, axes) : 0.0;
                if (left > most) {
                    most = axes ? left : INFINITY; /* of the first, any will do */
                    for (int c = 0; c < 3; c++)
                        axis[axes][c] = v[c] / left;
                }
            }
        }
        if (most <= FLAT)
            break;
    }
    pushers->flats = 3 - axes;
    for (int k = axes; k < 3; k++) {
        double most = 0.0;
        for (int c = 0; c < 3; c++) {
            double v[3] = {c == 0, c == 1, c == 2};
            double left = across_all(v, axis, k);
            if (left > most) {
                most = left;
                for (int j = 0; j < 3; j++)
                    axis[k][j] = v[j] / left;
            }
        }
        memcpy(pushers->flat[k - axes], axis[k], sizeof axis[k]);
    }
}

/* The power of 2 next to a size. */
static double unit_of(double size) { return size > 0.0 ? ldexp(1.0, ilogb(size)) : 1.0; }

Status pushers_begin(Pushers *pushers, const double *scale, int count, const double *arm,
                     const double *rows, const double *elements) {
    *pushers = (Pushers){.count = count, .scale = {scale[0], scale[1], scale[2]}};
    size_t many = 0, n = (size_t)count;
    double most = 0.0;
    for (size_t i = 0; i < n; i++)
        many += (size_t)elements[i];
    for (size_t k = 0; k < many; k++)
        most = larger(most, larger(rows[ELEMENT * k], larger(fabs(rows[ELEMENT * k + 1]),
                                                             fabs(rows[ELEMENT * k + 2]))));
    pushers->force = unit_of(most);
    if (count == 0) {
        pushers->wrench = 1.0;
        find_flats(pushers);
        return SOLVED;
    }
    pushers->pusher = malloc(n * sizeof *pushers->pusher);
    pushers->element = malloc(many * sizeof *pushers->element);
    pushers->border = malloc(many * sizeof *pushers->border);
    pushers->room = malloc(2 * PLACES * n * sizeof *pushers->room);
    if (!pushers->pusher || !pushers->element || !pushers->border || !pushers->room)
        return NO_MEMORY;
    size_t at = 0;
    most = 0.0;
    for (size_t i = 0; i < n; i++) {
        Pusher *r = pushers->pusher + i;
        *r = (Pusher){.set = {.arm = {arm[2 * i], arm[2 * i + 1]}}};
        order(r, rows + ELEMENT * at, (int)elements[i], pushers->force, pushers->element + at,
              pushers->border + at);
        at += (size_t)elements[i];
        settle(r);
        const double *a = r->set.arm;
        r->size = r->reach * sqrt(scale[0] * scale[0] + scale[1] * scale[1]
                                  + scale[2] * scale[2] * along(a, a));
        most = larger(most, r->size);
    }
    double unit = unit_of(most);
    for (int c = 0; c < 3; c++)
        pushers->scale[c] /= unit;
    pushers->wrench = pushers->force * unit;
    for (size_t i = 0; i < n; i++) {
        Pusher *r = pushers->pusher + i;
        double wrench[3];
        r->size /= unit;
        pushers->total += r->size;
        wrench_of(pushers->scale, r->set.arm, r->rest, wrench);
        add(pushers->rest, wrench);
    }
    find_flats(pushers);
    return SOLVED;
}

void pushers_end(Pushers *pushers) {
    free(pushers->pusher);
    free(pushers->element);
    free(pushers->border);
    free(pushers->room);
    *pushers = (Pushers){0};
}
