/* Stress and displacement about a crack's tip in modes I and II, and by a force on the tip. */
#include "physics/crack_tip.h"

#include <math.h>

double physics_crack_tip_modulus(const struct physics_crack_tip *in) {
    const double nu = in->poisson_ratio;
    return in->plane_strain ? in->youngs_modulus / (1 - nu * nu) : in->youngs_modulus;
}

/* Only sigma_rr = -cos t/(pi r) is not 0. */
static void by_force(const struct physics_crack_tip *in, double r, double t, double stress[3], double u[2],
                     double slope[2]) {
    const double nu = in->plane_strain ? in->poisson_ratio / (1 - in->poisson_ratio) : in->poisson_ratio;
    const double pi = acos(-1), c = cos(t), s = sin(t), radial = -c / (pi * r);
    const double size = 1 / (pi * physics_crack_tip_modulus(in));
    stress[0] = radial * c * c;
    stress[1] = radial * s * s;
    stress[2] = radial * s * c;
    u[0] = -size * (log(r) + 0.5 * (1 + nu) * s * s);
    u[1] = size * (0.5 * (1 + nu) * s * c - 0.5 * (1 - nu) * t);
    slope[0] = -size * c / r * (1 - (1 + nu) * s * s);
    slope[1] = -size * s / r * (0.5 * (1 + nu) * (c * c - s * s) - 0.5 * (1 - nu));
}

void physics_crack_tip_field(const struct physics_crack_tip *in, int mode, double r, double t, double stress[3],
                             double u[2], double slope[2]) {
    const double nu = in->poisson_ratio, mu = in->youngs_modulus / (2 * (1 + nu));
    const double kappa = in->plane_strain ? 3 - 4 * nu : (3 - nu) / (1 + nu), pi = acos(-1);
    const double c = cos(t / 2), s = sin(t / 2), c3 = cos(1.5 * t), s3 = sin(1.5 * t);
    const double over = 1 / sqrt(2 * pi * r), size = sqrt(r / (2 * pi)) / (2 * mu);
    double du[2]; /* u over size, and its derivative with the angle */
    if (mode == 2) {
        by_force(in, r, t, stress, u, slope);
        return;
    }
    if (mode == 0) {
        stress[0] = over * c * (1 - s * s3);
        stress[1] = over * c * (1 + s * s3);
        stress[2] = over * s * c * c3;
        u[0] = c * (kappa - 1 + 2 * s * s);
        u[1] = s * (kappa + 1 - 2 * c * c);
        du[0] = -0.5 * s * (kappa - 1 + 2 * s * s) + 2 * c * c * s;
        du[1] = 0.5 * c * (kappa + 1 - 2 * c * c) + 2 * s * s * c;
    } else {
        stress[0] = -over * s * (2 + c * c3);
        stress[1] = over * s * c * c3;
        stress[2] = over * c * (1 - s * s3);
        u[0] = s * (kappa + 1 + 2 * c * c);
        u[1] = -c * (kappa - 1 - 2 * s * s);
        du[0] = 0.5 * c * (kappa + 1 + 2 * c * c) - 2 * s * s * c;
        du[1] = 0.5 * s * (kappa - 1 - 2 * s * s) + 2 * c * c * s;
    }
    for (int k = 0; k < 2; k++) {
        slope[k] = size / r * (0.5 * u[k] * cos(t) - du[k] * sin(t));
        u[k] *= size;
    }
}
