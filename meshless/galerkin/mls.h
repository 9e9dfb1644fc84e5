/* Shape functions of moving least squares.  (002: eqs 1 to 4)
 *
 *     phi_I(x) = p(x)^T M(x)^-1 w(x - x_I) p(x_I),   M(x) = sum_I w(x - x_I) p(x_I) p(x_I)^T
 *
 * The span of p decides phi, not the functions that span it. So p is taken about x: (1, dx/h, dy/h), and each function
 * of the tip minus its own tangent plane at x, over its second derivatives' size. M stays well conditioned far from the
 * tip, where the plain functions are almost linear. */
#pragma once
#include "meshless/galerkin/galerkin.h"

enum meshless_mls_fault { MESHLESS_MLS_DONE, MESHLESS_MLS_FEW, MESHLESS_MLS_MANY, MESHLESS_MLS_SINGULAR };

/* Shape functions and gradients at a place with the basis that is in force there: near a tip the whole basis, beyond
 * tip_radius the linear one, and between half of it and all of it a smooth mean of the two. */
enum meshless_mls_fault meshless_mls_shape(const struct galerkin *g, const struct galerkin_place *at,
                                           struct galerkin_shape *shape);
/* Functions of the basis that belong to a tip, at x: value [n] and gradient [n][2]. Returns n. */
int meshless_mls_functions(enum galerkin_basis basis, const struct galerkin_tip *tip, const double x[2],
                           const double see[2], double *value, double (*gradient)[2]);
/* meshless_mls_shape that dies (exit 2) with a sentence. Collective (same place on all ranks). */
void meshless_mls_need(const struct galerkin *g, const struct galerkin_place *at, struct galerkin_shape *shape);

void meshless_mls_bins(struct galerkin *g); /* Not collective. */
