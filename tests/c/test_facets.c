/* Sweeps over the planes across generators, and facets listed. */
#include "../../src/swarmgrasp/kernels/facets.h"
#include "check.h"

#define MOST 12

static double generators[3 * MOST];
static const double none[3] = {0.0};

static double swept(int n, const double *load, double *normal) {
    Sweep sweep;
    CHECK(sweep_room(&sweep, n, load) == SOLVED);
    double least = sweep_all(&sweep, generators, n, normal);
    sweep_free(&sweep);
    return least;
}

/* The least swept is that of all normals across two generators, and attained. */
static void sweeps(int n) {
    double load[3], normal[3];
    fill_uniform(generators, 3 * n);
    fill_uniform(load, 3);
    for (int k = 0; k < 3; k++)
        load[k] *= 0.1;
    double least = swept(n, none, normal);
    CHECK_NEAR(least, slow_least(generators, n, none, 0, NULL, 0), 1e-13);
    CHECK_NEAR(slow_height(generators, n, none, 0, normal), least, 1e-13);
    double loaded = slow_least(generators, n, load, 0, NULL, 0);
    if (loaded > 0.0)
        CHECK_NEAR(swept(n, load, normal), loaded, 1e-13);
}

/* Each pair has its two facets, with h at both. */
static void lists(int n) {
    static double normals[3 * MOST * MOST], heights[MOST * MOST];
    Sweep sweep;
    fill_uniform(generators, 3 * n);
    CHECK(sweep_room(&sweep, n, none) == SOLVED);
    CHECK(sweep_facets(&sweep, generators, n, normals, heights) == n * (n - 1));
    for (int k = 0; k < n * (n - 1); k++)
        CHECK_NEAR(slow_height(generators, n, none, 0, normals + 3 * k), heights[k], 1e-13);
    sweep_free(&sweep);
}

static Status job(void) {
    Sweep sweep;
    double normal[3];
    Status status = sweep_room(&sweep, MOST, none);
    if (status != SOLVED) {
        CHECK(!sweep.normals && !sweep.ray && !sweep.rank);
        return status;
    }
    sweep_all(&sweep, generators, MOST, normal);
    sweep_free(&sweep);
    return SOLVED;
}

void test_facets(void) {
    double normal[3];
    for (int k = 0; k < 60; k++) {
        sweeps(2 + k % (MOST - 1));
        lists(k % (MOST + 1));
    }
    for (int n = 0; n <= 3; n++) { /* nothing, and all along one line: no plane */
        for (int k = 0; k < 3 * n; k++)
            generators[k] = k % 3 == 0 ? k - 3.0 : 0.0;
        CHECK(swept(n, none, normal) == INFINITY);
    }
    for (int k = 0; k < 3 * MOST; k++) /* all in one plane: nothing across it */
        generators[k] = k % 3 == 2 ? 0.0 : uniform(-1.0, 1.0);
    CHECK_NEAR(swept(MOST, none, normal), 0.0, 1e-15);
    CHECK_NEAR(fabs(normal[2]), 1.0, 1e-15);
    CHECK(total_height(generators, 0, normal) == 0.0);
    CHECK(fail_each(job) == 0);
}
