/* The nonlocal boundary-value problem with the manufactured solution u = R^2 - |x|^2 in a ball of 1, 2 or 3 dimensions:
 * u is solved for in |x| <= r and given in r < |x| <= R.  (004: eqs 1, 10) */
#pragma once
#include "meshless/nonlocal/gradients.h"

struct meshless_nonlocal_input {
    int dimension;                        /* 1, 2, 3 */
    double exponent;                      /* P, below dimension + 2 */
    double horizon, inner, outer;         /* delta, r, R, m */
    struct meshless_arrange_input points; /* all but the domain */
};

struct meshless_nonlocal {
    struct meshless_nonlocal_input in;
    struct meshless_points *points;
    char *free; /* [points] 1: solved for */
    struct meshless_matrix *matrix;
    double *u; /* [matrix->rows] solution */
    double b;  /* the right-hand side, the same everywhere */
    struct meshless_gradients solved;
    double operator_mean,
        operator_max;            /* (discrete operator of the exact u - b) / b: mean; of largest size, with sign */
    double error_linf, error_l2; /* largest |u_i - u(x_i)|; root of the sum of squares, relative to that of u */
    double condition;            /* 0: not computed */
};

/* b = S delta^(d + 2 - P) / (d + 2 - P), S = 2, 2 pi, 4 pi in d = 1, 2, 3 dimensions. */
double meshless_nonlocal_load(int dimension, double exponent, double horizon);
/* Puts the points. Dies (exit 2) where outer < inner + horizon. Collective, as all below. */
struct meshless_nonlocal *meshless_nonlocal_new(const struct meshless_nonlocal_input *in);
void meshless_nonlocal_assemble(struct meshless_nonlocal *n);
/* Dies (exit 3) where the conjugate gradients do not converge. */
void meshless_nonlocal_solve(struct meshless_nonlocal *n);
void meshless_nonlocal_measure(struct meshless_nonlocal *n);
void meshless_nonlocal_free(struct meshless_nonlocal *n);
/* u = R^2 - |x|^2 at a point. Pure. */
double meshless_nonlocal_exact(const struct meshless_nonlocal *n, long i);
