/* The runner: checks, faults on demand, and slow truths. */
#include "check.h"

#include <stdint.h>
#include <stdlib.h>

#define SOME 4 /* looks at the keyboard that are interrupted one by one; then ever fewer */

static long checks, failures;
static long allocations, failing, live; /* the failing-th allocation fails */
static long looks, stopping;            /* the stopping-th look finds an interrupt */

void check(int is_so, const char *claim, const char *file, int line) {
    checks++;
    failures += !is_so;
    if (!is_so && failures <= 20)
        fprintf(stderr, "%s:%d: not so: %s (allocation %ld, look %ld)\n", file, line, claim, failing,
                stopping);
}

/* -- faults on demand: the linker has the kernels call these ------------------------------------ */

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *memory, size_t size);
void __real_free(void *memory);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *memory, size_t size);
void __wrap_free(void *memory);

static int is_refused(size_t size) {
    CHECK(size > 0); /* what is returned for nothing differs between machines */
    return ++allocations == failing;
}

void *__wrap_malloc(size_t size) {
    void *memory = is_refused(size) ? NULL : __real_malloc(size);
    live += memory != NULL;
    return memory;
}

void *__wrap_calloc(size_t count, size_t size) {
    void *memory = is_refused(count * size) ? NULL : __real_calloc(count, size);
    live += memory != NULL;
    return memory;
}

void *__wrap_realloc(void *memory, size_t size) {
    void *grown = is_refused(size) ? NULL : __real_realloc(memory, size);
    live += grown && !memory;
    return grown;
}

void __wrap_free(void *memory) {
    live -= memory != NULL;
    __real_free(memory);
}

int look(void) { return ++looks == stopping; }

static Status run(Status (*job)(void), long allocation, long at_look) {
    allocations = looks = live = 0;
    failing = allocation;
    stopping = at_look;
    Status status = job();
    CHECK(live == 0);
    return status;
}

long fail_each(Status (*job)(void)) {
    CHECK(!is_fault(run(job, 0, 0)));
    long whole = allocations, most = looks;
    for (long k = 1; k <= whole; k++)
        CHECK(run(job, k, 0) == NO_MEMORY);
    for (long k = 1; k <= most; k += 1 + k / SOME) {
        CHECK(run(job, 0, k) == INTERRUPTED);
        CHECK(looks == k);
    }
    failing = stopping = 0;
    return most;
}

/* -- numbers and slow truths --------------------------------------------------------------------- */

static uint64_t state;

double uniform(double low, double high) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return low + (high - low) * (double)(state >> 11) / 9007199254740992.0;
}

void fill_uniform(double *values, int count) {
    for (int k = 0; k < count; k++)
        values[k] = uniform(-1.0, 1.0);
}

static int by_size(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x < y) - (x > y);
}

double slow_height(const double *generators, int n, const double *load, int losing,
                   const double *normal) {
    static double terms[512];
    double sum = dot(load, normal);
    for (int i = 0; i < n; i++)
        terms[i] = larger(0.0, dot(generators + 3 * i, normal));
    qsort(terms, (size_t)n, sizeof *terms, by_size);
    for (int i = losing; i < n; i++)
        sum += terms[i];
    return sum;
}

double slow_least(const double *generators, int n, const double *load, int losing,
                  const double *task, int tasks) {
    double least = INFINITY;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++)
            for (int side = -1; side <= 1; side += 2) {
                const double *a = generators + 3 * i, *b = generators + 3 * j;
                double normal[3], extent = 0.0;
                cross(a, b, normal);
                double size = side * length(normal);
                if (fabs(size) <= 1e-12 * length(a) * length(b))
                    continue;
                for (int k = 0; k < 3; k++)
                    normal[k] /= size;
                for (int k = 0; k < tasks; k++)
                    extent = larger(extent, dot(task + 3 * k, normal));
                extent = tasks ? extent : 1.0;
                if (extent > 1e-12)
                    least = smaller(least, slow_height(generators, n, load, losing, normal) / extent);
            }
    return least;
}

int main(void) {
    static const struct {
        const char *name;
        void (*test)(void);
    } suites[] = {{"triangle", test_triangle},   {"facets", test_facets}, {"sphere", test_sphere},
                  {"criterion", test_criterion}, {"place", test_place},   {"forces", test_forces},
                  {"sets", test_sets},           {"push", test_push},     {"boxes", test_boxes},
                  {"motion", test_motion}};
    for (size_t k = 0; k < sizeof suites / sizeof *suites; k++) {
        long before = checks;
        state = 88172645463325252u; /* the same numbers, whatever the others take */
        suites[k].test();
        printf("%-10s %6ld checks\n", suites[k].name, checks - before);
    }
    printf("%ld failed\n", failures);
    return failures != 0;
}
