/* Interface particles that know the surface of the shape they were cut from: how far away it is, and its normal.
 * Without it a particle's wetted face is half a spacing away, as on the lattice's own faces. */
#pragma once
#include "solid/surface/surface.h"

struct solid_shaped {
    /* by owned particle, [n] */
    uint8_t *on;
    double *depth;      /* below the surface, m */
    double *normal[3];  /* unit, the surface's at the start */
    double *lattice[3]; /* unit, the normal that the particles gave at the start, by which they are seen to turn */
};

/* For the particles on the interface at the start. Those along edges, and those on no lattice, are left as they are.
 * Not collective. */
struct solid_shaped *solid_shaped_new(const struct solid *s, const struct solid_surface *surface);
void solid_shaped_free(struct solid_shaped *shaped);

/* Particle h's depth below the surface, m, and the surface's normal, turned as h's family has turned. Returns 0 where h
 * is bounded otherwise: not shaped, or its neighbours have changed. Not collective. */
int solid_shaped_at(const struct solid_surface *surface, int h, double normal[3], double *depth);
