/* The velocity Verlet substep of the solid: one force sweep, and an acceleration that lasts to the next substep. */
#pragma once
#include "solid/state.h"

/* The part of a Verlet step at which pairwise damping sees the velocity. A later velocity damps the fastest waves
 * more than the damping coefficient says, an earlier one less, with longer stable steps (solid/step/stable.c;
 * docs/design/solid-motion.md). */
#define SOLID_VERLET_PAIRWISE 0.4

void solid_verlet_begin(struct solid *s);           /* computes a(t_n), unless a is still valid. Collective. */
void solid_verlet_again(struct solid *s);           /* computes a(t_n) with changed loads and imposed velocities. Not
                                                     * collective. */
void solid_verlet_step(struct solid *s, double dt); /* Collective. */
void solid_verlet_end(struct solid *s);             /* a holds for the present d, v. Not collective. */
