/* Which pores lead through the sample. Pieces of connected pore cells are found with the number of periods by which a
 * way through them returns to its start. Layers of given pressure count as joined to one another, a period apart. */
#pragma once
#include "stokes/cells.h"

struct stokes_pieces {
    long all;          /* pieces of pore cells */
    long through;      /* of these, those that lead through along some axis */
    long cells;        /* pore cells in them */
    int percolates[3]; /* 1: some piece of the pores connects the two sides of the axis */
    uint8_t *stays;    /* [n] 1: the cell's piece connects two sides; owned */
};

struct stokes_pieces *stokes_pieces_new(const struct stokes_cells *cells); /* Collective. */
void stokes_pieces_free(struct stokes_pieces *p);                          /* may be NULL. Not collective. */
