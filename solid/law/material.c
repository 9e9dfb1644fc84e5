/* The numbers of a material's bonds, by the formulas of physics/bond.c. */
#include "solid/law/material.h"
#include "base/ensure.h"
#include "physics/micromodulus.h"

double solid_material_micromodulus(const struct solid_material *m, double spacing) {
    return physics_bond_of(PHYSICS_3D, PHYSICS_CONSTANT, 0, m->youngs_modulus, m->fracture_energy,
                           m->horizon_ratio * spacing)
        .c;
}

double solid_material_critical_stretch(const struct solid_material *m, double spacing) {
    return physics_bond_lattice_stretch(m->youngs_modulus, m->fracture_energy, m->horizon_ratio, spacing);
}

struct physics_bond solid_material_constants(enum physics_model model, double thickness, const struct solid_material *m,
                                             double delta) {
    return physics_bond_of(model, m->micromodulus, thickness, m->youngs_modulus, m->fracture_energy, delta);
}

struct physics_softening solid_material_softening(enum physics_model model, double thickness,
                                                  const struct solid_material *m, double delta) {
    if (!(m->tensile_strength > 0)) return (struct physics_softening){0, 0};
    return physics_softening_of(model, m->youngs_modulus, m->tensile_strength,
                                solid_material_constants(model, thickness, m, delta).s0);
}

double solid_material_c0(const struct solid_input *in, const struct solid_material *m) {
    return physics_bond_of(in->model, PHYSICS_CONSTANT, in->thickness, m->youngs_modulus, m->fracture_energy,
                           m->horizon_ratio * in->spacing)
        .c;
}
