/* The solution at a place. */
#pragma once
#include "meshless/galerkin/galerkin.h"

/* Displacement and its gradient du_i/dx_j at a place. Not collective. */
void meshless_field_at(const struct galerkin *g, const struct galerkin_place *at, double u[2], double grad[2][2]);
/* Stress xx, yy, xy from a gradient. */
void meshless_field_stress(const struct galerkin *g, const double grad[2][2], double stress[3]);
