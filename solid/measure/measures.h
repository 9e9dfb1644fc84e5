/* What is read off the solid for series and fields; nothing here is computed unless written.  (SPEC 7) */
#pragma once
#include "solid/solid.h"

struct solid_energy {
    double kinetic, strain; /* J, whole solid */
};
struct solid_energy solid_energy_measure(struct solid *s); /* Collective. */
void solid_damage_measure(const struct solid *s,
                          double *phi); /* [n], 1 - sum(lambda Gamma V)/sum(Gamma V). Not collective. */
/* Of each particle, [n]: the energy in its halves of its intact bonds, J/m3, and the largest of their stretches, -1
 * where none is left. Ghosts must be current. Not collective. */
void solid_energy_bonds(const struct solid *s, double *energy, double *stretch);
void solid_energy_bonds_of(const struct solid *s, int h, double *energy, double *stretch); /* one of them */
/* Bond-force flux stress and least-squares strain, each [n][6] as xx yy zz xy yz zx; Pa and 1. A plate has no yz and
 * zx; its zz is what holds it plane: sigma_zz = nu (sigma_xx + sigma_yy) in plane strain, with nu = 1/4, and in plane
 * stress eps_zz = -nu/(1 - nu) (eps_xx + eps_yy), with nu = 1/3 (small strain). Not collective. */
void solid_stress_measure(const struct solid *s, double (*stress)[6]);
void solid_stress_strain(const struct solid *s, double (*strain)[6]);
/* Principal values, largest first, and von Mises of a symmetric tensor. */
void solid_tensors_principal(const double t[6], double value[3]);
void solid_tensors_largest(int n, double (*t)[6], double *largest); /* of n tensors. Not collective. */
double solid_tensors_von_mises(const double t[6]);

/* Connected components of intact bonds. id[n]: the smallest global id of the fragment, a name that all ranks share. */
struct solid_fragment {
    long id;
    long particles;
    double mass, x[3], v[3]; /* kg, centre of mass m, mean velocity m/s */
    int held;                /* has a held or driven particle */
};
/* Returns the number of fragments; list (malloc'ed, on every rank, largest first) may be NULL. Collective. */
int solid_fragments_measure(struct solid *s, long *id, struct solid_fragment **list);
