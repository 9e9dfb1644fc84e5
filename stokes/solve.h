/* The solution of a creeping flow: conjugate gradients for the pressure with the Schur complement S = G^T A^-1 G,
 * preconditioned by 1 + M^-1 with the Darcy operator M  (as Cahouet and Chabard 1988 do for unsteady flow), and by
 * solutions with A inside. S is close to 1 for what varies within a pore, and to M for what varies along many. */
#pragma once
#include "stokes/stokes.h"

/* What one solution took, and how good it is. */
struct stokes_effort {
    int outer;     /* iterations with the Darcy operator */
    long products; /* with A, of all three components */
    long cycles;   /* of multigrid */
    double error;  /* of the permeability, relative: estimate of what the iteration left */
    int stopped;   /* 1: by the input's `stops`; nothing is solved */
    double seconds;
};

/* Solves for a force 1 along an axis: u, p, pressure[axis], and the parts of the tensor that are known then. The axis
 * must lead through. Collective. */
struct stokes_effort stokes_solve(struct stokes *s, int axis);
/* The same from u and p as they are: the caller has set them from a flow through much the same pores. Ghosts are
 * filled, u is 0 at closed faces, p is 0 in layers of given pressure. Collective. */
struct stokes_effort stokes_solve_on(struct stokes *s, int axis);
