/* Motion: closed forms of a push ahead and of robots' answers, energy, batches, and faults. */
#include "../../src/swarmgrasp/kernels/motion.h"
#include "check.h"

#define ROBOTS 7
#define RUNS 5
#define ROW (BODY + 2 * ROBOTS)

static Afloat hull;
static Driver driver[ROBOTS];
static double state[RUNS * ROW], order[RUNS * 2 * ROBOTS], stream[RUNS * STREAM], load[RUNS * 3];
static const double calm[STREAM] = {0.0}, none[3] = {0.0};

/* A barge of 80 m: mass 4 and added masses 1 and 2, inertia 900 and 600, about the origin. */
static void make_hull(void) {
    hull = (Afloat){.inverse = {1.0 / 5.0, 0, 0, 0, 1.0 / 6.0, 0, 0, 0, 1.0 / 1500.0},
                    .mass = 4.0, .added = {1.0, 2.0}, .length = 80.0, .midship_x = 2.0,
                    .air = 1e-6, .frontal = 100.0, .lateral = 400.0, .bow = 0.6, .stern = 0.7,
                    .cross = 0.5, .ahead = 0.02, .abeam = 0.3};
}

/* Robots of each following, with and without lag and bounds, some on lines. */
static void make_robots(void) {
    for (int i = 0; i < ROBOTS; i++) {
        driver[i] = (Driver){.x = uniform(-40, 40), .y = uniform(-10, 10), .efficiency = 0.9,
                             .lag = i == 1 ? 0.0 : uniform(1, 5), .rate = i == 2 ? 1e300 : 0.3,
                             .turn_lag = i == 3 ? 0.0 : 2.0, .turn_rate = 0.2, .following = i % 4,
                             .keeps = i > 4, .c = 0.8, .s = 0.6};
    }
    for (int k = 0; k < RUNS; k++) {
        fill_uniform(state + ROW * k, ROW);
        fill_uniform(order + 2 * ROBOTS * k, 2 * ROBOTS);
        fill_uniform(stream + STREAM * k, STREAM);
        fill_uniform(load + 3 * k, 3);
        for (int i = 0; i < ROBOTS; i++) /* of those that are always positive */
            if (i % 4)
                state[ROW * k + BODY + i] = fabs(state[ROW * k + BODY + i]);
    }
}

static Status advance(int n, int runs, double *at, double step, long steps) {
    Work work = work_of(INFINITY, look);
    return motion_advance(&hull, driver, n, runs, at, order, stream, load, step, steps, &work);
}

/* A steady push ahead: u = sqrt(F / k) tanh(t sqrt(F k) / m), without air. */
static void push_ahead(void) {
    double body[BODY] = {0.0}, push[3] = {0.5, 0.0, 0.0}, air = hull.air;
    Work work = work_of(INFINITY, look);
    hull.air = 0.0;
    CHECK(motion_advance(&hull, NULL, 0, 1, body, NULL, calm, push, 0.1, 300, &work) == SOLVED);
    double fastest = sqrt(push[0] / hull.ahead), rate = push[0] / (fastest * 5.0);
    CHECK_NEAR(body[3], fastest * tanh(30.0 * rate), 1e-8);
    CHECK_NEAR(body[0], fastest / rate * log(cosh(30.0 * rate)), 1e-7);
    CHECK(body[1] == 0.0 && body[2] == 0.0 && body[4] == 0.0 && body[5] == 0.0);
    hull.air = air;
}

/* Without a push, energy falls; and nothing at rest starts. */
static void drift(void) {
    double body[BODY] = {0.0}, energy = INFINITY, still[BODY] = {0.0};
    Work work = work_of(INFINITY, look);
    body[3] = 0.5;
    body[4] = -0.3;
    body[5] = 0.02;
    for (int k = 0; k < 50; k++) {
        const double *v = body + 3;
        double now = 5.0 * v[0] * v[0] + 6.0 * v[1] * v[1] + 1500.0 * v[2] * v[2];
        CHECK(now <= energy);
        energy = now;
        CHECK(motion_advance(&hull, NULL, 0, 1, body, NULL, calm, none, 0.2, 5, &work) == SOLVED);
    }
    CHECK(motion_advance(&hull, NULL, 0, 1, still, NULL, calm, none, 1.0, 50, &work) == SOLVED);
    for (int j = 0; j < BODY; j++)
        CHECK(still[j] == 0.0);
}

/* 0.3 a second until 0.3 lag before the end, then slower; as one step or as many. */
static void answer(void) {
    double lag = driver[0].lag = 2.0, once[ROW] = {0.0}, often[ROW] = {0.0};
    order[0] = 1.5;
    CHECK(advance(ROBOTS, 1, once, 6.0, 1) == SOLVED);
    CHECK(advance(ROBOTS, 1, often, 0.06, 100) == SOLVED);
    CHECK_NEAR(once[BODY], 1.5 - 0.6 * exp(-(6.0 - 3.0) / lag), 1e-14);
    for (int j = BODY; j < ROW; j++)
        CHECK_NEAR(remainder(once[j] - often[j], j < BODY + ROBOTS ? 1e9 : 2.0 * PI), 0.0, 1e-12);
    CHECK(once[BODY + 1] == order[2] || fabs(order[2]) > 6.0 * 0.3); /* without lag it arrives */
}

/* Runs alone are what they are together. */
static void batches(void) {
    static double together[RUNS * ROW], rows[RUNS * EXERTED], row[EXERTED];
    memcpy(together, state, sizeof together);
    CHECK(advance(ROBOTS, RUNS, together, 0.1, 20) == SOLVED);
    motion_exerted(&hull, driver, ROBOTS, RUNS, together, stream, rows);
    for (ptrdiff_t k = 0; k < RUNS; k++) {
        double alone[ROW];
        Work work = work_of(INFINITY, look);
        memcpy(alone, state + ROW * k, sizeof alone);
        CHECK(motion_advance(&hull, driver, ROBOTS, 1, alone, order + 2 * ROBOTS * k,
                             stream + STREAM * k, load + 3 * k, 0.1, 20, &work) == SOLVED);
        CHECK(memcmp(alone, together + ROW * k, sizeof alone) == 0);
        motion_exerted(&hull, driver, ROBOTS, 1, alone, stream + STREAM * k, row);
        CHECK(memcmp(row, rows + EXERTED * k, sizeof row) == 0);
    }
}

static Status job(void) {
    static double runs[RUNS * ROW];
    memcpy(runs, state, sizeof runs);
    return advance(ROBOTS, RUNS, runs, 0.01, 3000);
}

void test_motion(void) {
    make_hull();
    make_robots();
    push_ahead();
    drift();
    answer();
    batches();
    CHECK(fail_each(job) > 3);
}
