/* Micromodulus and critical stretch of the bonds from a material's constants.  (001: eqs 3.21, 3.27; 000: eqs 9, 10,
 * 16, 17) */
#pragma once
#include "physics/micromodulus.h"

struct physics_bond {
    double c;  /* c0, or c1 of a conical micromodulus, N/m6 */
    double s0; /* critical stretch; INFINITY: bonds never break */
};

/* E Pa, G0 J/m2, delta m: horizon; thickness (m) is read for plates only.
 *     model          c0                       E delta s0^2/G0       s0 of G0: the energy of all bonds across a plane
 *     3D             12 E/(pi delta^4)        5/6
 *     plane stress    9 E/(pi t delta^3)      4 pi/9
 *     plane strain   48 E/(5 pi t delta^3)    5 pi/12
 * Another micromodulus multiplies c0 and s0^2 by the factors of its law. */
struct physics_bond physics_bond_of(enum physics_model model, enum physics_micromodulus kind, double thickness,
                                    double youngs_modulus, double fracture_energy, double delta);

/* The same of a material with any Poisson's ratio (physics/dilatation.h), ratio_excess above that of bonds alone. */
struct physics_bond physics_bond_elastic(enum physics_model model, enum physics_micromodulus kind, double thickness,
                                         double youngs_modulus, double ratio_excess, double fracture_energy,
                                         double delta);

/* s0 of a constant micromodulus in 3D, delta = ratio * spacing: equal to physics_bond_of's up to the last digit, on
 * which results on lattices depend. */
double physics_bond_lattice_stretch(double youngs_modulus, double fracture_energy, double ratio, double spacing);
