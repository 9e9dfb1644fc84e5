/* The tensor of permeability on one grid, of creeping flow. */
#pragma once
#include "program/permeability/drive.h"
#include "stokes/solve.h"

struct permeability_level {
    int finer, n[3]; /* cells of the scene's grid are cut in so many parts along each axis; cells */
    long pores, through;
    double porosity;      /* of the medium's box */
    double layer;         /* a layer of one cell on all walls, over the domain's volume */
    double K[3][3];       /* m2, [component][axis]; NaN: not measured; 0: no way through */
    double tortuosity[3]; /* NaN: no way through */
    int leads[3];         /* pores lead through along the axis */
    double meets[3];      /* share of the pores' area at the sides that meets pores across them; NaN: these are
                           * not periodic */
    double chance[3];     /* what it were if the sides had nothing to do with one another */
    struct stokes_effort effort[3];
    double seconds, bytes; /* altogether; of all ranks at most */
    int stopped;
};

/* Dies where a permeability is not defined: fluid can pass beside the medium's box, or the box ends within the solid.
 * say: called after each axis. Collective. */
void permeability_level_measure(const struct scene *s, const struct permeability_drive *drive, int finer,
                                int (*stops)(void *), void (*say)(const struct permeability_level *, int axis),
                                struct permeability_level *l);
