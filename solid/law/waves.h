/* Wave speeds of the solid that the bonds model. */
#pragma once
#include "solid/state.h"

struct solid_waves {
    double longitudinal, shear, rayleigh; /* m/s */
};

/* nu = 1/4 in 3D and in plane strain, 1/3 in plane stress. The Rayleigh wave runs along a free edge; its speed is an
 * upper limit of a crack tip's speed. */
struct solid_waves solid_waves_of(enum solid_model model, double youngs_modulus, double density);
