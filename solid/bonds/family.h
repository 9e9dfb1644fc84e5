/* The bonds: which particles interact, with what weight, and which bonds are broken.
 *
 * There are two bond stores with one common view. The lattice store (solid/bonds/lattice.c) is the fast one: rows of
 * eight sites along x, one byte of lambda bits per row and offset, weights common to all rows. The list store
 * (solid/bonds/list.c), for all other bodies: lists of bonds. Code outside the force sweep reads bonds through struct
 * solid_family_view, which hides the store. */
#pragma once
#include "solid/state.h"

struct solid_family_view {
    int n;                           /* bonds in the family as made, broken ones included */
    int l[SOLID_FAMILY_MAX];         /* local index of the other end (owned or ghost) */
    double xi[SOLID_FAMILY_MAX][3];  /* X0_l - X0_h, across periodic sides, m; z of a plate is 0 */
    double weight[SOLID_FAMILY_MAX]; /* Gamma_hl V_l, m3 */
    double alpha[SOLID_FAMILY_MAX];  /* surface correction, symmetric */
    double micro[SOLID_FAMILY_MAX]; /* micromodulus c of the bond, N/m6: its force on h is alpha c s Gamma V per volume;
                                     * of a softening bond what is left of it */
    uint8_t intact[SOLID_FAMILY_MAX]; /* lambda */
};

/* Fills in the family of owned particle h. Not collective. */
void solid_family_view(const struct solid *s, int h, struct solid_family_view *view);
/* The number of bonds in the family as made, the view's n. Faster than the view. Not collective. */
int solid_family_initial_bonds(const struct solid *s, int h);
/* The particles at the other ends of h's broken bonds, [SOLID_FAMILY_MAX], but for those bonds that `known` has. known
 * has a bit for each bond, solid_family_bytes(s) bytes, all 0 at first; the bonds found are added to it. Returns how
 * many. Not collective. */
int solid_family_newly_broken(const struct solid *s, int h, uint8_t *known, int *other);
/* On a lattice: the broken bonds of h, the particles at their other ends and X0_l - X0_h in spacings,
 * [SOLID_FAMILY_MAX]. Returns how many. Not collective. */
int solid_family_struts(const struct solid *s, int h, int *other, signed char (*step)[3]);
/* The same of the intact bonds. */
int solid_family_intact(const struct solid *s, int h, int *other, signed char (*step)[3]);
/* The number of intact bonds of h: it tells whether some have broken since. Not collective. */
int solid_family_intact_bonds(const struct solid *s, int h);
/* On a lattice: the nearest particles in the directions -x, x, -y, y, -z, z, whether or not the bond is broken; -1:
 * none, or one of another body without a bond. Not collective. */
void solid_family_nearest(const struct solid *s, int h, int nearest[6]);
/* Breaks the b-th bond of h's view permanently, from both ends if both are owned here; otherwise the owner of the other
 * end must break it for its own particle. For initial cracks and tests. Not collective. */
void solid_family_break(struct solid *s, int h, int b);

/* Whether the body's bonds are swept in mixed precision (solid/force/segment_single.h). Not collective. */
int solid_family_is_mixed(const struct solid *s, int body);

/* lambda as a checkpoint stores it, without the histories of softening bonds, which a load forgets: for the owned
 * particle h, bit b of its view; bytes = (n_view + 7)/8 per particle, independent of store and ranks. Not collective.
 */
int solid_family_bytes(const struct solid *s); /* bytes per particle, the same during the whole run */
void solid_family_save(const struct solid *s, int h, uint8_t *bits);
void solid_family_load(struct solid *s, int h, const uint8_t *bits);

long solid_family_directed(const struct solid *s); /* directed intact and broken bonds of owned particles */
void solid_family_count(struct solid *s);          /* sets s->bonds_broken. Collective. */
