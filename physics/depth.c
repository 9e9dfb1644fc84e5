/* Estimates the depth of a lattice site below a surface from the weighted number of its neighbours. */
#include "physics/depth.h"

#include <math.h>

enum {
    ALL = 25 + 6 * 16 + 12 * 9 + 8 * 4 + 6 * 1, /* weights of the 33 sites */
    FACE = 25 + 5 * 16 + 8 * 9 + 4 * 4 + 5 * 1  /* of those that are not above a face along the lattice */
};
static const double FAR = 2; /* the farthest site */

int physics_depth_weight(int r2) { return r2 <= PHYSICS_DEPTH_REACH2 ? (5 - r2) * (5 - r2) : 0; }

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

double physics_depth(int present) {
    return fmin(1, fmax(0, inverse((double)present / ALL) - inverse((double)FACE / ALL) + 0.5));
}
