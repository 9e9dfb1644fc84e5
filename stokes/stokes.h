/* Creeping flow through the pores of a box of cells,
 *     A u + G p = f,  G^T u = 0,
 * with velocities on the faces between pore cells (stokes/faces.h), pressures in pore cells, the viscosity 1, and a
 * force f = 1 along an axis. So velocities are permeabilities, m2, and pressures lengths, m: with a viscosity mu and a
 * gradient g they are g/mu and g times as large. The sides of given pressure have the pressure 0. */
#pragma once
#include "stokes/cells.h"
#include "stokes/faces.h"
#include "stokes/input.h"
#include "stokes/pieces.h"

/* Of a pore cell, at most, with what solving takes; of a pore cell and a solution from nothing, on a core: Berea
 * sandstone and a block with cavities. */
enum { STOKES_BYTES = 250, STOKES_MICROSECONDS = 8 };

struct stokes_darcy;
struct stokes_viscous;

struct stokes {
    struct stokes_grid g;
    struct stokes_mask *mask;   /* the pores that lead through, with layers of given pressure; owned */
    struct stokes_cells *cells; /* NULL: no pore leads through */
    struct stokes_faces *faces;
    struct stokes_viscous *viscous;
    struct stokes_darcy *darcy;
    long pores, through;         /* pore cells of the box; of these in pieces that lead through */
    double volume;               /* cells of the box */
    struct stokes_pieces pieces; /* without its array */
    double (*u)[3], *p;          /* [size] the last solution, ghosts filled */
    float *pressure[3];          /* [size] p of the solution along each axis; NULL: there is none */
    double tensor[3][3];         /* mean velocities over the box, [component][axis of the force], m2; NaN: not known;
                                  * 0 along an axis along which no pores lead through */
};

/* mask is borrowed until it returns. Collective. */
struct stokes *stokes_new(const struct stokes_mask *mask, const struct stokes_input *in);
void stokes_free(struct stokes *s); /* may be NULL. Not collective. */
