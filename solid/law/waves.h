/* Wave speeds of the solid that the bonds stand for. */
#pragma once
#include "solid/state.h"

struct solid_waves {
    double longitudinal, shear, rayleigh; /* m/s */
};

/* nu = 1/4 in space and in plane strain, 1/3 in plane stress. Rayleigh's wave runs along a free edge; a crack's tip
 * does not pass it. */
struct solid_waves solid_waves_of(enum solid_model model, double youngs_modulus, double density);
