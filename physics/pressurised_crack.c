/* Opening, volume, stress intensity and critical pressure of a crack under uniform pressure. */
#include "physics/pressurised_crack.h"
#include "base/ensure.h"

#include <math.h>

double physics_pressurised_crack_opening(enum physics_crack_shape shape, double modulus, double p, double a, double x) {
    const double at = x / a, plane = at * at < 1 ? 4 * p * a / modulus * sqrt(1 - at * at) : 0;
    switch (shape) {
    case PHYSICS_CRACK_PLANE:
        return plane;
    case PHYSICS_CRACK_PENNY:
        return 2 / acos(-1) * plane;
    }
    ENSURE(0, "shape %d", (int)shape);
}

double physics_pressurised_crack_volume(enum physics_crack_shape shape, double modulus, double p, double a) {
    switch (shape) {
    case PHYSICS_CRACK_PLANE:
        return 2 * acos(-1) * p * a * a / modulus;
    case PHYSICS_CRACK_PENNY:
        return 16.0 / 3 * p * a * a * a / modulus;
    }
    ENSURE(0, "shape %d", (int)shape);
}

double physics_pressurised_crack_intensity(enum physics_crack_shape shape, double p, double a) {
    switch (shape) {
    case PHYSICS_CRACK_PLANE:
        return p * sqrt(acos(-1) * a);
    case PHYSICS_CRACK_PENNY:
        return 2 * p * sqrt(a / acos(-1));
    }
    ENSURE(0, "shape %d", (int)shape);
}

double physics_pressurised_crack_critical(enum physics_crack_shape shape, double modulus, double fracture_energy,
                                          double a) {
    return sqrt(modulus * fracture_energy) / physics_pressurised_crack_intensity(shape, 1, a);
}

double physics_pressurised_crack_hole(double youngs_modulus, double poisson_ratio, double p, double radius) {
    return (1 + poisson_ratio) * p * radius / youngs_modulus;
}
