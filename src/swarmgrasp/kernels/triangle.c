/* Small things about triangles of directions. Trusted are counts of a few rows, and corners that are
 * units or nearly. The linear program is cubic in its rows, of which there are 4 at most. */
#include <string.h>

#include "triangle.h"
#include "vectors.h"

#define INSIDE 1e-6 /* of a triangle's edge: by how much a direction may lie outside */

static double highest(double rows[][3], int count, const double *share) {
    double value = dot(rows[0], share);
    for (int k = 1; k < count; k++)
        value = larger(value, dot(rows[k], share));
    return value;
}

double relax(double rows[][3], int count, double *share) {
    double least = INFINITY, trial[3];
#define TRY                                              \
    do {                                                 \
        double value = highest(rows, count, trial);      \
        if (value < least) {                             \
            least = value;                               \
            memcpy(share, trial, sizeof trial);          \
        }                                                \
    } while (0)
    for (int j = 0; j < 3; j++) {
        for (int k = 0; k < 3; k++)
            trial[k] = k == j;
        TRY;
    }
    for (int a = 0; a < count; a++)
        for (int b = a + 1; b < count; b++) {
            double d[3];
            for (int k = 0; k < 3; k++)
                d[k] = rows[a][k] - rows[b][k];
            for (int j = 0; j < 3; j++) {
                int i = (j + 1) % 3;
                if (d[i] * d[j] < 0.0) {
                    trial[i] = d[j] / (d[j] - d[i]);
                    trial[j] = 1.0 - trial[i];
                    trial[3 - i - j] = 0.0;
                    TRY;
                }
            }
            for (int c = b + 1; c < count; c++) {
                double e[3], sum;
                for (int k = 0; k < 3; k++)
                    e[k] = rows[a][k] - rows[c][k];
                cross(d, e, trial);
                sum = trial[0] + trial[1] + trial[2];
                if (sum == 0.0)
                    continue;
                for (int k = 0; k < 3; k++)
                    trial[k] /= sum;
                if (trial[0] >= 0.0 && trial[1] >= 0.0 && trial[2] >= 0.0)
                    TRY;
            }
        }
#undef TRY
    return least;
}

double hold(double rows[][3], int count) {
    double most = -INFINITY, mixed[3], share[3];
    for (int a = 0; a < count; a++)
        for (int b = a; b < count; b++)
            for (int c = b; c < count; c++) {
                const double *three[3] = {rows[a], rows[b], rows[c]};
                int used = a == b ? (b == c ? 1 : 0) : b == c ? 2 : 3;
                if (used == 0)
                    continue; /* as with another order */
                for (int j = 0; j < (used == 2 ? 3 : 1); j++) { /* alike at two corners, or at all */
                    if (used == 1) {
                        share[0] = 1.0;
                        share[1] = share[2] = 0.0;
                    } else if (used == 2) {
                        int i = (j + 1) % 3;
                        double d = three[0][i] - three[0][j], e = three[1][i] - three[1][j];
                        if (d * e >= 0.0)
                            continue;
                        share[0] = e / (e - d);
                        share[1] = 1.0 - share[0];
                        share[2] = 0.0;
                    } else {
                        double d[3], e[3];
                        for (int k = 0; k < 3; k++) {
                            d[k] = three[k][0] - three[k][1];
                            e[k] = three[k][0] - three[k][2];
                        }
                        cross(d, e, share);
                        double sum = share[0] + share[1] + share[2];
                        if (sum == 0.0)
                            continue;
                        for (int k = 0; k < 3; k++)
                            share[k] = larger(0.0, share[k] / sum);
                        sum = share[0] + share[1] + share[2];
                        for (int k = 0; k < 3; k++)
                            share[k] /= sum;
                    }
                    for (int i = 0; i < 3; i++)
                        mixed[i] = share[0] * three[0][i] + share[1] * three[1][i]
                                   + share[2] * three[2][i];
                    most = larger(most, smaller(mixed[0], smaller(mixed[1], mixed[2])));
                }
            }
    return most;
}

int is_inside(const double *corner, const double *m) {
    double side[3], edge = 0.0;
    for (int j = 0; j < 3; j++) {
        double across[3];
        const double *a = corner + 3 * j, *b = corner + 3 * ((j + 1) % 3);
        cross(a, b, across);
        side[j] = dot(across, m);
        edge = larger(edge, length(across));
    }
    double slack = INSIDE * edge * edge * length(m);
    if (side[0] >= -slack && side[1] >= -slack && side[2] >= -slack)
        return 1;
    return side[0] <= slack && side[1] <= slack && side[2] <= slack ? -1 : 0;
}

int longest_edge(const double *corner, double *edge) {
    double longest = -1.0;
    int at = 0;
    for (int j = 0; j < 3; j++) {
        double side[3];
        for (int k = 0; k < 3; k++)
            side[k] = corner[3 * j + k] - corner[3 * ((j + 1) % 3) + k];
        if (dot(side, side) > longest) {
            longest = dot(side, side);
            at = j;
        }
    }
    *edge = sqrt(longest);
    return at;
}
