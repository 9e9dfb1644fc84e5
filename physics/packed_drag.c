/* Drag of a flow on grains, from a single one to a packed bed. */
#include "physics/packed_drag.h"

#include <math.h>

static double of_single(double reynolds) {
    return fmax(24 / reynolds * (1 + 0.15 * pow(reynolds, 0.687)), reynolds > 1000 ? 0.44 : 0);
}

double physics_packed_drag(double e, double velocity, double d, double density, double viscosity) {
    const double solid = 1 - e, inertia = density * velocity * velocity / d;
    if (!(velocity > 0)) return 0;
    if (e <= PHYSICS_PACKED) {
        const double cube = e * e * e;
        return 150 * viscosity * velocity * solid * solid / (cube * d * d) + 1.75 * inertia * solid / cube;
    }
    return 0.75 * of_single(density * velocity * d / viscosity) * inertia * solid * pow(e, -2.65);
}
