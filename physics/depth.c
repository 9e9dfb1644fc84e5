/* Estimates the depth of a lattice site below a surface from the weighted number of its neighbours. */
#include "physics/depth.h"

#include <math.h>

static const double ALL = 10.68; /* weights of the 33 sites: 1 + 6 0.64 + 12 0.36 + 8 0.16 + 6 0.04 */
static const double FACE =
    7.92;                    /* of those at or below a face along the lattice: 1 + 5 0.64 + 8 0.36 + 4 0.16 + 5 0.04 */
static const double FAR = 2; /* the farthest site */

double physics_depth_weight(double r2) {
    const double t = 1 - r2 / 5;
    return r2 <= PHYSICS_DEPTH_REACH2 * (1 + 1e-6) ? t * t : 0;
}

static double integral(double z) {
    const double z2 = z * z;
    return z * (1 - 1 / 125.0 - z2 * (1 / 5.0 - z2 * (3 / 125.0 - z2 / 875)));
}

/* d with F(d) = fraction, by bisection: F rises with d. */
static double inverse(double fraction) {
    double low = -FAR, high = FAR;
    for (int n = 0; n < 60; n++) {
        const double d = 0.5 * (low + high);
        *(integral(d) < (2 * fraction - 1) * integral(FAR) ? &low : &high) = d;
    }
    return 0.5 * (low + high);
}

double physics_depth(double present) { return fmin(1, fmax(0, inverse(present / ALL) - inverse(FACE / ALL) + 0.5)); }
