/* Constants of one bond, from its two ends. Lengths are in spacings of the lattice, volumes in spacings^dim: the
 * constants do not depend on the absolute size, and positions are exact (solid/body/cloud.h).
 *
 * Every particle has a horizon delta_h, and with it c_h(xi) and s0_h. A bond's stiffness is the mean of two halves, one
 * from each end. The half of h is c_h(xi) Gamma_h(l) if l is in the family of h, else 0.
 *
 *     dual horizon:  K_hl = K_lh = (c_h Gamma_h(l) + c_l Gamma_l(h))/2
 *                    breaks at s0^2 = sum(c Gamma s0^2)/sum(c Gamma)
 *     one-sided:     K_hl = c_h Gamma_h(l), breaks at s0_h  (000: sec. 1.2.5)
 *
 * The force density on h is K_hl s e V_l. So a broken bond releases the energy of both halves. */
#pragma once
#include "solid/state.h"

struct physics_micromodulus_law; /* physics/micromodulus.h */

/* One end of a bond. */
struct solid_end {
    double size;    /* side of the particle's cell */
    double horizon; /* delta */
    double volume;  /* of the part of the cell inside the body */
};

/* Constants common to all bonds of a body. */
struct solid_bond_law {
    int dim;
    enum solid_partial partial;
    enum solid_horizons horizons;
    const struct physics_micromodulus_law *micromodulus;
    double horizon;                   /* horizon of the material */
    double c, s0;                     /* at this horizon: c0 or c1 in N/m6; critical stretch, s_e of a bilinear law */
    double s_c;                       /* of a bilinear law; 0: brittle */
    double density;                   /* kg/m3 */
    double bonds_energy;              /* J/m2, solid_material_bonds_energy */
    int columns;                      /* of the quadrature of partial volumes in 3D */
    struct solid_weight_table *table; /* table of earlier partial volumes; borrowed */
};

struct solid_pair {
    double stiffness; /* K_hl, N/m6 */
    double eps_limit; /* (1 + s0)^2 - 1 */
    double gamma;     /* Gamma_h(l), 0 if l is not in the family of h */
};

struct solid_bond_law solid_pair_law(const struct solid_input *in, const struct solid_material *material);

/* Whether l, at xi from h, is in the family of h. */
int solid_pair_holds(const struct solid_bond_law *law, const double *xi, double horizon, double size_of_l);
/* Whether h has a bond to l. */
int solid_pair_exists(const struct solid_bond_law *law, const double *xi, const struct solid_end *h,
                      const struct solid_end *l);
/* Gamma_h(l) of a member l of the family. */
double solid_pair_gamma(const struct solid_bond_law *law, const double *xi, double horizon, double size_of_l);
/* All constants of the bond, the same from both ends to the bit with dual horizons. xi = X0_l - X0_h. */
struct solid_pair solid_pair_of(const struct solid_bond_law *law, const double *xi, const struct solid_end *h,
                                const struct solid_end *l);
/* The limit only. */
double solid_pair_limit(const struct solid_bond_law *law, const double *xi, const struct solid_end *h,
                        const struct solid_end *l);
/* The mean micromodulus of the existing halves, N/m6: K = c Gamma, with the Gamma that damage and energies use. */
double solid_pair_micromodulus(const struct solid_bond_law *law, const double *xi, const struct solid_end *h,
                               const struct solid_end *l);
/* The same of a bond between bodies with two laws: `law` of h, `other` of l. The half of each end follows its own. */
int solid_pair_across_exists(const struct solid_bond_law *law, const struct solid_bond_law *other, const double *xi,
                             const struct solid_end *h, const struct solid_end *l);
struct solid_pair solid_pair_across(const struct solid_bond_law *law, const struct solid_bond_law *other,
                                    const double *xi, const struct solid_end *h, const struct solid_end *l);
double solid_pair_across_micromodulus(const struct solid_bond_law *law, const struct solid_bond_law *other,
                                      const double *xi, const struct solid_end *h, const struct solid_end *l);
/* V0: the volume of a complete family inside a body of particles of one size, spacings^dim. The size is rounded to the
 * nearest of 1, 1/2, 1/4 and so on. */
double solid_pair_full_volume(const struct solid_bond_law *law, double horizon, double size);
/* A contribution to V_h, rounded to about 2^-49 of V0, so that sums of these are exact in any order. */
double solid_pair_rounded(const struct solid_bond_law *law, double horizon, double volume);
