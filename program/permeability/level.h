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
    int percolates[3];    /* the pores connect the two sides of the axis */
    double overlap[3];    /* share of the pores' area that is pore at both of the axis's sides; NaN: these are
                           * not periodic */
    int is_cut[3];        /* and the pores do not continue across these (stokes_mask_overlap_share) */
    int written[3];       /* the axis's flow is in a file */
    struct stokes_effort effort[3];
    double seconds, bytes; /* altogether; of all ranks at most */
    int stopped;
};

/* Memory of all ranks for the pores of a level that was measured, bytes. Not collective. */
double permeability_level_bytes(const struct permeability_level *l);
/* Prints the memory and time of the level before it uses them, and dies if there is less memory. Dies if a
 * permeability is not defined: fluid can pass beside the medium's box, or the box ends within the solid. axis_done:
 * called after each axis. smooth: 1: cells are the stairs of a smooth solid (stokes/input.h). out: the folder in which
 * the flows are written as fields; NULL: they are not. Collective. */
void permeability_level_measure(const struct scene *s, const struct permeability_drive *drive, int finer, int smooth,
                                const char *out, int (*stops)(void *),
                                void (*axis_done)(const struct permeability_level *, int axis),
                                struct permeability_level *l);
