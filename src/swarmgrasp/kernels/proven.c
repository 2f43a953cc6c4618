/* A quick check of shares and of their proof (T18): what the robots make, what the first normal says
 * of the largest share or of the nearest wrench, and each robot's share. It trusts the sizes of the
 * arrays and the generators, and nothing that was found. Time grows with the robots. */
#include "proven.h"
#include "vectors.h"

#define RELATIVE 5e-10 /* difference that counts as rounding */
#define BLURRED 5e-15  /* relative error of a product of a price and a generator */

/* The proof and what is made, in the robots' unit. */
typedef struct {
    const Turning *turning;
    const double *shares;
    const Shares *found;
    double top;                       /* the largest share */
    double wanted[3], made[3], miss[3];
    double slack;                     /* difference of wrenches that counts as rounding */
} Audit;

/* The height along a normal; of the robots in a plane across another one only, if there is one. */
static double height(const Audit *a, const double *normal, const double *across) {
    double sum = 0.0;
    for (ptrdiff_t i = 0; i < a->turning->n; i++) {
        const double *unit = a->turning->units + 3 * i;
        if (!across || fabs(dot(across, unit)) <= FLAT)
            sum += a->turning->sizes[i] * larger(0.0, dot(normal, unit));
    }
    return sum;
}

/* Tell whether no smaller largest share makes the wrench: n . w <= t h(n) for all that do. */
static int is_needed(const Audit *a) {
    const double *normal = a->found->normals[0];
    return a->top * height(a, normal, NULL) <= dot(normal, a->wanted) + a->slack;
}

/* Tell whether no wrench is nearer: all are behind the plane through the one made. Where nobody has
 * to give all, those in the plane make it with no smaller largest share. */
static int is_nearest(const Audit *a) {
    const double *normal = a->found->normals[0], *next = a->found->normals[1];
    double slack = a->slack + RELATIVE * a->turning->total, along = dot(normal, a->miss), off[3];
    for (int k = 0; k < 3; k++)
        off[k] = a->miss[k] - along * normal[k];
    if (!(height(a, normal, NULL) - dot(normal, a->made) <= slack && length(off) <= slack))
        return 0;
    for (ptrdiff_t i = 0; i < a->turning->n; i++)
        if (dot(normal, a->turning->units + 3 * i) > FLAT)
            return 1;
    return length(next) == 0.0
           || a->top * height(a, next, normal) <= dot(next, a->made) + a->slack;
}

/* Tell whether a robot gives what the first normal that its generator is not across says, or what
 * the price says of one that is across all. */
static int is_shared(const Audit *a, ptrdiff_t i) {
    const double *unit = a->turning->units + 3 * i, *price = a->found->price;
    double size = a->turning->sizes[i], share = a->shares[i];
    for (int k = 0; k < 3; k++) {
        const double *normal = a->found->normals[k];
        double along = dot(normal, unit);
        if (along != 0.0 && fabs(share - (along > 0.0 ? a->top : 0.0)) <= RELATIVE)
            return 1;
        if (fabs(along) > FLAT)
            return 0;
    }
    size = ldexp(size, a->turning->exponent);
    double fair = smaller(larger(size * dot(price, unit), 0.0), a->top);
    double most = RELATIVE + BLURRED * size * length(price)
                  + NOTHING * a->turning->total / a->turning->sizes[i]; /* so little may be any */
    return size == 0.0 || fabs(share - fair) <= most;
}

int shares_are_proven(const Turning *turning, const double *wanted, const double *load,
                     const double *shares, const Shares *found) {
    Audit a = {.turning = turning, .shares = shares, .found = found};
    double given = 0.0, distance;
    for (ptrdiff_t i = 0; i < turning->n; i++) {
        if (!(shares[i] >= 0.0 && shares[i] <= 1.0))
            return 0;
        a.top = larger(a.top, shares[i]);
        given += shares[i] * turning->sizes[i];
        for (int k = 0; k < 3; k++)
            a.made[k] += shares[i] * turning->sizes[i] * turning->units[3 * i + k];
    }
    for (int k = 0; k < 3; k++) {
        a.wanted[k] = ldexp(wanted[k] - load[k], -turning->exponent);
        a.miss[k] = a.wanted[k] - a.made[k];
    }
    a.slack = RELATIVE * (given + length(a.wanted)) + NOTHING * turning->total;
    distance = length(a.miss);
    if (!isfinite(a.slack)) /* a wrench so large that its square is none */
        return 1;
    if (!(fabs(distance - ldexp(found->shortfall, -turning->exponent)) <= a.slack))
        return 0;
    if (length(found->normals[0]) == 0.0)
        return a.top == 0.0;
    if (!(found->shortfall == 0.0 ? is_needed(&a) : is_nearest(&a)))
        return 0;
    for (ptrdiff_t i = 0; i < turning->n; i++)
        if (!is_shared(&a, i))
            return 0;
    return 1;
}
