/* Solves A e = r by conjugate gradients with a cycle over blocks (stokes/blocks.h), the three components at once, each
 * with its own step. */
#pragma once
#include "stokes/faces.h"

struct stokes_blocks;

struct stokes_viscous {
    const struct stokes_cells *cells; /* borrowed, as is faces */
    const struct stokes_faces *faces;
    float (*e)[3], (*r)[3]; /* [size] the solution, with ghosts filled; what is left of the right-hand side */
    float (*s)[3];          /* [size] the direction */
    float (*v)[3];          /* [size] A s, and then the residual, preconditioned */
    struct stokes_blocks *blocks;
    long products; /* with A, so far */
    double left;   /* of the last solve: what its last quarter of steps added to e.A e, more than is left */
};

struct stokes_viscous *stokes_viscous_new(const struct stokes_cells *cells, const struct stokes_faces *faces);
void stokes_viscous_free(struct stokes_viscous *v);
/* e = A^-1 r from e = 0, until the residual in the norm of the cycle is `tolerance` times what it was. Returns e.A e,
 * by which the solution was lacking. Collective. */
double stokes_viscous_solve(struct stokes_viscous *v, double tolerance);
