/* Newcomers of fixed direction by boxes: the best, what bounds it, searches cut short, and faults. */
#include "../../src/swarmgrasp/kernels/boxes.h"
#include "check.h"

#define MOST 12
#define GRID 10
#define GAP 1e-3

static double arm[2 * MOST], row[2 * ELEMENT * MOST], elements[MOST], machine[MOST];
static double pieces[2 * PIECE], task[3 * 4];

/* Two-way robots, ahead and astern of random limits; 0 astern is a ray. */
static Robots crew(int n, double back) {
    fill_uniform(arm, 2 * n);
    for (int i = 0; i < n; i++) {
        double turn = uniform(-PI, PI), u = uniform(0.5, 1.5), r = back * u, right = 0.5 * PI;
        const double made[2][ELEMENT] = {
            {0.0, u * cos(turn), u * sin(turn), turn - right, turn + right},
            {0.0, -r * cos(turn), -r * sin(turn), turn + right, turn + 3.0 * right}};
        memcpy(row + 2 * ELEMENT * i, made, sizeof made);
        elements[i] = 2.0;
        machine[i] = i;
    }
    return (Robots){.count = n, .arm = arm, .row = row, .elements = elements, .machine = machine};
}

static Sets asked_of(int losing, int tasks, int is_polytope) {
    fill_uniform(task, 3 * tasks);
    return (Sets){.scale = {1.0, 1.0, 1.0}, .losing = losing, .tasks = tasks, .task = task,
                  .is_polytope = is_polytope};
}

/* A side of the unit square, pushed inwards, as far aside as half a width. */
static void make_piece(double *piece, int side, double width) {
    double middle = side * 0.5 * PI + PI, lo = middle - 0.5 * width, hi = middle + 0.5 * width;
    double c = cos(side * 0.5 * PI), s = sin(side * 0.5 * PI);
    const double made[PIECE] = {c + s, s - c, c - s, s + c, lo, hi, cos(lo), sin(lo), cos(hi), sin(hi)};
    memcpy(piece, made, sizeof made);
}

/* No robot of a grid beats what bounds its box, and the best is as good as it says. */
static void bounds(int n, double present, double back, int losing, int tasks, int asks) {
    Robots robots = crew(n, present);
    Sets sets = asked_of(losing, tasks, losing % 2);
    BoxSearch search;
    Place best;
    double quality, normal[3], point[2], top = 0.0;
    for (int k = 0; k < 2; k++)
        make_piece(pieces + PIECE * k, k, k ? PI : 1.0);
    CHECK(sets_begin(&sets, &robots) == SOLVED);
    CHECK(boxes_begin(&search, &sets, pieces, 2, 1.0, back, WORK, look) == SOLVED);
    Status status = boxes_solve(&search, NULL, GAP, asks, &best);
    CHECK(status == SOLVED || status == OUT_OF_BUDGET);
    for (int k = 0; k < search.boxes; k++)
        top = larger(top, search.box[k].bound);
    if (status == SOLVED)
        CHECK(top <= best.quality * (1.0 + GAP) + 1e-11 * search.pool.size);
    for (int k = 0; k < search.boxes; k += 1 + search.boxes / 40) {
        const Box *box = search.box + k;
        const double *p = pieces + PIECE * box->piece;
        double share = uniform(box->from, box->to), turn = uniform(box->lo, box->hi);
        for (int c = 0; c < 2; c++)
            point[c] = p[c] + share * (p[c + 2] - p[c]);
        CHECK(boxes_quality(&search, point, turn, EXACT, &quality, normal) == SOLVED);
        CHECK(quality <= larger(box->bound, best.quality * (1.0 + GAP)) * (1.0 + 1e-8) + 1e-11 * search.pool.size);
        double weights = 0.0;
        for (int t = 0; t < box->terms; t++)
            weights += box->term[t].weight;
        CHECK_NEAR(weights, search.is_flat ? 2.0 : 1.0, 1e-12); /* flat normals are no sum */
    }
    if (best.piece >= 0) {
        const double *p = pieces + PIECE * best.piece;
        for (int c = 0; c < 2; c++)
            point[c] = p[c] + best.share * (p[c + 2] - p[c]);
        CHECK(boxes_quality(&search, point, best.direction, EXACT, &quality, normal) == SOLVED);
        CHECK_NEAR(quality, best.quality, 1e-4 * best.quality);
    }
    boxes_end(&search);
    sets_end(&sets);
}

/* A search, from the robots to the last box. */
static Status job(void) {
    Robots robots = {.count = 4, .arm = arm, .row = row, .elements = elements, .machine = machine};
    Sets sets = {.scale = {1.0, 1.0, 1.0}};
    BoxSearch search = {0};
    Place best;
    Status status = sets_begin(&sets, &robots);
    if (status == SOLVED)
        status = boxes_begin(&search, &sets, pieces, 2, 1.0, 1.0, WORK, look);
    if (status == SOLVED)
        status = boxes_solve(&search, NULL, 1e-5, 150, &best);
    boxes_end(&search);
    sets_end(&sets);
    return status;
}

void test_boxes(void) {
    for (int k = 0; k < 8; k++) {
        bounds(5 + k, 0.0, 0.5 * (k % 3), 0, 0, 300);
        bounds(4 + k % 3, 1.0, 0.5 * (k % 3), k % 2, k % 4 ? 0 : 4, 300);
        bounds(6, 0.5, 1.0, 0, 0, 5);
    }
    bounds(1, 0.0, 1.0, 0, 0, 20); /* too few to hold anything */
    crew(4, 1.0);
    CHECK(fail_each(job) > 0);
}
