/* The method of conjugate gradients for the symmetric positive matrices of this folder. */
#pragma once
#include "meshless/nonlocal/matrix.h"

/* Lanczos' tridiagonal matrix, which the coefficients of the method give.  (Golub and Van Loan 2013: sec. 11.3.5) */
struct meshless_lanczos {
    int n, room;
    double *diagonal, *beside; /* [n] each; owned, by memory_new */
};

struct meshless_gradients {
    int iterations;
    double residual; /* |b - A x| / |b|, computed from x */
    int converged;   /* the residual's recursion has come below the tolerance */
};

/* Solves A x = b to round-off: twice, the second time for the residual of the first. b, x [rows]. Collective. */
struct meshless_gradients meshless_gradients_solve(struct meshless_matrix *a, const double *b, double *x);
/* One run to the relative residual, from x = 0, which keeps Lanczos' matrix. Collective. */
struct meshless_gradients meshless_gradients_lanczos(struct meshless_matrix *a, const double *b, double tolerance,
                                                     struct meshless_lanczos *t);
