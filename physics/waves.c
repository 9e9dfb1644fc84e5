/* Longitudinal, shear and Rayleigh wave speeds from modulus, Poisson's ratio and density. */
#include "physics/waves.h"

#include <math.h>

/* Rayleigh's equation in x = (c/c_s)^2 with q = (c_s/c_l)^2:  (2 - x)^2 = 4 sqrt(1 - x) sqrt(1 - q x),  its root
 * between 0.5 and 1. */
static double rayleigh(double q) {
    double low = 0.5, high = 1;
    for (int i = 0; i < 60; i++) {
        const double x = 0.5 * (low + high);
        if ((2 - x) * (2 - x) < 4 * sqrt((1 - x) * (1 - q * x)))
            low = x;
        else
            high = x;
    }
    return sqrt(low);
}

struct physics_waves physics_waves_of(enum physics_model model, double youngs_modulus, double poisson_ratio,
                                      double density) {
    const double e = youngs_modulus, nu = poisson_ratio;
    const double lateral = model == PHYSICS_PLANE_STRESS ? 1 / (1 - nu * nu) : (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    struct physics_waves w = {sqrt(lateral * e / density), sqrt(e / (2 * (1 + nu) * density)), 0};
    w.rayleigh = w.shear * rayleigh(w.shear * w.shear / (w.longitudinal * w.longitudinal));
    return w;
}
