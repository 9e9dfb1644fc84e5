/* Distance and normal of interface particles by the exact surface of the body's shape. Without it a particle's wetted
 * face is half a spacing away. */
#pragma once
#include "solid/surface/surface.h"

struct solid_exact {
    /* by owned particle, [n] */
    uint8_t *on;
    double *depth;      /* below the surface, m */
    double *curvature;  /* mean curvature of the surface, 1/m */
    double *normal[3];  /* unit, the surface's at the start */
    double *lattice[3]; /* unit, the initial normal from the particles, from which the rotation is measured */
};

/* For the particles on the interface at the start, except those along edges and those on no lattice. Not collective. */
struct solid_exact *solid_exact_new(const struct solid *s, const struct solid_surface *surface);
void solid_exact_free(struct solid_exact *exact);

/* Particle h's depth below the surface, m, the surface's mean curvature, and its normal, rotated with h's family.
 * Returns 0 if h has no such surface or if its neighbours have changed. Not collective. */
int solid_exact_at(const struct solid_surface *surface, int h, double normal[3], double *depth, double *curvature);
