/* The interface between solid and void, and what is read off the bonds there.  (001: secs 3.3.7, 3.3.9; SPEC 2) */
#pragma once
#include "solid/solid.h"

struct solid_surface {
    int n;               /* interface particles owned here */
    int capacity;
    int *h;              /* [n] local index of the particle */
    double *normal[3];   /* [n] unit, out of the material; for two-sided particles the plate's axis, either sign */
    uint8_t *two_sided;  /* [n] a wall one or two particles thick: both faces are wetted */
    double *area;        /* [n] A_h, m2 (per face) */
    double initial_area; /* A_h of the particles that were on the interface at the start */
    double immersed_area;/* whole solid, at the start, m2 */
    long total;          /* interface particles of all ranks */
};

struct solid_surface *solid_surface_new(struct solid *s); /* Detects from scratch; sets SOLID_INTERFACE, SOLID_FIRST. Collective. */
void solid_surface_free(struct solid_surface *surface);
/* After the solid has moved or broken: looks again only where a bond has broken, and turns normals only where particles
 * have moved enough to matter. Costs next to nothing while no bond has broken. Returns 1 if the set has changed. Collective. */
int solid_surface_update(struct solid *s, struct solid_surface *surface);
