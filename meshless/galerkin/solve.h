/* The augmented Lagrangian: min over u, max over r of 1/2 u K u - f u + r (G u - g) + alpha/2 |G u - g|^2.
 *                                                                                             (002: eqs 8 to 11)
 * K + alpha G^T G is factored once (LAPACK's banded Cholesky). The multipliers r are found by conjugate gradients on
 * the dual problem, or by the updates of Hestenes and Powell, r += alpha (G u - g), which are steepest ascent with a
 * fixed step. Each iteration is one solution with the factor. */
#pragma once
#include "meshless/galerkin/galerkin.h"

/* Fills in g->solution. Dies (exit 2) where the stiffness is not positive; a violation that stays above the tolerance
 * gives converged = 0. Collective. */
void meshless_galerkin_solve(struct galerkin *g);
