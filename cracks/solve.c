/* The pressures of one substep: conjugate gradients within an active set. */
#include "cracks/solve.h"
#include "base/memory.h"
#include "base/par.h"
#include "cracks/coarse.h"
#include "cracks/precondition.h"
#include "cracks/struts.h"
#include "cracks/sums.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    SETS_MAX = 200,        /* changes of the set in a substep */
    ITERATIONS_MAX = 20000 /* in all of them */
};

/* The sum of the full particles' |residual|, over that at the start of the substep and what is injected. What is left
 * is a source of the next substep, and its sum is 0. A larger number would do for the volume, but pressures that hardly
 * push (one sign above a crack, the other below) would be noise. */
static const double TOLERANCE = 1e-7;
/* The same over the volumes whose difference it is: what rounding leaves. */
static const double ROUNDING = 1e-15;

struct cracks_work *cracks_solve_workspace(struct cracks_work *w, const struct cracks_struts *t) {
    const long links = t->rows.n > 0 ? t->rows.link_start[t->rows.n] : 0;
    const int seats = CRACKS_LANES * t->rows.n;
    if (!w) w = memory_new(MEMORY_SOLID, 1, sizeof *w);
    if (t->n + t->ghosts + 1 > w->capacity) {
        const size_t n = (size_t)(t->n + t->ghosts) + (size_t)t->n / 4 + 64;
        w->set = memory_renew(MEMORY_SOLID, w->set, n, sizeof *w->set);
        w->ones_set = memory_renew(MEMORY_SOLID, w->ones_set, n, sizeof *w->ones_set);
        double **const array[] = {&w->b,     &w->residual, &w->width,   &w->diagonal,  &w->search,
                                  &w->along, &w->z,        &w->of_ones, &w->ones_stiff};
        for (size_t a = 0; a < sizeof array / sizeof array[0]; a++)
            *array[a] = memory_renew(MEMORY_SOLID, *array[a], n, sizeof **array[a]);
        cracks_vec **const vector[] = {&w->force, &w->u};
        for (size_t a = 0; a < sizeof vector / sizeof vector[0]; a++)
            *vector[a] = memory_renew(MEMORY_SOLID, *vector[a], n, sizeof **vector[a]);
        w->capacity = (int)n;
    }
    if (seats + 1 > w->slot_capacity) {
        const size_t n = (size_t)seats + (size_t)seats / 4 + 64;
        double **const array[] = {&w->outflow, &w->left, &w->weight, &w->change};
        for (size_t a = 0; a < sizeof array / sizeof array[0]; a++)
            *array[a] = memory_renew(MEMORY_SOLID, *array[a], n, sizeof **array[a]);
        w->slot_capacity = (int)n;
    }
    if (links + 1 > w->link_capacity) {
        const size_t n = (size_t)links + (size_t)links / 4 + 64;
        w->conductance = memory_renew(MEMORY_SOLID, w->conductance, CRACKS_LANES * n, sizeof *w->conductance);
        w->smooth = memory_renew(MEMORY_SOLID, w->smooth, CRACKS_LANES * n, sizeof *w->smooth);
        w->link_capacity = (long)n;
    }
    w->ones_hold = w->force_holds = 0;
    return w;
}

void cracks_solve_free(struct cracks_work *w) {
    if (!w) return;
    MEMORY_FREE(w->set, w->b, w->residual, w->conductance, w->smooth, w->outflow, w->width, w->diagonal, w->search,
                w->along, w->z, w->left, w->weight, w->change, w->of_ones, w->ones_stiff, w->force, w->ones_set, w->u);
    cracks_coarse_free(w->coarse);
    memory_free(w);
}

/* y = A p. Ghosts of p are updated. Returns p.y of this rank. */
static double apply(const struct cracks *c, double dt, double *p, double *y) {
    double sum = 0;
    cracks_sums_apply(c, dt, 1, p, y);
    for (int i = 0; i < c->struts.n; i++) {
        y[i] += c->storage[i] * p[i];
        sum += p[i] * y[i];
    }
    return sum;
}

/* The part of z along 1 in the sense of A, which the search does without, so that the sum of the residuals stays 0.
 * product: of r and z, on all ranks. */
static double part_along_ones(const struct cracks *c, double *product) {
    const struct cracks_work *w = c->work;
    double sum[2] = {0, 0};
    for (int i = 0; i < c->struts.n; i++) { /* z is 0 where a particle is not full */
        sum[0] += w->of_ones[i] * w->z[i];
        sum[1] += w->residual[i] * w->z[i];
    }
    par_sum_array(sum, 2);
    *product = sum[1];
    return w->ones > 0 ? sum[0] / w->ones : 0;
}

/* A 1 with 1 at the full particles. The part of the struts is kept as long as the set and the struts are the
 * same. */
static void ones_begin(struct cracks *c, double dt) {
    const int n = c->struts.n;
    struct cracks_work *w = c->work;
    const int same = w->ones_hold && w->ones_dt == dt && memcmp(w->ones_set, w->set, (size_t)n) == 0;
    double sum = 0;
    for (int i = 0; i < n; i++) w->search[i] = w->set[i] == CRACKS_FULL;
    if (par_min(same) < 1) {
        cracks_sums_apply(c, dt, 0, w->search, w->ones_stiff);
        memcpy(w->ones_set, w->set, (size_t)n);
        w->ones_hold = 1;
        w->ones_dt = dt;
    }
    cracks_struts_update(&c->struts, sizeof *w->search, w->search);
    for (int i = 0; i < n; i++) w->of_ones[i] = w->ones_stiff[i] + c->storage[i] * w->search[i];
    cracks_sums_flow(c, dt, w->search, w->of_ones);
    for (int i = 0; i < n; i++) sum += w->of_ones[i] * w->search[i];
    w->ones = par_sum(sum);
}

/* p and residual go on by a step along the search. Returns the sum of the full particles' |residual|, on all ranks. */
static double go(struct cracks *c, double step, const double *search, const double *along) {
    struct cracks_work *w = c->work;
    double sum = 0;
    for (int i = 0; i < c->struts.n; i++) {
        c->p[i] += step * search[i];
        w->residual[i] -= step * along[i];
        sum += w->set[i] == CRACKS_FULL ? fabs(w->residual[i]) : 0;
    }
    return par_sum(sum);
}

/* Moves all full pressures by one number, so that the sum of their residuals is 0: what was injected is in the cracks.
 * Returns the sum of their |residual|, on all ranks. */
static double level(struct cracks *c, double dt) {
    struct cracks_work *w = c->work;
    double sum = 0;
    ones_begin(c, dt);
    for (int i = 0; i < c->struts.n; i++)
        if (w->set[i] == CRACKS_FULL) sum += w->residual[i];
    sum = par_sum(sum);
    return go(c, w->ones > 0 ? sum / w->ones : 0, w->search, w->of_ones);
}

/* Conjugate gradients over the full particles until the sum of |residual| is at most `least`, with the sum of the
 * residuals at 0. Returns whether. */
static int iterate(struct cracks *c, double dt, double least, long *left) {
    const int n = c->struts.n;
    struct cracks_work *w = c->work;
    double sum = level(c, dt), old = 0;
    cracks_precondition_begin(c, dt);
    while (sum > least) {
        double product;
        cracks_precondition(c, dt);
        const double part = part_along_ones(c, &product), beta = old > 0 ? product / old : 0;
        if ((*left)-- == 0 || !isfinite(product)) return 0;
        for (int i = 0; i < n; i++) {
            const double z = w->set[i] == CRACKS_FULL ? w->z[i] - part : 0;
            w->search[i] = old > 0 ? z + beta * w->search[i] : z;
        }
        old = product;
        const double curvature = par_sum(apply(c, dt, w->search, w->along));
        if (!(curvature > 0)) return 0;
        sum = go(c, old / curvature, w->search, w->along);
        c->iterations++;
    }
    return 1;
}

/* Full particles below the least pressure become cavities; cavities with less than no void become full. Returns how
 * many changed, on all ranks. */
static long change_set(struct cracks *c, double dt, double least) {
    const int n = c->struts.n;
    struct cracks_work *w = c->work;
    double changed[2] = {0, 0};
    for (int i = 0; i < n; i++) {
        w->search[i] = 0;
        if (w->set[i] == CRACKS_FULL && c->p[i] < c->in.least_pressure) {
            w->set[i] = CRACKS_CAVITY;
            w->search[i] = c->in.least_pressure - c->p[i];
            changed[1]++;
        } else if (w->set[i] == CRACKS_CAVITY && w->residual[i] > least) {
            w->set[i] = CRACKS_FULL;
            changed[0]++;
        }
    }
    par_sum_array(changed, 2);
    if (changed[1] > 0) { /* pressures were raised */
        apply(c, dt, w->search, w->along);
        go(c, 1, w->search, w->along);
        for (int i = 0; i < n; i++)
            if (w->set[i] == CRACKS_CAVITY) c->p[i] = c->in.least_pressure; /* to the bit */
    }
    return (long)(changed[0] + changed[1]);
}

static int lost(struct cracks *c, const char *field, double value) {
    c->status = (struct step_status){.failed = 1, .seen_in = STEP_STATUS_SOLID, .rank = par_rank(), .value = value};
    snprintf(c->status.field, sizeof c->status.field, "%s", field);
    return 0;
}

/* force = B p. Collective. */
static void push(const struct cracks *c) {
    cracks_struts_update(&c->struts, sizeof *c->p, c->p);
    cracks_sums_force(c, c->p, c->work->force);
}

int cracks_solve(struct cracks *c, double dt, double injected, double size) {
    long left = ITERATIONS_MAX;
    double sum = 0;
    for (int i = 0; i < c->struts.n; i++) sum += fabs(c->work->residual[i]);
    const double least = TOLERANCE * (injected + par_sum(sum)) + ROUNDING * size;
    for (int turn = 0; turn < SETS_MAX; turn++) {
        c->solves++;
        if (!iterate(c, dt, least, &left)) return lost(c, "crack iteration", (double)(ITERATIONS_MAX - left));
        if (change_set(c, dt, least) > 0) continue;
        push(c);
        return 1;
    }
    return lost(c, "crack cavities", SETS_MAX);
}
