/* The least of a curved function over a triangle in the plane: the greatest of some linear functions,
 * and a quadratic one. Nothing is checked. */
#ifndef SWARMGRASP_PLANE_H
#define SWARMGRASP_PLANE_H

#define CUTS 5 /* linear functions at most */

/* A linear function a + b . d. */
typedef struct {
    double a, b[2];
} Cut;

static inline double cut_at(const Cut *cut, const double *d) {
    return cut->a + cut->b[0] * d[0] + cut->b[1] * d[1];
}

/* d' N d / 2 of a symmetric matrix (xx, xy, yy). */
static inline double bend_at(const double *bend, const double *d) {
    return 0.5 * (bend[0] * d[0] * d[0] + 2.0 * bend[1] * d[0] * d[1] + bend[2] * d[1] * d[1]);
}

/* Find the least of max_k cut_k(d) + d' N d / 2 over a triangle of corners (3, 2), and where. */
double least_on_triangle(double corner[3][2], const Cut *cut, int cuts, const double *bend,
                         double *where);

#endif
