/* Constants of a material's bonds.  (001: eqs 3.21, 3.27; 000: eqs 9, 10, 16, 17) */
#pragma once
#include "physics/dilatation.h"
#include "physics/softening.h"
#include "solid/input.h"

/* What it has beyond bonds alone. */
struct physics_dilatation solid_material_dilatation(enum physics_model model, const struct solid_material *material);
double solid_material_poisson_ratio(enum physics_model model, const struct solid_material *material);

/* At a horizon, m; thickness, m, is used for plates only. */
struct physics_bond solid_material_constants(enum physics_model model, double thickness,
                                             const struct solid_material *material, double horizon);

/* The stretches of its bilinear law; 0 and 0 if it is brittle. */
struct physics_softening solid_material_softening(enum physics_model model, double thickness,
                                                  const struct solid_material *material, double horizon);

/* c0 and s0 of a material in 3D.  (001: eqs 3.21, 3.26) */
double solid_material_micromodulus(const struct solid_material *m, double spacing);
double solid_material_critical_stretch(const struct solid_material *m, double spacing);
/* The energy per area of a crack that bonds hold when each is at its critical stretch, J/m2: G0, but of materials with
 * a dilatation, whose critical stretch is another. */
double solid_material_bonds_energy(enum physics_model model, const struct solid_material *m);
/* c0 that a constant micromodulus would have, whatever the material's is: contact is measured by it. */
double solid_material_c0(const struct solid_input *in, const struct solid_material *m);
