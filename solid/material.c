#include "solid/solid.h"

#include <math.h>

double solid_micromodulus(const struct solid_material *m, double spacing) {
    const double delta = m->horizon_ratio * spacing;
    return 12 * m->youngs_modulus / (M_PI * delta * delta * delta * delta);
}

double solid_critical_stretch(const struct solid_material *m, double spacing) {
    return sqrt(5 * m->fracture_energy / (6 * m->youngs_modulus * m->horizon_ratio * spacing));
}
