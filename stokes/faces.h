/* The faces that carry velocity: those between two pore cells. Component c of cell i is the face between it and its
 * neighbour at the high side along c, so velocities have three places a cell, and those of closed faces are 0.
 *
 * Walls stand on the faces of cells. Of a velocity u on a face, A u = -sum over the six neighbouring faces of
 * (u_neighbour - u)/d^2, where
 *     a neighbour along c is closed                    u_neighbour = 0
 *     a neighbour across c has solid on both sides     u_neighbour = -u: the wall is half a cell away
 *     it has solid on one side alone: an edge          u_neighbour = 0, with STOKES_FACES_EDGE in place of 1
 *     it is beyond a side that is free of shear        u_neighbour = u
 * At an edge of solid u rises with r^0.5445 (Moffatt 1964, an angle of 270 degrees), which differences do not follow:
 * with the weight 1 k is too large by a part that falls with d^1.089 alone. The weight 2.4 takes most of it away; what
 * is left falls with d^4/3 to d^2. It was found by square and staircase obstacles on up to 256 x 256 cells, and holds
 * for cells that are cubes. The stairs of a smooth solid have no such edges: there the weight is 1. On a side of given
 * pressure a face has half a cell of fluid. Its row is half as large, so that A stays symmetric, and so is its part of
 * a force along c. */
#pragma once
#include "stokes/cells.h"

enum { STOKES_FACES_CLOSED = 255, STOKES_FACES_KINDS = 200 /* 100, and 100 on a side of given pressure */ };
#define STOKES_FACES_EDGE 2.4

struct stokes_faces {
    uint8_t (*kind)[3];                    /* [size] closed, or the number of a diagonal; those of ghosts too */
    double diagonal[3][256];               /* [c][kind] of A, 1/m2; closed: 0 */
    float single[3][256], inverse[3][256]; /* the same in single precision, and 1 over it, m2; closed: 0 */
    int halves;
    struct stokes_faces_half {
        int cell, inner; /* of this rank; the direction of its inner neighbour along c, 0 .. 5 */
    } * half;            /* [halves] faces on sides of given pressure, all along the grid's axis */
    long open[3];        /* over all ranks, a half as 1 */
};

struct stokes_faces *stokes_faces_new(const struct stokes_cells *cells); /* Collective. */
void stokes_faces_free(struct stokes_faces *f);                          /* may be NULL. Not collective. */
static inline int stokes_faces_is_open(const struct stokes_faces *f, int cell, int c) {
    return f->kind[cell][c] != STOKES_FACES_CLOSED;
}
static inline int stokes_faces_is_half(int kind) { return kind >= STOKES_FACES_KINDS / 2 && kind < STOKES_FACES_KINDS; }
