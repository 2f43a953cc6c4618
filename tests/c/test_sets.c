/* Sets of forces: what they exert, and the least of it after losses and beside a task. */
#include "../../src/swarmgrasp/kernels/losses.h"
#include "check.h"

#define MOST 16
#define ELEMENTS (4 * MOST)
#define TRIALS 400

static double arm[2 * MOST], row[ELEMENT * ELEMENTS], elements[MOST], machine[MOST], task[9];
static double part[PART * MOST], pose[POSE * MOST];

/* Write the elements of a ray, a sector or a disc; returns how many. */
static int make_set(int kind, double *out) {
    double turn = uniform(-3.0, 3.0), limit = uniform(0.5, 2.0), half = uniform(0.1, 1.4);
    double c = limit * cos(turn), s = limit * sin(turn), right = 0.5 * PI;
    const double ray[2][ELEMENT] = {{0.0, c, s, turn - right, turn + right},
                                    {0.0, 0.0, 0.0, turn + right, turn + 3.0 * right}};
    const double disc[ELEMENT] = {limit, 0.0, 0.0, 0.0, 2.0 * PI};
    double lo = turn - half, hi = turn + half;
    const double sector[4][ELEMENT] = {
        {limit, 0.0, 0.0, lo, hi},
        {0.0, limit * cos(hi), limit * sin(hi), hi, hi + right},
        {0.0, 0.0, 0.0, hi + right, lo - right + 2.0 * PI},
        {0.0, limit * cos(lo), limit * sin(lo), lo - right, lo}};
    if (kind == 0)
        memcpy(out, ray, sizeof ray);
    else if (kind == 1)
        memcpy(out, disc, sizeof disc);
    else
        memcpy(out, sector, sizeof sector);
    return kind == 0 ? 2 : kind == 1 ? 1 : 4;
}

static Robots robots_at(int n, int kinds, int machines) {
    double *next = row;
    fill_uniform(arm, 2 * n);
    for (int i = 0; i < n; i++) {
        int made = make_set(i % kinds, next);
        elements[i] = made;
        machine[i] = i % machines;
        next += ELEMENT * made;
    }
    return (Robots){.count = n, .arm = arm, .row = row, .elements = elements, .machine = machine};
}

static Sets sets_for(int losing, int tasks, int is_polytope) {
    fill_uniform(task, 3 * tasks);
    return (Sets){.scale = {1.0, 1.0, 1.0}, .losing = losing, .tasks = tasks, .task = task,
                  .is_polytope = is_polytope};
}

/* What is exerted is what the force found is worth, and no other force of the set is worth more. */
static void exerts(void) {
    static const double scale[3] = {1.0, 2.0, 0.5};
    for (int k = 0; k < 60; k++) {
        Robots robots = robots_at(1, 1 + k % 3, 1);
        Sets sets = sets_for(0, 0, 0);
        CHECK(sets_begin(&sets, &robots) == SOLVED);
        double normal[3], other[3], wrench[3], best[3];
        fill_uniform(normal, 3);
        fill_uniform(other, 3);
        double value = exert(scale, sets.set, normal, best, NULL, NULL);
        CHECK_NEAR(value, dot(best, normal), 1e-14);
        exert(scale, sets.set, other, wrench, NULL, NULL);
        CHECK(dot(wrench, normal) <= value + 1e-14);
        CHECK(length(best) <= largest_wrench(scale, sets.set) + 1e-14);
        sets_end(&sets);
    }
}

/* No direction has less than the bound, and the value's own normal has it. */
static void holds(int n, int kinds, int machines, int losing, int tasks, int is_polytope) {
    Robots robots = robots_at(n, kinds, machines);
    Sets sets = sets_for(losing, tasks, is_polytope);
    double value, bound, normal[3], height, cap;
    Work work = work_of(WORK, look);
    CHECK(sets_begin(&sets, &robots) == SOLVED);
    CHECK(sets_search(&sets, NULL, 1e-9, INFINITY, 0.0, NULL, 0, &work, &value, &bound, normal) == SOLVED);
    CHECK(bound <= value);
    CHECK(bound >= value * (1.0 - 2e-7) - 2e-13 * sets.weight);
    CHECK(sets_height(&sets, normal, NULL, &height, &cap) == SOLVED);
    CHECK_NEAR(value * sets_extent(&sets, normal), height, 1e-11);
    for (int k = 0; k < TRIALS; k++) {
        fill_uniform(normal, 3);
        CHECK(sets_height(&sets, normal, NULL, &height, &cap) == SOLVED);
        CHECK(height >= bound * sets_extent(&sets, normal) - 1e-12);
        CHECK(cap >= height);
    }
    sets_end(&sets);
}

/* One more robot is as good as one of the swarm. */
static void joins(int n, int losing) {
    Robots robots = robots_at(n, 3, n);
    Sets all = sets_for(losing, 0, 0), fewer = all;
    double value, other, bound, normal[3], start[3];
    Work work = work_of(WORK, look);
    CHECK(sets_begin(&all, &robots) == SOLVED);
    robots.count--;
    CHECK(sets_begin(&fewer, &robots) == SOLVED);
    CHECK(sets_search(&all, NULL, 1e-9, INFINITY, 0.0, NULL, 0, &work, &value, &bound, start) == SOLVED);
    CHECK(sets_search(&fewer, all.set + n - 1, 1e-9, INFINITY, 0.0, start, 1, &work, &other, &bound, normal)
          == SOLVED);
    CHECK_NEAR(value, other, 2e-9 * value);
    if (value > 0.0) { /* what is not less than wanted is not looked for */
        CHECK(sets_search(&all, NULL, 1e-9, 0.5 * value, 0.0, NULL, 0, &work, &other, &bound, normal) == SOLVED);
        CHECK(other == 0.5 * value && length(normal) == 0.0);
        /* and less than enough will do */
        CHECK(sets_search(&all, NULL, 1e-9, INFINITY, 2.0 * value, NULL, 0, &work, &other, &bound, normal)
              == SOLVED);
        CHECK(value * (1.0 - 2e-9) <= other && other < 2.0 * value && bound == 0.0);
    }
    sets_end(&all);
    sets_end(&fewer);
}

static Robots asked;
static int lost;

static Status job(void) {
    Sets sets = sets_for(lost, 0, 0);
    double value, bound, normal[3];
    Work work = work_of(WORK, look);
    Status status = sets_begin(&sets, &asked);
    if (status == SOLVED)
        status = sets_search(&sets, NULL, 1e-9, INFINITY, 0.0, NULL, 0, &work, &value, &bound, normal);
    sets_end(&sets);
    return status;
}

/* Robots that drift along a part of the boundary or turn a little have at most what they have at any
 * place there. */
static void drifts(int n) {
    Robots robots = robots_at(n, 3, n);
    for (int i = 0; i < n; i++) {
        double shift = uniform(0.0, 0.2), turn = uniform(-3.0, 3.0);
        const double ends[PART] = {i, arm[2 * i], arm[2 * i + 1] - shift, arm[2 * i], arm[2 * i + 1] + shift};
        const double piece[POSE] = {n + i, 1.0, ends[1], ends[2], ends[3], ends[4], turn - 0.2, turn + 0.2,
                                    cos(turn - 0.2), sin(turn - 0.2), cos(turn + 0.2), sin(turn + 0.2)};
        memcpy(part + PART * i, ends, sizeof ends);
        memcpy(pose + POSE * i, piece, sizeof piece);
        elements[n + i] = 0.0;
        machine[n + i] = n + i;
        arm[2 * (n + i)] = arm[2 * (n + i) + 1] = 0.0;
    }
    Sets sets = sets_for(0, 0, 0);
    robots.count = 2 * n;
    robots.part = part;
    robots.pose = pose;
    robots.parts = robots.poses = n;
    CHECK(sets_begin(&sets, &robots) == SOLVED);
    double value, bound, normal[3], height, cap, most, wrench[3];
    Work work = work_of(WORK, look);
    CHECK(sets_search(&sets, NULL, 1e-7, INFINITY, 0.0, NULL, 0, &work, &value, &bound, normal) == SOLVED);
    CHECK(bound <= value && bound >= value * (1.0 - 2e-7) - 2e-13 * sets.weight);
    for (int k = 0; k < TRIALS; k++) {
        fill_uniform(normal, 3);
        CHECK(sets_height(&sets, normal, NULL, &height, &cap) == SOLVED);
        CHECK(height >= bound * length(normal) - 1e-12);
        most = 0.0;
        for (int i = 0; i < 2 * n; i++) {
            ForceSet fixed = sets.set[i];
            double share = uniform(0.0, 1.0), end = uniform(-0.2, 0.2);
            const double *p = i < n ? fixed.part : fixed.piece;
            for (int j = 0; j < 2; j++)
                fixed.arm[j] = p[j] + share * (p[2 + j] - p[j]);
            if (i < n) {
                fixed.adrift = 0;
                most += exert(sets.scale, &fixed, normal, NULL, NULL, NULL);
            } else {
                double turn = 0.5 * (p[4] + p[5]) + end, force[2] = {cos(turn), sin(turn)};
                wrench_of(sets.scale, fixed.arm, force, wrench);
                most += larger(0.0, dot(wrench, normal));
            }
        }
        CHECK(most >= height - 1e-12);
    }
    sets_end(&sets);
}

void test_sets(void) {
    exerts();
    for (int k = 0; k < 60; k++) {
        holds(2 + k % (MOST - 2), 1 + k % 3, 2 + k % 5 < 2 + k % (MOST - 2) ? 2 + k % 5 : 2, k % 3,
              k % 4 == 3 ? 3 : 0, k % 8 == 3);
        joins(3 + k % 8, k % 3);
    }
    for (int n = 1; n < MOST / 2; n++)
        drifts(n);
    asked = robots_at(MOST, 3, MOST / 2);
    lost = 2;
    fail_each(job);
    for (int i = 0; i < MOST; i++) { /* a ring of discs has a whole curve of minima */
        const double disc[ELEMENT] = {1.0, 0.0, 0.0, 0.0, 2.0 * PI};
        arm[2 * i] = 0.9 * cos(2.0 * PI * i / MOST);
        arm[2 * i + 1] = 0.9 * sin(2.0 * PI * i / MOST);
        memcpy(row + ELEMENT * i, disc, sizeof disc);
        elements[i] = 1.0;
    }
    lost = 0;
    CHECK(fail_each(job) >= 1);
}
