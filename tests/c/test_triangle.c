/* Triangles of directions, and what a robot can do on a piece. */
#include "../../src/swarmgrasp/kernels/sector.h"
#include "../../src/swarmgrasp/kernels/triangle.h"
#include "check.h"

#define GRID 60

/* The relaxed least is below that at any shares, and next to the least of a grid of them. */
static void relaxes(int count) {
    double rows[4][3], share[3], least = INFINITY;
    fill_uniform(rows[0], 12);
    double relaxed = relax(rows, count, share), own = -INFINITY;
    for (int i = 0; i <= GRID; i++)
        for (int j = 0; i + j <= GRID; j++) {
            const double at[3] = {(double)i / GRID, (double)j / GRID, (double)(GRID - i - j) / GRID};
            double highest = -INFINITY;
            for (int k = 0; k < count; k++)
                highest = larger(highest, dot(rows[k], at));
            least = smaller(least, highest);
        }
    for (int k = 0; k < count; k++)
        own = larger(own, dot(rows[k], share));
    CHECK(relaxed <= least + 1e-15 && least <= relaxed + 4.0 / GRID);
    CHECK_NEAR(own, relaxed, 1e-15);
    CHECK_NEAR(hold(rows, count), relaxed, 1e-13); /* duality */
    CHECK_NEAR(share[0] + share[1] + share[2], 1.0, 1e-14);
}

/* The best of a piece is reached by a robot of it, and next to the best of a grid of them. */
static void values(double width, int is_point) {
    double lo = uniform(-PI, PI), hi = lo + width, v[3], wrench[3], best = -INFINITY;
    double p[4] = {uniform(-1.0, 1.0), uniform(-1.0, 1.0)};
    double along = is_point ? 0.0 : uniform(0.0, 1.0), middle = 0.5 * (lo + hi);
    p[2] = p[0] - along * cos(middle + 0.5 * PI) * -1.0;
    p[3] = p[1] + along * sin(middle + 0.5 * PI);
    const double piece[PIECE] = {p[0], p[1], p[2], p[3], lo, hi, cos(lo), sin(lo), cos(hi), sin(hi)};
    fill_uniform(v, 3);
    for (int i = 0; i <= GRID; i++)
        for (int j = 0; j <= 1; j++) {
            double a = lo + width * i / GRID, c = cos(a), s = sin(a);
            const double b[3] = {c, s, p[2 * j] * s - p[2 * j + 1] * c};
            best = larger(best, dot(v, b));
        }
    double value = best_on_piece(piece, v, wrench);
    CHECK(value >= best - 1e-15 && value <= best + 4.0 * width * width / GRID / GRID + 1e-15);
    CHECK_NEAR(dot(v, wrench), value, 1e-15);
}

/* One direction alone: of its opposite a robot is worth -1, not 1. */
static void opposes(void) {
    double a = uniform(-PI, PI), wrench[3], v[3] = {-cos(a), -sin(a), 0.0};
    const double piece[PIECE] = {0.3, 0.2, 0.3, 0.2, a, a, cos(a), sin(a), cos(a), sin(a)};
    CHECK_NEAR(best_on_piece(piece, v, wrench), -1.0, 1e-15);
    CHECK_NEAR(dot(v, wrench), -1.0, 1e-15);
}

void test_triangle(void) {
    const double corner[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double in[3] = {1, 1, 1}, behind[3] = {-1, -1, -2}, out[3] = {1, 1, -1};
    const double longer[9] = {1, 0, 0, 0, 2, 0, 0, 0, 5}, point[9] = {0};
    double edge;
    CHECK(is_inside(corner, in) == 1 && is_inside(corner, behind) == -1);
    CHECK(is_inside(corner, out) == 0 && is_inside(corner, corner) == 1);
    CHECK(longest_edge(longer, &edge) == 1);
    CHECK_NEAR(edge, sqrt(29.0), 1e-15);
    CHECK(longest_edge(point, &edge) == 0 && edge == 0.0);
    for (int k = 0; k < 100; k++) {
        opposes();
        relaxes(1 + k % 4);
        values(k % 4 ? uniform(0.0, PI) : 0.0, k % 3 == 0);
    }
}
