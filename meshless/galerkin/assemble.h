/* Stiffness and load, in LAPACK's band storage.
 *
 * Gradients in a piece are corrected by a constant a node, so that their mean is (1/A) of the integral of phi n over
 * the piece's edges. The sum over all pieces is then that over the body's outline: linear displacements are in
 * equilibrium to rounding (patch test), however coarse the quadrature is. Constant and linear fields keep their exact
 * gradients. (Chen et al. 2001; Duan et al. 2012) */
#pragma once
#include "meshless/galerkin/galerkin.h"

/* Numbers the nodes along the longer side of the body and sets half_band. Collective. */
void meshless_assemble_order(struct galerkin *g);
/* band [2 nodes][half_band + 1]: the lower triangle by columns, K + penalty G^T G; load [2 nodes] in the order of the
 * band. Collective. */
void meshless_assemble(const struct galerkin *g, double penalty, double *band, double *load);
/* y = K u without constraints, unknowns in the nodes' own order. Not collective. */
void meshless_assemble_apply(const struct galerkin *g, const double *u, double *y);
/* Unknown 2 node + c in the band. */
static inline int meshless_assemble_place(const struct galerkin *g, int unknown) {
    return 2 * g->rank[unknown / 2] + unknown % 2;
}
