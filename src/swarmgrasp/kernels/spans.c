/* A newcomer that keeps its whole force set by branch and bound over spans of the boundary (T22). Trusted are
 * pieces as `Pieces` makes them, and elements that go once around. */
#include <stdlib.h>
#include <string.h>

#include "place.h"
#include "quality.h"
#include "spans.h"

#define STARTS 2      /* normals at which a quality begins */
#define INNER 0.1     /* share of a span within which it is not cut near its ends */
#define STRONG 0.3    /* of the swarm's size: from this strength on a newcomer's own poles matter */
#define PASS 12.0     /* units of work that a normal takes on a span */
#define STEEP 0.01    /* share of D, along each of two normals, below which none travels between them */

/* The newcomer on a piece, at a share of the way. */
static ForceSet at_share(const SpanSearch *s, int piece, double share) {
    ForceSet set = s->set[piece];
    arm_at(s->ends + 4 * (ptrdiff_t)piece, share, set.arm);
    return set;
}

/* -- what is known ------------------------------------------------------------------------------ */

/* Of a newcomer beside which the others are weak, add the two normals along which it exerts nothing. */
static Status meet_poles(SpanSearch *s, int piece, double share) {
    ForceSet set = at_share(s, piece, share);
    const double *scale = s->pool.sets->scale;
    double pole[3] = {scale[2] / scale[0] * set.arm[1], -scale[2] / scale[1] * set.arm[0], 1.0};
    double size = length(pole);
    Status status = SOLVED;
    for (int sign = 1; sign >= -1 && !is_fault(status); sign -= 2) {
        double normal[3];
        for (int k = 0; k < 3; k++)
            normal[k] = sign * pole[k] / size;
        status = pool_meet(&s->pool, normal);
    }
    return status;
}

Status spans_begin(SpanSearch *s, const Sets *sets, const double *ends, int many,
                   const double *rows, const double *counts, double units,
                   int (*interrupted)(void)) {
    *s = (SpanSearch){.ends = ends, .many = many,
                      .may_travel = sets->losing == 0 && sets->failures <= 1};
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
    return pool_begin(&s->pool, sets, s->strength, units, interrupted);
}

void spans_end(SpanSearch *s) {
    void *all[] = {s->set, s->element, s->span, s->line};
    pool_end(&s->pool);
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        free(all[k]);
}

/* The quality that a normal met allows with a newcomer. */
static double reach_of(const SpanSearch *s, const Known *at, const ForceSet *set) {
    double p[2];
    lever(s->pool.sets->scale, set->arm, at->normal, p);
    return allowed(at, at->height + support(set, p, NULL, NULL));
}

Status spans_quality(SpanSearch *s, int piece, double share, double enough, double *quality,
                     double *normal) {
    ForceSet set = at_share(s, piece, share);
    double start[STARTS][3], low[STARTS], bound;
    int kept[STARTS], starts = 0;
    for (int k = 0; k < s->pool.count; k++) {
        double value = reach_of(s, s->pool.row + k, &set);
        if (value < INFINITY)
            starts = keep_lowest(kept, low, starts, STARTS, k, value);
    }
    for (int k = 0; k < starts; k++)
        memcpy(start[k], s->pool.row[kept[k]].normal, sizeof start[k]);
    charge(&s->pool.work, PASS * s->pool.count);
    if (starts && low[0] < enough) {
        *quality = larger(0.0, low[0]);
        memcpy(normal, start[0], sizeof start[0]);
        return SOLVED;
    }
    return sets_search(s->pool.sets, &set, EXACT, INFINITY, enough, start[0], starts, &s->pool.work, quality, &bound,
                       normal);
}

void spans_gains(const SpanSearch *s, int piece, double share, const double *normals, int many,
                 double *gains) {
    ForceSet set = at_share(s, piece, share);
    for (int k = 0; k < many; k++)
        gains[k] = exert(s->pool.sets->scale, &set, normals + 3 * (ptrdiff_t)k, NULL, NULL, NULL);
}

/* -- bounds --------------------------------------------------------------------------------------- */

/* Bound a span by chords: find the share at which the least of them is greatest, and the two that meet
 * there. Writes them to the span. */
static void by_chords(const SpanSearch *s, Span *span, const double *a, const double *b) {
    int rising = -1, falling = -1;
    double x = 0.0, value;
    for (int k = 0; k < s->pool.count; k++) {
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
        memcpy(span->normal[0], s->pool.row[one].normal, sizeof span->normal[0]);
        return;
    }
    for (int turn = 0; turn <= s->pool.count; turn++) {
        double up = b[rising] - a[rising], down = a[falling] - b[falling];
        x = (a[falling] - a[rising]) / (up + down);
        value = between(a[rising], b[rising], x);
        int least = -1;
        double lowest = value - 1e-15 * fabs(value);
        for (int k = 0; k < s->pool.count; k++)
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
    memcpy(span->normal[0], s->pool.row[rising].normal, sizeof span->normal[0]);
    memcpy(span->normal[1], s->pool.row[falling].normal, sizeof span->normal[1]);
    span->bound = larger(share * a[rising] + (1.0 - share) * a[falling],
                         share * b[rising] + (1.0 - share) * b[falling]);
}

/* Bound it by a normal that turns on the way, of either sign of the torque. */
static void by_travelling(const SpanSearch *s, Span *span, const double *a, const double *b) {
    double bound = 0.0;
    int pair[2][2];
    for (int sign = 0; sign < 2; sign++) {
        int first = -1, last = -1;
        for (int k = 0; k < s->pool.count; k++) {
            if ((sign ? -s->pool.row[k].normal[2] : s->pool.row[k].normal[2]) <= 0.0)
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
        const Known *one = s->pool.row + first, *other = s->pool.row + last;
        double sum[3], far[3];
        for (int k = 0; k < 3; k++)
            sum[k] = one->normal[k] + other->normal[k];
        sets_farthest(s->pool.sets, sum, far);
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
        memcpy(span->normal[0], s->pool.row[first].normal, sizeof span->normal[0]);
        memcpy(span->normal[1], s->pool.row[last].normal, sizeof span->normal[1]);
    }
    span->bound = bound;
}

/* Bound a span by all normals met, and no worse than before: `known` is 0 if it was not bounded. */
static Status bound_span(SpanSearch *s, Span *span) {
    double before = span->known ? span->bound : INFINITY;
    Span was = *span;
    if (s->line_room < s->pool.count) {
        double *grown = realloc(s->line, 2 * (size_t)s->pool.room * sizeof *grown);
        if (!grown)
            return NO_MEMORY;
        s->line = grown;
        s->line_room = s->pool.room;
    }
    double *a = s->line, *b = s->line + s->line_room;
    ForceSet first = at_share(s, span->piece, span->from), last = at_share(s, span->piece, span->to);
    for (int k = 0; k < s->pool.count; k++) {
        a[k] = reach_of(s, s->pool.row + k, &first);
        b[k] = span->from < span->to ? reach_of(s, s->pool.row + k, &last) : a[k];
        if (s->pool.row[k].extent == 0.0)
            a[k] = b[k] = larger(a[k], b[k]);
    }
    by_chords(s, span, a, b);
    double ask = between(span->from, span->to, span->ask);
    if (s->may_travel)
        by_travelling(s, span, a, b);
    if (before < span->bound) {
        *span = was;
        span->bound = before;
    }
    if (s->pool.least_cap < span->bound) { /* no newcomer does better, anywhere */
        span->bound = s->pool.least_cap;
        span->kind = CHORDS;
        span->terms = 1;
        span->weight[0] = 1.0;
        memcpy(span->normal[0], s->pool.row[s->pool.capped].normal, sizeof span->normal[0]);
    }
    span->ask = ask;
    span->known = s->pool.count;
    return spend(&s->pool.work, 2.0 * PASS * s->pool.count);
}

/* -- the search ----------------------------------------------------------------------------------- */

/* Bound a span, and open it if that is too much. */
static Status put_span(SpanSearch *s, int at, double enough) {
    Span *span = s->span + at;
    Status status = bound_span(s, span), put;
    if (is_fault(status) || span->bound <= enough)
        return status;
    put = pool_open(&s->pool, span->bound, at);
    return put == SOLVED ? status : put;
}

/* The same with one more. */
static Status add_span(SpanSearch *s, const Span *span, double enough) {
    if (!has_room((void **)&s->span, &s->span_room, s->spans, sizeof *s->span))
        return NO_MEMORY;
    s->span[s->spans] = *span;
    return put_span(s, s->spans++, enough);
}

/* Ask the quality where a span looks best. */
static Status ask(SpanSearch *s, const Span *span, Stand *best) {
    double quality, normal[3];
    Status status = spans_quality(s, span->piece, span->ask, best->quality, &quality, normal);
    s->pool.asks--;
    if (status != SOLVED)
        return status;
    if (quality > best->quality)
        *best = (Stand){quality, span->ask, span->piece};
    status = pool_meet(&s->pool, normal);
    if (s->strength > STRONG * s->pool.sets->weight && !is_fault(status))
        status = meet_poles(s, span->piece, span->ask);
    return status;
}

/* Ask where a span looks best; near an end, at that end, if it was not asked there before. Returns whether
 * the span was asked inside, to be cut there. */
static Status ask_span(SpanSearch *s, Span *span, Stand *best, int *is_inside) {
    double width = span->to - span->from, inner = INNER * width;
    int end = span->ask < span->from + inner ? 0 : span->ask > span->to - inner ? 1 : 2;
    *is_inside = end == 2 || !(width > SMALLEST_PART) || span->asked[end];
    if (!*is_inside) {
        span->ask = end ? span->to : span->from;
        span->asked[end] = 1;
    } else if (end < 2) {
        span->ask = between(span->from, span->to, 0.5);
    }
    return ask(s, span, best);
}

Status spans_solve(SpanSearch *s, const char *chosen, double gap, int asks, Stand *best) {
    Pool *pool = &s->pool;
    *best = (Stand){.quality = pool->quality, .piece = -1};
    s->spans = pool->opens = 0;
    pool->asks = asks;
    double enough = enough_for(pool, best->quality, gap);
    Status status = SOLVED;
    for (int k = 0; k < s->many && !is_fault(status); k++) {
        const double *p = s->ends + 4 * (ptrdiff_t)k;
        Span span = {.piece = k, .to = p[0] == p[2] && p[1] == p[3] ? 0.0 : 1.0};
        if (!chosen || chosen[k])
            status = add_span(s, &span, enough);
    }
    while (status == SOLVED && pool->opens && pool->open[0].bound > enough) {
        int at = pool_take(pool), is_inside;
        Span *span = s->span + at;
        if (span->known < pool->count) {
            status = put_span(s, at, enough);
            continue;
        }
        if (pool->asks <= 0)
            return OUT_OF_BUDGET;
        status = ask_span(s, span, best, &is_inside);
        enough = enough_for(pool, best->quality, gap);
        if (status != SOLVED)
            break;
        if (!is_inside) {
            status = put_span(s, at, enough);
            continue;
        }
        if (!(span->to - span->from > SMALLEST_PART)) {
            status = bound_span(s, span); /* a point: its own normal bounds it now */
            continue;
        }
        if (span->kind == TRAVELLING_NORMAL)
            span->known = 0; /* that bounds the whole only */
        Span half = *span;
        span->to = half.from = half.ask;
        span->asked[1] = half.asked[0] = 1;
        status = put_span(s, at, enough);
        if (!is_fault(status))
            status = add_span(s, &half, enough);
    }
    return status;
}
