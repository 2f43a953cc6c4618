/* Triangles of directions, three corners (3, 3) each, for searches that split them. Nothing is
 * checked: corners are units or nearly, counter-clockwise. */
#ifndef SWARMGRASP_TRIANGLE_H
#define SWARMGRASP_TRIANGLE_H

#define NO_VERTEX 1e-12 /* sine of the angle between generators that have no vertex */
#define SMALLEST 1e-13  /* edge of a triangle that is a point */

/* Minimise the greatest of some rows over shares of the corners: a linear program of three
 * unknowns, solved by looking at all its vertices. */
double relax(double rows[][3], int count, double *share);

/* The same from below, whatever rounding does to rows that differ in size: the greatest that a
 * mixture of the rows has at every corner. */
double hold(double rows[][3], int count);

/* Tell whether a direction lies in a triangle; a little outside counts too. 1, or -1 for the
 * opposite direction. */
int is_inside(const double *corner, const double *m);

/* Return the corner at which the longest edge begins, and write its length. */
int longest_edge(const double *corner, double *edge);

#endif
