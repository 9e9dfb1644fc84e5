/* Conjugate gradients, and the tridiagonal matrix of Lanczos that they contain. */
#include "meshless/nonlocal/gradients.h"
#include "base/memory.h"

#include <math.h>

static const double round_off = 1e-15; /* relative residual of a run */

/* Adds a row: T_kk = 1/alpha_k + beta_(k-1)/alpha_(k-1), T_(k,k+1) = sqrt(beta_k)/alpha_k. */
static void keep(struct meshless_lanczos *t, double alpha, double beta, double alpha_before, double beta_before) {
    if (!t) return;
    if (t->n == t->room) {
        const size_t used = (size_t)t->n, room = (size_t)(t->room = 2 * t->room + 256);
        t->diagonal = memory_grown(MEMORY_SOLID, t->diagonal, used, room, sizeof(double));
        t->beside = memory_grown(MEMORY_SOLID, t->beside, used, room, sizeof(double));
    }
    t->diagonal[t->n] = 1 / alpha + (t->n > 0 ? beta_before / alpha_before : 0);
    t->beside[t->n++] = sqrt(beta) / alpha;
}

/* Adds to x the solution of A d = b. */
static struct meshless_gradients run(struct meshless_matrix *a, const double *b, double *x, double tolerance,
                                     struct meshless_lanczos *t) {
    const int n = a->rows;
    double *r = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *r),
           *q = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *q),
           *p = memory_new(MEMORY_SOLID, (size_t)(n + a->ghosts) + 1, sizeof *p);
    for (int i = 0; i < n; i++) p[i] = r[i] = b[i];
    const double start = meshless_matrix_dot(a, r, r);
    struct meshless_gradients done = {0};
    double rr = start, alpha_before = 1, beta_before = 0;
    const long most = 100 + 20 * a->rows_global;
    done.converged = start == 0;
    while (!done.converged && done.iterations < most && rr > 0) {
        meshless_matrix_times(a, p, q);
        const double alpha = rr / meshless_matrix_dot(a, p, q);
        if (!(alpha > 0)) break; /* not positive, or no number */
        for (int i = 0; i < n; i++) {
            x[i] += alpha * p[i];
            r[i] -= alpha * q[i];
        }
        const double next = meshless_matrix_dot(a, r, r), beta = next / rr;
        keep(t, alpha, beta, alpha_before, beta_before);
        for (int i = 0; i < n; i++) p[i] = r[i] + beta * p[i];
        rr = next;
        alpha_before = alpha;
        beta_before = beta;
        done.iterations++;
        done.converged = rr <= tolerance * tolerance * start;
    }
    memory_free(p);
    memory_free(q);
    memory_free(r);
    return done;
}

/* r = b - A x; returns its norm. */
static double residual(struct meshless_matrix *a, const double *b, const double *x, double *r) {
    double *p = memory_new(MEMORY_SOLID, (size_t)(a->rows + a->ghosts) + 1, sizeof *p);
    for (int i = 0; i < a->rows; i++) p[i] = x[i];
    meshless_matrix_times(a, p, r);
    for (int i = 0; i < a->rows; i++) r[i] = b[i] - r[i];
    memory_free(p);
    return sqrt(meshless_matrix_dot(a, r, r));
}

struct meshless_gradients meshless_gradients_solve(struct meshless_matrix *a, const double *b, double *x) {
    double *r = memory_new(MEMORY_SOLID, (size_t)a->rows + 1, sizeof *r);
    const double norm = sqrt(meshless_matrix_dot(a, b, b));
    for (int i = 0; i < a->rows; i++) x[i] = 0;
    struct meshless_gradients done = run(a, b, x, round_off, NULL);
    residual(a, b, x, r);
    done.iterations += run(a, r, x, 1e-3, NULL).iterations;
    const double left = residual(a, b, x, r);
    done.residual = norm > 0 ? left / norm : 0;
    memory_free(r);
    return done;
}

struct meshless_gradients meshless_gradients_lanczos(struct meshless_matrix *a, const double *b, double tolerance,
                                                     struct meshless_lanczos *t) {
    double *x = memory_new(MEMORY_SOLID, (size_t)a->rows + 1, sizeof *x);
    const struct meshless_gradients done = run(a, b, x, tolerance, t);
    memory_free(x);
    return done;
}
