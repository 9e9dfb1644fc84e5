/* Micromodulus and critical stretch from a material's constants.  (001: eqs 3.21, 3.28; 000: eqs 9, 10, 16, 17) */
#include "solid/law/material.h"
#include "base/ensure.h"
#include "solid/law/micromodulus.h"

#include <math.h>

double solid_material_micromodulus(const struct solid_material *m, double spacing) {
    const double delta = m->horizon_ratio * spacing;
    return 12 * m->youngs_modulus / (M_PI * delta * delta * delta * delta);
}

double solid_material_critical_stretch(const struct solid_material *m, double spacing) {
    return sqrt(5 * m->fracture_energy / (6 * m->youngs_modulus * m->horizon_ratio * spacing));
}

/* c0 and, in place of s0, s0^2 of the constant law. */
static struct solid_constants constant_law(enum solid_model model, double thickness, const struct solid_material *m,
                                           double delta) {
    const double e = m->youngs_modulus, g = m->fracture_energy;
    switch (model) {
    case SOLID_3D:
        return (struct solid_constants){12 * e / (M_PI * delta * delta * delta * delta), 5 * g / (6 * e * delta)};
    case SOLID_PLANE_STRESS:
        return (struct solid_constants){9 * e / (M_PI * thickness * delta * delta * delta),
                                        4 * M_PI * g / (9 * e * delta)};
    case SOLID_PLANE_STRAIN:
        return (struct solid_constants){48 * e / (5 * M_PI * thickness * delta * delta * delta),
                                        5 * M_PI * g / (12 * e * delta)};
    }
    ENSURE(0, "model %d", (int)model);
}

struct solid_constants solid_material_constants(enum solid_model model, double thickness,
                                                const struct solid_material *m, double delta) {
    const struct solid_micromodulus *law = solid_micromodulus_of(m->micromodulus);
    const struct solid_constants constant = constant_law(model, thickness, m, delta);
    return (struct solid_constants){constant.c * law->stiffness[model], sqrt(constant.s0 * law->stretch2[model])};
}
