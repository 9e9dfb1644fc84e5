/* Speeds of waves in an isotropic elastic solid or plate. */
#pragma once
#include "physics/model.h"

struct physics_waves {
    double longitudinal, shear, rayleigh; /* m/s */
};

/* E Pa, density kg/m3. Plane stress: waves in the plane of a thin plate; else in a solid or in plane strain. The
 * Rayleigh wave runs along a free edge, and no crack's tip passes it: its speed c is the root of
 *     (2 - c^2/cs^2)^2 = 4 sqrt(1 - c^2/cl^2) sqrt(1 - c^2/cs^2) .                                  (Rayleigh 1885) */
struct physics_waves physics_waves_of(enum physics_model model, double youngs_modulus, double poisson_ratio,
                                      double density);
