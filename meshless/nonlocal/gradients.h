/* The method of conjugate gradients for the symmetric positive matrices of this folder. */
#pragma once
#include "meshless/nonlocal/matrix.h"

struct meshless_gradients {
    int iterations;
    double residual; /* |b - A x| / |b|, computed from x */
    int converged;   /* the residual's recursion has come below the tolerance */
};

/* Solves A x = b to round-off: twice, the second time for the residual of the first. b, x [rows]. Collective. */
struct meshless_gradients meshless_gradients_solve(struct meshless_matrix *a, const double *b, double *x);
