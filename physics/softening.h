/* The bilinear (softening) bond law: its two stretches from a tensile strength and a fracture energy.
 *
 * A bond is elastic up to the stretch s_e; beyond it the force falls linearly and is 0 at s_c. With f =
 * force/stiffness,
 *
 *     f(s) = s                                   s <= s_e
 *     f(s) = s_e (s_c - s)/(s_c - s_e)           s_e < s < s_c
 *
 * Damage is irreversible: below the largest stretch so far the bond is elastic with the secant stiffness. */
#pragma once
#include "physics/micromodulus.h"

struct physics_softening {
    double s_e, s_c; /* s_e = 0: no such law, the horizon is too wide */
};

/* sigma_t/(E' s_e): the largest stress of a body in uniaxial stress over the one at which its first bonds soften, as a
 * function of s_c/s_e >= 1. It is 1 at s_c = s_e, and rises slowly, because bonds of all directions share the load.
 * Bonds have all directions alike; the micromodulus does not matter. beyond: k/k_b - 1, what the dilatation bears
 * beside the bonds (physics/dilatation.h); a bond that softens loses the same part of its weight in the dilatation. */
double physics_softening_peak(enum physics_model model, double ratio, double beyond);

/* ratio_excess: Poisson's ratio less that of bonds alone. s0: the critical stretch of a brittle bond with the same
 * fracture energy at this horizon (physics/bond.h). The two stretches follow from s_e s_c = s0^2, which gives each bond
 * the same fracture energy as the brittle law, and from tensile_strength = E' s_e peak(s_c/s_e); E' = E, in plane
 * strain E/(1 - nu^2). */
struct physics_softening physics_softening_of(enum physics_model model, double youngs_modulus, double ratio_excess,
                                              double tensile_strength, double s0);
/* The fracture energy of a brittle material of this strength at this horizon, J/m2: s0 = strength/E'. */
double physics_softening_brittle_energy(enum physics_model model, enum physics_micromodulus kind, double youngs_modulus,
                                        double ratio_excess, double tensile_strength, double delta);
/* The horizon at which s_c = s_e, m. With wider ones a brittle bond of this fracture energy is weaker than the
 * strength. delta: the horizon that s0 belongs to. */
double physics_softening_widest(enum physics_model model, double youngs_modulus, double ratio_excess,
                                double tensile_strength, double s0, double delta);
