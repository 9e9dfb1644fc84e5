/* The reactions that hold bodies in balance under given forces, as of a rigid support. */
#pragma once
#include "solid/state.h"

/* Extents of the particles of some bodies at the start, spacings beyond their centres not included. */
struct solid_support_extent {
    double low[3], high[3]; /* m */
    int endless[3];         /* 1: they fill the period of a periodic direction; also the third direction of a plate */
};
/* chosen: [s->in.bodies] 1: those bodies. Collective. */
struct solid_support_extent solid_support_extent_of(const struct solid *s, const uint8_t *chosen);
/* Adds to force, [3][n] N/m3 on owned particles, what holds the chosen bodies in balance: volume times a rigid motion,
 * on held particles in the directions in which they are held; what no held particle takes up accelerates all of them
 * (inertia relief). No rotation about a direction if they are endless across it. Collective. */
void solid_support_add(const struct solid *s, const uint8_t *chosen, const struct solid_support_extent *extent,
                       double *const force[3]);
