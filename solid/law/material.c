/* Micromodulus and critical stretch from a material's constants.  (001: eqs 3.21, 3.28; 000: eqs 9, 10, 16, 17) */
#include "solid/law/material.h"

#include <math.h>

double solid_material_micromodulus(const struct solid_material *m, double spacing) {
    const double delta = m->horizon_ratio * spacing;
    return 12 * m->youngs_modulus / (M_PI * delta * delta * delta * delta);
}

double solid_material_critical_stretch(const struct solid_material *m, double spacing) {
    return sqrt(5 * m->fracture_energy / (6 * m->youngs_modulus * m->horizon_ratio * spacing));
}

/* A conical micromodulus has the stiffness of a constant one for c1 = 5 c0 in 3D and c1 = 4 c0 in a plate. It gives
 * shorter bonds more weight, so for the same G0 s0^2 is 6/5 (3D) and 5/4 (plate) of the constant one's. */
struct solid_constants solid_material_constants(enum solid_model model, double thickness,
                                                const struct solid_material *m, double delta) {
    const double e = m->youngs_modulus, g = m->fracture_energy;
    struct solid_constants k;
    double s2;
    switch (model) {
    case SOLID_PLANE_STRESS:
        k.c = 9 * e / (M_PI * thickness * delta * delta * delta);
        s2 = 4 * M_PI * g / (9 * e * delta);
        break;
    case SOLID_PLANE_STRAIN:
        k.c = 48 * e / (5 * M_PI * thickness * delta * delta * delta);
        s2 = 5 * M_PI * g / (12 * e * delta);
        break;
    default:
        k.c = 12 * e / (M_PI * delta * delta * delta * delta);
        s2 = 5 * g / (6 * e * delta);
    }
    if (m->micromodulus == SOLID_CONICAL) {
        k.c *= model == SOLID_3D ? 5 : 4;
        s2 *= model == SOLID_3D ? 6. / 5 : 5. / 4;
    }
    k.s0 = sqrt(s2);
    return k;
}
