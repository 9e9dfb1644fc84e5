/* Conjugate gradients.  (Golub and Van Loan 2013: sec. 11.3) */
#include "meshless/nonlocal/gradients.h"
#include "base/memory.h"

#include <math.h>

static const double round_off = 1e-15; /* relative residual of a run */

/* Adds to x the solution of A d = b. */
static struct meshless_gradients run(struct meshless_matrix *a, const double *b, double *x, double tolerance) {
    const int n = a->rows;
    double *r = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *r),
           *q = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *q),
           *p = memory_new(MEMORY_SOLID, (size_t)(n + a->ghosts) + 1, sizeof *p);
    for (int i = 0; i < n; i++) p[i] = r[i] = b[i];
    const double start = meshless_matrix_dot(a, r, r);
    struct meshless_gradients done = {0};
    double rr = start;
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
        for (int i = 0; i < n; i++) p[i] = r[i] + beta * p[i];
        rr = next;
        done.iterations++;
        done.converged = rr <= tolerance * tolerance * start;
    }
    MEMORY_FREE(p, q, r);
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
    struct meshless_gradients done = run(a, b, x, round_off);
    residual(a, b, x, r);
    done.iterations += run(a, r, x, 1e-3).iterations;
    const double left = residual(a, b, x, r);
    done.residual = norm > 0 ? left / norm : 0;
    memory_free(r);
    return done;
}
