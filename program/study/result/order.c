/* Observed order of convergence, from two levels or by a fit over all. */
#include "program/study/result/order.h"

#include <math.h>

static int is_positive(double x) { return isfinite(x) && x > 0; }

double study_order_between(double e_coarse, double e_fine, double h_coarse, double h_fine) {
    if (!is_positive(e_coarse) || !is_positive(e_fine) || !is_positive(h_coarse) || !is_positive(h_fine) ||
        h_coarse == h_fine)
        return NAN;
    return log(e_coarse / e_fine) / log(h_coarse / h_fine);
}

double study_order_fit(int n, const double *x, const double *y) {
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    int used = 0;
    for (int i = 0; i < n; i++) {
        if (!is_positive(x[i]) || !is_positive(y[i])) continue;
        mean_x += log(x[i]);
        mean_y += log(y[i]);
        used++;
    }
    if (used < 2) return NAN;
    mean_x /= used;
    mean_y /= used;
    for (int i = 0; i < n; i++) {
        if (!is_positive(x[i]) || !is_positive(y[i])) continue;
        const double dx = log(x[i]) - mean_x;
        xx += dx * dx;
        xy += dx * (log(y[i]) - mean_y);
    }
    return xx > 1e-24 * used * (1 + mean_x * mean_x) ? xy / xx : NAN;
}
