/* A newcomer that keeps its whole force set by branch and bound over spans of the boundary (T22). Trusted are
 * pieces as `Pieces` makes them, and elements that go once around. */
#include <stdlib.h>
#include <string.h>

#include "place.h"
#include "quality.h"
#include "spans.h"

#define EXACT 1e-9    /* gap of a quality that is asked */
#define SAME 1e-14   /* distance between unit normals that are one: on ridges they differ by little */
#define INNER 0.1     /* share of a span within which it is not cut near its ends */
#define SMALLEST 1e-12 /* share of a piece that only rounding could split */
#define STRONG 0.3    /* of the swarm's size: from this strength on a newcomer's own poles matter */
#define PASS 12.0     /* units of work that a normal takes on a span */
#define NOTHING 1.5   /* times what counts as 0: what normals leave that were asked where it is 0 */
#define STEEP 0.01    /* share of D, along each of two normals, below which none travels between them */

static double between(double a, double b, double share) { return a + (b - a) * share; }

/* The newcomer on a piece, at a share of the way. */
static ForceSet at_share(const SpanSearch *s, int piece, double share) {
    const double *p = s->ends + 4 * (ptrdiff_t)piece;
    ForceSet set = s->set[piece];
    for (int k = 0; k < 2; k++)
        set.arm[k] = share == 1.0 ? p[2 + k] : between(p[k], p[2 + k], share);
    return set;
}

/* -- what is known ------------------------------------------------------------------------------ */

static int has_room(void **things, int *room, int count, size_t size) {
    if (count < *room)
        return 1;
    int more = 2 * *room + 64;
    void *grown = realloc(*things, (size_t)more * size);
    if (!grown)
        return 0;
    *things = grown;
    *room = more;
    return 1;
}

/* Add a unit normal to the pool, unless it is there. */
static Status meet(SpanSearch *s, const double *normal) {
    for (int k = 0; k < s->count; k++) {
        double apart = 0.0;
        for (int i = 0; i < 3; i++)
            apart += (s->pool[k].normal[i] - normal[i]) * (s->pool[k].normal[i] - normal[i]);
        if (apart <= SAME * SAME)
            return SOLVED;
    }
    if (!has_room((void **)&s->pool, &s->room, s->count, sizeof *s->pool))
        return NO_MEMORY;
    Level *at = s->pool + s->count;
    memcpy(at->normal, normal, sizeof at->normal);
    Status status = sets_height(s->sets, normal, NULL, &at->height, &at->cap);
    if (status != SOLVED)
        return status;
    at->extent = sets_extent(s->sets, normal);
    if (at->extent <= UNASKED)
        at->extent = 0.0;
    double cap = at->extent > 0.0 ? larger(at->cap, 0.0) / at->extent : INFINITY;
    if (cap < s->least_cap) {
        s->least_cap = cap;
        s->capped = s->count;
    }
    s->count++;
    return spend(&s->work, s->sets->count);
}

/* Of a newcomer beside which the others are weak, add the two normals along which it exerts nothing. */
static Status meet_poles(SpanSearch *s, int piece, double share) {
    ForceSet set = at_share(s, piece, share);
    const double *scale = s->sets->scale;
    double pole[3] = {scale[2] / scale[0] * set.arm[1], -scale[2] / scale[1] * set.arm[0], 1.0};
    double size = length(pole);
    Status status = SOLVED;
    for (int sign = 1; sign >= -1 && !is_fault(status); sign -= 2) {
        double normal[3];
        for (int k = 0; k < 3; k++)
            normal[k] = sign * pole[k] / size;
        status = meet(s, normal);
    }
    return status;
}

Status spans_begin(SpanSearch *s, const Sets *sets, const double *ends, int many,
                   const double *rows, const double *counts, double units,
                   int (*interrupted)(void)) {
    *s = (SpanSearch){.sets = sets, .ends = ends, .many = many, .least_cap = INFINITY,
                      .may_travel = sets->losing == 0,
                      .work = work_of(units, interrupted)};
    double bound, opposite[3];
    int elements = 0;
    for (int k = 0; k < many; k++)
        elements += (int)counts[k];
    s->element = malloc(((size_t)elements + 1) * sizeof *s->element);
    s->set = malloc(((size_t)many + 1) * sizeof *s->set);
    if (!s->element || !s->set)
        return NO_MEMORY;
    for (int k = 0; k < elements; k++)
        s->element[k] = element_of(rows + ELEMENT * (ptrdiff_t)k);
    for (int k = 0, first = 0; k < many; first += (int)counts[k++]) {
        s->set[k] = (ForceSet){.element = s->element + first, .elements = (int)counts[k]};
        for (int end = 0; end < 2; end++) {
            ForceSet set = at_share(s, k, end);
            s->strength = larger(s->strength, largest_wrench(sets->scale, &set));
        }
    }
    for (int i = 0; i < sets->count; i++)
        if (sets->set[i].adrift || sets->set[i].turning)
            s->may_travel = 0;
    s->size = sets->weight + s->strength;
    Status status = sets_search(sets, NULL, EXACT, INFINITY, NULL, 0, &s->work, &s->quality,
                                &bound, s->weakest);
    if (is_fault(status))
        return status;
    for (int k = 0; k < 3; k++)
        opposite[k] = -s->weakest[k];
    status = meet(s, s->weakest);
    if (!is_fault(status))
        status = meet(s, opposite);
    for (int k = 0; k < 6 && !is_fault(status); k++) {
        double axis[3] = {0.0};
        axis[k / 2] = k % 2 ? -1.0 : 1.0;
        status = meet(s, axis);
    }
    return is_fault(status) ? status : SOLVED;
}

void spans_end(SpanSearch *s) {
    void *all[] = {s->set, s->element, s->pool, s->open, s->closed, s->line};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        free(all[k]);
}

/* What a newcomer reaches at most along a normal met, relative to D if anything is asked there. */
static double reach_of(const SpanSearch *s, const Level *at, const ForceSet *set) {
    double p[2];
    lever(s->sets->scale, set->arm, at->normal, p);
    double height = at->height + support(set, p, NULL, NULL);
    return at->extent > 0.0 ? height / at->extent : height;
}

/* The same as a bound: where nothing is asked there is none, unless a load is not held. */
static double bound_of(const Level *at, double reach) {
    return at->extent > 0.0 ? reach : reach < 0.0 ? 0.0 : INFINITY;
}

Status spans_quality(SpanSearch *s, int piece, double share, double *quality, double *normal) {
    ForceSet set = at_share(s, piece, share);
    double start[2][3], low[2] = {INFINITY, INFINITY}, bound;
    int starts = 0;
    for (int k = 0; k < s->count; k++) {
        double value = bound_of(s->pool + k, reach_of(s, s->pool + k, &set));
        int at = value < low[0] ? 0 : value < low[1] ? 1 : 2;
        if (at == 2)
            continue;
        if (at == 0) {
            memcpy(start[1], start[0], sizeof start[0]);
            low[1] = low[0];
        }
        memcpy(start[at], s->pool[k].normal, sizeof start[0]);
        low[at] = value;
        starts = starts < 2 ? starts + 1 : 2;
    }
    charge(&s->work, PASS * s->count);
    return sets_search(s->sets, &set, EXACT, INFINITY, start[0], starts, &s->work, quality, &bound,
                       normal);
}

/* -- bounds --------------------------------------------------------------------------------------- */

/* Bound a span by chords: find the share at which the least of them is greatest, and the two that meet
 * there. Writes them to the span. */
static void by_chords(const SpanSearch *s, Span *span, const double *a, const double *b) {
    int rising = -1, falling = -1;
    double x = 0.0, value;
    for (int k = 0; k < s->count; k++) {
        if (a[k] < INFINITY && (rising < 0 || a[k] < a[rising] || (a[k] == a[rising] && b[k] < b[rising])))
            rising = k;
        if (b[k] < INFINITY && (falling < 0 || b[k] < b[falling] || (b[k] == b[falling] && a[k] < a[falling])))
            falling = k;
    }
    span->kind = CHORDS;
    span->terms = 0;
    span->ask = 0.5;
    span->bound = INFINITY;
    if (rising < 0)
        return;
    if (b[rising] <= a[rising] || a[falling] <= b[falling]) { /* one chord is the least, from end to end */
        int at_first = b[rising] <= a[rising], one = at_first ? rising : falling;
        span->bound = at_first ? a[one] : b[one];
        span->ask = a[one] == b[one] ? 0.5 : at_first ? 0.0 : 1.0;
        span->terms = 1;
        span->weight[0] = 1.0;
        memcpy(span->normal[0], s->pool[one].normal, sizeof span->normal[0]);
        return;
    }
    for (int turn = 0; turn <= s->count; turn++) {
        double up = b[rising] - a[rising], down = a[falling] - b[falling];
        x = (a[falling] - a[rising]) / (up + down);
        value = between(a[rising], b[rising], x);
        int least = -1;
        double lowest = value - 1e-15 * fabs(value);
        for (int k = 0; k < s->count; k++)
            if (a[k] < INFINITY && between(a[k], b[k], x) < lowest) {
                lowest = between(a[k], b[k], x);
                least = k;
            }
        if (least < 0)
            break;
        if (b[least] > a[least])
            rising = least;
        else
            falling = least;
        if (b[least] == a[least])
            rising = least; /* flat: it ends here */
        if (b[least] == a[least])
            break;
    }
    double up = b[rising] - a[rising], down = a[falling] - b[falling];
    double share = up + down > 0.0 ? down / (up + down) : 1.0; /* of the rising one: the mixture is flat */
    span->ask = x;
    span->terms = 2;
    span->weight[0] = share;
    span->weight[1] = 1.0 - share;
    memcpy(span->normal[0], s->pool[rising].normal, sizeof span->normal[0]);
    memcpy(span->normal[1], s->pool[falling].normal, sizeof span->normal[1]);
    span->bound = larger(share * a[rising] + (1.0 - share) * a[falling],
                         share * b[rising] + (1.0 - share) * b[falling]);
}

/* Bound it by a normal that turns on the way, of either sign of the torque. */
static void by_travelling(const SpanSearch *s, Span *span, const double *a, const double *b) {
    double bound = 0.0;
    int pair[2][2];
    for (int sign = 0; sign < 2; sign++) {
        int first = -1, last = -1;
        for (int k = 0; k < s->count; k++) {
            if ((sign ? -s->pool[k].normal[2] : s->pool[k].normal[2]) <= 0.0)
                continue;
            if (first < 0 || a[k] < a[first])
                first = k;
            if (last < 0 || b[k] < b[last])
                last = k;
        }
        pair[sign][0] = first;
        pair[sign][1] = last;
    }
    bound = span->bound;
    for (int sign = 0; sign < 2; sign++) {
        int first = pair[sign][0], last = pair[sign][1];
        if (first < 0 || first == last)
            continue;
        const Level *one = s->pool + first, *other = s->pool + last;
        double sum[3], far[3];
        for (int k = 0; k < 3; k++)
            sum[k] = one->normal[k] + other->normal[k];
        sets_farthest(s->sets, sum, far);
        double along_one = dot(far, one->normal), along_other = dot(far, other->normal);
        if (!(along_one > STEEP * one->extent && along_other > STEEP * other->extent)
            || one->extent == 0.0 || other->extent == 0.0)
            continue;
        double found = larger(larger(a[first] * one->extent / along_one,
                                     b[last] * other->extent / along_other), 0.0);
        if (!(found < bound))
            continue;
        bound = found;
        span->kind = TRAVELLING_NORMAL;
        span->terms = 2;
        span->weight[0] = span->weight[1] = 1.0;
        memcpy(span->normal[0], s->pool[first].normal, sizeof span->normal[0]);
        memcpy(span->normal[1], s->pool[last].normal, sizeof span->normal[1]);
    }
    span->bound = bound;
}

/* Bound a span by all normals met, and no worse than before: `known` is 0 if it was not bounded. */
static Status bound_span(SpanSearch *s, Span *span) {
    double before = span->known ? span->bound : INFINITY;
    Span was = *span;
    if (s->line_room < s->count) {
        double *grown = realloc(s->line, 2 * (size_t)s->room * sizeof *grown);
        if (!grown)
            return NO_MEMORY;
        s->line = grown;
        s->line_room = s->room;
    }
    double *a = s->line, *b = s->line + s->line_room;
    ForceSet first = at_share(s, span->piece, span->from), last = at_share(s, span->piece, span->to);
    for (int k = 0; k < s->count; k++) {
        a[k] = reach_of(s, s->pool + k, &first);
        b[k] = span->from < span->to ? reach_of(s, s->pool + k, &last) : a[k];
        if (s->pool[k].extent == 0.0)
            a[k] = b[k] = bound_of(s->pool + k, larger(a[k], b[k]));
    }
    by_chords(s, span, a, b);
    double ask = between(span->from, span->to, span->ask);
    if (s->may_travel)
        by_travelling(s, span, a, b);
    if (before < span->bound) {
        *span = was;
        span->bound = before;
    }
    if (s->least_cap < span->bound) { /* no newcomer does better, anywhere */
        span->bound = s->least_cap;
        span->kind = CHORDS;
        span->terms = 1;
        span->weight[0] = 1.0;
        memcpy(span->normal[0], s->pool[s->capped].normal, sizeof span->normal[0]);
    }
    span->ask = ask;
    span->known = s->count;
    return spend(&s->work, 2.0 * PASS * s->count);
}

/* -- the search ----------------------------------------------------------------------------------- */

static Status put_closed(SpanSearch *s, const Span *span) {
    if (!has_room((void **)&s->closed, &s->closed_room, s->closes, sizeof *s->closed))
        return NO_MEMORY;
    s->closed[s->closes++] = *span;
    return SOLVED;
}

static Status put_open(SpanSearch *s, const Span *span) {
    if (!has_room((void **)&s->open, &s->open_room, s->opens, sizeof *s->open))
        return NO_MEMORY;
    int k = s->opens++;
    for (; k > 0 && s->open[(k - 1) / 2].bound < span->bound; k = (k - 1) / 2)
        s->open[k] = s->open[(k - 1) / 2];
    s->open[k] = *span;
    return SOLVED;
}

static Span take_open(SpanSearch *s) {
    Span top = s->open[0], last = s->open[--s->opens];
    int k = 0;
    for (int child; (child = 2 * k + 1) < s->opens; k = child) {
        if (child + 1 < s->opens && s->open[child + 1].bound > s->open[child].bound)
            child++;
        if (s->open[child].bound <= last.bound)
            break;
        s->open[k] = s->open[child];
    }
    if (s->opens)
        s->open[k] = last;
    return top;
}

/* What a bound may be for a span to be closed. */
static double enough_for(const SpanSearch *s, const Stand *best, double gap) {
    double most = best->quality + larger(gap * best->quality, FLOOR * s->size);
    return larger(most, NOTHING * ZERO * s->size);
}

static Status put_span(SpanSearch *s, Span *span, double enough) {
    Status status = bound_span(s, span), put;
    if (is_fault(status))
        return status;
    put = span->bound <= enough ? put_closed(s, span) : put_open(s, span);
    return put == SOLVED ? status : put;
}

/* Ask the quality where a span looks best. */
static Status ask(SpanSearch *s, const Span *span, Stand *best) {
    double quality, normal[3];
    Status status = spans_quality(s, span->piece, span->ask, &quality, normal);
    s->asks--;
    if (status != SOLVED)
        return status;
    if (quality > best->quality)
        *best = (Stand){quality, span->ask, span->piece};
    status = meet(s, normal);
    if (s->strength > STRONG * s->sets->weight && !is_fault(status))
        status = meet_poles(s, span->piece, span->ask);
    return status;
}

Status spans_solve(SpanSearch *s, const char *chosen, double gap, int asks, Stand *best) {
    Status status = SOLVED;
    *best = (Stand){.quality = s->quality, .piece = -1};
    s->opens = s->closes = 0;
    s->asks = asks;
    for (int k = 0; k < s->many && !is_fault(status); k++) {
        const double *p = s->ends + 4 * (ptrdiff_t)k;
        Span span = {.piece = k, .to = p[0] == p[2] && p[1] == p[3] ? 0.0 : 1.0};
        if (!chosen || chosen[k])
            status = put_span(s, &span, enough_for(s, best, gap));
    }
    while (status == SOLVED && s->opens && s->open[0].bound > enough_for(s, best, gap)) {
        Span span = take_open(s), halves[2];
        if (span.known < s->count) {
            status = put_span(s, &span, enough_for(s, best, gap));
            continue;
        }
        if (s->asks <= 0) {
            put_open(s, &span); /* there is room: it came from there */
            status = OUT_OF_BUDGET;
            break;
        }
        double width = span.to - span.from, inner = INNER * width;
        int end = span.ask < span.from + inner ? 0 : span.ask > span.to - inner ? 1 : 2;
        if (width > SMALLEST && end < 2 && !span.asked[end]) {
            span.ask = end ? span.to : span.from;
            span.asked[end] = 1;
            status = ask(s, &span, best);
            Status put = status == SOLVED ? put_span(s, &span, enough_for(s, best, gap))
                                          : put_open(s, &span);
            status = is_fault(put) ? put : status;
            continue;
        }
        if (end < 2) /* it was asked there before */
            span.ask = between(span.from, span.to, 0.5);
        status = ask(s, &span, best);
        if (status != SOLVED || !(width > SMALLEST)) {
            if (status == SOLVED) {
                status = bound_span(s, &span);
                put_closed(s, &span); /* a point: its own normal bounds it now */
            } else {
                put_open(s, &span);
            }
            continue;
        }
        if (span.kind == TRAVELLING_NORMAL)
            span.known = 0; /* that bounds the whole only */
        halves[0] = halves[1] = span;
        halves[0].to = halves[1].from = span.ask;
        halves[0].asked[1] = halves[1].asked[0] = 1;
        for (int k = 0; k < 2 && !is_fault(status); k++)
            status = put_span(s, halves + k, enough_for(s, best, gap));
    }
    for (int k = 0; k < s->opens && !is_fault(status); k++) {
        Status put = put_closed(s, s->open + k);
        status = put == SOLVED ? status : put;
    }
    s->opens = 0;
    return status;
}
