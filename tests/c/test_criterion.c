/* What a swarm is asked to withstand: losses, uncertain poses, a load and a task. */
#include "../../src/swarmgrasp/kernels/criterion.h"
#include "check.h"

#define FEW 12
#define MOST 60
#define TRIALS 400

static double points[3 * MOST], rows[SPREAD_ROW * MOST], task[3 * MOST];

/* A row: a robot of limit 1 on an upright stretch, that pushes more or less one way. */
static void make_row(double *row, double robot) {
    double x = uniform(-1.0, 1.0), y = uniform(-1.0, 1.0), turn = uniform(-3.0, 3.0);
    double lo = turn - 0.2, hi = turn + 0.2;
    const double made[SPREAD_ROW] = {robot, 1.0, x, y - 0.2, x, y + 0.2, lo, hi, cos(lo), sin(lo), cos(hi),
                                 sin(hi)};
    memcpy(row, made, sizeof made);
}

static Criterion criterion_of(int known, int spread, int losing, int tasks) {
    fill_uniform(points, 3 * known);
    fill_uniform(task, 3 * tasks);
    for (int r = 0; r < spread; r++)
        make_row(rows + SPREAD_ROW * r, r);
    return (Criterion){.points = known, .point = points, .rows = rows, .scale = {1.0, 1.0, 1.0},
                       .losing = losing, .is_polytope = 1, .tasks = tasks, .task = task};
}

/* Of known robots the value is the least over the normals across two of them. */
static void finds(int n, int losing, int tasks) {
    Criterion c = criterion_of(n, 0, losing, tasks);
    double value, normal[3], height, cap;
    Work work = work_of(WORK, look);
    CHECK(criterion_begin(&c, 0) == SOLVED);
    CHECK(criterion_search(&c, NULL, 1e-11, INFINITY, UNASKED * c.weight, &work, &value, normal)
          == SOLVED);
    double truth = slow_least(points, n, c.load, losing, task, tasks);
    CHECK_NEAR(value, truth < INFINITY ? truth : 0.0, 1e-10 + 1e-10 * truth);
    fill_uniform(normal, 3);
    CHECK(criterion_height(&c, normal, NULL, &height, &cap) == SOLVED);
    CHECK_NEAR(height, slow_height(points, n, c.load, losing, normal), 1e-14);
    CHECK_NEAR(criterion_total(&c, normal), slow_height(points, n, c.load, 0, normal), 1e-14);
    if (losing)
        CHECK_NEAR(cap, slow_height(points, n, c.load, losing - 1, normal), 1e-14);
    else
        CHECK(cap == INFINITY);
    criterion_end(&c);
}

/* No direction has less than the value, and its own normal has it. */
static void holds(int n, int spread, int losing, int tasks) {
    Criterion c = criterion_of(n, spread, losing, tasks);
    double value, normal[3], height, cap;
    Work work = work_of(WORK, look);
    CHECK(criterion_begin(&c, spread) == SOLVED);
    CHECK(criterion_search(&c, NULL, 1e-7, INFINITY, UNASKED * c.weight, &work, &value, normal)
          == SOLVED);
    CHECK(criterion_height(&c, normal, NULL, &height, &cap) == SOLVED);
    CHECK_NEAR(value * criterion_extent(&c, normal), height, 1e-11);
    for (int k = 0; k < TRIALS; k++) {
        fill_uniform(normal, 3);
        CHECK(criterion_height(&c, normal, NULL, &height, &cap) == SOLVED);
        CHECK(height >= value * criterion_extent(&c, normal) * (1.0 - 1e-6) - 1e-11);
        CHECK(cap >= height);
    }
    criterion_end(&c);
}

static void refuses(void) {
    static const double orders[][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 0}, {0, 0.5, 1}, {-1, 0, 1}};
    for (size_t k = 0; k < sizeof orders / sizeof *orders; k++) {
        Criterion c = criterion_of(0, 3, 0, 0);
        for (int r = 0; r < 3; r++)
            rows[SPREAD_ROW * r] = orders[k][r];
        CHECK(criterion_begin(&c, 3) == UNSORTED);
        criterion_end(&c);
    }
}

/* Uncertain robots, and more to lose than there is room for without asking for memory. */
static Criterion asked;
static int asked_rows;

static Status job(void) {
    Criterion c = asked;
    double value, normal[3];
    Work work = work_of(WORK, look);
    Status status = criterion_begin(&c, asked_rows);
    if (status == SOLVED)
        status = criterion_search(&c, NULL, 1e-7, INFINITY, UNASKED * c.weight, &work, &value, normal);
    criterion_end(&c);
    return status;
}

void test_criterion(void) {
    for (int k = 0; k < 40; k++) {
        finds(3 + k % (FEW - 2), k % 3, k % 2 ? 0 : 3);
        finds(FEW, FEW - k % 4, 0); /* too many lost: nothing is left */
    }
    for (int k = 0; k < 12; k++)
        holds(k % 4, 1 + k % 5, k % 3, k % 2 ? 0 : 3);
    for (int n = 0; n < 3; n++) /* nobody, or too few to hold anything */
        finds(n, 0, 0);
    refuses();
    asked = criterion_of(FEW, asked_rows = FEW, 9, 0);
    fail_each(job);
    long looks = 0;
    for (int k = 0; k < 20 && looks < 4; k++) { /* one-way robots and tasks: some take long */
        asked = criterion_of(MOST, asked_rows = FEW, 3, 3);
        for (int j = 0; j < 3 * MOST; j++)
            points[j] -= 1.0;
        for (int j = 0; j < 9; j++)
            task[j] -= 1.0;
        looks = fail_each(job);
    }
    CHECK(looks >= 4);
}
