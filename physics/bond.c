/* Micromodulus and critical stretch of the bonds from a material's constants.  (001: eqs 3.21, 3.27; 000: eqs 9, 10,
 * 16, 17) */
#include "physics/bond.h"
#include "physics/dilatation.h"

#include <math.h>

struct physics_bond physics_bond_of(enum physics_model model, enum physics_micromodulus kind, double thickness,
                                    double youngs_modulus, double fracture_energy, double delta) {
    const double e = youngs_modulus, g = fracture_energy;
    const struct physics_micromodulus_law *law = physics_micromodulus_of(kind);
    struct physics_bond k = {0};
    double s2 = 0;
    switch (model) {
    case PHYSICS_PLANE_STRESS:
        k.c = 9 * e / (M_PI * thickness * delta * delta * delta);
        s2 = 4 * M_PI * g / (9 * e * delta);
        break;
    case PHYSICS_PLANE_STRAIN:
        k.c = 48 * e / (5 * M_PI * thickness * delta * delta * delta);
        s2 = 5 * M_PI * g / (12 * e * delta);
        break;
    case PHYSICS_3D:
        k.c = 12 * e / (M_PI * delta * delta * delta * delta);
        s2 = 5 * g / (6 * e * delta);
    }
    k.c *= law->stiffness[model];
    k.s0 = sqrt(s2 * law->stretch2[model]);
    return k;
}

struct physics_bond physics_bond_elastic(enum physics_model model, enum physics_micromodulus kind, double thickness,
                                         double youngs_modulus, double ratio_excess, double fracture_energy,
                                         double delta) {
    const struct physics_dilatation beyond = physics_dilatation_of(model, youngs_modulus, ratio_excess);
    struct physics_bond k = physics_bond_of(model, kind, thickness, beyond.bonds_modulus, fracture_energy, delta);
    if (ratio_excess != 0) k.s0 *= sqrt(beyond.stretch2);
    return k;
}

double physics_bond_lattice_stretch(double youngs_modulus, double fracture_energy, double ratio, double spacing) {
    return sqrt(5 * fracture_energy / (6 * youngs_modulus * ratio * spacing));
}
