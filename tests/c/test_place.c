/* Placement: the best robot over pieces, its proof, robots that join, and ties. */
#include "../../src/swarmgrasp/kernels/place.h"
#include "check.h"

#define MOST 90
#define GRID 12
#define GAP 1e-7

static double generators[3 * (MOST + 1)], pieces[2 * PIECE];
static const double none[3] = {0.0}, weights[3] = {1.0, 1.0, 1.0};

static void make_piece(double *piece, double width) {
    double x = uniform(-1.0, 1.0), y = uniform(-1.0, 1.0), lo = uniform(-PI, PI), hi = lo + width;
    double middle = 0.5 * (lo + hi), along = uniform(0.0, 0.5);
    const double made[PIECE] = {x, y, x + along * sin(middle), y - along * cos(middle), lo, hi,
                                cos(lo), sin(lo), cos(hi), sin(hi)};
    memcpy(piece, made, sizeof made);
    if ((made[2] - x) * sin(middle) - (made[3] - y) * cos(middle) < 0.0)
        for (int k = 0; k < 2; k++) {
            piece[k] = made[2 + k];
            piece[2 + k] = made[k];
        }
}

/* The quality of the first n generators and a robot. */
static double with(int n, const double *wrench) {
    memcpy(generators + 3 * n, wrench, 3 * sizeof *wrench);
    double least = slow_least(generators, n + 1, none, 0, NULL, 0);
    return least < INFINITY ? least : 0.0;
}

static double best_of_grid(int n, const double *piece) {
    double best = 0.0;
    for (int i = 0; i <= GRID; i++)
        for (int j = 0; j <= GRID; j++) {
            double a = piece[4] + (piece[5] - piece[4]) * i / GRID, c = cos(a), s = sin(a);
            double x = piece[0] + (piece[2] - piece[0]) * j / GRID;
            double y = piece[1] + (piece[3] - piece[1]) * j / GRID;
            const double wrench[3] = {c, s, x * s - y * c};
            best = larger(best, with(n, wrench));
        }
    return best;
}

/* The best is as good as it says and as any of a grid, and its bounds leave no more than the gap. */
static void places(int n, double size) {
    Search s;
    Best best;
    Proof proofs[2];
    fill_uniform(generators, 3 * n);
    for (int k = 0; k < 3 * n; k++)
        generators[k] *= size;
    make_piece(pieces, 1.0);
    make_piece(pieces + PIECE, 0.0);
    CHECK(search_begin(&s, generators, n, none, NULL, weights, pieces, 2, WORK, look) == SOLVED);
    CHECK(search_solve(&s, NULL, GAP, &best, proofs) == SOLVED);
    double bound = larger(proofs[0].bound, proofs[1].bound), rounding = 1e-12 * s.size;
    CHECK(bound <= best.quality * (1.0 + GAP) + rounding);
    if (best.piece >= 0)
        CHECK_NEAR(with(n, best.wrench), best.quality, rounding);
    if (n < 10)
        for (int k = 0; k < 2; k++)
            CHECK(best_of_grid(n, pieces + PIECE * k) <= proofs[k].bound + rounding);
    double target = best.quality * (1.0 - 1e-6);
    CHECK(search_break_tie(&s, proofs, target, &best) == SOLVED);
    CHECK(best.piece >= 0);
    CHECK(with(n, best.wrench) >= target - rounding);
    search_end(&s);
}

/* After a robot joins, the quality is that of all, and what is found next is the best beside it. */
static void joins(int n, int more) {
    Search s;
    Best best;
    Proof proof;
    fill_uniform(generators, 3 * n);
    make_piece(pieces, 1.0);
    CHECK(search_begin(&s, generators, n, none, NULL, weights, pieces, 1, WORK, look) == SOLVED);
    for (int k = 0; k < more; k++) {
        const double wrench[3] = {cos(k), sin(k), 0.3 * k};
        memcpy(generators + 3 * (n + k), wrench, sizeof wrench);
        CHECK(search_join(&s, wrench, pieces, 1) == SOLVED);
    }
    CHECK_NEAR(s.quality, slow_least(generators, n + more, none, 0, NULL, 0), 1e-11 * n);
    CHECK(search_solve(&s, NULL, GAP, &best, &proof) == SOLVED);
    CHECK(proof.bound <= best.quality * (1.0 + GAP) + 1e-12 * s.size);
    CHECK_NEAR(with(n + more, best.wrench), best.quality, 1e-12 * s.size);
    search_end(&s);
}

/* -- faults --------------------------------------------------------------------------------------- */

static int asked;
static const Criterion *criterion;

static Status job(void) {
    Search s;
    Best best;
    Proof proofs[2];
    double quality, normal[3], height;
    const double wrench[3] = {1.0, 0.0, 0.2}, up[3] = {0.0, 0.0, 1.0};
    Status status = search_begin(&s, generators, asked, none, criterion, weights, pieces, 2, WORK, look);
    if (status == SOLVED)
        status = search_solve(&s, NULL, GAP, &best, proofs);
    if (status == SOLVED)
        status = search_break_tie(&s, proofs, 0.9 * best.quality, &best);
    if (status == SOLVED)
        status = search_value(&s, wrench, &quality, normal);
    if (status == SOLVED)
        status = search_height(&s, up, &height);
    for (int k = 0; k < 2 && status == SOLVED && !criterion; k++) {
        status = search_join(&s, wrench, pieces, 2);
        if (status == SOLVED)
            status = search_solve(&s, NULL, GAP, &best, proofs);
    }
    search_end(&s);
    return status;
}

void test_place(void) {
    static const int sizes[] = {0, 1, 2, 3, 4, 6, 9, 40, 60, 61, 80};
    for (int k = 0; k < 33; k++)
        places(sizes[k % 11], k < 22 ? 1.0 : 0.01); /* and one stronger than all others together */
    joins(4, 3);
    joins(59, 3);
    joins(70, 3);
    fill_uniform(generators, 3 * MOST);
    make_piece(pieces, 1.0);
    make_piece(pieces + PIECE, 0.5);
    static const int asks[] = {0, 6, 59, 66}; /* facets listed, also until robots join, and a tree */
    for (int k = 0; k < 4; k++) {
        asked = asks[k];
        fail_each(job);
    }
    double rows[2 * SPREAD_ROW], task[9];
    for (int r = 0; r < 2; r++) {
        rows[SPREAD_ROW * r] = r;
        rows[SPREAD_ROW * r + 1] = 1.0;
        make_piece(rows + SPREAD_ROW * r + 2, 0.3);
    }
    fill_uniform(task, 9);
    for (int k = 0; k < 9; k++)
        task[k] -= 1.0;
    for (int k = 0; k < 3 * MOST; k++)
        generators[k] -= 1.0;
    Criterion c = {.points = 20, .point = generators, .rows = rows, .scale = {1.0, 1.0, 1.0},
                   .losing = 9, .is_polytope = 1, .tasks = 3, .task = task};
    criterion = &c;
    asked = 0;
    CHECK(criterion_begin(&c, 2) == SOLVED);
    fail_each(job); /* more to lose than there is room for without asking for memory */
    c.losing = 1;
    CHECK(fail_each(job) > 0);
    criterion_end(&c);
}
