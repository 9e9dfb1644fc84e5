/* J and stress-intensity factors of a crack's tip in a plate with bonds, at rest under small strain.
 *
 * The nonlocal J integral of a contour (Hu et al. 2012) is
 *
 *     J = int_contour W n_1 ds - int_inside int_outside f . (u,1 + u',1)/2 dA' dA
 *
 * where axis 1 goes on from the crack, W is the energy density of the bonds and f the force density of a bond, which
 * the particle outside exerts on the one inside. Its mean over the circles about the tip from half a radius to the
 * radius is a sum over particles and bonds, which needs no contour and suits any arrangement of particles:
 *
 *     t J = - sum_h W_h q,1(x_h) V_h - sum_bonds (q_h - q_l) f_hl . (u,1_h + u,1_l)/2 V_h V_l
 *
 * q is 1 within half the radius and falls linearly to 0 at the radius; t is the thickness. u,1 is that of the quadratic
 * which fits the displacements of a particle's intact bonds best, so that it never looks across the crack.
 *
 * J is quadratic in u. K of a mode is E'/2 times the same sum in mixed form, for u and the field of a crack in an
 * infinite plate with K = 1 in this mode (Yau et al. 1980; physics/crack_tip.h). T is E' times the mixed form with the
 * field of a force on the tip (Kfouri 1986). */
#pragma once
#include "solid/state.h"

struct solid_tip {
    double x[2], along[2]; /* m; unit vector that goes on from the crack */
};
struct solid_intensity {
    double k[2];   /* K_I, K_II, Pa m^1/2 */
    double j, k_j; /* J/m2; root of J E', Pa m^1/2 */
    double t;      /* T-stress, Pa */
};
/* Of each radius, [radii], ascending or not, each at least two horizons. All particles near the tip are of the material
 * given. The ghosts' displacements must be current. Collective. */
void solid_intensity_measure(const struct solid *s, const struct solid_tip *tip, int material, int radii,
                             const double *radius, struct solid_intensity *is);
/* Whether a circle about the tip has particles all along it. Collective. */
int solid_intensity_is_inside(const struct solid *s, const struct solid_tip *tip, double radius);
