/* Constant micromodulus: c(xi) = c0.  (000: eq. 9) */
#include "physics/micromodulus.h"

static double one(double q) {
    (void)q;
    return 1;
}

const struct physics_micromodulus_law physics_micromodulus_constant = {
    .name = "constant",
    .profile = one,
    .is_constant = 1,
    .stiffness = {[PHYSICS_3D] = 1, [PHYSICS_PLANE_STRESS] = 1, [PHYSICS_PLANE_STRAIN] = 1},
    .stretch2 = {[PHYSICS_3D] = 1, [PHYSICS_PLANE_STRESS] = 1, [PHYSICS_PLANE_STRAIN] = 1}};
