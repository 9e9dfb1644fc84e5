/* Pores: the fluid in the intact solid. (docs/design/cracks.md) */
#pragma once
#include "cracks/cracks.h"

/* Conductance of a link by the pores alone: k0 V/(h^2 mu), V of a whole cell, h the spacing; m3/(s Pa). */
double cracks_pores_conductance(const struct cracks *c);
/* V_h/M of a wet particle, m3/Pa. */
double cracks_pores_storage(const struct cracks *c, int i);
