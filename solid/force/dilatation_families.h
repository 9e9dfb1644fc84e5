/* Constants of each family for its dilatation (solid/force/dilatation.h). For solid/ only. */
#pragma once
#include "solid/state.h"

/* full, excess [n]: set for the owned particles of body b, N/m2, Pa. Not collective. */
void solid_dilatation_families(const struct solid *s, int b, double *full, double *excess);
