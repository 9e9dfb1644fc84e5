/* Consolidation: the pressure of the fluid in a porous elastic solid that is loaded at once and then drains. */
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
/* Poisson's ratio while no fluid moves: (3 K_u - 2 G)/(2 (3 K_u + G)), K_u = K + alpha^2 M; 1/2 if M is INFINITY. */
double physics_consolidation_undrained(const struct physics_consolidation *in);
/* Skempton's B: the pressure over the mean compression while no fluid moves, alpha M/K_u. */
double physics_consolidation_skempton(const struct physics_consolidation *in);

/* Terzaghi's column, whose top drains and whose base is closed, under a load from time 0 on: the pressure over that of
 * time 0 at the depth z, in parts of the height H; T = c t/H^2 >= 0.  (Terzaghi 1943)
 *     p/p_u = sum over m of 2/M sin(M z/H) exp(-M^2 T),   M = pi (2 m + 1)/2 */
double physics_consolidation_terzaghi(double depth, double T);
/* The part of the settlement that has come: 1 - sum of 2/M^2 exp(-M^2 T). */
double physics_consolidation_degree(double T);

/* Mandel's slab |x| <= a between two stiff plates, pressed with the force 2 F per depth from time 0 on, which drains at
 * x = +-a: the pressure over that of time 0, which is B (1 + nu_u)/3 F/a; x in parts of a, T = c t/a^2 >= 1e-6.
 * (Mandel 1953; Abousleiman et al. 1996)
 *     p/p_0 = 2 sum over i of sin b/(b - sin b cos b) (cos(b x/a) - cos b) exp(-b^2 T),
 *     tan b = b (1 - nu)/(nu_u - nu),   b in (i pi, (i + 1/2) pi) */
double physics_consolidation_mandel(double poisson_ratio, double undrained, double x, double T);
