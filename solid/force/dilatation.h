/* Materials of any Poisson's ratio: the dilatation of each family, and the pressure with which it acts on its bonds.
 * (Silling et al. 2007, secs 13-15, with the influence function 1/|xi|; physics/dilatation.h)
 *
 * With K for the stiffness of a bond without its surface correction alpha, s its stretch, n the dimension, sums over
 * intact bonds, M_0 for the M of a full family:
 *     M_h     = sum K |xi| V_l                            N/m2
 *     theta_h = (n/M_h) sum K |xi| s V_l                  1
 *     P_h     = n excess theta_h/M_0                      1
 *     force of l on h per volume: K (alpha s + P_h + P_l) V_l along the bond
 *     energy per volume: 1/2 excess (M_h/M_0) theta_h^2
 * The force is the derivative of the energy, the same from both ends. A uniform strain has theta = its trace in every
 * full family, so its stress is that of the bonds and excess theta, whatever the lattice. The excess is the material's
 * bulk modulus k less that of the lattice's bonds, k_b = M_0/(2 n^2), so that the sum is exact.
 *
 * With the factor M_h/M_0 the dilatation of a family that a surface cuts carries the same fraction of its stress as the
 * bonds do without alpha. In a uniform strain P is the same everywhere. So across any plane near a surface both carry
 * the same fraction of their stress, and at a free surface both vanish. And as
 *     (sum K |xi| s V)^2 <= M_h sum K |xi| s^2 V
 * the energy of the dilatation is at most |excess|/k_b times that of the family's bonds, whichever of them are left:
 * with alpha = 1 the sum is never negative, and its frequencies are at most sqrt(k/k_b) times those of the bonds.
 *
 * A sweep has two passes: sums over the families, in which bonds break; and forces. Between them P of ghosts comes from
 * their owners. For solid/ only. */
#pragma once
#include "solid/bonds/store.h"

struct solid_dilatation {
    uint8_t *of_body;  /* [bodies] 1: the body is swept in two passes */
    double *extension; /* [n] sum K |xi| s V of the last sweep, N/m2 */
    double *full;      /* [n] M_0, N/m2 */
    double *excess;    /* [n] Pa */
    double *pressure;  /* [n + n_ghost] P_h of the last sweep, 1 */
    double *sum[3];    /* [n] work: sums over the family, over the density of the store, m/s2 */
    struct solid_dilatation_loss *loss;
    int losses, capacity; /* of loss, from a bond's ends here; solid/force/dilatation_loss.h */
};

/* Whether body b is swept in two passes: a material of it has another Poisson's ratio than bonds alone, or a material
 * of a body that an interface joins to it, whose pressure it feels. */
int solid_dilatation_is(const struct solid_input *in, int b);
/* Sets s->dilatation, once the bonds are complete; NULL if bonds alone have the Poisson's ratio of each material. Not
 * collective; nor is a function below, unless it says so. */
void solid_dilatation_new(struct solid *s);
/* The same again, once a refined plate has its new bonds. */
void solid_dilatation_renew(struct solid *s);
void solid_dilatation_free(struct solid_dilatation *d);
/* The forces of all bodies, as solid_force_bonds; returns the power of damping, W. Collective. */
double solid_dilatation_force(struct solid *s, struct solid_sweep sweep);
/* excess theta of the owned particles at the present d, whose ghosts must be current [n], Pa; 0 in bodies of bonds
 * alone. */
void solid_dilatation_stress(const struct solid *s, double *stress);
/* Energy of the dilatation at the present d, this rank's share, J; and of one particle, J/m3. */
double solid_dilatation_energy(const struct solid *s);
double solid_dilatation_density(const struct solid *s, int h);
