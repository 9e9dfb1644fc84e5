/* The coefficient of consolidation. */
#include "physics/consolidation.h"

double physics_consolidation_coefficient(const struct physics_consolidation *in) {
    const double nu = in->poisson_ratio;
    const double confined = in->youngs_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    return in->mobility / (1 / in->modulus + in->biot * in->biot / confined);
}
