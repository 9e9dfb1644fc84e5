/* A crack at rest in an infinite elastic solid, opened by a uniform pressure within it; and a hole.  (Sneddon 1946) */
#pragma once

/* A straight crack of half-length a in plane strain; a circular one of radius a. */
enum physics_crack_shape { PHYSICS_CRACK_PLANE, PHYSICS_CRACK_PENNY };

/* E' = E/(1 - nu^2), Pa (physics_crack_tip_modulus); p Pa, lengths in m. */
/* The distance between the crack's faces at x from its centre: 4 p a/E' sqrt(1 - (x/a)^2), of a penny 2/pi of that, m;
 * 0 beyond the tip. */
double physics_pressurised_crack_opening(enum physics_crack_shape shape, double modulus, double p, double a, double x);
/* 2 pi p a^2/E' per thickness, m2; of a penny 16 p a^3/(3 E'), m3. */
double physics_pressurised_crack_volume(enum physics_crack_shape shape, double modulus, double p, double a);
/* K_I = p sqrt(pi a); of a penny 2 p sqrt(a/pi), Pa m^1/2. */
double physics_pressurised_crack_intensity(enum physics_crack_shape shape, double p, double a);
/* The pressure at which K_I^2 = E' G0: the crack begins to run, Pa.  (Griffith 1921) */
double physics_pressurised_crack_critical(enum physics_crack_shape shape, double modulus, double fracture_energy,
                                          double a);

/* How far the face of a round hole of radius R moves outwards under the pressure p within it: (1 + nu) p R/E, m; the
 * same in plane stress and in plane strain. */
double physics_pressurised_crack_hole(double youngs_modulus, double poisson_ratio, double p, double radius);
