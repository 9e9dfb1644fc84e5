/* Computes errors, orders and times from the runs of a study. */
#include "program/study/result/result.h"
#include "base/arena.h"
#include "program/study/result/order.h"
#include "program/study/result/statistic.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* An extrapolation is used only if its order is at least this. */
static const double order_low = 0.5;

static int levels_of(const struct study_result *r) { return r->plan->study->levels.n; }
static int methods_of(const struct study_result *r) { return r->plan->study->methods.n; }

const struct study_point *study_result_point(const struct study_result *r, const struct study_table *t, int method,
                                             int level) {
    return &t->point[method * levels_of(r) + level];
}

/* Collects a number from all repeats that have finished, in ascending order. Returns how many there are. */
struct column {
    int n;
    double *x; /* [repeats] work */
};

static void gather(struct column *c, const struct study_plan *p, int at, int quantity,
                   double (*value_at)(const struct study_run *run, int quantity)) {
    c->n = 0;
    for (int i = at; i < p->runs; i += p->cases) {
        const double x = p->run[i].outcome.state == STUDY_DONE ? value_at(&p->run[i], quantity) : NAN;
        if (isfinite(x)) c->x[c->n++] = x;
    }
    study_statistic_sort(c->n, c->x);
}

static double value_of(const struct study_run *run, int q) { return run->value[q]; }
static double wall_of(const struct study_run *run, int q) { return (void)q, run->outcome.wall; }
static double setup_of(const struct study_run *run, int q) { return (void)q, run->outcome.setup; }
static double cell_of(const struct study_run *run, int q) { return (void)q, run->outcome.cell_step; }
static double bond_of(const struct study_run *run, int q) { return (void)q, run->outcome.bond_sweep; }
static double memory_of(const struct study_run *run, int q) { return (void)q, run->outcome.memory; }

static double median(const struct column *c) { return study_statistic_quantile(c->n, c->x, 0.5); }

static const double quantile[STUDY_BAND_ENDS] = {
    [STUDY_LEAST] = 0, [STUDY_LOWER] = 0.25, [STUDY_UPPER] = 0.75, [STUDY_MOST] = 1};

static void point_fill(struct study_point *p, const struct study_plan *plan, int at, int quantity, struct column *c) {
    *p = (struct study_point){.ranks = plan->at[at].ranks, .error = NAN, .relative = NAN, .order = NAN};
    for (int i = at; i < plan->runs; i += plan->cases) {
        const struct study_outcome *o = &plan->run[i].outcome;
        if (o->state == STUDY_DONE) {
            p->state = STUDY_DONE;
            p->steps = o->steps;
        } else if (o->state == STUDY_FAILED) {
            if (p->state != STUDY_DONE) p->state = STUDY_FAILED;
            p->exit_code = o->exit_code;
        }
        p->failed += o->state == STUDY_FAILED;
        p->unmade += o->state == STUDY_TODO || o->state == STUDY_SKIPPED;
    }
    gather(c, plan, at, quantity, wall_of);
    p->wall = median(c);
    p->wall_min = study_statistic_quantile(c->n, c->x, 0);
    p->wall_iqr =
        c->n < 2 ? NAN : study_statistic_quantile(c->n, c->x, 0.75) - study_statistic_quantile(c->n, c->x, 0.25);
    gather(c, plan, at, quantity, setup_of);
    p->setup = median(c);
    gather(c, plan, at, quantity, cell_of);
    p->cell_step = median(c);
    gather(c, plan, at, quantity, bond_of);
    p->bond_sweep = median(c);
    gather(c, plan, at, quantity, memory_of);
    p->memory = study_statistic_quantile(c->n, c->x, 1);
    gather(c, plan, at, quantity, value_of);
    p->value = median(c);
    p->repeats = c->n;
    for (int e = 0; e < STUDY_BAND_ENDS; e++) p->band[e] = study_statistic_quantile(c->n, c->x, quantile[e]);
    p->spread = p->band[STUDY_MOST] - p->band[STUDY_LEAST];
    p->mean = study_statistic_mean(c->n, c->x);
    p->deviation = study_statistic_deviation(c->n, c->x);
    if (plan->study->members.n == 0 || plan->study->is_sweep) return;
    p->value = p->mean;
    p->spread = p->deviation;
}

/* The finest levels of a method that have finished with a value: [3], the finest first. Returns how many there are. */
static int finest_of(const struct study_result *r, const struct study_table *t, int method, int level[3]) {
    int n = 0;
    for (int l = levels_of(r) - 1; l >= 0 && n < 3; l--)
        if (isfinite(study_result_point(r, t, method, l)->value)) level[n++] = l;
    return n;
}

static void richardson_fill(const struct study_result *r, struct study_table *t, int method) {
    struct study_curve *c = &t->curve[method];
    const double order = t->quantity->reference.order;
    double f[3], h[3];
    int level[3];
    const int n = finest_of(r, t, method, level);
    c->finest = n ? level[0] : -1;
    for (int k = 0; k < n; k++) {
        f[k] = study_result_point(r, t, method, level[k])->value;
        h[k] = r->plan->study->levels.variant[level[k]].size;
    }
    c->richardson = (struct study_richardson){STUDY_UNKNOWN, NAN, 0, NAN, NAN};
    if (n >= 2 && !isnan(order))
        c->richardson = study_richardson_two(f, h, order);
    else if (n == 3)
        c->richardson = study_richardson_three(f, h, t->quantity->reference.formal);
}

/* Half the range of the finest levels: the uncertainty of the finest one if no extrapolation is possible. */
static double half_range(const struct study_result *r, const struct study_table *t, int method) {
    int level[3];
    double low = INFINITY, high = -INFINITY;
    const int n = finest_of(r, t, method, level);
    for (int k = 0; k < n; k++) {
        const double f = study_result_point(r, t, method, level[k])->value;
        low = fmin(low, f);
        high = fmax(high, f);
    }
    return n > 1 ? 0.5 * (high - low) : NAN;
}

static void reference_finest(const struct study_result *r, struct study_table *t) {
    const struct study_reference *ref = &t->quantity->reference;
    for (int m = 0; ref->method && m < methods_of(r); m++)
        if (!strcmp(r->plan->study->methods.variant[m].name, ref->method)) t->method = m;
    if (!ref->method) t->method = 0;
    const struct study_curve *c = &t->curve[t->method];
    t->reference = t->uncertainty = NAN;
    if (c->finest < 0) return;
    const struct study_richardson *e = &c->richardson;
    t->extrapolated = e->kind == STUDY_MONOTONE && e->order >= order_low;
    t->reference = t->extrapolated ? e->extrapolated : study_result_point(r, t, t->method, c->finest)->value;
    t->uncertainty = t->extrapolated ? e->gci : half_range(r, t, t->method);
}

static void errors_fill(const struct study_result *r, struct study_table *t) {
    for (int m = 0; m < methods_of(r); m++)
        for (int l = 0; l < levels_of(r); l++) {
            struct study_point *p = &t->point[m * levels_of(r) + l];
            p->error = fabs(p->value - t->reference);
            p->relative = p->error / t->scale;
            p->resolved = p->error > (isnan(t->uncertainty) ? 0 : t->uncertainty);
        }
}

/* Orders, from the errors that the reference resolves. */
static void orders_fill(const struct study_result *r, struct study_table *t, int m, double *work) {
    const int levels = levels_of(r);
    double *const size = work, *const error = work + levels, *const time = work + 2 * levels;
    struct study_point *last = NULL;
    double size_last = NAN;
    for (int l = 0; l < levels; l++) {
        struct study_point *p = &t->point[m * levels + l];
        size[l] = r->plan->study->levels.variant[l].size;
        error[l] = p->resolved ? p->error : NAN;
        time[l] = p->wall;
        if (isnan(error[l])) continue;
        if (last) p->order = study_order_between(last->error, p->error, size_last, size[l]);
        last = p;
        size_last = size[l];
    }
    t->curve[m].order = study_order_fit(levels, size, error);
    t->curve[m].gain = study_order_fit(levels, time, error);
}

static void table_fill(const struct study_result *r, struct study_table *t) {
    const struct study_reference *ref = &t->quantity->reference;
    for (int m = 0; m < methods_of(r); m++) richardson_fill(r, t, m);
    t->method = -1;
    t->reference = ref->value;
    t->uncertainty = ref->uncertainty;
    if (ref->kind == STUDY_REFERENCE_FINEST) reference_finest(r, t);
    t->has_scale = !isnan(ref->scale) || t->reference != 0;
    t->scale = !isnan(ref->scale) ? ref->scale : t->has_scale ? fabs(t->reference) : 1;
    errors_fill(r, t);
    double *work = arena_new(3 * (size_t)levels_of(r), sizeof *work);
    for (int m = 0; m < methods_of(r); m++) orders_fill(r, t, m, work);
}

struct study_result *study_result_new(const struct study_plan *plan) {
    const struct study *s = plan->study;
    struct study_result *r = arena_new(1, sizeof *r);
    struct column c = {0, arena_new((size_t)s->repeats, sizeof(double))};
    r->plan = plan;
    r->tables = s->quantities;
    r->table = arena_new((size_t)r->tables, sizeof *r->table);
    for (int q = 0; q < r->tables; q++) {
        struct study_table *t = &r->table[q];
        t->quantity = &s->quantity[q];
        t->curve = arena_new((size_t)s->methods.n, sizeof *t->curve);
        t->point = arena_new((size_t)plan->cases, sizeof *t->point);
        for (int at = 0; at < plan->cases; at++)
            point_fill(&t->point[plan->at[at].method * s->levels.n + plan->at[at].level], plan, at, q, &c);
        if (!s->is_sweep) table_fill(r, t);
    }
    return r;
}

void study_result_curve(const struct study_result *r, const struct study_table *t, int method, double *error,
                        double *time) {
    for (int l = 0; l < levels_of(r); l++) {
        const struct study_point *p = study_result_point(r, t, method, l);
        error[l] = p->relative;
        time[l] = p->wall;
    }
}
