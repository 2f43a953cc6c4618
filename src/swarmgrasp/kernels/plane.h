/* The least of a curved function over a triangle in the plane: the greatest of some linear functions, and
 * a quadratic one. Nothing is checked. */
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

/* A convex polygon. */
typedef struct {
    int count;
    double at[3 + CUTS][2];
} Polygon;

/* The greatest of some cuts over a triangle: each is the highest on a part of it. */
typedef struct {
    double corner[3][2];
    int cuts;
    Cut cut[CUTS];
    Polygon part[CUTS];
    double bend[3];                        /* N, and with it */
    double least[CUTS], where[CUTS][2];    /* the least on each part, INFINITY on one that is empty */
} Roof;

/* Begin without cuts. */
void roof_begin(Roof *roof, double corner[3][2], const double *bend);

/* Add a cut, of CUTS at most: of the parts of the others it takes where it is higher. */
void roof_add(Roof *roof, const Cut *cut);

/* Find the least of max_k cut_k(d) + d' N d / 2, and where. */
double roof_least(const Roof *roof, double *where);

/* Find the same for another N. */
double roof_least_with(const Roof *roof, const double *bend);

#endif
