/* Sorting and quantiles. */
#include "study/result/statistic.h"

#include <math.h>
#include <stdlib.h>

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void study_statistic_sort(int n, double *x) {
    if (n > 1) qsort(x, (size_t)n, sizeof *x, ascending);
}

double study_statistic_quantile(int n, const double *x, double q) {
    if (n == 0) return NAN;
    const double at = q * (n - 1);
    const int below = (int)at;
    if (below >= n - 1) return x[n - 1];
    return x[below] + (at - below) * (x[below + 1] - x[below]);
}
