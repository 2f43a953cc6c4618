/* Push forces of force sets: nearest forces, shares, the least factor, and what is made. */
#include "../../src/swarmgrasp/kernels/pushers.h"
#include "check.h"

#include <stdlib.h>

#define MOST 40
#define HOST 20000

static const double metric[3] = {1.0, 1.0, 1.0};
static double arms[2 * HOST], rows[4 * ELEMENT * HOST], counts[HOST];

/* Write the elements of a sector about a direction, a half turn wide at most; returns how many. */
static int sector(double *row, double limit, double middle, double half) {
    const double set[4][ELEMENT] = {
        {limit, 0.0, 0.0, middle - half, middle + half},
        {0.0, limit * cos(middle + half), limit * sin(middle + half), middle + half,
         middle + half + 0.5 * PI},
        {0.0, 0.0, 0.0, middle + half + 0.5 * PI, middle - half + 1.5 * PI},
        {0.0, limit * cos(middle - half), limit * sin(middle - half), middle - half + 1.5 * PI,
         middle - half + 2.0 * PI},
    };
    memcpy(row, set, sizeof set);
    return 4;
}

/* An azimuth, a segment that is weaker astern, or a robot that always exerts between 1 and 2. */
static int disc(double *row, double limit) {
    const double set[ELEMENT] = {limit, 0.0, 0.0, 0.0, 2.0 * PI};
    memcpy(row, set, sizeof set);
    return 1;
}

static int line(double *row, double limit, double low, double way) {
    const double set[2][ELEMENT] = {
        {0.0, limit * cos(way), limit * sin(way), way - 0.5 * PI, way + 0.5 * PI},
        {0.0, low * cos(way), low * sin(way), way + 0.5 * PI, way + 1.5 * PI},
    };
    memcpy(row, set, sizeof set);
    return 2;
}

/* Fill n robots of all kinds; returns the rows. */
static int crowd(int n) {
    int many = 0;
    for (int i = 0; i < n; i++) {
        double *row = rows + ELEMENT * many, way = uniform(-3.0, 3.0), limit = uniform(1.0, 2.0);
        fill_uniform(arms + 2 * i, 2);
        int own = i % 4 == 0   ? disc(row, limit)
                  : i % 4 == 1 ? sector(row, limit, way, uniform(0.1, 1.5))
                  : i % 4 == 2 ? line(row, limit, -0.5, way)
                               : line(row, 2.0, i % 8 == 3 ? 1.0 : 0.0, way);
        counts[i] = own;
        many += own;
    }
    return many;
}

/* -- one robot ------------------------------------------------------------------------------------ */

/* No force of a set is nearer, by its support function, and a share of 1 is on its boundary. */
static void finds_the_nearest(int n) {
    Pushers p;
    crowd(n);
    CHECK(pushers_begin(&p, metric, n, arms, rows, counts) == SOLVED);
    for (int i = 0; i < n; i++) {
        const Pusher *r = p.pusher + i;
        double wanted[2] = {uniform(-4.0, 4.0), uniform(-4.0, 4.0)}, force[2], again[2];
        double turn[3], off[2];
        nearest_force(r, wanted, force, turn);
        for (int c = 0; c < 2; c++)
            off[c] = wanted[c] - force[c];
        CHECK_NEAR(support(&r->set, off, NULL, NULL), along(off, force), 1e-13);
        nearest_force(r, force, again, turn);
        CHECK_NEAR(fabs(again[0] - force[0]) + fabs(again[1] - force[1]), 0.0, 1e-14);
        double share = share_of(r, force);
        CHECK(share <= 1.0 + 1e-12);
        if (along(off, off) > 1e-6 && r->is_flat == 0 && along(off, force) > 0.1)
            CHECK_NEAR(share, 1.0, 1e-12);
        for (int c = 0; c < 2; c++)
            force[c] = r->rest[c] + 0.5 * (force[c] - r->rest[c]);
        CHECK_NEAR(share_of(r, force), 0.5 * share, 1e-12);
    }
    pushers_end(&p);
}

/* -- all of them ---------------------------------------------------------------------------------- */

/* Ask for a wrench; its forces make it or the nearest, and are in their sets. */
static Push asked_of(Pushers *p, const double *wrench, double *forces, double *shares) {
    Push found;
    Work work = work_of(INFINITY, look);
    double made[3] = {0.0};
    CHECK(push(p, wrench, length(wrench), &work, forces, shares, &found) == SOLVED);
    CHECK(found.is_proven);
    for (int i = 0; i < p->count; i++) {
        const Pusher *r = p->pusher + i;
        double force[2] = {forces[2 * i] / p->force, forces[2 * i + 1] / p->force};
        double near[2], turn[3], one[3];
        nearest_force(r, force, near, turn);
        CHECK_NEAR(hypot(near[0] - force[0], near[1] - force[1]), 0.0, 1e-9);
        CHECK(shares[i] >= 0.0 && shares[i] <= 1.0);
        if (found.needed <= 1.0)
            CHECK(shares[i] <= found.needed * (1.0 + 2.0 * SLACK) + 1e-12);
        wrench_of(metric, r->set.arm, forces + 2 * i, one);
        add(made, one);
    }
    for (int c = 0; c < 3; c++)
        made[c] -= wrench[c];
    CHECK_NEAR(length(made), found.shortfall, 1e-9 * (1.0 + length(wrench)));
    return found;
}

static void makes_wrenches(int n) {
    static double forces[2 * MOST], shares[MOST];
    double wrench[3];
    Pushers p;
    crowd(n);
    CHECK(pushers_begin(&p, metric, n, arms, rows, counts) == SOLVED);
    for (int k = 0; k < 6; k++) {
        fill_uniform(wrench, 3);
        for (int c = 0; c < 3; c++)
            wrench[c] *= k < 3 ? 0.3 * n : 3.0 * n;
        asked_of(&p, wrench, forces, shares);
    }
    pushers_end(&p);
}

static void knows_constants(void) {
    static const double ahead[3] = {1, 0, 0}, turn[3] = {0, 0, 1}, both[3] = {0.3, 0.4, 0.2};
    static const double far[3] = {3, 0, 0}, none[3] = {0, 0, 0};
    double forces[4], shares[2];
    Pushers p;
    arms[0] = 0.7;
    arms[2] = -0.7;
    arms[1] = arms[3] = 0.0;
    for (int i = 0; i < 2; i++)
        counts[i] = disc(rows + ELEMENT * i, 1.0);
    CHECK(pushers_begin(&p, metric, 2, arms, rows, counts) == SOLVED);
    CHECK_NEAR(asked_of(&p, ahead, forces, shares).needed, 0.5, 1e-14);
    CHECK_NEAR(asked_of(&p, turn, forces, shares).needed, 1.0 / 1.4, 1e-14);
    CHECK_NEAR(asked_of(&p, both, forces, shares).needed, 12.0 / 35.0, 1e-10);
    CHECK_NEAR(asked_of(&p, far, forces, shares).shortfall, 1.0, 1e-12);
    CHECK(asked_of(&p, none, forces, shares).needed == 0.0);
    pushers_end(&p);
    CHECK(pushers_begin(&p, metric, 1, arms, rows, counts) == SOLVED); /* it turns nothing alone */
    CHECK_NEAR(asked_of(&p, turn, forces, shares).shortfall, 1.0 / sqrt(1.49), 1e-12);
    pushers_end(&p);
    CHECK(pushers_begin(&p, metric, 0, arms, rows, counts) == SOLVED);
    CHECK(asked_of(&p, far, forces, shares).shortfall == 3.0);
    pushers_end(&p);
    for (int i = 0; i < 2; i++) /* without a choice */
        counts[i] = line(rows + 2 * ELEMENT * i, 1.0, 1.0, 0.0);
    CHECK(pushers_begin(&p, metric, 2, arms, rows, counts) == SOLVED);
    CHECK_NEAR(asked_of(&p, far, forces, shares).shortfall, 1.0, 1e-15);
    pushers_end(&p);
}

/* -- faults --------------------------------------------------------------------------------------- */

static int asked;
static double wanted[3];

static Status job(void) {
    static double forces[2 * HOST], shares[HOST];
    Pushers p;
    Push found;
    Work work = work_of(INFINITY, look);
    Status status = pushers_begin(&p, metric, asked, arms, rows, counts);
    if (status == SOLVED)
        status = push(&p, wanted, 1.0, &work, forces, shares, &found);
    pushers_end(&p);
    return status;
}

void test_push(void) {
    knows_constants();
    for (int k = 0; k < 30; k++) {
        finds_the_nearest(MOST);
        makes_wrenches(1 + k % MOST);
    }
    wanted[0] = 1.0;
    asked = MOST;
    crowd(MOST);
    CHECK(fail_each(job) == 0);
    asked = HOST;
    crowd(HOST);
    wanted[2] = 2e3;
    CHECK(fail_each(job) > 3);
    wanted[2] = 1e6; /* out of reach */
    CHECK(fail_each(job) > 3);
}
