#include "fluid/tridiagonal.h"

/* Row k of the elimination: c = a/pivot and q = (b - a q_before)/pivot, pivot = diagonal + lambda - a c_before. */
static void eliminate(int columns, double a, double diagonal, const double *restrict lambda,
                      const double *restrict q_before, const double *restrict c_before, double *restrict q,
                      double *restrict c) {
    for (int i = 0; i < columns; i++) {
        const double inverse = 1 / (diagonal + lambda[i] - a * c_before[i]);
        c[i] = a * inverse;
        q[i] = (q[i] - a * q_before[i]) * inverse;
    }
}

static void begin(int columns, double a, double diagonal, const double *restrict lambda, double *restrict q,
                  double *restrict c) {
    for (int i = 0; i < columns; i++) {
        const double inverse = 1 / (diagonal + lambda[i]);
        c[i] = a * inverse;
        q[i] *= inverse;
    }
}

static void substitute(int columns, const double *restrict c, const double *restrict q_after,
                       double *restrict q) {
    for (int i = 0; i < columns; i++) q[i] -= c[i] * q_after[i];
}

static void remove_mean(int n, double *column, ptrdiff_t plane) {
    double mean = 0;
    for (int k = 0; k < n; k++) mean += column[k * plane];
    mean /= n;
    for (int k = 0; k < n; k++) column[k * plane] -= mean;
}

void fluid_tridiagonal_solve(int n, int columns, double d, enum fluid_end low, enum fluid_end high,
                             const double *lambda, double *b, ptrdiff_t plane, double *work) {
    const double a = 1 / (d * d);
    const double first = low == FLUID_END_NEUMANN ? a : -a, last = high == FLUID_END_NEUMANN ? a : -a;
    const int neumann = low == FLUID_END_NEUMANN && high == FLUID_END_NEUMANN;
    for (int i = 0; neumann && i < columns; i++)
        if (lambda[i] == 0) remove_mean(n, b + i, plane);
    for (int k = 0; k < n; k++) {
        const double diagonal = -2 * a + (k == 0 ? first : 0) + (k == n - 1 ? last : 0);
        double *q = b + k * plane, *c = work + (ptrdiff_t)k * columns;
        if (k == 0)
            begin(columns, a, diagonal, lambda, q, c);
        else
            eliminate(columns, a, diagonal, lambda, q - plane, c - columns, q, c);
    }
    for (int i = 0; neumann && i < columns;
         i++) /* a singular column's last pivot is round-off: fix the last value */
        if (lambda[i] == 0) b[(n - 1) * plane + i] = 0;
    for (int k = n - 2; k >= 0; k--)
        substitute(columns, work + (ptrdiff_t)k * columns, b + (k + 1) * plane, b + k * plane);
    for (int i = 0; neumann && i < columns; i++)
        if (lambda[i] == 0) remove_mean(n, b + i, plane);
}
