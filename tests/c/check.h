/* A small runner of tests in plain C, and slow truths to compare the kernels with. */
#ifndef CHECK_H
#define CHECK_H

#include <stdio.h>
#include <string.h>

#include "../../src/swarmgrasp/kernels/vectors.h"
#include "../../src/swarmgrasp/kernels/work.h"

#define CHECK(claim) check(claim, #claim, __FILE__, __LINE__)
#define CHECK_NEAR(a, b, error) check(fabs((a) - (b)) <= (error), #a " is " #b, __FILE__, __LINE__)

void check(int is_so, const char *claim, const char *file, int line);

/* A number between two, the next of a sequence that is the same in each run. */
double uniform(double low, double high);
void fill_uniform(double *values, int count);

/* The keyboard as the kernels see it. */
int look(void);

/* Run a job, which must not fail; then with each of its allocations failing once, and with each of
 * its looks at the keyboard (of many, some) finding an interrupt: it returns the fault at once and
 * leaves no memory behind. The job cleans up whatever it began. Returns how many looks it took. */
long fail_each(Status (*job)(void));

/* h at a normal: the load's part and the sum over generators without the `losing` largest. */
double slow_height(const double *generators, int n, const double *load, int losing,
                   const double *normal);

/* The least h / D over the normals across two generators, D the largest part along `tasks` rows or
 * the normal's length; INFINITY if there is no such normal. */
double slow_least(const double *generators, int n, const double *load, int losing,
                  const double *task, int tasks);

void test_boxes(void);
void test_triangle(void);
void test_facets(void);
void test_sphere(void);
void test_criterion(void);
void test_place(void);
void test_sets(void);
void test_forces(void);
void test_push(void);
void test_motion(void);

#endif
