/* The least of a support function over all directions: tree, sphere and the quality of both. */
#include "../../src/swarmgrasp/kernels/quality.h"
#include "check.h"

#define MOST 300
#define HOST 50000 /* generators whose tree takes long to build */

static double generators[3 * HOST];
static const double none[3] = {0.0};

static double quality_of(int n, double *normal) {
    Sweep sweep;
    double quality, bound;
    Work work = work_of(WORK, look);
    CHECK(sweep_room(&sweep, n <= SWEPT ? n : 0, none) == SOLVED);
    CHECK(exact_quality(&sweep, generators, n, &work, &quality, &bound, normal) == SOLVED);
    sweep_free(&sweep);
    CHECK(bound <= quality && quality <= bound * (1.0 + 1e-9) + 1e-12);
    return quality;
}

/* What the tree adds up and lists is what one by one says. */
static void counts(int n) {
    static double listed[3 * MOST];
    Tree tree;
    double n_in[3], corner[9], white[9], g[3], sum[3] = {0.0};
    int looked, crossed = 0;
    Work work = work_of(WORK, look);
    CHECK(tree_build(&tree, generators, n, none, &work) == SOLVED);
    fill_uniform(n_in, 3);
    whiten_normal(&tree.white, n_in, white);
    tree_gradient(&tree, white, 0.0, g);
    CHECK_NEAR(dot(g, white), slow_height(generators, n, none, 0, n_in), 1e-12 * n);
    fill_uniform(corner, 9);
    for (int j = 0; j < 3; j++)
        whiten_normal(&tree.white, corner + 3 * j, white + 3 * j);
    int found = tree_crossed(&tree, white, MOST, listed, g, &looked);
    for (int i = 0; i < n; i++) {
        const double *b = generators + 3 * i;
        int positive = (dot(b, corner) > 0.0) + (dot(b, corner + 3) > 0.0) + (dot(b, corner + 6) > 0.0);
        double c[3];
        whiten(&tree.white, b, c);
        if (positive == 3)
            add(sum, c);
        crossed += positive == 1 || positive == 2;
    }
    CHECK(found == crossed);
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(g[k], sum[k], 1e-12 * n);
    CHECK(found == 0 || tree_crossed(&tree, white, found - 1, listed, g, &looked) == -1);
    tree_free(&tree);
}

/* A second search begins with the cells that the first one kept, and one generator more. */
static void goes_on(int n) {
    Tree tree;
    Sphere first, kept = {0}, second;
    double extra[3], normal[3];
    Work work = work_of(WORK, look);
    CHECK(tree_build(&tree, generators, n - 1, none, &work) == SOLVED);
    whiten(&tree.white, generators + 3 * (n - 1), extra);
    CHECK(sphere_search(&first, &tree, NULL, 0, NULL, 2.0, INFINITY, 0.0, &work) == SOLVED);
    CHECK(sphere_keep(&kept, &first, first.best + 2.0) == SOLVED);
    CHECK(sphere_search(&second, &tree, extra, 1, &kept, 0.0, INFINITY, 0.0, &work) == SOLVED);
    CHECK_NEAR(sphere_best(&second, normal), slow_least(generators, n, none, 0, NULL, 0), 1e-11);
    sphere_free(&first);
    sphere_free(&kept);
    sphere_free(&second);
    tree_free(&tree);
}

/* Every facet of a regular ring is the weakest: nothing takes longer. */
static void make_ring(int n) {
    for (int i = 0; i < n; i++) {
        generators[3 * i] = cos(2.0 * PI * i / n);
        generators[3 * i + 1] = sin(2.0 * PI * i / n);
        generators[3 * i + 2] = i % 2 ? 0.3 : -0.3;
    }
}

/* Nearly in a plane, between two along its normal: around that h changes by 1e-9 of itself, and no
 * triangle where it is least may be left because its bound is as near. */
static void make_flat(int n) {
    for (int i = 0; i < n; i++) {
        double a = uniform(-PI, PI);
        const double b[3] = {cos(a), sin(a), uniform(-1e-9, 1e-9)};
        const double along[3] = {0.0, 0.0, i % 2 ? 0.2 * n : -0.2 * n};
        memcpy(generators + 3 * i, i < n - 2 ? b : along, sizeof b);
    }
}

static Status job(void) {
    Sweep sweep;
    double quality, bound, normal[3];
    Work work = work_of(WORK, look);
    Status status = sweep_room(&sweep, 0, none);
    if (status == SOLVED)
        status = exact_quality(&sweep, generators, MOST, &work, &quality, &bound, normal);
    sweep_free(&sweep);
    return status;
}

static Status build_job(void) {
    Tree tree;
    Work work = work_of(WORK, look);
    Status status = tree_build(&tree, generators, HOST, none, &work);
    CHECK(status == SOLVED || (!tree.vectors && !tree.node));
    tree_free(&tree);
    return status;
}

static Status keep_job(void) {
    Tree tree;
    Sphere sphere = {0}, kept = {0};
    Work work = work_of(WORK, look);
    Status status = tree_build(&tree, generators, 60, none, &work);
    if (status == SOLVED)
        status = sphere_search(&sphere, &tree, NULL, 0, NULL, 20.0, INFINITY, 0.0, &work);
    if (status == SOLVED)
        status = sphere_keep(&kept, &sphere, INFINITY);
    sphere_free(&sphere);
    sphere_free(&kept);
    tree_free(&tree);
    return status;
}

void test_sphere(void) {
    static const int sizes[] = {2, 3, 5, SWEPT, SWEPT + 1, 90};
    double normal[3];
    for (int k = 0; k < 12; k++) {
        int n = sizes[k % 6];
        fill_uniform(generators, 3 * n);
        double quality = quality_of(n, normal), truth = slow_least(generators, n, none, 0, NULL, 0);
        CHECK_NEAR(quality, truth, 1e-11 * n);
        CHECK_NEAR(slow_height(generators, n, none, 0, normal), quality, 1e-11 * n);
        counts(n);
        if (n > 3)
            goes_on(n);
    }
    counts(0);
    CHECK(quality_of(0, normal) == 0.0);
    for (int n = 1; n <= SWEPT + 1; n += SWEPT) { /* along one line, twice: no plane, and a normal */
        for (int k = 0; k < 3 * n; k++)
            generators[k] = k % 3 == 0 ? 1.0 + k : 0.0;
        CHECK(quality_of(n, normal) == 0.0);
        CHECK_NEAR(normal[0], 0.0, 1e-15);
        CHECK_NEAR(length(normal), 1.0, 1e-15);
    }
    for (int k = 0; k < 4; k++) {
        make_flat(120);
        double quality = quality_of(120, normal);
        CHECK_NEAR(quality, slow_least(generators, 120, none, 0, NULL, 0), 1e-13 * quality);
    }
    make_ring(MOST);
    CHECK(fail_each(job) > 3);
    fail_each(keep_job);
    Work little = work_of(1e4, look);
    Tree tree;
    Sphere sphere;
    CHECK(tree_build(&tree, generators, MOST, none, &little) == SOLVED);
    CHECK(sphere_search(&sphere, &tree, NULL, 0, NULL, 0.0, INFINITY, 0.0, &little) == OUT_OF_BUDGET);
    CHECK(sphere.bound <= sphere.best);
    sphere_free(&sphere);
    tree_free(&tree);
    fill_uniform(generators, 3 * HOST);
    CHECK(fail_each(build_job) > 1);
}
