/* Strongly coupled step: iterates fluid and solid until the interface's velocity has converged. */
/* The load is constant over the step, so its work is F . (d^{n+1} - d^n). The fluid is therefore given the mean
 * velocity of the step, V_m = (d^{n+1} - d^n)/dt: then the work that the fluid does on the solid is the work that it
 * gives. With the velocity at t_{n+1} the two differ, and waves of the solid that the step does not resolve (omega dt >
 * pi) may gain energy, however well the iteration converges. */
#include "coupling/load/strong.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/control/rollback.h"
#include "coupling/interface/forced_fluid.h"
#include "coupling/interface/interface.h"
#include "coupling/load/load.h"
#include "coupling/load/quasi_newton.h"
#include "coupling/run.h"
#include "base/files/log.h"
#include "solid/imposed/reactions.h"
#include "solid/step/integrate.h"

#include <math.h>
#include <string.h>

/* The factor w of the first iteration; the least independent fraction of a column. Both as in preCICE. */
static const double RELAXATION = 0.1, FILTER = 1e-2;
/* Lower bound of the reference in the convergence test: 1e-3 of the velocity change that the load alone would cause. A
 * solid in equilibrium hardly changes its velocity. */
static const double OF_LOAD = 1e-3;

struct strong {
    struct quasi_newton *relaxation;
    struct rollback *start; /* the state at t_n */
    int n, capacity;        /* particles of the interface */
    int *h;                 /* [n] their indices in the solid */
    double *guess, *image;  /* [3n] their mean velocity V_m, m/s: guess given to the fluid; result of the solid */
    double *end;            /* [3n] their displacement at t_{n+1}, extrapolated, m */
    double *before[3];      /* [particles] displacement at t_n, m */
    int forget;
    struct strong_count count;
};

static enum quasi_newton_kind kind_of(enum scene_relaxation relaxation) {
    switch (relaxation) {
    case SCENE_QUASI_NEWTON:
        return QUASI_NEWTON_LEAST_SQUARES;
    case SCENE_AITKEN:
        return QUASI_NEWTON_AITKEN;
    }
    ENSURE(0, "relaxation %d", (int)relaxation);
}

struct strong *strong_new(struct run *r) {
    const struct scene_coupling *scene = r->scene->coupling;
    if (!r->needs.immersed || !r->needs.bonds || scene->scheme != SCENE_STRONG) return NULL;
    struct strong *k = memory_new(MEMORY_COUPLING, 1, sizeof *k);
    k->relaxation = quasi_newton_new(
        &(struct quasi_newton_input){.kind = kind_of(scene->relaxation), .relaxation = RELAXATION, .filter = FILTER});
    k->start = rollback_new(r);
    for (int c = 0; c < 3; c++) k->before[c] = memory_new(MEMORY_COUPLING, (size_t)r->solid->n + 1, sizeof(double));
    return k;
}

void strong_free(struct strong *k) {
    if (!k) return;
    quasi_newton_free(k->relaxation);
    rollback_free(k->start);
    memory_free(k->h);
    memory_free(k->guess);
    memory_free(k->image);
    memory_free(k->end);
    for (int c = 0; c < 3; c++) memory_free(k->before[c]);
    memory_free(k);
}

void strong_forget(struct strong *k) {
    if (k) k->forget = 1;
}

struct strong_count strong_count_of(const struct strong *k) {
    return k->count;
}

static void reserve(struct strong *k, int n) {
    if (n <= k->capacity && k->h) return;
    double **const array[] = {&k->guess, &k->image, &k->end};
    k->capacity = n + n / 4 + 64;
    memory_free(k->h);
    k->h = memory_new(MEMORY_COUPLING, (size_t)k->capacity, sizeof *k->h);
    for (int a = 0; a < 3; a++) {
        memory_free(*array[a]);
        *array[a] = memory_new(MEMORY_COUPLING, 3 * (size_t)k->capacity, sizeof **array[a]);
    }
}

/* Copies the list of the interface's particles; forgets earlier iterations if it has changed. */
static void renew_interface(struct strong *k, const struct solid_surface *surface) {
    const size_t bytes = (size_t)surface->n * sizeof *k->h;
    const int same = k->h && k->n == surface->n && !memcmp(k->h, surface->h, bytes);
    if (!same) {
        reserve(k, surface->n);
        memcpy(k->h, surface->h, bytes);
        k->n = surface->n;
    }
    quasi_newton_begin(k->relaxation, 3 * k->n, !same || k->forget);
    k->forget = 0;
}

/* The first guess of the interface's mean velocity, extrapolated to the middle of the step from v at t_n and the mean
 * of the last step, which is v_last; and of its displacement. */
static void begin(struct run *r) {
    struct strong *k = r->strong;
    struct solid *s = r->solid;
    const double ahead = r->dt_last > 0 ? r->dt / r->dt_last : 1;
    renew_interface(k, r->surface);
    for (int c = 0; c < 3; c++) {
        memcpy(k->before[c], s->d[c], (size_t)s->n * sizeof(double));
        for (int i = 0; i < k->n; i++) {
            const int h = k->h[i];
            const double v = s->v[c][h], guess = v + ahead * (v - r->v_last[c][h]);
            k->guess[c * k->n + i] = guess;
            k->end[c * k->n + i] = s->d[c][h] + r->dt * guess;
        }
    }
    rollback_save(k->start, r);
}

static void swap(double *a, double *b) {
    const double was = *a;
    *a = *b;
    *b = was;
}

static void swap_interface(struct strong *k, struct solid *s) {
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < k->n; i++) {
            swap(&s->v[c][k->h[i]], &k->guess[c * k->n + i]);
            swap(&s->d[c][k->h[i]], &k->end[c * k->n + i]);
        }
}

/* Sets markers and probes from the guess of the interface. All stages use that velocity: the forcing lags behind by
 * some steps, and would lag more if the velocity changed from stage to stage. */
static void set_markers(struct run *r) {
    swap_interface(r->strong, r->solid);
    interface_begin_step(r);
    swap_interface(r->strong, r->solid);
}

static double mean_velocity(const struct run *r, int c, int h) {
    return (r->solid->d[c][h] - r->strong->before[c][h]) / r->dt;
}

/* Advances the solid from t_n under the load of t_{n+1}. Under the mean of both loads, the part that depends on the
 * acceleration would oscillate. */
static void advance_solid(struct run *r) {
    const struct strong *k = r->strong;
    struct solid *s = r->solid;
    s->t = r->t;
    solid_reactions_begin(s);
    solid_integrate(s, r->dt / r->substeps, r->substeps);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < k->n; i++) k->image[c * k->n + i] = mean_velocity(r, c, k->h[i]);
}

/* 1: guess and result agree, relative to the change of velocity in the step; 0: they do not; -1: NaN. */
static int is_converged(const struct run *r) {
    enum { RESIDUAL, CHANGE, LOAD, SUMS };
    const struct strong *k = r->strong;
    const struct solid *s = r->solid;
    double sum[SUMS] = {0};
    for (int i = 0; i < k->n; i++) {
        const int h = k->h[i];
        const double per_density = r->dt / solid_density(s, h);
        for (int c = 0; c < 3; c++) {
            const double image = k->image[c * k->n + i];
            sum[RESIDUAL] += pow(image - k->guess[c * k->n + i], 2);
            sum[CHANGE] += pow(image - r->v_last[c][h], 2);
            sum[LOAD] += pow(per_density * s->load[c][h], 2);
        }
    }
    par_sum_array(sum, SUMS);
    if (!isfinite(sum[RESIDUAL])) return -1;
    const double tolerance = r->scene->coupling->tolerance;
    return sum[RESIDUAL] <= tolerance * tolerance * fmax(sum[CHANGE], OF_LOAD * OF_LOAD * sum[LOAD]);
}

/* Logs at 1, 2, 4, ... such steps, so that a run that never converges does not fill its log. */
static void log_unconverged(const struct run *r) {
    const long n = ++r->strong->count.unconverged;
    if ((n & (n - 1)) == 0)
        log_line("step %ld: interface not converged after %d iterations (%ld such steps so far)", r->step,
                 r->scene->coupling->iterations, n);
}

static void add_up(struct run *r, int iterations) {
    struct strong_count *count = &r->strong->count;
    count->steps++;
    count->iterations += iterations;
    count->most = iterations > count->most ? iterations : count->most;
    r->fluid_cell_steps += (iterations - 1) * (long)fluid_cells(r->fluid);
    r->solid_sweeps += (iterations - 1) * solid_integrate_sweeps(r->solid, r->substeps);
    if (r->stage_step + 1 == r->scene->stage[r->stage].steps)
        log_line("strong coupling: %.2f iterations a step, %ld at most; %ld steps not converged",
                 (double)count->iterations / (double)count->steps, count->most, count->unconverged);
}

void strong_step(struct run *r) {
    struct strong *k = r->strong;
    int iterations = 1;
    begin(r);
    for (;; iterations++) {
        set_markers(r);
        forced_fluid_step(r);
        load_sample(r);
        advance_solid(r);
        if (r->solid->stops) return;
        const int converged = is_converged(r);
        if (converged < 0) k->forget = 1;
        if (converged == 0 && iterations == r->scene->coupling->iterations) log_unconverged(r);
        if (converged != 0 || iterations == r->scene->coupling->iterations) break;
        quasi_newton_next(k->relaxation, k->guess, k->image);
        rollback_restore(k->start, r);
    }
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < r->solid->n; h++) r->v_last[c][h] = mean_velocity(r, c, h);
    r->dt_last = r->dt;
    r->moved = r->step + 1;
    add_up(r, iterations);
}
