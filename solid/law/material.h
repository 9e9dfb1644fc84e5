/* The numbers of a material's bonds.  (001: eqs 3.21, 3.28; 000: eqs 9, 10, 16, 17) */
#pragma once
#include "solid/input.h"

struct solid_constants {
    double c;  /* c(0): c0, or c1 of a law that varies with |xi|, N/m6 */
    double s0; /* critical stretch; INFINITY: never breaks */
};

/* At a horizon, m; thickness (m) is read for plates only. */
struct solid_constants solid_material_constants(enum solid_model model, double thickness,
                                                const struct solid_material *material, double horizon);

/* c0 and s0 of a material in 3D.  (001: eqs 3.21, 3.28) */
double solid_material_micromodulus(const struct solid_material *m, double spacing);
double solid_material_critical_stretch(const struct solid_material *m, double spacing);
