/* Keeps the clocks at the beginning of every span of a run, and writes the timeline to run.json. */
#include "program/output/timeline.h"
#include "base/clock.h"
#include "base/ensure.h"
#include "base/par.h"

#include <math.h>
#include <stdlib.h>

/* Up to so many ranks are written one by one. */
enum { RANKS_SHOWN = 64 };

enum kind { WORKING, WAITING, KINDS };
static const char *const kind_name[KINDS] = {"working", "waiting"};

struct reading {
    double seconds[CLOCK_ALL][KINDS]; /* s */
};

struct span {
    const char *name;
    long step;             /* at its beginning */
    struct reading before; /* this rank's clocks at its beginning */
    struct reading mean;   /* its seconds, mean over the ranks, when they were collected */
};

struct timeline {
    int spans, capacity;
    struct span *span;
    long step;                        /* when it was collected */
    struct reading mean, least, most; /* of the whole run, over the ranks */
    double wall;                      /* s, the largest of the ranks */
    struct reading *rank;             /* [ranks] on rank 0; NULL: too many */
};

static void read_clocks(struct reading *r) {
    clock_count();
    for (int p = 0; p < CLOCK_ALL; p++) {
        r->seconds[p][WAITING] = clock_waiting((enum clock_part)p);
        r->seconds[p][WORKING] = fmax(clock_seconds((enum clock_part)p) - r->seconds[p][WAITING], 0); /* rounding */
    }
}

struct timeline *timeline_new(void) {
    struct timeline *t = calloc(1, sizeof *t);
    ENSURE(t, "no memory for %zu bytes", sizeof *t);
    timeline_span(t, "set-up", 0);
    return t;
}

void timeline_free(struct timeline *t) {
    if (!t) return;
    free(t->span);
    free(t->rank);
    free(t);
}

void timeline_span(struct timeline *t, const char *name, long step) {
    if (t->spans == t->capacity) {
        t->capacity = 2 * t->capacity + 4;
        t->span = realloc(t->span, (size_t)t->capacity * sizeof *t->span);
        ENSURE(t->span, "no memory for %d spans", t->capacity);
    }
    struct span *s = &t->span[t->spans++];
    *s = (struct span){.name = name, .step = step};
    if (t->spans > 1) read_clocks(&s->before); /* the set-up begins with clocks at 0 */
}

static double sum_of(const struct reading *r, int part) {
    return r->seconds[part][WORKING] + r->seconds[part][WAITING];
}

static double whole(const struct reading *r) {
    double sum = 0;
    for (int p = 0; p < CLOCK_PARTS; p++) sum += sum_of(r, p);
    return sum;
}

static void mean_of(struct reading *r) {
    par_sum_array(&r->seconds[0][0], CLOCK_ALL * KINDS);
    for (int p = 0; p < CLOCK_ALL; p++)
        for (int k = 0; k < KINDS; k++) r->seconds[p][k] /= par_size();
}

void timeline_collect(struct timeline *t, long step) {
    struct reading now;
    read_clocks(&now);
    t->step = step;
    t->wall = par_max(whole(&now));
    for (int s = 0; s < t->spans; s++) {
        const struct reading *end = s + 1 < t->spans ? &t->span[s + 1].before : &now;
        for (int p = 0; p < CLOCK_ALL; p++)
            for (int k = 0; k < KINDS; k++)
                t->span[s].mean.seconds[p][k] = end->seconds[p][k] - t->span[s].before.seconds[p][k];
        mean_of(&t->span[s].mean);
    }
    t->mean = t->least = t->most = now;
    mean_of(&t->mean);
    par_min_array(&t->least.seconds[0][0], CLOCK_ALL * KINDS);
    par_max_array(&t->most.seconds[0][0], CLOCK_ALL * KINDS);
    if (par_size() > RANKS_SHOWN) return;
    if (!t->rank) t->rank = malloc((size_t)par_size() * sizeof *t->rank);
    ENSURE(t->rank, "no memory for %d ranks", par_size());
    par_gather(&now, sizeof now, t->rank);
}

double timeline_seconds(const struct timeline *t, int part) { return sum_of(&t->mean, part); }

double timeline_wall(const struct timeline *t) { return t->wall; }

double timeline_last(const struct timeline *t) { return whole(&t->span[t->spans - 1].mean); }

static void write_ranks(const struct timeline *t, struct json *j, int p, int kind) {
    json_object(j, kind_name[kind]);
    json_number(j, "least", t->least.seconds[p][kind]);
    json_number(j, "mean", t->mean.seconds[p][kind]);
    json_number(j, "most", t->most.seconds[p][kind]);
    if (t->rank) {
        json_array(j, "by_rank");
        for (int k = 0; k < par_size(); k++) json_number(j, NULL, t->rank[k].seconds[p][kind]);
        json_close(j);
    }
    json_close(j);
}

static void write_span(const struct timeline *t, struct json *j, int s) {
    const struct span *span = &t->span[s];
    json_object(j, NULL);
    json_text(j, "span", span->name);
    json_long(j, "steps", (s + 1 < t->spans ? span[1].step : t->step) - span->step);
    json_number(j, "seconds", whole(&span->mean));
    for (int k = 0; k < KINDS; k++) {
        json_object(j, kind_name[k]);
        for (int p = 0; p < CLOCK_PARTS; p++)
            if (sum_of(&t->most, p) > 0) json_number(j, clock_name((enum clock_part)p), span->mean.seconds[p][k]);
        json_close(j);
    }
    json_object(j, "details");
    for (int p = CLOCK_PARTS; p < CLOCK_ALL; p++)
        if (sum_of(&t->most, p) > 0) json_number(j, clock_name((enum clock_part)p), sum_of(&span->mean, p));
    json_close(j);
    json_close(j);
}

void timeline_write(const struct timeline *t, struct json *j) {
    json_object(j, "setup_seconds_by_phase");
    for (int p = 0; p < CLOCK_PHASES; p++)
        json_number(j, clock_phase_name((enum clock_phase)p), clock_phase_seconds((enum clock_phase)p));
    json_close(j);
    json_object(j, "seconds_by_part_and_rank");
    for (int p = 0; p < CLOCK_PARTS; p++) {
        if (!(sum_of(&t->most, p) > 0)) continue;
        json_object(j, clock_name((enum clock_part)p));
        for (int k = 0; k < KINDS; k++) write_ranks(t, j, p, k);
        json_close(j);
    }
    json_close(j);
    json_array(j, "timeline");
    for (int s = 0; s < t->spans; s++) write_span(t, j, s);
    json_close(j);
}
