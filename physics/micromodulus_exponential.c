/* Exponential micromodulus: c(xi) = c1 exp(-|xi|/l) with l = delta/2, cut off at the horizon.
 *
 * Exponential decay over a length l is one of the usual forms (Lubineau et al. 2012); tied to the horizon it needs no
 * further constant. At the horizon c is c1 exp(-2) = 0.135 c1. With I_k = int_0^1 q^k exp(-2 q) dq, by parts,
 *     I_2 = (1 - 5 e)/4     I_3 = (3 - 19 e)/8     I_4 = (3 - 21 e)/4     e = exp(-2)                               */
#include "physics/micromodulus.h"

#include <math.h>

#define E 0.135335283236612692 /* exp(-2) */
#define I2 ((1 - 5 * E) / 4)
#define I3 ((3 - 19 * E) / 8)
#define I4 ((3 - 21 * E) / 4)

static double decay(double q) { return exp(-2 * q); }

const struct physics_micromodulus_law physics_micromodulus_exponential = {
    .name = "exponential",
    .profile = decay,
    .stiffness =
        {[PHYSICS_3D] = 1 / (4 * I3), [PHYSICS_PLANE_STRESS] = 1 / (3 * I2), [PHYSICS_PLANE_STRAIN] = 1 / (3 * I2)},
    .stretch2 = {[PHYSICS_3D] = 4 * I3 / (5 * I4),
                 [PHYSICS_PLANE_STRESS] = 3 * I2 / (4 * I3),
                 [PHYSICS_PLANE_STRAIN] = 3 * I2 / (4 * I3)}};
