/* Whether bodies may pass one another without contact: how far they are apart, and which speed contact can stop. */
#pragma once
#include "solid/state.h"

/* The least distance between the bounds of two bodies beyond the reach of contact's lists, m; 0: they are within it,
 * INFINITY: there is one body. Collective. */
double solid_contact_passing_gap(const struct solid *s);
/* The fraction of a spacing by which two particles may approach in a substep without their contact being missed. */
double solid_contact_passing_unseen(void);
/* The speed at which two free particles must meet to come nearer than half of r_c, m/s: their kinetic energy is then
 * the potential of contact at that depth. The least one of all materials. Faster particles are pushed through the gaps
 * of a lattice. Not collective. */
double solid_contact_passing_held_speed(const struct solid *s);
/* The pairs without a bond that are nearer than r_c: their least distance, m (INFINITY: there are none), their number,
 * and their potential, J. Leaves the solid unchanged. Collective. */
struct solid_contact_overlap {
    double least, pairs, potential;
};
struct solid_contact_overlap solid_contact_passing_overlap(struct solid *s);
