/* Sorting and quantiles. */
#include "program/study/result/statistic.h"
#include "base/sort.h"

#include <math.h>

void study_statistic_sort(int n, double *x) { sort_ascending(x, (size_t)n); }

double study_statistic_quantile(int n, const double *x, double q) {
    if (n == 0) return NAN;
    const double at = q * (n - 1);
    const int below = (int)at;
    if (below >= n - 1) return x[n - 1];
    return x[below] + (at - below) * (x[below + 1] - x[below]);
}

double study_statistic_mean(int n, const double *x) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += x[i];
    return n > 0 ? sum / n : NAN;
}

double study_statistic_deviation(int n, const double *x) {
    const double mean = study_statistic_mean(n, x);
    double sum = 0;
    for (int i = 0; i < n; i++) sum += (x[i] - mean) * (x[i] - mean);
    return n > 1 ? sqrt(sum / (n - 1)) : NAN;
}
