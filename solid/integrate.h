/* One substep of each integrator. Inside the room only. */
#pragma once
#include "solid/solid.h"

void solid_rk3_step(struct solid *s, double dt);    /* Collective. */
void solid_verlet_begin(struct solid *s);           /* a(t_n), anew unless it is still right. Collective. */
void solid_verlet_step(struct solid *s, double dt); /* Collective. */
void solid_verlet_end(struct solid *s);             /* Not collective. */
/* Within a sweep: remembers the part of a that depends on d and on differences of v alone. Not collective. */
void solid_verlet_keep(struct solid *s);
