/* Condition numbers: from all eigenvalues by LAPACK, or from the extreme ones by Lanczos. */
#include "meshless/nonlocal/condition.h"
#include "base/die.h"
#include "base/hash.h"
#include "base/memory.h"
#include "base/par.h"
#include "meshless/nonlocal/gradients.h"

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

/* The start is random, so that it holds every eigenvector; conjugate gradients to a tiny residual have both ends of the
 * spectrum in their tridiagonal matrix. Copies of eigenvalues, which round-off makes, do no harm. */
double meshless_condition_lanczos(struct meshless_matrix *a) {
    double *b = memory_new(MEMORY_SOLID, (size_t)a->rows + 1, sizeof *b);
    struct meshless_lanczos t = {0};
    for (int i = 0; i < a->rows; i++) b[i] = hash_even(1, a->point[i], 0, 0);
    meshless_gradients_lanczos(a, b, 1e-13, &t);
    memory_free(b);
    double condition = NAN;
    if (t.n > 0 && LAPACKE_dsterf((lapack_int)t.n, t.diagonal, t.beside) == 0)
        condition = t.diagonal[t.n - 1] / t.diagonal[0];
    memory_free(t.diagonal);
    memory_free(t.beside);
    if (!(isfinite(condition) && condition > 0))
        die_all(EXIT_CODE_UNSTABLE, "the extreme eigenvalues of the matrix of %ld unknowns were not found",
                a->rows_global);
    return condition;
}

double meshless_condition(struct meshless_matrix *a) {
    return a->rows_global <= MESHLESS_CONDITION_DENSE ? meshless_condition_dense(a) : meshless_condition_lanczos(a);
}
