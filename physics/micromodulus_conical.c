/* Conical micromodulus: c(xi) = c1 (1 - |xi|/delta).  (000: eq. 10) */
#include "physics/micromodulus.h"

static double cone(double q) { return 1 - q; }

/* Its bonds are shorter in the mean than a constant law's, so s0 is larger. */
const struct physics_micromodulus_law physics_micromodulus_conical = {
    .name = "conical",
    .profile = cone,
    .ends_at_horizon = 1,
    .stiffness = {[PHYSICS_3D] = 5, [PHYSICS_PLANE_STRESS] = 4, [PHYSICS_PLANE_STRAIN] = 4},
    .stretch2 = {[PHYSICS_3D] = 6. / 5, [PHYSICS_PLANE_STRESS] = 5. / 4, [PHYSICS_PLANE_STRAIN] = 5. / 4}};
