/* End conditions of a column: the true first and last values from the recurrences of fluid/poisson/column.h started at
 * zero. */
#pragma once
#include "fluid/poisson/transform.h"

/* Decay of a mode over a cell: r = exp(-theta), r + 1/r = 2 - lambda d^2, lambda <= 0. */
double fluid_column_ends_theta(double lambda, double d);

/* y(-1) = y_by_y Y + y_by_s S,  q(n) = q_by_y Y + q_by_s S, with Y and S of the recurrences started at zero. */
struct fluid_column_ends {
    double y_by_y, y_by_s, q_by_y, q_by_s;
};
/* For n cells; all zero for theta = 0 between periodic or Neumann ends, which is singular. */
struct fluid_column_ends fluid_column_ends_close(int n, double theta, enum fluid_end low, enum fluid_end high);
/* (1 - exp(-a theta))/(1 - exp(-b theta)), also at theta = 0. */
double fluid_column_ends_ratio(double a, double b, double theta);
