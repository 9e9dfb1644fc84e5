/* The pore cells of this rank: consecutive numbers of the mask, with their neighbours. Cells of other ranks that touch
 * them follow as ghosts, and after these one place that stands for all solid cells: whatever is stored there is 0. */
#pragma once
#include "base/par_ghost.h"
#include "stokes/grid.h"

struct stokes_cells {
    const struct stokes_grid *g; /* borrowed */
    int n, ghosts;
    long *first;             /* [ranks + 1] the first number of each rank */
    int (*next)[6];          /* [n] neighbours x low, x high, y low, ..: places in arrays; solid: n + ghosts */
    struct par_ghost *ghost; /* owned */
    int outside;             /* cells in layers of given pressure */
    int *of_outside;         /* [outside] which these are */
};

struct stokes_cells *stokes_cells_new(const struct stokes_grid *g); /* Collective. */
void stokes_cells_free(struct stokes_cells *c);                     /* may be NULL. Not collective. */
/* Entries of an array over the cells: with ghosts and the solid's. */
static inline size_t stokes_cells_size(const struct stokes_cells *c) { return (size_t)c->n + (size_t)c->ghosts + 1; }
/* Fills the ghosts of an array of records [size] of so many bytes. Collective. */
void stokes_cells_fill(const struct stokes_cells *c, size_t bytes, void *record);
