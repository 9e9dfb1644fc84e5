/* The crack of a plate, from its damage: positions of its tips, number of its fronts.  (000: sec. 3.1)
 *
 * Positions are initial ones (X0): a crack belongs to the material. A particle is damaged if its damage is above a
 * level. "Far" means far along a given direction; a body in 3D is projected along z. */
#pragma once
#include "solid/state.h"

/* Damaged particles of all ranks, the farthest first; equally far ones from the right to the left of the direction. */
struct solid_crack_particles {
    long n;
    double (*x)[2]; /* [n] m; owned */
    double *size;   /* [n] edge of the particle's cell, m; owned */
};

/* damage [s->n], direction of length 1. Collective; the same result on any number of ranks. */
struct solid_crack_particles solid_crack_gather(const struct solid *s, const double *damage, double level,
                                                const double direction[2]);
void solid_crack_particles_free(struct solid_crack_particles *p);
/* Sorts particles into that order. */
void solid_crack_sort(struct solid_crack_particles *p, const double direction[2]);

enum { SOLID_CRACK_LEFT, SOLID_CRACK_RIGHT, SOLID_CRACK_SIDES };
struct solid_crack_tips {
    int found;     /* 0: no particle is damaged, the rest is NaN */
    int fronts;    /* peaks of the crack that are longer than three particles */
    double tip[2]; /* the farthest point, mean of equally far ones, m */
    double side[SOLID_CRACK_SIDES]
               [2]; /* the farthest points to the left and to the right of the axis, or on it; NaN: none */
};

/* Tips of the damaged particles that are connected to an initially damaged one, across gaps of up to two particles; if
 * initial is empty, of all damaged particles. axis: a point of the axis, m; NULL: the axis goes through the tip. Both
 * lists sorted. Pure. */
struct solid_crack_tips solid_crack_tips_of(const struct solid_crack_particles *damaged,
                                            const struct solid_crack_particles *initial, const double direction[2],
                                            const double *axis);
