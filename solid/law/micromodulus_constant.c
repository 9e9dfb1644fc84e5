/* Constant micromodulus: c(xi) = c0.  (000: eq. 9) */
#include "solid/law/micromodulus.h"

static double one(double q) {
    (void)q;
    return 1;
}

const struct solid_micromodulus solid_micromodulus_constant = {
    .name = "constant",
    .profile = one,
    .is_constant = 1,
    .stiffness = {[SOLID_3D] = 1, [SOLID_PLANE_STRESS] = 1, [SOLID_PLANE_STRAIN] = 1},
    .stretch2 = {[SOLID_3D] = 1, [SOLID_PLANE_STRESS] = 1, [SOLID_PLANE_STRAIN] = 1}};
