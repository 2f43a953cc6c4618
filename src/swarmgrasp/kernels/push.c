/* Forces for a wrench: the least share, then the least squares; or those for the nearest wrench
 * (T27). */
#include "pushers.h"

#include <string.h>

#define NOTHING 1e-14 /* of what a wrench is the difference of: rounding */
#define PROVEN 3e-7   /* gap of a least share that counts as none: 1e-10 but for the hardest */
#define FAR 1e8       /* of the total: size of a wrench of which only the direction matters */

/* Write the forces, from those beyond the rests, and their shares, at most 1. */
static void tell(const Pushers *p, const double *beyond, double part, double *forces, double *shares) {
    for (int i = 0; i < p->count; i++) {
        const Pusher *r = p->pusher + i;
        double force[2];
        for (int c = 0; c < 2; c++) {
            force[c] = r->rest[c] + (r->reach > 0.0 ? part * beyond[2 * i + c] : 0.0);
            forces[2 * i + c] = force[c] * p->force;
        }
        shares[i] = smaller(share_of(r, force), 1.0);
    }
}

/* What is asked: a wrench of a size along a unit vector, beyond the rests. */
typedef struct {
    double way[3], size;
    double inside[3], within; /* of the way, what lies along all that the robots do, and its length */
    double aside[3];          /* and what does not, which is missing for certain; or 0 */
} Wish;

/* Make a wrench, of a size along a unit vector that has a least factor, by even forces if they can be
 * found. Writes them instead of those in `made`, and the part of them that is to be told. */
static Status even_out(Pushers *p, const double *way, double size, double factor,
                       const double *normal, Work *work, Column *made, double *part, Push *found) {
    double share = smaller(factor * size, 1.0), most = smaller(share * (1.0 + SLACK), 1.0), asked[3];
    double *forces = p->room; /* what it held is mixed already */
    for (int c = 0; c < 3; c++)
        asked[c] = way[c] * (size / most);
    *part = factor * size > 1.0 ? 1.0 / factor : size;
    Status status = even_forces(p, asked, normal, work, forces, found->price, &found->is_even);
    if (status == SOLVED && found->is_even) {
        memcpy(made->force, forces, 2 * (size_t)p->count * sizeof *forces);
        *part = most;
        for (int c = 0; c < 3; c++)
            found->price[c] *= most / p->wrench;
    }
    return status;
}

static void note(double *out, const double *normal) {
    double size = length(normal);
    for (int c = 0; c < 3; c++)
        out[c] = normal[c] / size;
}

/* Read a wrench [N]; tells whether it is any. */
static int read_wish(const Pushers *p, const double *wanted, double around, Wish *wish) {
    double largest = 0.0, target[3];
    *wish = (Wish){.size = 0.0};
    for (int c = 0; c < 3; c++) {
        target[c] = wanted[c] / p->wrench - p->rest[c];
        largest = larger(largest, fabs(target[c]));
    }
    if (!(largest > NOTHING * (around / p->wrench + length(p->rest))))
        return 0;
    for (int c = 0; c < 3; c++)
        wish->way[c] = target[c] / largest;
    double size = length(wish->way);
    wish->size = largest * size;
    for (int c = 0; c < 3; c++)
        wish->inside[c] = wish->way[c] /= size;
    for (int k = 0; k < p->flats; k++)
        for (int c = 0; c < 3; c++) {
            double away = dot(wish->way, p->flat[k]) * p->flat[k][c];
            wish->inside[c] -= away;
            wish->aside[c] += away;
        }
    wish->within = length(wish->inside);
    if (!(length(wish->aside) > FLAT * larger(1.0, 1e-2 * p->total / wish->size)))
        memset(wish->aside, 0, sizeof wish->aside);
    if (wish->within > FLAT)
        for (int c = 0; c < 3; c++)
            wish->inside[c] /= wish->within;
    else
        wish->within = 0.0;
    return 1;
}

/* Make the nearest wrench there is; writes the part of the forces that is to be told. */
static Status approach(Pushers *p, const Wish *wish, Work *work, Column *made, double *part,
                       Push *found) {
    double far = smaller(wish->size, FAR * p->total), sought[3], normal[3], beyond = INFINITY;
    for (int c = 0; c < 3; c++)
        sought[c] = wish->way[c] * far;
    Status status = nearest_wrench(p, sought, work, made, normal, &beyond);
    if (status != SOLVED)
        return status;
    found->is_proven &= beyond <= CLOSE * (p->total + far);
    note(found->normals[0], normal);
    double size = length(made->wrench), missing[3];
    *part = 1.0;
    if (size > NOTHING * p->total) {
        double way[3];
        note(way, made->wrench);
        status = even_out(p, way, size, 1.0 / size, normal, work, made, part, found);
        if (!found->is_even)
            *part = 1.0; /* of the forces found, which make all of it */
    } else /* what cancels is of no use */
        memset(made->force, 0, 2 * (size_t)p->count * sizeof *made->force);
    memcpy(missing, wish->way, sizeof missing);
    for (int i = 0; i < p->count; i++) {
        double wrench[3];
        wrench_of(p->scale, p->pusher[i].set.arm, made->force + 2 * (ptrdiff_t)i, wrench);
        for (int c = 0; c < 3; c++)
            missing[c] -= wrench[c] * (*part / wish->size);
    }
    found->shortfall = length(missing) * wish->size * p->wrench;
    return status;
}

Status push(Pushers *p, const double *wanted, double around, Work *work, double *forces,
            double *shares, Push *found) {
    double normal[3], factor = 0.0, proven = 0.0, part = 0.0;
    Column made = {.force = forces};
    Wish wish;
    *found = (Push){.is_even = 1, .is_proven = 1};
    for (int i = 0; i < 2 * p->count; i++)
        forces[i] = 0.0;
    Status status = SOLVED;
    int is_any = read_wish(p, wanted, around, &wish);
    if (is_any && wish.within > 0.0)
        status = least_factor(p, wish.inside, work, &made, &factor, &proven, normal);
    if (status != SOLVED)
        return status;
    double size = wish.within * wish.size, share = factor * size, aside = length(wish.aside);
    found->needed = aside > 0.0 ? INFINITY : share <= 1.0 + CLOSE ? smaller(share, 1.0) : share;
    found->is_proven = !(factor < INFINITY) || factor - proven <= PROVEN * factor;
    if (!(share <= 1.0 + CLOSE))
        status = approach(p, &wish, work, &made, &part, found);
    else {
        found->shortfall = aside * wish.size * p->wrench;
        if (aside > 0.0)
            note(found->normals[0], wish.aside);
        if (share > 0.0) {
            note(found->normals[aside > 0.0], normal);
            status = even_out(p, wish.inside, size, factor, normal, work, &made, &part, found);
        }
    }
    tell(p, forces, part, forces, shares);
    return status;
}
