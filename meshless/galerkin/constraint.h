/* Rows of the constraints G u = g: given displacements, and continuity across the virtual cracks' extensions. */
#pragma once
#include "meshless/galerkin/galerkin.h"

/* Dies (exit 2) where a constraint holds nothing, or where the body can still move as a rigid one. Collective. */
void meshless_constraint_new(struct galerkin *g);
void meshless_constraint_free(struct galerkin *g);
/* y = G u, [rows]; with its transpose, u += factor G^T r. Not collective. */
void meshless_constraint_apply(const struct galerkin *g, const double *u, double *y);
void meshless_constraint_add(const struct galerkin *g, double factor, const double *r, double *u);
