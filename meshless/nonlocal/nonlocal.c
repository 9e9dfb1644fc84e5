/* The manufactured nonlocal boundary-value problem: points, matrix, solution, errors. */
#include "meshless/nonlocal/nonlocal.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"

#include <math.h>

static double sphere(int dimension) { return dimension == 3 ? 4 * M_PI : dimension == 2 ? 2 * M_PI : 2; }

double meshless_nonlocal_load(int dimension, double exponent, double horizon) {
    const double n = dimension + 2 - exponent;
    return sphere(dimension) * pow(horizon, n) / n;
}

static double radius2(const struct meshless_points *p, long i) {
    double sum = 0;
    for (int c = 0; c < p->dim; c++) sum += p->x[c][i] * p->x[c][i];
    return sum;
}

double meshless_nonlocal_exact(const struct meshless_nonlocal *n, long i) {
    return n->in.outer * n->in.outer - radius2(n->points, i);
}

/* with: struct meshless_nonlocal_input */
static int is_in_ball(const void *with, const double x[3]) {
    const struct meshless_nonlocal_input *in = with;
    double sum = 0;
    for (int c = 0; c < in->dimension; c++) sum += x[c] * x[c];
    return sum <= in->outer * in->outer;
}

struct meshless_nonlocal *meshless_nonlocal_new(const struct meshless_nonlocal_input *in) {
    if (in->outer < (in->inner + in->horizon) * (1 - 1e-12))
        die_all(EXIT_CODE_SCENE, "the outer radius %g m must be at least the inner one and the horizon, %g m",
                in->outer, in->inner + in->horizon);
    struct meshless_nonlocal *n = memory_new(MEMORY_SOLID, 1, sizeof *n);
    struct meshless_arrange_input points = in->points;
    n->in = *in;
    points.domain =
        (struct meshless_domain){.dim = in->dimension,
                                 .is_inside = is_in_ball,
                                 .with = in,
                                 .measure = sphere(in->dimension) * pow(in->outer, in->dimension) / in->dimension};
    for (int c = 0; c < in->dimension; c++) {
        points.domain.low[c] = -in->outer;
        points.domain.high[c] = in->outer;
    }
    n->points = meshless_arrange_new(&points);
    n->free = memory_new(MEMORY_SOLID, (size_t)n->points->n + 1, 1);
    n->b = meshless_nonlocal_load(in->dimension, in->exponent, in->horizon);
    long solved = 0;
    for (long i = 0; i < n->points->n; i++)
        solved += n->free[i] = (char)(radius2(n->points, i) <= in->inner * in->inner);
    if (solved == 0)
        die_all(EXIT_CODE_SCENE,
                "no point lies within the inner radius %g m at spacing %g m: a smaller spacing puts some there",
                in->inner, n->points->spacing);
    return n;
}

void meshless_nonlocal_assemble(struct meshless_nonlocal *n) {
    n->matrix = meshless_matrix_new(&(struct meshless_matrix_input){
        .points = n->points, .exponent = n->in.exponent, .horizon = n->in.horizon, .free = n->free});
}

/* What the given values add to the right-hand side of row i. */
static double given(const struct meshless_nonlocal *n, int i) {
    const struct meshless_matrix *a = n->matrix;
    double sum = 0;
    for (long k = a->given_start[i]; k < a->given_start[i + 1]; k++)
        sum += a->given_value[k] * meshless_nonlocal_exact(n, a->given[k]);
    return sum;
}

void meshless_nonlocal_solve(struct meshless_nonlocal *n) {
    struct meshless_matrix *a = n->matrix;
    double *b = memory_new(MEMORY_SOLID, (size_t)a->rows + 1, sizeof *b);
    n->u = memory_new(MEMORY_SOLID, (size_t)a->rows + 1, sizeof *n->u);
    for (int i = 0; i < a->rows; i++) b[i] = n->points->volume[a->point[i]] * n->b + given(n, i);
    n->solved = meshless_gradients_solve(a, b, n->u);
    memory_free(b);
    if (!n->solved.converged || !(n->solved.residual < 1e-8))
        die_all(
            EXIT_CODE_UNSTABLE,
            "the conjugate gradients have not converged after %d iterations, residual %.2g: points that no chain of "
            "bonds joins to the given values have no solution; a larger horizon joins them",
            n->solved.iterations, n->solved.residual);
}

static void measure_operator(struct meshless_nonlocal *n) {
    struct meshless_matrix *a = n->matrix;
    double *u = memory_new(MEMORY_SOLID, (size_t)(a->rows + a->ghosts) + 1, sizeof *u),
           *y = memory_new(MEMORY_SOLID, (size_t)a->rows + 1, sizeof *y), sum = 0, most[2] = {0, 0};
    for (int i = 0; i < a->rows; i++) u[i] = meshless_nonlocal_exact(n, a->point[i]);
    meshless_matrix_times(a, u, y);
    for (int i = 0; i < a->rows; i++) {
        const double error = ((y[i] - given(n, i)) / n->points->volume[a->point[i]] - n->b) / n->b;
        sum += error;
        most[0] = fmax(most[0], error);
        most[1] = fmax(most[1], -error);
    }
    par_max_array(most, 2);
    n->operator_mean = par_sum(sum) / (double)a->rows_global;
    n->operator_max = most[0] >= most[1] ? most[0] : -most[1];
    MEMORY_FREE(y, u);
}

void meshless_nonlocal_measure(struct meshless_nonlocal *n) {
    const struct meshless_matrix *a = n->matrix;
    double most = 0, sum[2] = {0};
    for (int i = 0; i < a->rows; i++) {
        const double exact = meshless_nonlocal_exact(n, a->point[i]), error = n->u[i] - exact;
        most = fmax(most, fabs(error));
        sum[0] += error * error;
        sum[1] += exact * exact;
    }
    par_sum_array(sum, 2);
    n->error_linf = par_max(most);
    n->error_l2 = sqrt(sum[0] / sum[1]);
    measure_operator(n);
}

void meshless_nonlocal_free(struct meshless_nonlocal *n) {
    if (!n) return;
    meshless_matrix_free(n->matrix);
    meshless_arrange_free(n->points);
    MEMORY_FREE(n->free, n->u, n);
}
