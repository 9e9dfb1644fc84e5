/* Direct solution of the discrete Poisson equation on cell centres: x and y by fast transforms, plane by plane; z by
 * recurrences over the planes, which are divided over ranks (fluid/poisson/column.h). A plane is transformed while it
 * is in the cache: right after its right-hand side is computed, and right before its solution is used. With a shift the
 * same code solves the Helmholtz equation.  (001: secs 3.4.3, 4.1) */
#pragma once
#include "fluid/poisson/transform.h"
#include <stddef.h>

enum { FLUID_POISSON_SHIFTS = 3 }; /* largest number of shifts: one a stage */

struct fluid_poisson_input {
    int n[3];
    double d[3];              /* m */
    int ranks[3];             /* process grid, as fluid_grid's */
    const int *cut[3];        /* and its cuts, borrowed; NULL: even ones */
    enum fluid_end end[3][2]; /* of the unknown at the low and high face: value 0 or normal derivative 0 */
    ptrdiff_t row;            /* stride of the rows of the planes that the solution is written to */
    double *work;             /* [capacity] borrowed memory that fluid_poisson_solve overwrites; NULL: its own */
    size_t capacity;
    int shifts; /* 0: Poisson equation; otherwise Helmholtz equation, with this number of shifts */
};

struct fluid_poisson; /* opaque: plans, eigenvalues, columns, work */

struct fluid_poisson *fluid_poisson_new(const struct fluid_poisson_input *in); /* Collective. */
void fluid_poisson_free(struct fluid_poisson *p);
/* [m_y][n_x] The memory of plane k of the right-hand side: free scratch between two solutions. */
double *fluid_poisson_plane(const struct fluid_poisson *p, int k);

/* From this call on the equation is Laplacian(q) - shift q = the right-hand side, shift > 0, 1/m2. which = 0 ..
 * shifts-1: the slot that stores the data of a shift until another shift replaces it. Not collective. */
void fluid_poisson_shift(struct fluid_poisson *p, int which, double shift);
/* Calls fill for each plane k of this rank, which writes its right-hand side to [m_y][n_x] without padding, and does
 * the part of the solution that needs this rank's planes only. One thread has one plane. Not collective. */
void fluid_poisson_forward(struct fluid_poisson *p, void (*fill)(void *data, int k, double *plane), void *data);
/* Solves, after fluid_poisson_forward. With no Dirichlet end q gets the mean `mean`, and the mean of the right-hand
 * side is ignored. Collective. */
void fluid_poisson_solve(struct fluid_poisson *p, double mean);
/* Who takes the planes of the solution. One thread has one plane at a time. */
struct fluid_poisson_target {
    double *(*place)(void *data, int k); /* where plane k is to be written: [m_y] rows of [n_x] */
    void (*use)(void *data, int k); /* NULL, or called once the planes k, k+1, .. are written. It may read planes k .. k
                                       + threads; the others may be overwritten */
    void *data;
};
/* Writes the planes k = m_z, m_z - 1, .. 0 of the solution. Plane m_z is the next rank's first plane, or its image by
 * the end condition. Not collective. */
void fluid_poisson_backward(struct fluid_poisson *p, const struct fluid_poisson_target *to);

/* With no Dirichlet end, before fluid_poisson_solve: this rank's share of the mean of the solution (that has mean zero)
 * over the last cells in a direction (side 1) or the first (side 0). The direction is not periodic. Collective. */
double fluid_poisson_section_mean(struct fluid_poisson *p, int direction, int side);
