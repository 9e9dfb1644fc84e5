/* Wave speeds of an isotropic solid from modulus, Poisson's ratio and density. */
#include "postproc/data/waves.h"

#include <math.h>

/* Rayleigh's function of (c/cs)^2, negative below the root; q = (cs/cd)^2. */
static double rayleigh(double x, double q) { return (2 - x) * (2 - x) - 4 * sqrt(1 - q * x) * sqrt(1 - x); }

struct postproc_waves postproc_waves_of(double youngs_modulus, double poisson_ratio, double density, int plane_stress) {
    const double nu = poisson_ratio, c2 = youngs_modulus / density;
    const double d2 = plane_stress ? c2 / (1 - nu * nu) : c2 * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    const double s2 = c2 / (2 * (1 + nu)), q = s2 / d2;
    double low = 0.1, high = 1; /* x = 0 is also a root, but no wave */
    for (int k = 0; k < 60; k++) {
        const double middle = 0.5 * (low + high);
        if (rayleigh(middle, q) < 0)
            low = middle;
        else
            high = middle;
    }
    return (struct postproc_waves){sqrt(d2), sqrt(s2), sqrt(0.5 * (low + high) * s2)};
}
