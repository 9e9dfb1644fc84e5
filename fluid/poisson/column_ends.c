/* Closes a column's recurrences for each pair of end conditions. */
#include "fluid/poisson/column_ends.h"
#include "base/ensure.h"

#include <math.h>

double fluid_column_ends_theta(double lambda, double d) { return 2 * asinh(0.5 * d * sqrt(fmax(0, -lambda))); }

double fluid_column_ends_ratio(double a, double b, double theta) {
    return theta == 0 ? a / b : expm1(-a * theta) / expm1(-b * theta);
}

/* With E = r^2 + r^4 + .. + r^2n the recurrences end at
 *     y(n-1) = r^n y(-1) + Y ,   q(0) = r^n q(n) - S - E y(-1) ,
 * and the end conditions are y(-1) = y(n-1), q(0) = q(n) (periodic), y(-1) = q(0) (1 -+ 1/r), y(n-1) = q(n) (1 -+ 1/r),
 * with the upper sign for Neumann, or y(-1) = q(0), y(n-1) = q(n) (faces: q(-1) = q(n-1) = 0). Solved for each pair of
 * ends; differences that are small near r = 1 are cancelled by hand. q = r^n. */
struct fluid_column_ends fluid_column_ends_close(int n, double theta, enum fluid_end low, enum fluid_end high) {
    const double r = exp(-theta), q = exp(-n * theta), q2 = q * q, one_r = -expm1(-theta), one_q = -expm1(-n * theta),
                 one_q2 = -expm1(-2.0 * n * theta);
    const int neumann_low = low == FLUID_END_NEUMANN, neumann_high = high == FLUID_END_NEUMANN;
    struct fluid_column_ends e = {0, 0, 0, 0};
    ENSURE((low == FLUID_END_PERIODIC) == (high == FLUID_END_PERIODIC), "one end is periodic");
    ENSURE((low == FLUID_END_FACE) == (high == FLUID_END_FACE), "one end is a face");
    if (low == FLUID_END_PERIODIC) {
        if (theta == 0) return e;
        e.y_by_y = 1 / one_q;
        e.q_by_s = -1 / one_q;
        e.q_by_y = -r * r * fluid_column_ends_ratio(2.0 * n, 2, theta) / (one_q * one_q);
    } else if (low == FLUID_END_FACE) {
        const double scale = fluid_column_ends_ratio(2.0 * n, 2, theta);
        e.y_by_y = q / scale;
        e.y_by_s = -1 / scale;
        e.q_by_y = 1 + q * e.y_by_y;
        e.q_by_s = q * e.y_by_s;
    } else if (neumann_low && neumann_high) {
        if (theta == 0) return e;
        e.y_by_y = (1 + r) * q / one_q2;
        e.y_by_s = (1 + r) * one_r / (r * one_q2);
        e.q_by_y = -r * (1 + r * q2) / (one_r * one_q2);
        e.q_by_s = -(1 + r) * q / one_q2;
    } else if (!neumann_low && !neumann_high) {
        const double scale = r * fluid_column_ends_ratio(2.0 * n, 2, theta);
        e.y_by_y = r / (1 + r) * q / scale;
        e.y_by_s = -1 / scale;
        e.q_by_y = r / (1 + r) * r * fluid_column_ends_ratio(2.0 * n + 1, 2, theta) / scale;
        e.q_by_s = -r / (1 + r) * q / scale;
    } else if (neumann_low) {
        e.y_by_y = -q * one_r / (1 + q2);
        e.y_by_s = one_r * (1 + r) / (r * (1 + q2));
        e.q_by_y = r * (1 + r * q2) / ((1 + r) * (1 + q2));
        e.q_by_s = one_r * q / (1 + q2);
    } else {
        e.y_by_y = -q * (1 + r) / (1 + q2);
        e.y_by_s = -one_r * (1 + r) / (r * (1 + q2));
        e.q_by_y = -(1 + r) * r * fluid_column_ends_ratio(2.0 * n + 1, 2, theta) / (1 + q2);
        e.q_by_s = (1 + r) * q / (1 + q2);
    }
    return e;
}
