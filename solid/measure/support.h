/* The reactions that hold bodies in balance under given forces, as of a rigid support. */
#pragma once
#include "solid/state.h"

/* Extents of the particles of some bodies at the start, spacings beyond their centres not included. Bodies that lie
 * across a periodic side are put together: low is within the period, high may lie beyond it. */
struct solid_support_extent {
    double low[3], high[3]; /* m */
    int endless[3];         /* 1: they fill the period of a periodic direction but for gaps within the horizon; also
                               the third direction of a plate */
    double period[3];       /* m, 0: not periodic */
};
/* chosen: [s->in.bodies] 1: those bodies. Collective. */
struct solid_support_extent solid_support_extent_of(const struct solid *s, const uint8_t *chosen);
/* The coordinate of an owned particle at the start, counted from extent->low, m: within the extent of bodies that lie
 * across a periodic side. Not collective. */
double solid_support_place(const struct solid *s, const struct solid_support_extent *extent, int c, int h);
/* Adds to force, [3][n] N/m3 on owned particles, what holds the chosen bodies in balance: volume times a rigid motion,
 * on held particles in the directions in which they are held; what no held particle takes up accelerates all of them
 * (inertia relief). No rotation about a direction if they are endless across it. Collective. */
void solid_support_add(const struct solid *s, const uint8_t *chosen, const struct solid_support_extent *extent,
                       double *const force[3]);
