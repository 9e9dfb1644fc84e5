/* The 2-norm condition number of a symmetric positive matrix. */
#pragma once
#include "meshless/nonlocal/matrix.h"

enum { MESHLESS_CONDITION_DENSE = 2000 }; /* unknowns up to which all eigenvalues are computed */

/* Largest eigenvalue over the least: by LAPACK's dsyev up to MESHLESS_CONDITION_DENSE unknowns, by Lanczos beyond.
 * Collective. */
double meshless_condition(struct meshless_matrix *a);
double meshless_condition_dense(struct meshless_matrix *a);   /* Collective. */
double meshless_condition_lanczos(struct meshless_matrix *a); /* Collective. */
