/* Augmented Lagrangian with one banded factor. */
#include "meshless/galerkin/solve.h"
#include "base/die.h"
#include "base/memory.h"
#include "meshless/galerkin/assemble.h"
#include "meshless/galerkin/constraint.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

static double *numbers(int n) { return memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof(double)); }

static double dot(int n, const double *a, const double *b) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

static double largest(int n, const double *a) {
    double most = 0;
    for (int i = 0; i < n; i++) most = fmax(most, fabs(a[i]));
    return most;
}

struct factor {
    int n, half_band;
    double *band, *work;
};

static void factor_new(struct factor *f, const struct galerkin *g, double *load) {
    const double penalty = g->in.penalty * g->in.youngs_modulus * g->in.thickness;
    f->n = 2 * g->in.nodes;
    f->half_band = g->half_band;
    f->band = memory_new(MEMORY_SOLID, (size_t)f->n * ((size_t)f->half_band + 1), sizeof(double));
    f->work = numbers(f->n);
    meshless_assemble(g, penalty, f->band, load);
    const int failed = LAPACKE_dpbtrf_work(LAPACK_COL_MAJOR, 'L', f->n, f->half_band, f->band, f->half_band + 1);
    if (failed <= 0) return;
    const int node = g->node_of[(failed - 1) / 2];
    die_all(EXIT_CODE_SCENE,
            "the stiffness does not determine the displacement of node %d at (%.6g, %.6g) along %c: take a larger "
            "solid.element_free.gauss or support, more cells, or leave the node out",
            node, g->in.node[node][0], g->in.node[node][1], "xy"[(failed - 1) % 2]);
}

/* x (nodes' order) = A^-1 b (nodes' order). */
static void factor_solve(const struct factor *f, const struct galerkin *g, const double *b, double *x) {
    for (int i = 0; i < f->n; i++) f->work[meshless_assemble_place(g, i)] = b[i];
    LAPACKE_dpbtrs_work(LAPACK_COL_MAJOR, 'L', f->n, f->half_band, 1, f->band, f->half_band + 1, f->work, f->n);
    for (int i = 0; i < f->n; i++) x[i] = f->work[meshless_assemble_place(g, i)];
}

/* violation = G u - g; returns the largest, over the largest |u|. */
static double violation_of(const struct galerkin *g, const double *u, double *violation) {
    meshless_constraint_apply(g, u, violation);
    for (int r = 0; r < g->rows.rows; r++) violation[r] -= g->rows.given[r];
    const double scale = fmax(largest(2 * g->in.nodes, u), largest(g->rows.rows, g->rows.given));
    return scale > 0 ? largest(g->rows.rows, violation) / scale : 0;
}

/* u = A^-1 (f + alpha G^T g - G^T r) */
static void primal(const struct galerkin *g, const struct factor *f, const double *load, const double *r, double *u) {
    const double alpha = g->in.penalty * g->in.youngs_modulus * g->in.thickness;
    double *b = memory_copy(MEMORY_SOLID, load, (size_t)f->n, sizeof *b);
    meshless_constraint_add(g, alpha, g->rows.given, b);
    meshless_constraint_add(g, -1, r, b);
    factor_solve(f, g, b, u);
    memory_free(b);
}

static void hestenes_powell(struct galerkin *g, const struct factor *f, const double *load) {
    struct galerkin_solution *s = &g->solution;
    const double alpha = g->in.penalty * g->in.youngs_modulus * g->in.thickness;
    double *violation = numbers(g->rows.rows);
    for (s->iterations = 0; s->iterations < g->in.iterations && !s->converged; s->iterations++) {
        s->violation = violation_of(g, s->u, violation);
        s->history[s->iterations] = s->violation;
        s->converged = s->violation <= g->in.tolerance;
        if (s->converged) break;
        for (int r = 0; r < g->rows.rows; r++) s->multiplier[r] += alpha * violation[r];
        primal(g, f, load, s->multiplier, s->u);
    }
    memory_free(violation);
}

/* G A^-1 G^T is semi-definite where rows depend on each other; conjugate gradients stay in its range. */
static void conjugate(struct galerkin *g, const struct factor *f, const double *load) {
    struct galerkin_solution *s = &g->solution;
    const int rows = g->rows.rows;
    double *residual = numbers(rows), *p = numbers(rows), *image = numbers(rows), *b = numbers(f->n),
           *v = numbers(f->n);
    double before = 0;
    enum { RESTART = 200 };
    for (s->iterations = 0; s->iterations < g->in.iterations; s->iterations++) {
        s->violation = violation_of(g, s->u, residual);
        s->history[s->iterations] = s->violation;
        s->converged = s->violation <= g->in.tolerance;
        if (s->converged) break;
        const double square = dot(rows, residual, residual);
        const double beta = s->iterations % RESTART ? square / before : 0;
        for (int r = 0; r < rows; r++) p[r] = residual[r] + beta * p[r];
        before = square;
        memset(b, 0, (size_t)f->n * sizeof *b);
        meshless_constraint_add(g, 1, p, b);
        factor_solve(f, g, b, v);
        meshless_constraint_apply(g, v, image);
        const double curvature = dot(rows, p, image);
        if (!(curvature > 0)) break;
        const double step = square / curvature;
        for (int r = 0; r < rows; r++) s->multiplier[r] += step * p[r];
        for (int i = 0; i < f->n; i++) s->u[i] -= step * v[i];
    }
    primal(g, f, load, s->multiplier, s->u); /* without the rounding of the steps */
    s->violation = violation_of(g, s->u, residual);
    s->converged = s->violation <= g->in.tolerance;
    MEMORY_FREE(residual, p, image, b, v);
}

/* Sets energy and equilibrium. */
static void measure(struct galerkin *g, const double *load) {
    const int n = 2 * g->in.nodes;
    double *y = numbers(n), *reaction = numbers(n);
    meshless_assemble_apply(g, g->solution.u, y);
    g->solution.energy = 0.5 * dot(n, g->solution.u, y);
    meshless_constraint_add(g, 1, g->solution.multiplier, reaction);
    for (int i = 0; i < n; i++) y[i] += reaction[i] - load[i];
    const double scale = fmax(largest(n, load), largest(n, reaction)), imbalance = largest(n, y);
    MEMORY_FREE(y, reaction);
    g->solution.equilibrium = scale > 0 ? imbalance / scale : 0;
}

void meshless_galerkin_solve(struct galerkin *g) {
    struct galerkin_solution *s = &g->solution;
    const int n = 2 * g->in.nodes;
    struct factor f;
    double *band_load = numbers(n), *load = numbers(n);
    s->u = numbers(n);
    s->multiplier = numbers(g->rows.rows);
    s->history = numbers(g->in.iterations);
    factor_new(&f, g, band_load);
    for (int i = 0; i < n; i++) load[i] = band_load[meshless_assemble_place(g, i)];
    primal(g, &f, load, s->multiplier, s->u);
    switch (g->in.update) {
    case GALERKIN_CONJUGATE:
        conjugate(g, &f, load);
        break;
    case GALERKIN_HESTENES_POWELL:
        hestenes_powell(g, &f, load);
        break;
    }
    measure(g, load);
    MEMORY_FREE(f.band, f.work, band_load, load);
}
