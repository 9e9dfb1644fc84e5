/* A load that is recomputed before each substep, from the acceleration by the other forces.
 *
 * The solid calls it once a is complete and before anything moves. It may then change load, and a and v with it: a
 * change F of the load's part changes a by F/rho where the particle is free, and v by dt/2 F/rho. With that change of v
 * velocity Verlet moves with one load from the middle of the last substep to the middle of the next one:
 *     v(n+1/2) = v(n-1/2) + dt (a_others(n) + F(n)/rho)      d(n+1) = d(n) + dt v(n+1/2)
 * For velocity Verlet only. */
#pragma once
#include "solid/state.h"

struct solid_push {
    void (*before)(struct solid *s, double dt, void *with); /* Collective. */
    void *with;
};
