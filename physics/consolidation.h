/* Consolidation: how fast the pressure of the fluid in a porous elastic solid spreads. */
#pragma once

/* An isotropic porous solid.  (Detournay and Cheng 1993) */
struct physics_consolidation {
    double youngs_modulus, poisson_ratio; /* drained, Pa, 1 */
    double biot;                          /* alpha, 1 */
    double modulus;                       /* M, Pa; INFINITY: fluid and grains do not compress */
    double mobility;                      /* permeability over viscosity k/mu, m2/(Pa s) */
};

/* c = k/mu/(1/M + alpha^2/K_v), m2/s, with the modulus of confined compression
 * K_v = E (1 - nu)/((1 + nu)(1 - 2 nu)), which is 1.2 E at nu = 1/4. */
double physics_consolidation_coefficient(const struct physics_consolidation *in);
