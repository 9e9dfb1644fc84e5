/* One substep of each integrator. Inside the room only. */
#pragma once
#include "solid/solid.h"

/* The part of a Verlet step at which pairwise damping sees the velocity. A later one damps the fastest waves more than
 * it is asked to, an earlier one less, and takes longer steps (solid/step/stable.c; docs/design.md). */
#define SOLID_VERLET_PAIRWISE 0.4

void solid_rk3_step(struct solid *s, double dt); /* Collective. */
void solid_verlet_begin(struct solid *s);        /* a(t_n), anew unless it is still right. Collective. */
void solid_verlet_again(struct solid *s);        /* a(t_n) with other loads and imposed velocities. Not collective. */
void solid_verlet_step(struct solid *s, double dt); /* Collective. */
void solid_verlet_end(struct solid *s);             /* Not collective. */
/* Within a sweep: v_old becomes the present a, the part that depends on d and on differences of v alone; a is scratch
 * until solid_force_rest. Not collective. */
void solid_verlet_keep(struct solid *s);
