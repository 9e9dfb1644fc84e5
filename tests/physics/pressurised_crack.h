/* A crack at rest in an infinite elastic solid, opened by a uniform pressure within it; and a hole.  (Sneddon 1946)
 * E' = E/(1 - nu^2), Pa (physics_crack_tip_modulus); p Pa, lengths in m. */
#pragma once
#include "tests/check.h"

#include <math.h>

/* A straight crack of half-length a in plane strain; a circular one of radius a. */
enum crack_shape { CRACK_PLANE, CRACK_PENNY };

/* The distance between the crack's faces at x from its centre: 4 p a/E' sqrt(1 - (x/a)^2), of a penny 2/pi of that, m;
 * 0 beyond the tip. */
static inline double pressurised_crack_opening(enum crack_shape shape, double modulus, double p, double a, double x) {
    const double at = x / a, plane = at * at < 1 ? 4 * p * a / modulus * sqrt(1 - at * at) : 0;
    switch (shape) {
    case CRACK_PLANE:
        return plane;
    case CRACK_PENNY:
        return 2 / acos(-1) * plane;
    }
    fail();
    return NAN;
}

/* 2 pi p a^2/E' per thickness, m2; of a penny 16 p a^3/(3 E'), m3. */
static inline double pressurised_crack_volume(enum crack_shape shape, double modulus, double p, double a) {
    switch (shape) {
    case CRACK_PLANE:
        return 2 * acos(-1) * p * a * a / modulus;
    case CRACK_PENNY:
        return 16.0 / 3 * p * a * a * a / modulus;
    }
    fail();
    return NAN;
}

/* K_I = p sqrt(pi a); of a penny 2 p sqrt(a/pi), Pa m^1/2. */
static inline double pressurised_crack_intensity(enum crack_shape shape, double p, double a) {
    switch (shape) {
    case CRACK_PLANE:
        return p * sqrt(acos(-1) * a);
    case CRACK_PENNY:
        return 2 * p * sqrt(a / acos(-1));
    }
    fail();
    return NAN;
}

/* The pressure at which K_I^2 = E' G0: the crack begins to run, Pa.  (Griffith 1921) */
static inline double pressurised_crack_critical(enum crack_shape shape, double modulus, double fracture_energy,
                                                double a) {
    return sqrt(modulus * fracture_energy) / pressurised_crack_intensity(shape, 1, a);
}

/* How far the face of a round hole of radius R moves outwards under the pressure p within it: (1 + nu) p R/E, m; the
 * same in plane stress and in plane strain. */
static inline double pressurised_crack_hole(double youngs_modulus, double poisson_ratio, double p, double radius) {
    return (1 + poisson_ratio) * p * radius / youngs_modulus;
}
