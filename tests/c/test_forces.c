/* Push forces: least shares of a wrench, the nearest wrench, and the quick check of both. */
#include "../../src/swarmgrasp/kernels/proven.h"
#include "check.h"

#include <stdlib.h>

#define MOST 40
#define HOST 100000

static double generators[3 * HOST];
static const double none[3] = {0.0};

/* Find the shares of a wrench; they are proven, and make it. */
static Shares shares_of(int n, const double *wrench, double *shares) {
    Turning turning;
    Shares found = {0};
    double made[3] = {0.0}, most = 0.0;
    CHECK(turning_room(&turning, generators, n, look) == SOLVED);
    CHECK(least_shares(&turning, wrench, none, shares, &found) == SOLVED);
    CHECK(shares_are_proven(&turning, wrench, none, shares, &found));
    turning_free(&turning);
    for (int i = 0; i < n; i++) {
        most = larger(most, shares[i]);
        for (int k = 0; k < 3; k++)
            made[k] += shares[i] * generators[3 * i + k];
    }
    for (int k = 0; k < 3; k++)
        made[k] -= wrench[k];
    CHECK_NEAR(length(made), found.shortfall, 1e-12 * (n + length(wrench)));
    if (found.needed <= 1.0)
        CHECK_NEAR(most, found.needed, 1e-12);
    return found;
}

/* The most that any facet, the normals across two generators, says is needed of a wrench. */
static double slow_needed(int n, const double *wrench) {
    double needed = 0.0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double normal[3];
            cross(generators + 3 * i, generators + 3 * j, normal);
            if (length(normal) > 1e-12)
                needed = larger(needed, dot(normal, wrench)
                                            / slow_height(generators, n, none, 0, normal));
        }
    return needed;
}

static void shares_out(int n, double size) {
    double wrench[3], shares[MOST];
    fill_uniform(generators, 3 * n);
    fill_uniform(wrench, 3);
    for (int k = 0; k < 3; k++)
        wrench[k] *= size;
    double needed = slow_needed(n, wrench);
    Shares found = shares_of(n, wrench, shares);
    if (needed < 1.0)
        CHECK_NEAR(found.needed, needed, 1e-11);
    else
        CHECK(found.needed > 1.0 - 1e-11 && found.shortfall > 0.0);
}

/* Robots whose wrenches lie in a plane: a face with all of them. */
static void shares_in_plane(int n) {
    double shares[MOST], wrench[3] = {0.0}, off[3];
    for (int i = 0; i < n; i++) {
        fill_uniform(generators + 3 * i, 2);
        generators[3 * i + 2] = 0.0;
        for (int k = 0; k < 2; k++)
            wrench[k] += 0.3 * generators[3 * i + k];
    }
    CHECK(shares_of(n, wrench, shares).needed <= 0.3 + 1e-12);
    memcpy(off, wrench, sizeof off);
    off[2] = 2.0;
    CHECK_NEAR(shares_of(n, off, shares).shortfall, 2.0, 1e-12);
}

static void knows_constants(void) {
    static const double axes[9] = {2, 0, 0, 0, 2, 0, 0, 0, 1};
    const double one[3] = {1, 1, 0}, far[3] = {5, 0, 0}, back[3] = {-1, 0, 0};
    double shares[3];
    memcpy(generators, axes, sizeof axes);
    CHECK(shares_of(3, one, shares).needed == 0.5);
    CHECK(shares[0] == 0.5 && shares[1] == 0.5 && shares[2] == 0.0);
    CHECK_NEAR(shares_of(3, far, shares).shortfall, 3.0, 1e-15);
    CHECK_NEAR(shares[0], 1.0, 1e-15);
    CHECK_NEAR(shares_of(3, back, shares).shortfall, 1.0, 1e-15);
    CHECK_NEAR(shares[0], 0.0, 1e-15);
    CHECK(shares_of(3, none, shares).needed == 0.0);
    CHECK(shares_of(0, one, shares).shortfall == sqrt(2.0));
    memset(generators, 0, sizeof axes); /* robots that do nothing */
    CHECK(shares_of(3, one, shares).shortfall == sqrt(2.0));
    for (int k = 0; k < 3; k++) /* three times the same */
        memcpy(generators + 3 * k, one, sizeof one);
    CHECK_NEAR(shares_of(3, one, shares).needed, 1.0 / 3, 1e-15);
}

/* -- faults --------------------------------------------------------------------------------------- */

static int asked;
static double wanted[3];

static Status job(void) {
    static double shares[HOST];
    Turning turning;
    Shares found = {0};
    Status status = turning_room(&turning, generators, asked, look);
    CHECK(status == SOLVED || (!turning.units && !turning.where && !turning.meetings));
    if (status == SOLVED)
        status = least_shares(&turning, wanted, none, shares, &found);
    turning_free(&turning);
    return status;
}

void test_forces(void) {
    knows_constants();
    for (int k = 0; k < 60; k++) {
        shares_out(3 + k % (MOST - 2), 0.3);
        shares_out(3 + k % (MOST - 2), 30.0);
        shares_in_plane(2 + k % (MOST - 1));
    }
    wanted[2] = 1.0; /* off the plane that the robots lie in: nobody has to give all */
    asked = MOST;
    CHECK(fail_each(job) == 0);
    fill_uniform(generators, 3 * HOST);
    asked = HOST;
    CHECK(fail_each(job) > 3);
}
