/* Condition numbers: from all eigenvalues by LAPACK, or from the extreme ones by Lanczos. */
#include "meshless/nonlocal/condition.h"
#include "base/die.h"
#include "base/hash.h"
#include "base/memory.h"
#include "base/par.h"

#include <lapacke.h>
#include <math.h>

double meshless_condition_dense(struct meshless_matrix *a) {
    const lapack_int n = (lapack_int)a->rows_global;
    double *dense = meshless_matrix_dense(a), condition = NAN;
    if (par_rank() == 0) {
        double *value = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *value);
        if (LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'N', 'U', n, dense, n, value) == 0) condition = value[n - 1] / value[0];
        memory_free(value);
    }
    memory_free(dense);
    par_bcast(&condition, sizeof condition, 0);
    if (!isfinite(condition))
        die_all(EXIT_CODE_UNSTABLE, "the eigenvalues of the matrix of %ld unknowns were not found", a->rows_global);
    return condition;
}

/* Steps between checks of the ends of the spectrum, and their relative change at which the iteration ends. */
enum { CHECK_EVERY = 25 };
static const double change = 1e-10;

/* Lanczos' tridiagonal matrix. */
struct lanczos {
    int n, capacity;
    double *diagonal, *beside; /* [capacity] */
};

static void add(struct lanczos *t, double diagonal, double beside) {
    if (t->n == t->capacity) {
        const size_t used = (size_t)t->n, capacity = (size_t)(t->capacity = 2 * t->capacity + 256);
        t->diagonal = memory_grown(MEMORY_SOLID, t->diagonal, used, capacity, sizeof(double));
        t->beside = memory_grown(MEMORY_SOLID, t->beside, used, capacity, sizeof(double));
    }
    t->diagonal[t->n] = diagonal;
    t->beside[t->n++] = beside;
}

/* Its least and largest eigenvalue; returns 0 if LAPACK finds none. */
static int ends_of(const struct lanczos *t, double *least, double *most) {
    double *d = memory_copy(MEMORY_SOLID, t->diagonal, (size_t)t->n, sizeof *d),
           *e = memory_copy(MEMORY_SOLID, t->beside, (size_t)t->n, sizeof *e);
    const int good = LAPACKE_dsterf((lapack_int)t->n, d, e) == 0;
    *least = d[0];
    *most = d[t->n - 1];
    MEMORY_FREE(d, e);
    return good;
}

/* The start is random, so that it holds every eigenvector. The vectors are not made orthogonal again: the copies of
 * eigenvalues that this gives do no harm to the ends.  (Golub and Van Loan 2013: sec. 10.1) */
double meshless_condition_lanczos(struct meshless_matrix *a) {
    const int rows = a->rows;
    double *v = memory_new(MEMORY_SOLID, (size_t)(rows + a->ghosts) + 1, sizeof *v),
           *before = memory_new(MEMORY_SOLID, (size_t)rows + 1, sizeof *before),
           *w = memory_new(MEMORY_SOLID, (size_t)rows + 1, sizeof *w);
    struct lanczos t = {0};
    double least = NAN, most = NAN;
    int settled = 0, good = 1;
    for (int i = 0; i < rows; i++) v[i] = hash_even(1, a->point[i], 0, 0);
    double norm = sqrt(meshless_matrix_dot(a, v, v)), beta = 0;
    for (int i = 0; i < rows; i++) v[i] /= norm;
    while (good && !settled && t.n < 100 + 20 * a->rows_global) {
        meshless_matrix_times(a, v, w);
        const double alpha = meshless_matrix_dot(a, v, w);
        for (int i = 0; i < rows; i++) w[i] -= alpha * v[i] + beta * before[i];
        beta = sqrt(meshless_matrix_dot(a, w, w));
        add(&t, alpha, beta);
        const int ended = !(beta > 1e-14 * alpha); /* all eigenvalues are in the matrix */
        if (ended || t.n % CHECK_EVERY == 0) {
            const double least_before = least, most_before = most;
            good = ends_of(&t, &least, &most);
            settled =
                ended || (fabs(least - least_before) < change * least && fabs(most - most_before) < change * most);
        }
        for (int i = 0; i < rows && !ended; i++) {
            before[i] = v[i];
            v[i] = w[i] / beta;
        }
    }
    MEMORY_FREE(t.diagonal, t.beside, w, before, v);
    if (!settled || !good || !(least > 0))
        die_all(EXIT_CODE_UNSTABLE, "the extreme eigenvalues of the matrix of %ld unknowns were not found",
                a->rows_global);
    return most / least;
}

double meshless_condition(struct meshless_matrix *a) {
    return a->rows_global <= MESHLESS_CONDITION_DENSE ? meshless_condition_dense(a) : meshless_condition_lanczos(a);
}
