/* Wave speeds in an elastic plate or solid, for comparison with a crack's speed. */
#pragma once

struct postproc_waves {
    double dilatation, shear, rayleigh; /* m/s */
};
/* E in Pa, rho in kg/m3; plane_stress: waves in the plane of a thin plate, else in a solid or in plane strain. The
 * Rayleigh speed is the root of (2 - c^2/cs^2)^2 = 4 sqrt(1 - c^2/cd^2) sqrt(1 - c^2/cs^2).  (Rayleigh 1885) */
struct postproc_waves postproc_waves_of(double youngs_modulus, double poisson_ratio, double density, int plane_stress);
