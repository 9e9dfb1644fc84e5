/* Kink angle and equivalent stress-intensity factor by the maximum hoop stress. */
#include "physics/kink.h"

#include <math.h>

/* K_I sin t + K_II (3 cos t - 1) = 0 with t in the half plane of the larger hoop stress: tan t/2 = (K_I - s)/(4 K_II),
 * s = sqrt(K_I^2 + 8 K_II^2). The other form of the quotient does not cancel where K_II is small. */
double physics_kink_angle(const double k[2]) {
    const double s = sqrt(k[0] * k[0] + 8 * k[1] * k[1]);
    if (s == 0 || (k[1] == 0 && k[0] < 0)) return 0;
    return 2 * atan(k[0] >= 0 ? -2 * k[1] / (k[0] + s) : (k[0] - s) / (4 * k[1]));
}

double physics_kink_equivalent(const double k[2]) {
    const double t = physics_kink_angle(k), c = cos(t / 2);
    return c * (k[0] * c * c - 1.5 * k[1] * sin(t));
}
