/* The tree of generators: whitened, sorted along a space-filling curve on the cube's faces, halved
 * where the curve's keys differ (T12). Trusted are finite numbers and fewer than 2^31 / 16 generators.
 * Building is linear but for 6 passes of sorting, 32 bytes a generator while it lasts; at most 2 n
 * nodes stay, and 3 n numbers. The tree is at most 63 deep. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "tree.h"
#include "vectors.h"

#ifdef __GNUC__
#define FETCH(address) __builtin_prefetch(address)
#else
#define FETCH(address) ((void)0)
#endif
#define AHEAD 16             /* generators fetched before their turn */
#define LEAF 8               /* generators in a leaf, at most, unless they point alike */
#define GRID 1073741823.0    /* (u, v) as 30 bits each, */
#define FACE 60              /* and the face above them */
#define FLATTEST 1e-16       /* of C's pivots, relative to its trace: what rounding leaves of it */
#define EVEN 0.01            /* least determinant of C, in cubes of its trace, that is near 1/27 */
#define PER_ITEM 20.0        /* units of work to whiten a generator */
#define SOME 4096            /* generators between two looks at the keyboard */
#define STEPS 8              /* towards that, at most */
#define ALIKE 1e-15          /* difference of (u, v) that is rounding */
#define SWOLLEN 4e-16        /* by which a rectangle is widened */

typedef struct {
    uint64_t key;
    uint32_t index;
} Item;

/* The two components beside the largest one. */
static const int beside[3][2] = {{1, 2}, {0, 2}, {0, 1}};

void whiten(const Whitening *white, const double *b, double *c) {
    const double *w = white->m;
    c[0] = w[0] * b[0];
    c[1] = w[1] * b[0] + w[2] * b[1];
    c[2] = w[3] * b[0] + w[4] * b[1] + w[5] * b[2];
}

void normal_of(const Whitening *white, const double *m, double *n) {
    const double *w = white->m;
    n[0] = w[0] * m[0] + w[1] * m[1] + w[3] * m[2];
    n[1] = w[2] * m[1] + w[4] * m[2];
    n[2] = w[5] * m[2];
}

void whiten_normal(const Whitening *white, const double *n, double *m) {
    const double *w = white->m;
    m[2] = n[2] / w[5];
    m[1] = (n[1] - w[4] * m[2]) / w[2];
    m[0] = (n[0] - w[1] * m[1] - w[3] * m[2]) / w[0];
}

/* One step towards M: the inverse of the Cholesky factor of C = sum b b' / |M b|, with pivots
 * that are not 0. Tells whether M was good before. */
static int improve_whitening(double *w, const Whitening *before, const double *generators,
                             ptrdiff_t count) {
    double c[6] = {0.0}, d[6] = {0.0}; /* C, and the same of the whitened ones: lower triangles */
    for (ptrdiff_t k = 0; k < count; k++) {
        const double *b = generators + 3 * k;
        double white[3], size;
        whiten(before, b, white);
        size = length(white);
        if (size > 0.0) {
            double x = b[0] / size, y = b[1] / size, z = b[2] / size;
            c[0] += x * b[0];
            c[1] += y * b[0];
            c[2] += y * b[1];
            c[3] += z * b[0];
            c[4] += z * b[1];
            c[5] += z * b[2];
            for (int i = 0, at = 0; i < 3; i++)
                for (int j = 0; j <= i; j++)
                    d[at++] += white[i] / size * white[j];
        }
    }
    double trace = d[0] + d[2] + d[5];
    double volume = d[0] * (d[2] * d[5] - d[4] * d[4]) - d[1] * (d[1] * d[5] - d[4] * d[3])
                    + d[3] * (d[1] * d[4] - d[2] * d[3]);
    if (volume >= EVEN * trace * trace * trace)
        return 1;
    double least = FLATTEST * (c[0] + c[2] + c[5]);
    double l0 = sqrt(larger(c[0], least));
    double l1 = c[1] / l0, l3 = c[3] / l0;
    double l2 = sqrt(larger(c[2] - l1 * l1, least));
    double l4 = (c[4] - l3 * l1) / l2;
    double l5 = sqrt(larger(c[5] - l3 * l3 - l4 * l4, least));
    w[0] = 1.0 / l0;
    w[2] = 1.0 / l2;
    w[5] = 1.0 / l5;
    w[1] = -w[2] * l1 * w[0];
    w[4] = -w[5] * l4 * w[2];
    w[3] = -w[5] * (l3 * w[0] + l4 * w[1]);
    return 0;
}

/* Spread 30 bits to every second place. */
static uint64_t every_second(uint64_t x) {
    x = (x | x << 16) & 0x0000FFFF0000FFFFull;
    x = (x | x << 8) & 0x00FF00FF00FF00FFull;
    x = (x | x << 4) & 0x0F0F0F0F0F0F0F0Full;
    x = (x | x << 2) & 0x3333333333333333ull;
    return (x | x << 1) & 0x5555555555555555ull;
}

static int face_of(const double *c) {
    double x = fabs(c[0]), y = fabs(c[1]), z = fabs(c[2]);
    int axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
    return 2 * axis + (c[axis] < 0.0);
}

/* Where a generator's direction meets the cube. */
static void place_on(int face, const double *c, double *uv) {
    for (int k = 0; k < 2; k++)
        uv[k] = c[beside[face / 2][k]] / fabs(c[face / 2]);
}

static uint64_t key_of(const double *c) {
    int face = face_of(c);
    double uv[2];
    place_on(face, c, uv);
    uint64_t i = (uint64_t)((uv[0] + 1.0) * 0.5 * GRID), j = (uint64_t)((uv[1] + 1.0) * 0.5 * GRID);
    return (uint64_t)face << FACE | every_second(j) << 1 | every_second(i);
}

static int highest_bit(uint64_t x) {
    int bit = 0;
    for (int step = 32; step > 0; step /= 2)
        if (x >> step) {
            x >>= step;
            bit += step;
        }
    return bit;
}

/* Sort by key, 11 bits at a time; digits that all items share are passed over. */
static Status sort_items(Item **items, Item **spare, size_t n, Work *work) {
    for (int shift = 0; shift < 63; shift += 11) {
        if (spend(work, (double)n) == INTERRUPTED)
            return INTERRUPTED;
        size_t start[2049] = {0};
        for (size_t i = 0; i < n; i++)
            start[((*items)[i].key >> shift & 2047) + 1]++;
        if (start[((*items)[0].key >> shift & 2047) + 1] == n)
            continue;
        for (int d = 0; d < 2048; d++)
            start[d + 1] += start[d];
        for (size_t i = 0; i < n; i++)
            (*spare)[start[(*items)[i].key >> shift & 2047]++] = (*items)[i];
        Item *swap = *items;
        *items = *spare;
        *spare = swap;
    }
    return SOLVED;
}

/* Write the node of generators [first, last) and those below it; keys are in `items`. */
static void grow(Tree *tree, const Item *items, int first, int last) {
    int here = tree->nodes++;
    Node *node = tree->node + here;
    /* by its key: adding up parallel neighbours may have turned a tie of components */
    *node = (Node){.first = first, .face = (int)(items[first].key >> FACE)};
    uint64_t differ = items[first].key ^ items[last - 1].key;
    if (last - first <= LEAF || differ == 0) {
        double low[2] = {2.0, 2.0}, high[2] = {-2.0, -2.0};
        for (int i = first; i < last; i++) {
            const double *c = tree->vectors + 3 * i;
            double uv[2];
            place_on(node->face, c, uv);
            for (int k = 0; k < 2; k++) {
                low[k] = smaller(low[k], uv[k]);
                high[k] = larger(high[k], uv[k]);
            }
            for (int k = 0; k < 3; k++)
                node->sum[k] += c[k];
        }
        for (int k = 0; k < 2; k++) {
            node->middle[k] = 0.5 * (low[k] + high[k]);
            node->half[k] = 0.5 * (high[k] - low[k]) + SWOLLEN;
        }
        node->count = last - first;
        node->skip = tree->nodes;
        return;
    }
    /* split where the highest bit that differs turns to 1 */
    int bit = highest_bit(differ), low = first, high = last - 1;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (items[middle].key >> bit & 1)
            high = middle;
        else
            low = middle;
    }
    int below[2] = {tree->nodes, 0};
    grow(tree, items, first, high);
    below[1] = tree->nodes;
    grow(tree, items, high, last);
    node = tree->node + here;
    const Node *a = tree->node + below[0], *b = tree->node + below[1];
    for (int k = 0; k < 3; k++)
        node->sum[k] = a->sum[k] + b->sum[k];
    for (int k = 0; k < 2; k++) {
        double lo = smaller(a->middle[k] - a->half[k], b->middle[k] - b->half[k]);
        double hi = larger(a->middle[k] + a->half[k], b->middle[k] + b->half[k]);
        node->middle[k] = 0.5 * (lo + hi);
        node->half[k] = 0.5 * (hi - lo) + SWOLLEN;
    }
    node->skip = tree->nodes;
}

static int is_parallel(int face, const double *a, const double *b) {
    double p[2], q[2];
    place_on(face, a, p);
    place_on(face, b, q);
    return fabs(p[0] - q[0]) <= ALIKE && fabs(p[1] - q[1]) <= ALIKE;
}

void whitening_of(Whitening *white, const double *generators, ptrdiff_t count) {
    /* forces in any unit come to a total near 1 */
    double total = total_size(generators, count), *w = white->m;
    memset(w, 0, sizeof white->m);
    w[0] = w[2] = w[5] = total > 0.0 ? 1.0 / total : 1.0;
    for (int step = 0; step < STEPS; step++) {
        double better[6];
        if (improve_whitening(better, white, generators, count))
            break;
        memcpy(w, better, sizeof better);
    }
}

static Status build(Tree *tree, const double *generators, ptrdiff_t count, const double *load,
                    Work *work) {
    Status status = NO_MEMORY;
    memset(tree, 0, sizeof *tree);
    whitening_of(&tree->white, generators, count);
    if (spend(work, PER_ITEM * (double)count) == INTERRUPTED)
        return INTERRUPTED;
    whiten(&tree->white, load, tree->load);
    tree->weight = length(tree->load);
    size_t room = count > 0 ? (size_t)count : 1;
    Item *items = malloc(room * sizeof *items), *spare = malloc(room * sizeof *spare);
    tree->vectors = malloc(3 * room * sizeof *tree->vectors);
    if (!items || !spare || !tree->vectors)
        goto done;
    size_t n = 0;
    for (ptrdiff_t i = 0; i < count; i++) {
        double c[3];
        whiten(&tree->white, generators + 3 * i, c);
        if (c[face_of(c) / 2] == 0.0)
            continue;
        tree->weight += length(c);
        items[n].key = key_of(c);
        items[n++].index = (uint32_t)i;
    }
    status = n > 0 ? sort_items(&items, &spare, n, work) : SOLVED;
    int size = 0;
    for (size_t i = 0; i < n && status != INTERRUPTED; i++) {
        if (i % SOME == 0)
            status = spend(work, SOME);
        double *c = tree->vectors + 3 * size;
        if (i + AHEAD < n) /* they lie anywhere: waiting for each would take as long as sorting */
            FETCH(generators + 3 * (ptrdiff_t)items[i + AHEAD].index);
        whiten(&tree->white, generators + 3 * (ptrdiff_t)items[i].index, c);
        int face = (int)(items[i].key >> FACE);
        if (size > 0 && items[size - 1].key >> FACE == items[i].key >> FACE
            && is_parallel(face, c - 3, c)) {
            for (int k = 0; k < 3; k++)
                c[k - 3] += c[k];
            continue;
        }
        items[size++] = items[i];
    }
    tree->size = size;
    free(spare);
    spare = NULL;
    if (size > 0 && status != INTERRUPTED) {
        tree->node = malloc(2 * (size_t)size * sizeof *tree->node);
        status = tree->node ? SOLVED : NO_MEMORY;
        for (int first = 0, last = 0; first < size && !is_fault(status); first = last) {
            while (last < size && items[last].key >> FACE == items[first].key >> FACE)
                last++;
            grow(tree, items, first, last); /* one for each square */
            status = spend(work, last - first);
        }
    }
done:
    free(items);
    free(spare);
    if (is_fault(status))
        tree_free(tree);
    return is_fault(status) ? status : SOLVED;
}

Status tree_build(Tree *tree, const double *generators, ptrdiff_t count, const double *load,
                  Work *work) {
    double left = work->left;
    work->left = INFINITY;
    Status status = build(tree, generators, count, load, work);
    work->left = left;
    return status;
}

void tree_free(Tree *tree) {
    free(tree->vectors);
    free(tree->node);
    memset(tree, 0, sizeof *tree);
}

/* The sign of a normal on all of a node's rectangle: 1, -1, or 0 if there are both. */
static inline int sign_on(const Node *node, const double *m, double slack) {
    int axis = node->face >> 1;
    double p = m[beside[axis][0]], q = m[beside[axis][1]];
    double at = (node->face & 1 ? -m[axis] : m[axis]) + p * node->middle[0] + q * node->middle[1];
    double reach = fabs(p) * node->half[0] + fabs(q) * node->half[1] + slack;
    return at > reach ? 1 : at < -reach ? -1 : 0;
}

/* Count a node on which a normal has one sign as one vector, or not at all; go to the next that is
 * not below it. */
static inline const Node *pass_over(const Tree *tree, const Node *node, int sign, double *sum) {
    if (sign > 0)
        add(sum, node->sum);
    return tree->node + node->skip;
}

int tree_gradient(const Tree *tree, const double *m, double rounding, double *g) {
    double sum[3] = {tree->load[0], tree->load[1], tree->load[2]};
    const Node *node = tree->node, *end = tree->node + tree->nodes;
    int looked = 0;
    for (; node < end; looked++) {
        int sign = sign_on(node, m, 0.0);
        if (sign != 0) {
            node = pass_over(tree, node, sign, sum);
            continue;
        }
        const double *c = tree->vectors + 3 * node->first;
        looked += node->count;
        for (int i = 0; i < node->count; i++, c += 3) {
            double a = m[0] * c[0], b = m[1] * c[1], d = m[2] * c[2];
            if (a + b + d > rounding * (fabs(a) + fabs(b) + fabs(d))) {
                add(sum, c);
            }
        }
        node++;
    }
    memcpy(g, sum, sizeof sum);
    return looked;
}

int tree_crossed(const Tree *tree, const double *corners, int room, double *listed, double *g,
                 int *looked) {
    int found = 0, seen = 0;
    double sum[3] = {tree->load[0], tree->load[1], tree->load[2]}, slack[3];
    const Node *node = tree->node, *end = tree->node + tree->nodes;
    for (int j = 0; j < 3; j++) {
        const double *m = corners + 3 * j;
        slack[j] = ON_PLANE * (fabs(m[0]) + fabs(m[1]) + fabs(m[2]));
    }
    for (; node < end; seen++) {
        int sign = sign_on(node, corners, slack[0]);
        for (int j = 1; j < 3 && sign != 0; j++)
            if (sign_on(node, corners + 3 * j, slack[j]) != sign)
                sign = 0;
        if (sign != 0) {
            node = pass_over(tree, node, sign, sum);
            continue;
        }
        const double *c = tree->vectors + 3 * node->first;
        seen += node->count;
        for (int i = 0; i < node->count; i++, c += 3) {
            double near = ON_PLANE * (fabs(c[0]) + fabs(c[1]) + fabs(c[2]));
            double a = dot(corners, c), b = dot(corners + 3, c), d = dot(corners + 6, c);
            if (a > near && b > near && d > near) {
                add(sum, c);
            } else if (!(a < -near && b < -near && d < -near)) {
                if (found == room) {
                    *looked = seen;
                    return -1;
                }
                memcpy(listed + 3 * found++, c, 3 * sizeof *c);
            }
        }
        node++;
    }
    memcpy(g, sum, sizeof sum);
    *looked = seen;
    return found;
}
