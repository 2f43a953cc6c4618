/* One triangle of directions: H is at least the greatest of some linear functions and a quadratic one,
 * the task at most a quadratic one, all on the plane that touches the sphere in the middle (T21).
 *
 * A robot whose best force turns smoothly on all of the triangle has a curvature there; of any other
 * any force will do, and those taken where the bound is lowest close it. So a vertex, where three such
 * cuts meet H, ends at once, and so does a smooth minimum. Trusted is what `sets_search.c` fills in.
 * Tried: 7 cuts, of which the lowest gives way, take a quarter more time than 5; 3 twice the triangles.
 * Fewer cuts on wide triangles than on others take longer, of 5 000 robots too. */
#include <string.h>

#include "cell.h"

#define CLOSED 0.15    /* of what lacks: a cut that closes less is the last */
#define WIDE_CELL 0.02 /* squared reach of a triangle that is split at once if it looks easy, */
#define EASY 2.0       /* because its middle exceeds so many times what is wanted */
#define NEARLY 0.1     /* of the squared reach: what lacks at most for a closer look to help */
#define ASKED 4e-15    /* share of a task's size at and below which it asks for nothing */
#define UNKNOWN 1e100  /* a value, as long as there is none */

/* A triangle seen from its middle: n = m + d_0 e_0 + d_1 e_1. */
typedef struct {
    double m[3], e[2][3];
    double scaled[3][3]; /* times the scale: p of m and of both e is (s_0 - s_2 c_1, s_1 + s_2 c_0) at an arm c */
    double corner[3][2]; /* d of the corners, */
    double depth[3];     /* and n . m of the unit vectors */
    double reach;        /* the largest d . d */
} Frame;

/* What is taken together at a middle. */
typedef struct {
    double smooth[3], jagged[3]; /* wrenches of those that turn, and the others' */
    Cut loose;                   /* of robots whose pose is uncertain */
    double height;               /* H */
    double curve[3];             /* the curvature of those that turn */
    int kinky, turning;
} Taken;

double wanted(const Hunt *h) {
    double best = smaller(h->best, UNKNOWN);
    return smaller(best * (1.0 - h->gap), best - h->floor);
}

void offer(Hunt *h, const double *normal, double height, double extent) {
    double size = length(normal), value;
    if (extent <= ASKED * size) {
        if (height >= -h->zero * size) /* a load that is not held counts as the worst there is */
            return;
        extent = ASKED * size;
    }
    value = height <= larger(h->rounding * size, h->zero * extent) ? 0.0
                                                                   : (height + h->rounding * size) / extent;
    if (value < h->best) {
        h->best = value;
        memcpy(h->normal, normal, sizeof h->normal);
    }
}

static void frame_of(const Hunt *h, const Triangle *triangle, Frame *f) {
    double size, *m = f->m;
    for (int k = 0; k < 3; k++)
        m[k] = triangle->normal[k] + triangle->normal[3 + k] + triangle->normal[6 + k];
    size = length(m);
    for (int k = 0; k < 3; k++)
        m[k] /= size;
    double sign = m[2] < 0.0 ? -1.0 : 1.0, a = -1.0 / (sign + m[2]), b = m[0] * m[1] * a;
    const double e[2][3] = {{1.0 + sign * m[0] * m[0] * a, sign * b, -sign * m[0]},
                            {b, sign + m[1] * m[1] * a, -m[1]}};
    memcpy(f->e, e, sizeof e);
    for (int k = 0; k < 3; k++) {
        const double *n = k ? e[k - 1] : m;
        for (int i = 0; i < 3; i++)
            f->scaled[k][i] = h->sets->scale[i] * n[i];
    }
    f->reach = 0.0;
    for (int j = 0; j < 3; j++) {
        const double *v = triangle->normal + 3 * j;
        f->depth[j] = dot(v, m);
        for (int k = 0; k < 2; k++)
            f->corner[j][k] = dot(v, e[k]) / f->depth[j];
        f->reach = larger(f->reach, along(f->corner[j], f->corner[j]));
    }
}

/* p of m, or of an e, at an arm. */
static inline void lever_of(const double *scaled, const double *arm, double *p) {
    p[0] = scaled[0] - scaled[2] * arm[1];
    p[1] = scaled[1] + scaled[2] * arm[0];
}

/* Add a force at an arm to (x, y, torque). */
static inline void add_force(double *sum, const double *arm, const double *force) {
    sum[0] += force[0];
    sum[1] += force[1];
    sum[2] += across(arm, force);
}

/* The wrench, in the metric's coordinates, of such a sum and a fixed part. */
static void wrench_with(const Hunt *h, const double *fixed, const double *sum, double *wrench) {
    for (int k = 0; k < 3; k++)
        wrench[k] = fixed[k] + h->sets->scale[k] * sum[k];
}

static void normal_at(const Frame *f, const double *d, double *n) {
    for (int k = 0; k < 3; k++)
        n[k] = f->m[k] + d[0] * f->e[0][k] + d[1] * f->e[1][k];
}

/* -- robots ------------------------------------------------------------------------------------- */

void hold_at(const Hunt *h, int robot, const double *middle, const double *corner, double *row) {
    const ForceSet *set = set_of(h, robot);
    const double *scale = h->sets->scale;
    double wrench[3], force[2], arm[2], p[2];
    row[0] = row[1] = row[2] = set->adrift ? INFINITY : 0.0;
    if (set->turning) { /* the least over its poses is concave: as long as it is positive, it holds */
        double sum = 0.0;
        for (int j = 0; j < 3; j++) {
            row[j] = INFINITY;
            for (int r = 0; r < set->turning; r++) {
                double v[3];
                for (int k = 0; k < 3; k++)
                    v[k] = -corner[3 * j + k] * scale[k] * set->limit;
                row[j] = smaller(row[j], -best_on_piece(set->piece + (ptrdiff_t)PIECE * r, v, wrench));
            }
            sum += row[j];
        }
        if (sum <= 0.0)
            row[0] = row[1] = row[2] = 0.0;
        return;
    }
    for (int r = 0; r < set->adrift; r++) {
        const double *part = set->part + (ptrdiff_t)(PART - 1) * r;
        worst_on_part(scale, set, part, middle, arm, force);
        for (int j = 0; j < 3; j++)
            for (int end = 0; end < 4; end += 2) {
                lever(scale, part + end, corner + 3 * j, p);
                row[j] = smaller(row[j], along(p, force));
            }
    }
    if (set->adrift)
        return;
    exert(scale, set, middle, wrench, NULL, NULL);
    for (int j = 0; j < 3; j++)
        row[j] = dot(wrench, corner + 3 * j);
}

/* Add a linear function that a robot's forces at a normal hold. */
static void add_loose(const Hunt *h, const Triangle *triangle, const Frame *f, int robot,
                      const double *normal, Cut *loose) {
    double row[3], side[2][2], rise[2];
    hold_at(h, robot, normal, triangle->normal, row);
    for (int j = 0; j < 3; j++)
        row[j] /= f->depth[j];
    for (int j = 0; j < 2; j++) {
        rise[j] = row[j + 1] - row[0];
        for (int k = 0; k < 2; k++)
            side[j][k] = f->corner[j + 1][k] - f->corner[0][k];
    }
    double det = across(side[0], side[1]);
    double slope[2] = {(rise[0] * side[1][1] - rise[1] * side[0][1]) / det,
                       (rise[1] * side[0][0] - rise[0] * side[1][0]) / det};
    loose->a += row[0] - along(slope, f->corner[0]);
    loose->b[0] += slope[0];
    loose->b[1] += slope[1];
}

/* Find what a robot exerts at the middle of a triangle, of the element that does at all corners if there
 * is one: a cone of a half turn at most that holds these holds the middle. */
static double push_at(const Active *robot, const Frame *f, Push *push) {
    const ForceSet *set = push->set;
    const Element *e = set->element + robot->which[0];
    double p[2];
    lever_of(f->scaled[0], set->arm, p);
    push->which = robot->which[0];
    if (push->which != robot->which[1] || push->which != robot->which[2] || e->shape == WIDE) {
        double value = support(set, p, push->force, &push->which);
        e = set->element + push->which;
        if (e->shape == POINT)
            return value;
    } else if (e->shape == POINT) {
        memcpy(push->force, e->at, sizeof push->force);
        return along(e->at, p);
    }
    push->size = sqrt(along(p, p));
    double inverse = push->size > 0.0 ? 1.0 / push->size : 0.0;
    for (int k = 0; k < 2; k++) {
        push->way[k] = push->size > 0.0 ? p[k] * inverse : e->middle[k];
        push->force[k] = e->radius * push->way[k];
    }
    return e->radius * push->size;
}

/* Take all robots' forces at the middle. */
static void take_all(Hunt *h, const Triangle *triangle, const Frame *f, size_t begin, size_t end,
                     Taken *taken) {
    double sum[3] = {0.0};
    memset(taken, 0, sizeof *taken);
    taken->height = dot(triangle->fixed, f->m);
    for (size_t a = begin; a < end; a++) {
        const Active *robot = h->active + a;
        Push *push = h->push + (a - begin);
        if (h->is_lost && h->is_lost[machine_of(h, robot->robot)])
            continue;
        push->set = set_of(h, robot->robot);
        push->which = -1;
        if (robot->which[0] < 0) {
            taken->height += exert(h->sets->scale, push->set, f->m, NULL, NULL, NULL);
            add_loose(h, triangle, f, robot->robot, f->m, &taken->loose);
            continue;
        }
        taken->height += push_at(robot, f, push);
        add_force(sum, push->set->arm, push->force);
    }
    wrench_with(h, triangle->fixed, sum, taken->smooth);
}

/* Tell whether a robot's best force turns smoothly on a triangle, an arc being the farthest on all of it;
 * if so, write how, and the largest |p| there, squared. */
static int is_turning(const Active *robot, const Frame *f, const Push *push, Bend *bend, double *most) {
    const double *arm = push->set->arm;
    const Element *e = push->set->element + push->which;
    double step[2][2];
    if (push->which != robot->which[0] || push->which != robot->which[1]
        || push->which != robot->which[2] || e->shape == POINT)
        return 0;
    bend->radius = e->radius;
    bend->size = push->size;
    for (int k = 0; k < 2; k++) {
        lever_of(f->scaled[k + 1], arm, step[k]);
        bend->ahead[k] = along(push->way, step[k]);
        bend->side[k] = across(push->way, step[k]);
    }
    *most = 0.0;
    int left = 0, right = 0;
    for (int j = 0; j < 3; j++) {
        const double *d = f->corner[j];
        double ahead = push->size + along(bend->ahead, d), side = along(bend->side, d);
        if (ahead <= 0.0)
            return 0;
        *most = larger(*most, ahead * ahead + side * side);
        if (e->shape == WIDE) {
            double aside = across(e->middle, push->way) * ahead + along(e->middle, push->way) * side;
            left |= aside > 0.0;
            right |= aside < 0.0;
        }
    }
    /* nor does the triangle reach over the gap of an arc */
    return !(e->shape == WIDE && along(e->middle, push->way) < 0.0 && left && right);
}

/* Of the robots taken part those that turn smoothly from those that may jump. */
static void part_all(Hunt *h, const Triangle *triangle, const Frame *f, size_t begin, size_t end,
                     Taken *taken) {
    double smooth[3] = {0.0}, jagged[3] = {0.0}, most;
    for (size_t a = begin; a < end; a++) {
        const Active *robot = h->active + a;
        const Push *push = h->push + (a - begin);
        Bend *bend = h->bend + taken->turning;
        if (h->is_lost && h->is_lost[machine_of(h, robot->robot)])
            continue;
        if (push->which < 0 || !is_turning(robot, f, push, bend, &most)) {
            h->kinky[taken->kinky++] = (int)(a - begin);
            if (push->which >= 0)
                add_force(jagged, push->set->arm, push->force);
            continue;
        }
        taken->turning++;
        add_force(smooth, push->set->arm, push->force);
        double share = bend->radius / sqrt(most);
        taken->curve[0] += share * bend->side[0] * bend->side[0];
        taken->curve[1] += share * bend->side[0] * bend->side[1];
        taken->curve[2] += share * bend->side[1] * bend->side[1];
    }
    wrench_with(h, triangle->fixed, smooth, taken->smooth);
    wrench_with(h, (const double[3]){0.0}, jagged, taken->jagged);
}

/* Take the forces of the robots that jump at another place on the plane; returns H there. */
static double take_again(Hunt *h, const Triangle *triangle, const Frame *f, size_t begin,
                         const double *d, const double *normal, Taken *taken) {
    double height = dot(triangle->fixed, normal), scaled[3], sum[3] = {0.0};
    memset(&taken->loose, 0, sizeof taken->loose);
    for (int i = 0; i < taken->turning; i++) {
        const Bend *bend = h->bend + i;
        double ahead = bend->size + along(bend->ahead, d), side = along(bend->side, d);
        height += bend->radius * sqrt(ahead * ahead + side * side);
    }
    for (int k = 0; k < 3; k++)
        scaled[k] = h->sets->scale[k] * normal[k];
    for (int i = 0; i < taken->kinky; i++) {
        const ForceSet *set = h->push[h->kinky[i]].set;
        double p[2], force[2];
        if (h->push[h->kinky[i]].which < 0) {
            int robot = h->active[begin + (size_t)h->kinky[i]].robot;
            height += exert(h->sets->scale, set, normal, NULL, NULL, NULL);
            add_loose(h, triangle, f, robot, normal, &taken->loose);
            continue;
        }
        lever_of(scaled, set->arm, p);
        height += support(set, p, force, NULL);
        add_force(sum, set->arm, force);
    }
    wrench_with(h, (const double[3]){0.0}, sum, taken->jagged);
    return height;
}

/* -- the task ----------------------------------------------------------------------------------- */

/* Add x x' of a wrench seen on the plane to a quadratic function, as value, slope and bend. */
static void add_square(const Frame *f, const double *x, Cut *square, double *bend) {
    double a = dot(x, f->m), b[2] = {dot(x, f->e[0]), dot(x, f->e[1])};
    square->a += a * a;
    square->b[0] += 2.0 * a * b[0];
    square->b[1] += 2.0 * a * b[1];
    bend[0] += 2.0 * b[0] * b[0];
    bend[1] += 2.0 * b[0] * b[1];
    bend[2] += 2.0 * b[1] * b[1];
}

/* Find a quadratic function that D does not exceed on a triangle: of a ball or an ellipsoid by a tangent
 * to the root, of a polytope the plane through its corners, D being convex. */
static void asked_of(const Hunt *h, const Triangle *triangle, const Frame *f, Cut *asked, double *bend) {
    const Sets *sets = h->sets;
    memset(asked, 0, sizeof *asked);
    memset(bend, 0, 3 * sizeof *bend);
    if (!sets->is_polytope || sets->tasks == 0) {
        static const double axes[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
        double mean, root;
        for (int k = 0; k < (sets->tasks ? sets->tasks : 3); k++)
            add_square(f, sets->tasks ? sets->task + (ptrdiff_t)3 * k : axes[k], asked, bend);
        mean = 0.25 * asked->a;
        for (int j = 0; j < 3; j++)
            mean += 0.25 * (cut_at(asked, f->corner[j]) + bend_at(bend, f->corner[j]));
        if (mean > 0.0) {
            root = sqrt(mean);
            asked->a = root + (asked->a - mean) / (2.0 * root);
            for (int k = 0; k < 2; k++)
                asked->b[k] /= 2.0 * root;
            for (int k = 0; k < 3; k++)
                bend[k] /= 2.0 * root;
            return;
        }
        memset(asked, 0, sizeof *asked);
        memset(bend, 0, 3 * sizeof *bend);
    }
    double row[3], side[2][2], rise[2];
    for (int j = 0; j < 3; j++)
        row[j] = triangle->extent[j] / f->depth[j];
    for (int j = 0; j < 2; j++) {
        rise[j] = row[j + 1] - row[0];
        for (int k = 0; k < 2; k++)
            side[j][k] = f->corner[j + 1][k] - f->corner[0][k];
    }
    double det = across(side[0], side[1]);
    asked->b[0] = (rise[0] * side[1][1] - rise[1] * side[0][1]) / det;
    asked->b[1] = (rise[1] * side[0][0] - rise[0] * side[1][0]) / det;
    asked->a = row[0] - along(asked->b, f->corner[0]);
}

/* -- the proof ---------------------------------------------------------------------------------- */

/* The linear function of forces taken, beyond what is wanted. */
static void cut_of(const Hunt *h, const Frame *f, const Taken *taken, double target, const Cut *asked,
                   Cut *cut) {
    double all[3];
    for (int k = 0; k < 3; k++)
        all[k] = taken->smooth[k] + taken->jagged[k];
    cut->a = dot(all, f->m) + taken->loose.a + h->rounding - target * asked->a;
    for (int k = 0; k < 2; k++)
        cut->b[k] = dot(all, f->e[k]) + taken->loose.b[k] - target * asked->b[k];
}

/* Look closer at those that turn, up to third order: r |p| is at least
 *     P + alpha + beta^2 (1/P - B^2 / (4 p^3)) / 2 - alpha beta^2 / (2 P^2),   alpha = ahead . d, beta =
 * side . d, B the largest |beta|, p the least P + alpha; the last is linear in d times a quadratic,
 * so that on the triangle it is a mixture of what it is with d at the corners. */
static int is_held_closely(const Hunt *h, const Frame *f, const Taken *taken, const Roof *roof,
                           const double *less) {
    double curve[3][3], where[2], least = roof_least(roof, where);
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++)
            curve[j][k] = -less[k];
    for (int i = 0; i < taken->turning; i++) {
        const Bend *bend = h->bend + i;
        double ahead[3], widest = 0.0, nearest = INFINITY, P = bend->size;
        for (int j = 0; j < 3; j++) {
            ahead[j] = along(bend->ahead, f->corner[j]);
            widest = larger(widest, fabs(along(bend->side, f->corner[j])));
            nearest = smaller(nearest, P + ahead[j]);
        }
        if (nearest <= 0.0)
            return 0;
        double even = 1.0 / P - widest * widest / (4.0 * nearest * nearest * nearest);
        for (int j = 0; j < 3; j++) {
            double share = bend->radius * (even - ahead[j] / (P * P));
            curve[j][0] += share * bend->side[0] * bend->side[0];
            curve[j][1] += share * bend->side[0] * bend->side[1];
            curve[j][2] += share * bend->side[1] * bend->side[1];
        }
    }
    for (int j = 0; j < 3; j++)
        if (least + bend_at(curve[j], where) < bend_at(roof->bend, where))
            return 0; /* mostly */
    for (int j = 0; j < 3; j++)
        if (roof_least_with(roof, curve[j]) < 0.0)
            return 0;
    return 1;
}

/* Tell whether the plain bound, a linear function, is enough; writes it as a value. */
static int is_held_plainly_at(const Triangle *triangle, const Frame *f, double target, const Cut *asked,
                              const Cut *cut, double *reach) {
    *reach = target;
    for (int j = 0; j < 3; j++) {
        double extent = triangle->extent[j] / f->depth[j];
        double over = cut_at(cut, f->corner[j]) + target * (cut_at(asked, f->corner[j]) - extent);
        if (extent > 0.0)
            *reach = smaller(*reach, target + over / extent);
        else if (over < 0.0)
            *reach = 0.0;
    }
    return *reach >= target;
}

int is_held(Hunt *h, Triangle *triangle, size_t begin, size_t end) {
    Frame f;
    Taken taken;
    Roof roof;
    Cut asked, cut;
    double less[3], bend[3], where[2], target = wanted(h), reach;
    frame_of(h, triangle, &f);
    take_all(h, triangle, &f, begin, end, &taken);
    charge(h->work, EACH * (double)(end - begin));
    offer(h, f.m, taken.height, sets_extent(h->sets, f.m));
    asked_of(h, triangle, &f, &asked, less);
    cut_of(h, &f, &taken, target, &asked, &cut);
    int is_plain = is_held_plainly_at(triangle, &f, target, &asked, &cut, &reach);
    triangle->bound = larger(triangle->bound, reach);
    if (is_plain)
        return 1;
    if (f.reach > WIDE_CELL && taken.height > EASY * target * sets_extent(h->sets, f.m))
        return 0;
    part_all(h, triangle, &f, begin, end, &taken);
    for (int k = 0; k < 3; k++) {
        less[k] *= target;
        bend[k] = taken.curve[k] - less[k];
    }
    roof_begin(&roof, f.corner, bend);
    roof_add(&roof, &cut);
    double least = roof_least(&roof, where);
    for (int t = 1; t < CUTS && least < 0.0; t++) {
        double normal[3], at[2] = {where[0], where[1]}, before = least;
        normal_at(&f, at, normal);
        double height = take_again(h, triangle, &f, begin, at, normal, &taken);
        charge(h->work, 1.0 * taken.turning + EACH * taken.kinky);
        offer(h, normal, height, sets_extent(h->sets, normal));
        cut_of(h, &f, &taken, target, &asked, &cut);
        if (cut_at(&cut, at) + bend_at(bend, at) - before < -CLOSED * before)
            break;
        roof_add(&roof, &cut);
        least = roof_least(&roof, where);
    }
    if (least >= 0.0)
        return 1;
    return least > -NEARLY * target * f.reach && f.reach < WIDE_CELL && taken.turning
           && is_held_closely(h, &f, &taken, &roof, less);
}
