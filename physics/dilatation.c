/* Constants of the linear solid of any Poisson's ratio.  (Silling et al. 2007; Madenci and Oterkus 2014) */
#include "physics/dilatation.h"
#include "base/ensure.h"

#include <math.h>

static double bulk_modulus(enum physics_model model, double e, double nu) {
    switch (model) {
    case PHYSICS_3D:
        return e / (3 * (1 - 2 * nu));
    case PHYSICS_PLANE_STRESS:
        return e / (2 * (1 - nu));
    case PHYSICS_PLANE_STRAIN:
        return e / (2 * (1 + nu) * (1 - 2 * nu));
    }
    ENSURE(0, "model %d", (int)model);
}

/* G0/(delta s0^2) = bonds + pressure:  3 mu and (3/4)^4 excess in space, 6 mu/pi and 16 excess/(9 pi^2) in plates. */
static double stretch2_of(enum physics_model model, double mu, double excess) {
    const double bonds = model == PHYSICS_3D ? 3 * mu : 6 * mu / M_PI,
                 pressure = model == PHYSICS_3D ? 81. / 256 * excess : 16 * excess / (9 * M_PI * M_PI);
    return bonds / (bonds + pressure);
}

struct physics_dilatation physics_dilatation_of(enum physics_model model, double youngs_modulus, double ratio_excess) {
    const double own = physics_model_poisson_ratio(model), nu = own + ratio_excess,
                 mu = youngs_modulus / (2 * (1 + nu)), of_bonds = (model == PHYSICS_3D ? 5. / 3 : 2.) * mu,
                 bulk = bulk_modulus(model, youngs_modulus, nu);
    if (ratio_excess == 0) return (struct physics_dilatation){youngs_modulus, bulk, 1};
    return (struct physics_dilatation){2 * (1 + own) * mu, bulk, stretch2_of(model, mu, bulk - of_bonds)};
}

double physics_dilatation_ratio_excess(enum physics_model model, double poisson_ratio) {
    const double excess = poisson_ratio - physics_model_poisson_ratio(model);
    if (model == PHYSICS_PLANE_STRESS && poisson_ratio >= 0.333 && poisson_ratio <= 0.3334) return 0;
    return fabs(excess) < 1e-9 ? 0 : excess;
}

double physics_dilatation_ratio(enum physics_model model, double poisson_ratio) {
    return physics_model_poisson_ratio(model) + physics_dilatation_ratio_excess(model, poisson_ratio);
}
