/* The cracks that carry fluid below the grid in a field file: aperture, pressure, and the band that they take. */
#pragma once
#include "postproc/data/plate.h"

struct postproc_crack_fluid {
    /* What is drawn: a plate's particles about the cracks; in 3D the columns of the lattice along `along` about the
     * cracks, without displacement, each with the area-weighted means over its cracks. */
    struct postproc_plate plate;
    double *aperture, *pressure; /* [plate.n] m, Pa; NAN where there is no crack; with pores the pressure everywhere.
                                  * Owned */
    int along;                   /* 2 of a plate; else the axis across which the cracks are flattest */
    /* Of the particles at the cracks. Each layer of a band counts its part of the cracks' area. */
    long particles;
    double area, volume; /* sum of |a_h|, m2; of the particles' volumes, m3 */
    double conductive;   /* sum of |a_h| w^3/12, m5: w is the aperture, at least the least one */
};

/* Of the k-th file, in the window and along the axis of `like`, or its own with NULL. NULL: the file has no such field,
 * or neither a crack nor a pore. */
struct postproc_crack_fluid *postproc_crack_fluid_new(const struct postproc_history *h, int k,
                                                      const struct postproc_crack_fluid *like);
void postproc_crack_fluid_free(struct postproc_crack_fluid *w);
/* The least aperture in the conductance, m: smaller ones count as this one. */
double postproc_crack_fluid_least_aperture(const struct postproc_history *h);
