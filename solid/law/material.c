/* The numbers of a material's bonds, by the formulas of physics/bond.c. */
#include "solid/law/material.h"
#include "physics/micromodulus.h"

#include <math.h>

struct physics_dilatation solid_material_dilatation(enum physics_model model, const struct solid_material *m) {
    return physics_dilatation_of(model, m->youngs_modulus, m->ratio_excess);
}

double solid_material_poisson_ratio(enum physics_model model, const struct solid_material *m) {
    return physics_model_poisson_ratio(model) + m->ratio_excess;
}

double solid_material_micromodulus(const struct solid_material *m, double spacing) {
    const double modulus = solid_material_dilatation(PHYSICS_3D, m).bonds_modulus;
    return physics_bond_of(PHYSICS_3D, PHYSICS_CONSTANT, 0, modulus, m->fracture_energy, m->horizon_ratio * spacing).c;
}

double solid_material_critical_stretch(const struct solid_material *m, double spacing) {
    const struct physics_dilatation k = solid_material_dilatation(PHYSICS_3D, m);
    const double s0 = physics_bond_lattice_stretch(k.bonds_modulus, m->fracture_energy, m->horizon_ratio, spacing);
    return m->ratio_excess == 0 ? s0 : s0 * sqrt(k.stretch2);
}

struct physics_bond solid_material_constants(enum physics_model model, double thickness, const struct solid_material *m,
                                             double delta) {
    return physics_bond_elastic(model, m->micromodulus, thickness, m->youngs_modulus, m->ratio_excess,
                                m->fracture_energy, delta);
}

struct physics_softening solid_material_softening(enum physics_model model, double thickness,
                                                  const struct solid_material *m, double delta) {
    if (!(m->tensile_strength > 0)) return (struct physics_softening){0, 0};
    return physics_softening_of(model, m->youngs_modulus, m->ratio_excess, m->tensile_strength,
                                solid_material_constants(model, thickness, m, delta).s0);
}

double solid_material_bonds_energy(enum physics_model model, const struct solid_material *m) {
    return m->fracture_energy * solid_material_dilatation(model, m).stretch2;
}

double solid_material_c0(const struct solid_input *in, const struct solid_material *m) {
    return physics_bond_of(in->model, PHYSICS_CONSTANT, in->thickness,
                           solid_material_dilatation(in->model, m).bonds_modulus, m->fracture_energy,
                           m->horizon_ratio * in->spacing)
        .c;
}
