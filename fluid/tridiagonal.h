/* Many tridiagonal systems at once, one a column: the last direction of the Poisson equation solved by bands. */
#pragma once
#include "fluid/transform.h"
#include <stddef.h>

/* Solves (q[k-1] - 2 q[k] + q[k+1])/d^2 + lambda[i] q[k] = b[k] for every column i, by Thomas's elimination: diagonally
 * dominant, as lambda <= 0. The conditions low and high (Neumann or Dirichlet, at the outer faces) change the first and
 * last diagonal by +-1/d^2. A column with lambda = 0 between two Neumann ends is singular: the mean of its b
 * is ignored, and the solution with mean zero is returned.
 * b       [n][columns]  strides `plane` and 1; overwritten by q
 * lambda  [columns]     1/m2
 * work    [n][columns]  tight */
void fluid_tridiagonal_solve(int n, int columns, double d, enum fluid_end low, enum fluid_end high,
                             const double *lambda, double *b, ptrdiff_t plane, double *work);
