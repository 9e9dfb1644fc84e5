/* The crack of a plate, read off its damage: where its tips are, how many fronts it has.  (000: sec. 3.1)
 *
 * Particles stand where they stood at the start (X0): a crack is in the material. One is damaged when its damage is
 * above a level. "Far" is along a direction given; a body in 3D is seen along z. */
#pragma once
#include "solid/state.h"

/* Damaged particles of all ranks, the farthest first; those equally far from the direction's right to its left. */
struct solid_crack_particles {
    long n;
    double (*x)[2]; /* [n] m; owned */
    double *size;   /* [n] edge of the particle's cell, m; owned */
};

/* damage [s->n], direction of length 1. Collective; the same on every rank, whatever their number. */
struct solid_crack_particles solid_crack_gather(const struct solid *s, const double *damage, double level,
                                                const double direction[2]);
void solid_crack_particles_free(struct solid_crack_particles *p);
/* Puts particles of any order into the one above. */
void solid_crack_sort(struct solid_crack_particles *p, const double direction[2]);

enum { SOLID_CRACK_LEFT, SOLID_CRACK_RIGHT, SOLID_CRACK_SIDES };
struct solid_crack_tips {
    int found;     /* 0: nothing is damaged, the rest is NaN */
    int fronts;    /* peaks of the crack that stand out by more than three particles */
    double tip[2]; /* the farthest; the mean of those equally far, m */
    double side[SOLID_CRACK_SIDES]
               [2]; /* the farthest to the left and to the right of the axis, it included; NaN: none */
};

/* Tips of the damaged particles that hang together with an initially damaged one (gaps of up to two particles are
 * passed); of all where initial is empty. axis: a point of it, m; NULL: it goes through the tip. Both lists sorted.
 * Pure. */
struct solid_crack_tips solid_crack_tips_of(const struct solid_crack_particles *damaged,
                                            const struct solid_crack_particles *initial, const double direction[2],
                                            const double *axis);
